"""Cross-sections of bars: outlines with their moments.

A section has its own axes: u along the flange, v along the web, both from the corner of the smallest box
around it, which is where a section without offsets stands on the trace line. OCX says what the dimensions
mean; that the height of a T leaves its flange out, and that of an L does not, is how exporters write them
(their declared weights show it).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
import numpy.typing as npt

from gantline.cad.ocx.curves import Arc, Curve, Line, polyline
from gantline.cad.ocx.moments import Frame, Moments, enclosed
from gantline.cad.ocx.quantities import Quantities
from gantline.cad.ocx.xml import Element

__all__ = ["Section", "read_section"]

Array = npt.NDArray[np.float64]

_PLANE = Frame(np.zeros(3), np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]))

#: Bulb flats of EN 10067 by height [mm]: width c of the bulb beyond the web and radius r of its corners.
#: Between and beyond these both are linear in the height.
_BULB_HEIGHTS = (60.0, 80.0, 100.0, 120.0, 140.0, 160.0, 430.0)
_BULB_WIDTHS = (13.0, 14.0, 15.5, 17.0, 19.0, 22.0, 62.5)
_BULB_RADII = (3.5, 4.0, 4.5, 5.0, 5.5, 6.0, 19.5)
_BULB_ANGLE = math.radians(30.0)
_MM = 1e-3


@dataclass(frozen=True, eq=False)
class Section:
    """A cross-section.

    Attributes:
        name: as in the catalogue.
        moments: of its area about the corner of its box.
        width: of the box, along the flange [m].
        height: of the box, along the web [m].
        is_symmetrical: whether both sides of the web are the same: without offset it stands centred.
        loops: outline, then cavities; each a closed path of curves in the plane z = 0.
        doubts: what is not certain.
    """

    name: str
    moments: Moments
    width: float
    height: float
    is_symmetrical: bool
    loops: tuple[tuple[Curve, ...], ...]
    doubts: tuple[str, ...] = ()

    @classmethod
    def of(
        cls,
        name: str,
        loops: Sequence[Sequence[Curve]],
        size: tuple[float, float],
        is_symmetrical: bool = False,
        doubts: tuple[str, ...] = (),
    ) -> Section:
        """A section within its loops, the first of which is the outline."""
        moments = Moments.none()
        for number, loop in enumerate(loops):
            own = enclosed(loop, _PLANE)
            positive = own if own.area >= 0 else -own
            moments = moments + (positive if number == 0 else -positive)
        return cls(name, moments, *size, is_symmetrical, tuple(tuple(loop) for loop in loops), doubts)

    def outlines(self, tolerance: float) -> list[Array]:
        """Corners (n, 2) [m] of each loop, its curves cut into straight parts to within a tolerance [m]."""
        return [polyline(loop, tolerance)[:, :2] for loop in self.loops]


def read_section(element: Element, quantities: Quantities) -> Section:
    """A section of the catalogue.

    Args:
        element: a `BarSection`.
        quantities: numbers of the file.

    Raises:
        CadError: if a dimension is missing or impossible, or the kind of bar is not known.
    """
    name = element.attributes.get("name") or element.attributes.get("id", "")
    for shape in element.children:
        reader = _READERS.get(shape.name)
        if reader is not None:
            try:
                return reader(name, partial(quantities.positive, shape), shape, quantities)
            except ValueError as problem:
                raise _as_error(quantities, element, problem) from None
    found = ", ".join(child.name for child in element.children[:3]) or "nothing"
    raise quantities.fail(element, f"has no shape that is known, but {found}")


_Get = Callable[[str], float]
_Reader = Callable[[str, _Get, Element, Quantities], Section]


def _as_error(quantities: Quantities, element: Element, problem: ValueError) -> Exception:
    from gantline.cad.errors import CadError

    return problem if isinstance(problem, CadError) else quantities.fail(element, str(problem))


def _polygon(*corners: tuple[float, float]) -> list[Curve]:
    closed = np.array([*corners, corners[0]])
    return [Line(np.concatenate([closed, np.zeros((len(closed), 1))], axis=1))]


def _rectangle(width: float, height: float, inset: float = 0.0) -> list[Curve]:
    low, right, top = inset, width - inset, height - inset
    return _polygon((low, low), (right, low), (right, top), (low, top))


def _need(is_right: bool, what: str) -> None:
    if not is_right:
        raise ValueError(what)


def _flat(name: str, get: _Get, *_: object) -> Section:
    width, height = get("Width"), get("Height")
    return Section.of(name, [_rectangle(width, height)], (width, height))


def _square(name: str, get: _Get, *_: object) -> Section:
    side = get("Height")
    return Section.of(name, [_rectangle(side, side)], (side, side), True)


def _angle(name: str, get: _Get, shape: Element, quantities: Quantities) -> Section:
    """L, with the web overshooting the flange (OW) or the flange the web (OF)."""
    height, width, web, flange = _four(get)
    over = quantities.of_child(shape, "Overshoot") or 0.0
    _need(over >= 0, "has an overshoot below zero")
    above = over if shape.name == "LBarOW" else 0.0
    beside = over if shape.name == "LBarOF" else 0.0
    _need(beside + web <= width, "has an overshoot and a web that are wider than its flange")
    corners = [
        (beside, 0.0),
        (beside + web, 0.0),
        (beside + web, height - flange),
        (width, height - flange),
        (width, height),
        (beside + web, height),
        (beside + web, height + above),
        (beside, height + above),
        (beside, height),
        (0.0, height),
        (0.0, height - flange),
        (beside, height - flange),
    ]
    return Section.of(name, [_polygon(*corners)], (width, height + above))


def _four(get: _Get) -> tuple[float, float, float, float]:
    height, width = get("Height"), get("Width")
    web, flange = get("WebThickness"), get("FlangeThickness")
    _need(web <= width, "has a web that is thicker than the section is wide")
    _need(flange <= height, "has a flange that is thicker than the section is high")
    return height, width, web, flange


def _tee(name: str, get: _Get, *_: object) -> Section:
    height, width, web, flange = _four(get)
    left, right, top = (width - web) / 2, (width + web) / 2, height + flange
    corners = [(left, 0.0), (right, 0.0), (right, height), (width, height), (width, top), (0.0, top)]
    return Section.of(name, [_polygon(*corners, (0.0, height), (left, height))], (width, top), True)


def _eye(name: str, get: _Get, *_: object) -> Section:
    height, width, web, flange = _four(get)
    _need(2 * flange <= height, "has flanges that are thicker than the section is high")
    left, right = (width - web) / 2, (width + web) / 2
    low, high = flange, height - flange
    half = [(0.0, 0.0), (width, 0.0), (width, low), (right, low), (right, high), (width, high)]
    rest = [(width, height), (0.0, height), (0.0, high), (left, high), (left, low), (0.0, low)]
    return Section.of(name, [_polygon(*half, *rest)], (width, height), True)


def _channel(name: str, get: _Get, *_: object) -> Section:
    height, width, web, flange = _four(get)
    _need(2 * flange <= height, "has flanges that are thicker than the section is high")
    low, high = flange, height - flange
    corners = [(0.0, 0.0), (width, 0.0), (width, low), (web, low), (web, high), (width, high)]
    return Section.of(name, [_polygon(*corners, (width, height), (0.0, height))], (width, height))


def _zed(name: str, get: _Get, *_: object) -> Section:
    """Lower flange to one side of the web, upper flange to the other; the width is that of one flange."""
    height, width, web, flange = _four(get)
    _need(2 * flange <= height, "has flanges that are thicker than the section is high")
    left, right, whole = width - web, width, 2 * width - web
    low, high = flange, height - flange
    corners = [(0.0, 0.0), (right, 0.0), (right, high), (whole, high), (whole, height), (left, height)]
    return Section.of(name, [_polygon(*corners, (left, low), (0.0, low))], (whole, height))


def _circle(radius: float, of: float) -> list[Curve]:
    return [Arc.circle(np.array([of, of, 0.0]), np.array([0.0, 0.0, 1.0]), 2 * radius)]


def _round(name: str, get: _Get, *_: object) -> Section:
    diameter = get("Height")
    return Section.of(name, [_circle(diameter / 2, diameter / 2)], (diameter, diameter), True)


def _half_round(name: str, get: _Get, *_: object) -> Section:
    """Part of a disc: its chord stands along the web, its arc rises over it."""
    chord, rise = get("Height"), get("Width")
    low, top = np.zeros(3), np.array([0.0, chord, 0.0])
    arc = Arc.through(low, np.array([rise, chord / 2, 0.0]), top)
    return Section.of(name, [[arc, Line(np.stack([top, low]))]], (rise, chord))


def _tube(name: str, get: _Get, *_: object) -> Section:
    diameter, wall = get("Diameter"), get("Thickness")
    _need(2 * wall <= diameter, "has a wall that is thicker than its radius")
    loops = [_circle(diameter / 2, diameter / 2)]
    if 2 * wall < diameter:
        loops.append(_circle(diameter / 2 - wall, diameter / 2))
    return Section.of(name, loops, (diameter, diameter), True)


def _rectangular_tube(name: str, get: _Get, *_: object) -> Section:
    height, width, wall = get("Height"), get("Width"), get("Thickness")
    _need(2 * wall <= min(width, height), "has a wall that is thicker than half its width")
    loops = [_rectangle(width, height)]
    if 2 * wall < min(width, height):
        loops.append(_rectangle(width, height, wall))
    return Section.of(name, loops, (width, height), True)


def _regular(sides: int) -> _Reader:
    def read(name: str, get: _Get, *_: object) -> Section:
        across = get("Height")
        radius = across / 2 / math.cos(math.pi / sides)
        angles = [math.pi * (2 * k + 1) / sides for k in range(sides)]
        wide = 2 * radius * max(abs(math.cos(angle)) for angle in angles)
        high = 2 * radius * max(abs(math.sin(angle)) for angle in angles)
        corners = [(wide / 2 + radius * math.cos(a), high / 2 + radius * math.sin(a)) for a in angles]
        return Section.of(name, [_polygon(*corners)], (wide, high), True)

    return read


def _bulb(name: str, get: _Get, shape: Element, quantities: Quantities) -> Section:
    """Bulb flat as rolled to EN 10067: one corner radius at the tip and in the throat, lower face at 30°."""
    height, web = get("Height"), get("WebThickness")
    doubts = []
    width = quantities.of_child(shape, "FlangeWidth")
    in_mm = height / _MM
    if width is None:
        width = web + _MM * _linear(in_mm, _BULB_WIDTHS)
        doubts.append(f"section {name}: width of the bulb taken from EN 10067 for its height")
    radius = quantities.of_child(shape, "BulbOuterRadius")
    outer = _MM * _linear(in_mm, _BULB_RADII) if radius is None else radius
    throat = quantities.of_child(shape, "BulbInnerRadius")
    inner = outer if throat is None else throat
    angle = quantities.of_child(shape, "BulbAngle", "angle")
    slope = _BULB_ANGLE if angle is None else angle
    _need(0 < slope < math.pi / 3, "has an angle of its bulb that is not between 0 and 60 degrees")
    _need(width > web, "has a bulb that is not wider than its web")
    return Section.of(
        name, [_bulb_outline(height, web, width, outer, inner, slope)], (width, height), False, tuple(doubts)
    )


def _linear(height: float, values: tuple[float, ...]) -> float:
    """Value at a height [mm], on with the last slope where the table ends."""
    index = int(np.clip(np.searchsorted(_BULB_HEIGHTS, height) - 1, 0, len(_BULB_HEIGHTS) - 2))
    low, high = _BULB_HEIGHTS[index : index + 2]
    share = (height - low) / (high - low)
    return values[index] + share * (values[index + 1] - values[index])


def _bulb_outline(h: float, t: float, width: float, outer: float, inner: float, slope: float) -> list[Curve]:
    """Up the back, over the top, round the tip, down the sloping face, through the throat, down the web."""
    sine, cosine = math.sin(slope), math.cos(slope)
    # The circle at the tip touches the top, the outermost line u = width, and the sloping face at `leaves`.
    tip = np.array([width - outer, h - outer, 0.0])
    leaves = tip + outer * np.array([sine, -cosine, 0.0])
    # The sloping face meets the web at `foot`; the throat rounds that corner, from `back` below it on.
    foot = leaves[1] - (leaves[0] - t) * sine / cosine
    back = inner * math.tan((math.pi / 2 - slope) / 2)
    below = np.array([t, foot - back, 0.0])
    beyond = np.array([t + back * cosine, foot + back * sine, 0.0])
    _need(
        outer >= 0 and inner >= 0 and tip[0] >= t and beyond[0] <= leaves[0] + 1e-12 and below[1] >= 0,
        "has a bulb whose width, radii and height do not fit together",
    )
    middle = np.array([t + inner, foot - back, 0.0])
    curves: list[Curve] = [_line((0.0, 0.0), (t, 0.0), below)]
    if inner > 0:
        curves.append(_corner(middle, below, beyond))
    curves.append(_line(beyond, leaves))
    if outer > 0:
        curves.append(_corner(tip, leaves, tip + np.array([0.0, outer, 0.0])))
    curves.append(_line((tip[0], h), (0.0, h), (0.0, 0.0)))
    return curves


def _line(*points: Array | tuple[float, float]) -> Curve:
    return Line(np.array([[point[0], point[1], 0.0] for point in points]))


def _corner(centre: Array, begin: Array, end: Array) -> Curve:
    """The shorter arc about a centre from one point to another."""
    half = begin + end - 2 * centre
    middle = centre + half / np.linalg.norm(half) * np.linalg.norm(begin - centre)
    return Arc.through(begin, middle, end)


def _user_defined(name: str, _get: _Get, shape: Element, quantities: Quantities) -> Section:
    """By its shape, or by area, neutral axes and second moments of area."""
    from gantline.cad.ocx.geometry import read_contour

    outer = shape.child("SectionOuterShape")
    if outer is not None:
        loops = [
            read_contour(each, quantities)[0] for each in shape.all("SectionOuterShape", "SectionInnerShape")
        ]
        corners = polyline(loops[0], 1e-4)[:, :2]
        low, size = corners.min(axis=0), np.ptp(corners, axis=0)
        shift = np.array([-low[0], -low[1], 0.0])
        moved = [[curve.moved(np.eye(3), shift) for curve in loop] for loop in loops]
        return Section.of(name, moved, (float(size[0]), float(size[1])))
    table = shape.child("SectionProperties")
    if table is None:
        raise ValueError("has neither a shape nor properties")
    area = quantities.positive(table, "Area", "area")
    side = math.sqrt(area)
    return Section.of(
        name,
        [_rectangle(side, side)],
        (side, side),
        True,
        (f"section {name}: only its area is known; it is taken as a square bar",),
    )


_READERS: dict[str, _Reader] = {
    "FlatBar": _flat,
    "BulbFlat": _bulb,
    "LBar": _angle,
    "LBarOW": _angle,
    "LBarOF": _angle,
    "TBar": _tee,
    "IBar": _eye,
    "UBar": _channel,
    "ZBar": _zed,
    "RoundBar": _round,
    "HalfRoundBar": _half_round,
    "SquareBar": _square,
    "HexagonBar": _regular(6),
    "OctagonBar": _regular(8),
    "Tube": _tube,
    "RectangularTube": _rectangular_tube,
    "UserDefinedBarSection": _user_defined,
}
