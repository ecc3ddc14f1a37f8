"""Curves of an OCX file: each kind of `Curve3D`, and contours made of several."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from gantline.cad.errors import CadError
from gantline.cad.ocx.curves import Arc, Curve, Line, Spline, chained
from gantline.cad.ocx.quantities import Quantities
from gantline.cad.ocx.xml import Element

__all__ = ["read_contour", "read_controls", "read_trace"]

Array = npt.NDArray[np.float64]

#: Ends that are closer belong together [m]; the files' own tolerances are a micrometre to a millimetre.
JOIN = 1e-3
#: Bounds of one contour, and of one curve or surface.
MOST_CURVES = 10_000
MOST_CONTROLS = 40_000
_SHORTEST = 1e-9
_CURVES = {
    "Line3D",
    "PolyLine3D",
    "CircumArc3D",
    "CircumCircle3D",
    "Circle3D",
    "Ellipse3D",
    "NURBS3D",
    "CompositeCurve3D",
}


def read_contour(element: Element, quantities: Quantities) -> tuple[list[Curve], float]:
    """Curves of a closed contour in a row, and the widest gap between them [m], from end to start included.

    Args:
        element: what holds curves, such as `OuterContour`.
        quantities: numbers of the file.

    Raises:
        CadError: if it has no curve, or one that cannot be read.
    """
    path, gap = read_trace(element, quantities)
    return path, max(gap, float(np.linalg.norm(path[-1].end - path[0].start)))


def read_trace(element: Element, quantities: Quantities) -> tuple[list[Curve], float]:
    """As `read_contour`, of a path that may be open: its curves, and the widest gap between them [m]."""
    curves = _curves(element, quantities)
    if len(curves) > MOST_CURVES:
        raise quantities.fail(element, f"has {len(curves)} curves; at most {MOST_CURVES} are read")
    path, gap = chained(curves, JOIN)
    if not path:
        raise quantities.fail(element, "has no curve")
    return path, gap


def _curves(element: Element, quantities: Quantities) -> list[Curve]:
    curves: list[Curve] = []
    for child in element.children:
        if child.name == "CompositeCurve3D":
            curves += _curves(child, quantities)
        elif child.name in _CURVES:
            curve = _curve(child, quantities)
            if curve.length > _SHORTEST:
                curves.append(curve)
    return curves


def _curve(element: Element, quantities: Quantities) -> Curve:
    match element.name:
        case "Line3D":
            ends = [quantities.point_of(element, name) for name in ("StartPoint", "EndPoint")]
            return Line(np.stack(ends))
        case "PolyLine3D":
            return _polyline(element, quantities)
        case "CircumArc3D":
            names = ("StartPoint", "IntermediatePoint", "EndPoint")
            return Arc.through(*(quantities.point_of(element, name) for name in names))
        case "CircumCircle3D":
            return _circle_through(element, quantities)
        case "Circle3D":
            return Arc.circle(
                quantities.point_of(element, "Center"),
                quantities.direction(element, "Normal"),
                quantities.positive(element, "Diameter"),
            )
        case "Ellipse3D":
            return _ellipse(element, quantities)
        case _:
            return _nurbs(element, quantities)


def _polyline(element: Element, quantities: Quantities) -> Curve:
    points = [quantities.point(point) for point in element.all("Point3D")]
    if len(points) < 2:
        raise quantities.fail(element, "has fewer than two points")
    if element.attributes.get("isClosed") in ("true", "1"):
        points.append(points[0])
    return Line(np.stack(points))


def _circle_through(element: Element, quantities: Quantities) -> Curve:
    holder = element.child("Positions") or element
    points = [quantities.point(point) for point in holder.all("Point3D")]
    if len(points) != 3:
        raise quantities.fail(element, f"has {len(points)} points, not three")
    arc = Arc.through(*points)
    if not isinstance(arc, Arc):
        raise quantities.fail(element, "has three points in a row, through which no circle goes")
    return Arc(arc.centre, arc.first, arc.second, 0.0, 2 * math.pi)


def _ellipse(element: Element, quantities: Quantities) -> Curve:
    major = quantities.direction(element, "MajorAxis") * quantities.positive(element, "MajorDiameter") / 2
    minor = quantities.direction(element, "MinorAxis") * quantities.positive(element, "MinorDiameter") / 2
    return Arc(quantities.point_of(element, "Center"), major, minor, 0.0, 2 * math.pi)


def read_controls(element: Element, quantities: Quantities) -> tuple[Array, Array]:
    """Control points (n, 3) [m] and their weights (n,) of all lists within an element.

    Raises:
        CadError: if there are none, or too many.
    """
    points, weights = [], []
    for each in (point for table in element.all("ControlPtList") for point in table.all("ControlPoint")):
        points.append(quantities.point(each))
        weight = each.attributes.get("weight")
        weights.append(1.0 if weight is None else float(quantities.numbers(each, "weight", 1)[0]))
    if not points:
        raise quantities.fail(element, "has no control points")
    if len(points) > MOST_CONTROLS:
        raise quantities.fail(element, f"has {len(points)} control points; at most {MOST_CONTROLS} are read")
    return np.stack(points), np.array(weights)


def read_degree(element: Element, quantities: Quantities, name: str) -> int:
    """Degree of a NURBS as its properties say it; CadError if they do not."""
    properties = element.child(name)
    text = "" if properties is None else properties.attributes.get("degree", "")
    try:
        return int(text)
    except ValueError:
        raise quantities.fail(element, f"has '{text[:20]}' as degree in its {name}") from None


def read_knots(element: Element, quantities: Quantities, name: str) -> Array:
    """Knot vector of a child, shape (knots,); CadError if there is none."""
    child = element.child(name)
    if child is None:
        raise quantities.fail(element, f"has no {name}")
    return quantities.numbers(child, "value")


def _nurbs(element: Element, quantities: Quantities) -> Curve:
    points, weights = read_controls(element, quantities)
    degree = read_degree(element, quantities, "NURBSproperties")
    knots = read_knots(element, quantities, "KnotVector")
    try:
        return Spline.nurbs(degree, knots, points, weights)
    except CadError:
        raise
    except ValueError as problem:
        raise quantities.fail(element, str(problem)) from None
