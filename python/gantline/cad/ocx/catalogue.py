"""What parts of an OCX file refer to: materials, sections, shapes of holes, surfaces, edges."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from gantline.cad.ocx.curves import Arc, Curve, Line
from gantline.cad.ocx.geometry import read_contour
from gantline.cad.ocx.moments import Frame
from gantline.cad.ocx.quantities import Quantities
from gantline.cad.ocx.section import Section, read_section
from gantline.cad.ocx.surface import Surface, read_surface
from gantline.cad.ocx.xml import Element

__all__ = ["Catalogue", "Material"]

_Thing = TypeVar("_Thing")
_SURFACES = (
    "Plane3D",
    "NURBSSurface",
    "Cylinder3D",
    "Cone3D",
    "Sphere3D",
    "ExtrudedSurface",
    "SurfaceCollection",
)


@dataclass(frozen=True)
class Material:
    """A material: its name and density [kg/m^3]."""

    name: str
    density: float


class Catalogue:
    """Things that parts refer to, each read once when it is asked for.

    A reference is followed to the thing itself, which is read without following references of its own, so
    references in a circle cannot keep the reader busy; what one leads to must be of the kind that is needed.
    """

    def __init__(self, root: Element, quantities: Quantities) -> None:
        self._quantities = quantities
        self._by_id: dict[str, Element] = {}
        self._read: dict[tuple[str, str], object] = {}
        twice: set[str] = set()
        for element in root.walk():
            name = element.attributes.get("id")
            if name is not None and element.name != "Unit":
                if name in self._by_id:
                    twice.add(name)
                self._by_id.setdefault(name, element)
        self._twice = twice

    def material(self, reference: Element) -> Material:
        """Material that a `MaterialRef` or `PlateMaterial` refers to."""
        return self._get(reference, ("Material",), self._material)

    def section(self, reference: Element) -> Section:
        """Section that a `SectionRef` refers to."""
        return self._get(reference, ("BarSection",), lambda found: read_section(found, self._quantities))

    def surface(self, reference: Element) -> Surface | None:
        """Surface that a `SurfaceRef` refers to; None if it is an unbounded plane or not read."""
        return self._get(reference, _SURFACES, lambda found: read_surface(found, self._quantities))

    def hole(self, reference: Element) -> tuple[Curve, ...]:
        """Contour, in its own plane z = 0, that a `HoleRef` refers to."""
        return self._get(reference, ("Hole2D",), lambda found: tuple(_hole(found, self._quantities)))

    def edge(self, reference: Element) -> list[Curve]:
        """Curves of the edge or opening that an `EdgeCurveRef` refers to."""
        found = self._found(reference, ("FreeEdgeCurve3D", "Hole2DContour", "InnerContour", "OuterContour"))
        if found.name == "Hole2DContour":
            return self.placed_hole(found)
        return read_contour(found, self._quantities)[0]

    def placed_hole(self, element: Element) -> list[Curve]:
        """Contour in space of a `Hole2DContour`: a shape of the catalogue, put in its place."""
        reference, place = element.child("HoleRef"), element.child("Transformation")
        if reference is None or place is None:
            missing = "HoleRef" if reference is None else "Transformation"
            raise self._quantities.fail(element, f"has no {missing}")
        first = self._quantities.direction(place, "PrimaryAxis")
        second = self._quantities.direction(place, "SecondaryAxis")
        second = second - (second @ first) * first
        size = float(np.linalg.norm(second))
        if size < 0.05:
            raise self._quantities.fail(place, "has two axes in one direction")
        frame = Frame(self._quantities.point_of(place, "Origin"), first, second / size)
        return [_placed(curve, frame) for curve in self.hole(reference)]

    def _get(self, reference: Element, kinds: tuple[str, ...], read: Callable[[Element], _Thing]) -> _Thing:
        found = self._found(reference, kinds)
        key = (kinds[0], reference.attributes["localRef"])
        if key not in self._read:
            self._read[key] = read(found)
        return self._read[key]  # type: ignore[return-value]  # the kind is part of the key

    def _found(self, reference: Element, kinds: tuple[str, ...]) -> Element:
        name = reference.attributes.get("localRef")
        if name is None:
            raise self._quantities.fail(reference, "has no localRef")
        found = self._by_id.get(name)
        if found is None:
            raise self._quantities.fail(reference, f"refers to '{name[:60]}', which the file does not have")
        if name in self._twice:
            raise self._quantities.fail(
                reference, f"refers to '{name[:60]}', which the file has more than once"
            )
        if found.name not in kinds:
            right = kinds[0] if len(kinds) == 1 else f"one of {', '.join(kinds)}"
            raise self._quantities.fail(
                reference, f"refers to '{name[:60]}', which is a {found.name}, not {right}"
            )
        return found

    def _material(self, element: Element) -> Material:
        name = element.attributes.get("name") or element.attributes.get("grade", "")
        return Material(name, self._quantities.positive(element, "Density", "density"))


def _placed(curve: Curve, frame: Frame) -> Curve:
    """A curve of the plane z = 0 in a frame."""
    turn = np.stack([frame.first, frame.second, frame.normal], axis=1)
    return curve.moved(turn, frame.origin)


def _hole(element: Element, quantities: Quantities) -> list[Curve]:
    contour = element.child("Contour")
    if contour is not None:
        return read_contour(contour, quantities)[0]
    shape = element.child(
        "ParametricHole2D", "ParametricCircle", "RectangularHole", "SymmetricalHole", "SuperElliptical"
    )
    if shape is None:
        raise quantities.fail(element, "has no shape that is known")
    if shape.name == "ParametricCircle":
        diameter = quantities.positive(shape, "Diameter")
        return _rounded(diameter, diameter, math.inf)
    # The width lies along the first axis, the height along the second.
    width, height = quantities.positive(shape, "Width"), quantities.positive(shape, "Height")
    if shape.name == "SuperElliptical":
        return _super_ellipse(shape, width, height, quantities)
    radius = quantities.of_child(shape, "FilletRadius") if shape.name == "RectangularHole" else None
    if radius is not None and radius < 0:
        raise quantities.fail(shape, "has a negative FilletRadius")
    return _rounded(width, height, math.inf if radius is None else radius)


def _rounded(width: float, height: float, radius: float) -> list[Curve]:
    """A rectangle about the origin with rounded corners, at most by half the shorter side."""
    radius = min(radius, width / 2, height / 2)
    right, top = width / 2 - radius, height / 2 - radius
    curves: list[Curve] = []
    for quarter, (u, v) in enumerate([(right, top), (-right, top), (-right, -top), (right, -top)]):
        centre = np.array([u, v, 0.0])
        begin = quarter * math.pi / 2
        arc = Arc(
            centre, np.array([radius, 0.0, 0.0]), np.array([0.0, radius, 0.0]), begin, begin + math.pi / 2
        )
        corner: Curve = arc if radius > 0 else Line(np.stack([centre, centre]))
        if curves and np.linalg.norm(corner.start - curves[-1].end) > 0:
            curves.append(Line(np.stack([curves[-1].end, corner.start])))
        if radius > 0:
            curves.append(corner)
        elif not curves:
            curves.append(Line(np.stack([centre, centre])))
    if np.linalg.norm(curves[-1].end - curves[0].start) > 0:
        curves.append(Line(np.stack([curves[-1].end, curves[0].start])))
    return curves


def _super_ellipse(shape: Element, width: float, height: float, quantities: Quantities) -> list[Curve]:
    """|2x/width|ᵉ + |2y/height|ᵉ = 1, as a polygon unless e is 2."""
    exponent = 2.0
    if "exponent" in shape.attributes:
        exponent = float(quantities.numbers(shape, "exponent", 1)[0])
    if not 0.5 <= exponent <= 100:
        raise quantities.fail(shape, f"has an exponent of {exponent:g}; 0.5 to 100 can be read")
    axes = np.array([width / 2, 0.0, 0.0]), np.array([0.0, height / 2, 0.0])
    if exponent == 2.0:
        return [Arc(np.zeros(3), *axes, 0.0, 2 * math.pi)]
    angles = np.linspace(0.0, 2 * math.pi, 721)
    powers = [np.sign(wave) * np.abs(wave) ** (2 / exponent) for wave in (np.cos(angles), np.sin(angles))]
    return [Line(np.outer(powers[0], axes[0]) + np.outer(powers[1], axes[1]))]
