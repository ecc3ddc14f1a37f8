"""Surfaces that curved plates lie on, as facets."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt

from gantline.cad.ocx.curves import bezier_spans, check_knots, polyline
from gantline.cad.ocx.geometry import read_contour, read_controls, read_degree, read_knots, read_trace
from gantline.cad.ocx.moments import Frame
from gantline.cad.ocx.quantities import Quantities
from gantline.cad.ocx.triangulate import simplified, triangulated
from gantline.cad.ocx.xml import Element

__all__ = ["Surface", "along_edge", "bounds", "read_surface"]

Array = npt.NDArray[np.float64]

_JOIN = 3e-4  # corners of facets that are closer are one [m]: exporters round, and so do normals of faces
_NEIGHBOURS = [(x, y, z) for x in (0, -1, 1) for y in (0, -1, 1) for z in (0, -1, 1)]
_MOST_FACETS = 100_000
_LOOKS = 40  # points of an outline that are looked at
_CIRCLE = 8  # spans of a whole circle


@dataclass(frozen=True, eq=False)
class Surface:
    """A surface in facets.

    Attributes:
        facets: triangles (n, 3, 3) for a number of parts of each of its spans.
        is_faceted: whether it is made of flat faces, so that more parts change nothing.
    """

    facets: Callable[[int], Array]
    is_faceted: bool

    @classmethod
    def of(cls, facets: Callable[[int], Array], is_faceted: bool = False) -> Surface:
        """A surface that makes its facets once for each number of parts."""
        return cls(cache(facets), is_faceted)

    def parts(self, wanted: int) -> int:
        """Parts of each span, as many as wanted unless that were too many facets."""
        once = len(self.facets(1))
        return max(1, min(wanted, math.isqrt(_MOST_FACETS // max(once, 1))))


def read_surface(element: Element, quantities: Quantities) -> Surface | None:
    """A surface of the file; None if it is an unbounded plane, or of a kind that is not read.

    Raises:
        CadError: if it is broken.
    """
    match element.name:
        case "SurfaceCollection":
            return _collection([read_surface(child, quantities) for child in element.children])
        case "Plane3D":
            return _face(element, quantities)
        case "NURBSSurface":
            return _nurbs(element, quantities)
        case "Cylinder3D":
            return _cylinder(element, quantities)
        case "Cone3D":
            return _cone(element, quantities)
        case "Sphere3D":
            return _sphere(element, quantities)
        case "ExtrudedSurface":
            return _extruded(element, quantities)
    return None


def bounds(facets: Array, outline: Array, tolerance: float) -> bool:
    """Whether a closed outline (n, 3) is the edge of a surface of facets, to a tolerance [m]."""
    places = facets.reshape(-1, 3)
    sides = _joined(places, _JOIN).reshape(-1, 3)
    pairs = np.sort(np.stack([sides, np.roll(sides, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    pairs, uses = np.unique(pairs[pairs[:, 0] != pairs[:, 1]], axis=0, return_counts=True)
    edge = pairs[uses == 1]
    if not len(edge):
        return False
    around = np.stack([outline, np.roll(outline, -1, axis=0)], axis=1)
    return (
        _farthest(places[edge].reshape(-1, 3), around) <= tolerance
        and _farthest(outline, places[edge]) <= tolerance
    )


def along_edge(facets: Array, outline: Array) -> Array:
    """Those facets that hang together with one that an outline (n, 3) touches."""
    sides = _joined(facets.reshape(-1, 3), _JOIN).reshape(-1, 3)
    group = np.arange(len(facets))
    # Each takes the least number among its neighbours over a corner, until nothing changes.
    while True:
        least = np.full(3 * len(facets), len(facets))
        np.minimum.at(least, sides.reshape(-1), np.repeat(group, 3))
        spread = least[sides].min(axis=1)
        if np.array_equal(spread, group):
            break
        group = spread
    nearest = {int(np.argmin(_away(facets, point))) for point in outline[:: max(1, len(outline) // _LOOKS)]}
    return facets[np.isin(group, group[sorted(nearest)])]


def _away(facets: Array, point: Array) -> Array:
    """Distance of a point (3,) from each of triangles (n, 3, 3)."""
    ways = np.roll(facets, -1, axis=1) - facets
    normals = np.cross(ways[:, 0], ways[:, 1])
    lengths = np.maximum(np.linalg.norm(normals, axis=1), 1e-300)
    off = point - facets
    above = np.einsum("nci,ni->nc", np.cross(ways, off), normals)
    inside = np.all(above >= 0, axis=1)
    height = np.abs(np.einsum("ni,ni->n", off[:, 0], normals)) / lengths
    squared = np.maximum(np.einsum("nci,nci->nc", ways, ways), 1e-300)
    share = np.clip(np.einsum("nci,nci->nc", off, ways) / squared, 0.0, 1.0)
    beside = np.linalg.norm(off - share[:, :, None] * ways, axis=2).min(axis=1)
    return np.asarray(np.where(inside, height, beside))


def _joined(points: Array, tolerance: float) -> npt.NDArray[np.int64]:
    """For each point (n, 3) the first that is closer than a tolerance [m]; itself if none is before it."""
    cells = np.floor(points / tolerance).astype(np.int64)
    first: dict[tuple[int, int, int], list[int]] = {}
    found = np.arange(len(points))
    for index, (x, y, z) in enumerate(cells.tolist()):
        near = (
            other
            for dx, dy, dz in _NEIGHBOURS
            for other in first.get((x + dx, y + dy, z + dz), ())
            if float(np.abs(points[other] - points[index]).max()) <= tolerance
        )
        match = next(near, None)
        if match is None:
            first.setdefault((x, y, z), []).append(index)
        else:
            found[index] = match
    return found


def _farthest(points: Array, lines: Array) -> float:
    """Largest distance of points (n, 3) from the nearest of straight lines (m, 2, 3)."""
    begin, way = lines[:, 0], lines[:, 1] - lines[:, 0]
    squared = np.maximum(np.einsum("mi,mi->m", way, way), 1e-300)
    worst = 0.0
    for point in points:
        share = np.clip(np.einsum("mi,mi->m", point - begin, way) / squared, 0.0, 1.0)
        away = np.linalg.norm(begin + share[:, None] * way - point, axis=1)
        worst = max(worst, float(away.min()))
    return worst


def _collection(members: list[Surface | None]) -> Surface | None:
    known = [member for member in members if member is not None]
    if not known:
        return None
    return Surface.of(
        lambda parts: np.concatenate([member.facets(parts) for member in known]),
        all(member.is_faceted for member in known),
    )


def _face(element: Element, quantities: Quantities) -> Surface | None:
    """A plane with a boundary: its polygon."""
    boundary = element.child("FaceBoundaryCurve")
    if boundary is None:
        return None
    path, _ = read_contour(boundary, quantities)
    frame = Frame.across(quantities.point_of(element, "Origin"), quantities.direction(element, "Normal"))
    flat = simplified(frame.flat(polyline(path, 1e-4)), 1e-5)
    if len(flat) < 3:
        return None
    corners, triangles = triangulated(flat)
    facets = frame.spatial(corners)[triangles]
    return Surface.of(lambda _: facets, True)


def _grid(points: Array) -> Array:
    """Triangles (n, 3, 3) over a grid of points (u, v, 3)."""
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    pairs = np.stack([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)], axis=2)
    return np.asarray(pairs.reshape(-1, 3, 3))


def _nurbs(element: Element, quantities: Quantities) -> Surface:
    points, weights = read_controls(element, quantities)
    degrees = [read_degree(element, quantities, f"{axis}_NURBSproperties") for axis in "UV"]
    knots = [read_knots(element, quantities, f"{axis}knotVector") for axis in "UV"]
    counts = [len(knot) - degree - 1 for knot, degree in zip(knots, degrees, strict=True)]
    try:
        for degree, knot, count in zip(degrees, knots, counts, strict=True):
            check_knots(degree, knot, count)
        if counts[0] * counts[1] != len(points):
            raise ValueError(f"has {len(points)} control points, not {counts[0]} times {counts[1]}")
        if not np.all(weights > 0):
            raise ValueError("has a control point whose weight is not positive")
    except ValueError as problem:
        raise quantities.fail(element, str(problem)) from None
    net = np.concatenate([points * weights[:, None], weights[:, None]], axis=1)
    net = _shorter(net, *counts)
    along = bezier_spans(degrees[0], knots[0], net.reshape(counts[0], -1))
    spans = along.reshape(len(along), degrees[0] + 1, counts[1], 4)
    return Surface.of(lambda parts: _bezier_facets(spans, degrees, knots[1], parts))


def _shorter(net: Array, first: int, second: int) -> Array:
    """Control points (first, second, 4): OCX does not say which run on, but the wrong way zigzags."""
    ways = (net.reshape(second, first, 4).transpose(1, 0, 2), net.reshape(first, second, 4))
    return min(ways, key=lambda way: sum(float(np.abs(np.diff(way, axis=axis)).sum()) for axis in (0, 1)))


def _bezier_facets(spans: Array, degrees: list[int], knots: Array, parts: int) -> Array:
    places = np.arange(parts + 1) / parts
    facets = []
    for span in spans:
        in_v = bezier_spans(degrees[1], knots, span.transpose(1, 0, 2).reshape(span.shape[1], -1))
        for patch in in_v.reshape(len(in_v), degrees[1] + 1, degrees[0] + 1, 4):
            rows = np.einsum("pi,ijk->pjk", _powers(degrees[1], places), patch)
            grid = np.einsum("qj,pjk->qpk", _powers(degrees[0], places), rows)
            facets.append(_grid(grid[..., :3] / grid[..., 3:]))
    return np.concatenate(facets)


def _powers(degree: int, places: Array) -> Array:
    return np.stack(
        [math.comb(degree, i) * places**i * (1 - places) ** (degree - i) for i in range(degree + 1)], axis=1
    )


def _round(at: Callable[[Array, Array], Array], straight: bool) -> Surface:
    """Facets over an angle from 0 to 2π and a place from 0 to 1."""

    def facets(parts: int) -> Array:
        angles = np.linspace(0.0, 2 * math.pi, _CIRCLE * parts + 1)
        places = np.linspace(0.0, 1.0, 2 if straight else 4 * parts + 1)
        return _grid(at(angles[:, None, None], places[None, :, None]))

    return Surface.of(facets)


def _around(axis: Array) -> tuple[Array, Array]:
    frame = Frame.across(np.zeros(3), axis)
    return frame.first, frame.second


def _cylinder(element: Element, quantities: Quantities) -> Surface:
    origin, axis = quantities.point_of(element, "Origin"), quantities.direction(element, "Axis")
    radius, height = quantities.positive(element, "Radius"), quantities.needed(element, "Height")
    one, two = _around(axis)
    return _round(
        lambda angle, place: (
            origin + place * height * axis + radius * (np.cos(angle) * one + np.sin(angle) * two)
        ),
        True,
    )


def _cone(element: Element, quantities: Quantities) -> Surface:
    origin, tip = quantities.point_of(element, "Origin"), quantities.point_of(element, "Tip")
    base, top = quantities.positive(element, "BaseRadius"), quantities.of_child(element, "TipRadius") or 0.0
    length = float(np.linalg.norm(tip - origin))
    if not length > 0:
        raise quantities.fail(element, "has its tip at its origin")
    one, two = _around((tip - origin) / length)
    return _round(
        lambda angle, place: (
            origin
            + place * (tip - origin)
            + (base + place * (top - base)) * (np.cos(angle) * one + np.sin(angle) * two)
        ),
        True,
    )


def _sphere(element: Element, quantities: Quantities) -> Surface:
    origin, radius = quantities.point_of(element, "Origin"), quantities.positive(element, "Radius")
    one, two, up = np.eye(3)

    def at(angle: Array, place: Array) -> Array:
        height = math.pi * (place - 0.5)
        ring = np.cos(height) * (np.cos(angle) * one + np.sin(angle) * two)
        return np.asarray(origin + radius * (ring + np.sin(height) * up))

    return _round(at, False)


def _extruded(element: Element, quantities: Quantities) -> Surface | None:
    """A curve moved along a straight line; other sweeps are not read."""
    base, sweep = element.child("BaseCurve"), element.child("Sweep")
    if base is None or sweep is None:
        return None
    path, _ = read_trace(base, quantities)
    way = quantities.direction(sweep, "Vector3D") * quantities.needed(sweep, "SweepLength")

    def facets(parts: int) -> Array:
        line = np.concatenate(
            [curve.evaluate(np.arange(4 * parts) / (4 * parts))[0].reshape(-1, 3) for curve in path]
            + [path[-1].end[None]]
        )
        return _grid(np.stack([line, line + way], axis=1))

    return Surface.of(facets)
