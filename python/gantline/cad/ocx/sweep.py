"""Bars: a section swept along a trace line, straight or curved, upright or twisted.

At the arc length s the trace r(s) has the unit tangent t, and the section lies in the plane across it with
f along its flange and w along its web. A point of the bar is x = r + u f + v w, and a small piece of it has
the volume (1 − u f·t′ − v w·t′) du dv ds: curvature makes the inside shorter (Pappus), twist changes
nothing. With the moments of the section up to third order, mass, first and second moments are integrals
over s alone. `docs/concepts/cad.md` derives it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh
from gantline.cad.ocx.curves import Curve, gauss
from gantline.cad.ocx.moments import Moments, kept_half, of_polygon
from gantline.cad.ocx.section import Section
from gantline.cad.ocx.triangulate import prism, simplified, triangulated

__all__ = ["Bar", "BarError", "EndCut", "Inclination", "swept"]

Array = npt.NDArray[np.float64]

_POINTS = 12  # Gauss points along a smooth span
_TWISTED_PARTS = 4  # of a span whose section turns between given inclinations
_STRAIGHT = 1e-9


class BarError(ValueError):
    """A bar cannot be made; the message says what it has."""


@dataclass(frozen=True, eq=False)
class Inclination:
    """How the section stands at a place of the trace.

    Attributes:
        web: direction (3,) of the web.
        flange: direction (3,) of the flange; None if the file leaves it open.
        place: (3,) [m].
    """

    web: Array
    flange: Array | None
    place: Array


@dataclass(frozen=True)
class EndCut:
    """How an end of a bar is cut: back by a distance, and sniped from a nose upwards.

    At the height v of its section the bar ends before its trace by cutback + (v − nose)/tan(angle), the last
    term where v is above the nose.

    Attributes:
        cutback: [m].
        angle: of the slope with the trace, π/2 for a square end [rad].
        nose: height at the end that is not sniped [m].
    """

    cutback: float = 0.0
    angle: float = math.pi / 2
    nose: float = 0.0

    def short(self, height: npt.ArrayLike) -> Array:
        """By how much the bar ends before its trace at heights of its section [m]."""
        above = np.maximum(np.asarray(height, dtype=float) - self.nose, 0.0)
        return np.asarray(self.cutback + above / math.tan(self.angle))


@dataclass(frozen=True, eq=False)
class Bar:
    """What comes out: weight, and triangles around it."""

    properties: MassProperties
    mesh: TriangleMesh
    doubts: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class _Stations:
    """Places along a trace in order: (n, 3) each, arc lengths and weights (n,), none at ends of spans."""

    places: Array
    tangents: Array
    bends: Array  # t′ = dt/ds
    arc: Array
    weights: Array  # ds


def swept(
    trace: Sequence[Curve],
    section: Section,
    offset: Array,
    inclinations: Sequence[Inclination],
    density: float,
    tolerance: float,
    ends: tuple[EndCut | None, EndCut | None] = (None, None),
) -> Bar:
    """A bar along a trace.

    Args:
        trace: curves in a row.
        section: what is swept.
        offset: of the section's corner from the trace along flange and web (2,) [m].
        inclinations: how it stands, at least one.
        density: [kg/m^3].
        tolerance: by how much triangles may miss the body [m].
        ends: how it is cut where the trace starts and where it ends; None for square.

    Raises:
        BarError: if the web runs along the trace, or nothing is left of the bar.
    """
    moments = section.moments.shifted(offset)
    stations = _stations(trace, _TWISTED_PARTS if len(inclinations) > 1 else 1)
    webs, flanges, doubts = _frames(stations, inclinations)
    used = stations.weights > 0
    if not used.any():
        raise BarError("has a trace line without length")
    origin = stations.places[used].mean(axis=0)
    axes = np.stack([flanges, webs], axis=2)
    # Along and across the bar: curvature makes the inside shorter.
    bend = np.einsum("nik,ni->nk", axes[used], stations.bends[used])  # f·t′, w·t′
    area = moments.area - bend @ moments.first
    if not np.all(area > 0):
        doubts.append("its trace is bent more sharply than its section is deep, so parts of it overlap")
    total = _integrals(
        stations.places[used] - origin,
        axes[used],
        stations.weights[used],
        area,
        moments.first - bend @ moments.second,
        moments.second - np.einsum("nk,kij->nij", bend, moments.third),
    )
    for end, cut in zip((0, -1), ends, strict=True):
        if cut is not None:
            total = total - _removed(section, offset, cut, stations, axes[end], end, origin, doubts)
    mesh = _mesh(section, offset, stations, axes, tolerance, ends)
    return Bar(_weighed(total, origin, density), mesh, tuple(doubts))


@dataclass(frozen=True, eq=False)
class _Integrals:
    """Volume [m^3], ∫ x dV (3,) and ∫ x xᵀ dV (3, 3) about an origin."""

    volume: float
    first: Array
    second: Array

    def __sub__(self, other: _Integrals) -> _Integrals:
        return _Integrals(self.volume - other.volume, self.first - other.first, self.second - other.second)


def _integrals(
    places: Array, axes: Array, weights: Array, area: Array, first: Array, second: Array
) -> _Integrals:
    """Sums over slices: places (n, 3), axes (n, 3, 2), depths (n,), and moments of each in its axes."""
    out = np.einsum("nij,nj->ni", axes, first)
    mixed = np.einsum("n,ni,nj->ij", weights, places, out)
    return _Integrals(
        float(weights @ area),
        weights @ (places * area[:, None] + out),
        np.einsum("n,ni,nj->ij", weights * area, places, places)
        + mixed
        + mixed.T
        + np.einsum("n,nik,nkl,njl->ij", weights, axes, second, axes),
    )


def _removed(
    section: Section,
    offset: Array,
    cut: EndCut,
    stations: _Stations,
    axes: Array,
    end: int,
    origin: Array,
    doubts: list[str],
) -> _Integrals:
    """What an end cut takes away, slice by slice from the end of the trace; the trace is straight there."""
    reach = float(cut.short(section.height))
    length = float(stations.weights.sum())
    if reach > length / 2:
        raise BarError(f"has an end cut that is {reach:.3g} m long on a trace line of {length:.3g} m")
    zone = np.abs(stations.arc - stations.arc[end]) <= reach
    if float(np.abs(stations.tangents[zone] - stations.tangents[end]).max()) > 1e-3:
        doubts.append("its trace line is bent where an end is cut: the cut is taken as on a straight one")
    at, share = gauss(3)
    # The cut passes corners of the section at heights between which moments are polynomials of its place.
    corners = np.unique(np.concatenate([loop[:, 1] for loop in section.outlines(1e-5)]))
    knots = np.unique(np.concatenate([[0.0], cut.short(corners), [reach]]))
    begin, step = knots[:-1, None], np.diff(knots)[:, None]
    along = (begin + step * at).reshape(-1)
    weights = (step * share).reshape(-1)
    inward = stations.tangents[end] * (1.0 if end == 0 else -1.0)
    places = stations.places[end] - origin + along[:, None] * inward
    slices = [_above(section, cut, float(here)).shifted(offset) for here in along]
    return _integrals(
        places,
        np.broadcast_to(axes, (len(along), 3, 2)),
        weights,
        np.array([each.area for each in slices]),
        np.stack([each.first for each in slices]),
        np.stack([each.second for each in slices]),
    )


def _above(section: Section, cut: EndCut, along: float) -> Moments:
    """Moments of the part of a section that a cut takes at a distance from the end of the trace."""
    if along <= cut.cutback:
        return section.moments
    height = cut.nose + (along - cut.cutback) * math.tan(cut.angle)
    total = Moments.none()
    for number, loop in enumerate(section.outlines(1e-5)):
        own = of_polygon(kept_half(loop, loop[:, 1] - height))
        positive = own if own.area >= 0 else -own
        total = total + (positive if number == 0 else -positive)
    return total


def _weighed(total: _Integrals, origin: Array, density: float) -> MassProperties:
    if not total.volume > 0:
        raise BarError("has no volume: its section or its trace line is empty")
    centre = total.first / total.volume
    about = total.second - total.volume * np.outer(centre, centre)
    about = (about + about.T) / 2
    inertia = density * (np.trace(about) * np.eye(3) - about)
    return MassProperties(density * total.volume, origin + centre, inertia)


def _stations(trace: Sequence[Curve], parts: int) -> _Stations:
    """Gauss points of each part of each span, and the ends of the parts without weight."""
    at, share = gauss(_POINTS)
    places = np.concatenate([[0.0], at, [1.0]])
    local = (np.arange(parts)[:, None] + places[None, :]).reshape(-1) / parts
    weight = np.tile(np.concatenate([[0.0], share, [0.0]]) / parts, parts)
    rows: list[tuple[Array, Array, Array, Array]] = []
    for curve in trace:
        points, along, bend = curve.evaluate(local)
        speed = np.linalg.norm(along, axis=2, keepdims=True)
        if not np.all(speed > 0):
            speed = np.maximum(speed, 1e-300)
        tangent = along / speed
        across = (bend - np.sum(bend * tangent, axis=2, keepdims=True) * tangent) / speed**2
        rows += [
            (points[span], tangent[span], across[span], speed[span, :, 0] * weight)
            for span in range(len(points))
        ]
    places3, tangents, bends, weights = (np.concatenate(column) for column in zip(*rows, strict=True))
    # Gauss points see the length up to them by half their own weight more than those before: good enough to
    # interpolate a twist.
    arc = np.cumsum(weights) - weights / 2
    return _Stations(places3, tangents, bends, arc, weights)


def _frames(stations: _Stations, inclinations: Sequence[Inclination]) -> tuple[Array, Array, list[str]]:
    """Directions of web and flange (n, 3) at each station, and doubts."""
    doubts: list[str] = []
    nearest = [int(np.argmin(np.linalg.norm(stations.places - each.place, axis=1))) for each in inclinations]
    carried = _carried(stations, nearest[0], inclinations[0].web)
    side = np.cross(stations.tangents, carried)
    # Angle of each given web about the tangent, from the one that is carried along without turning.
    angles = []
    for place, each in zip(nearest, inclinations, strict=True):
        up, over = float(each.web @ carried[place]), float(each.web @ side[place])
        if math.hypot(up, over) < 0.05:
            raise BarError("has a web that runs along its trace line")
        angles.append(math.atan2(over, up))
    order = np.argsort([stations.arc[place] for place in nearest], kind="stable")
    known = np.unwrap(np.array(angles)[order])
    turn = np.interp(stations.arc, stations.arc[np.array(nearest)[order]], known)[:, None]
    web = np.cos(turn) * carried + np.sin(turn) * side
    hand = _hand(stations, inclinations, nearest, doubts)
    return web, hand * np.cross(stations.tangents, web), doubts


def _hand(
    stations: _Stations, inclinations: Sequence[Inclination], nearest: list[int], doubts: list[str]
) -> float:
    """+1 where the flange points along tangent × web, −1 where against it."""
    hands = [
        float(np.cross(stations.tangents[place], each.web) @ each.flange)
        for place, each in zip(nearest, inclinations, strict=True)
        if each.flange is not None
    ]
    if not hands:
        return 1.0
    if min(abs(hand) for hand in hands) < 0.05:
        doubts.append("its flange is not said to point across its trace line")
    if min(hands) < 0 < max(hands):
        doubts.append("its flange is said to point to either side at different places; the first counts")
    return math.copysign(1.0, hands[0])


def _carried(stations: _Stations, start: int, web: Array) -> Array:
    """A direction carried along the trace from a station, square to it and without turning about it (n, 3).

    From station to station by two reflections (Wang, Jüttler, Zheng, Liu, ACM Transactions on Graphics 27,
    2008).
    """
    tangents, places = stations.tangents, stations.places
    first = web - (web @ tangents[start]) * tangents[start]
    size = float(np.linalg.norm(first))
    if size < 0.05:
        raise BarError("has a web that runs along its trace line")
    out = np.empty_like(tangents)
    out[start] = first / size
    if float(np.abs(tangents - tangents[start]).max()) < _STRAIGHT:
        out[:] = out[start]
        return out
    for steps in (range(start, len(tangents) - 1), range(start, 0, -1)):
        onward = 1 if steps.step > 0 else -1
        for here in steps:
            there = here + onward
            out[there] = _reflected(places[there] - places[here], tangents[here], tangents[there], out[here])
    return out


def _reflected(way: Array, tangent: Array, following: Array, web: Array) -> Array:
    length = float(way @ way)
    if length > 1e-24:
        web = web - 2.0 / length * (way @ web) * way
        tangent = tangent - 2.0 / length * (way @ tangent) * way
    else:
        # A kink: the two reflections of a rotation from one tangent to the other.
        tangent, web = -tangent, web - 2.0 * (tangent @ web) * tangent
    change = following - tangent
    size = float(change @ change)
    if size > 1e-24:
        web = web - 2.0 / size * (change @ web) * change
    web = web - (web @ following) * following
    return np.asarray(web / np.linalg.norm(web))


def _mesh(
    section: Section,
    offset: Array,
    stations: _Stations,
    axes: Array,
    tolerance: float,
    ends: tuple[EndCut | None, EndCut | None],
) -> TriangleMesh:
    loops = [simplified(loop, tolerance) for loop in section.outlines(tolerance)]
    corners, cap = triangulated(loops[0], loops[1:])
    heights = corners[:, 1]
    corners = corners + offset
    kept = _shown(stations, axes[:, :, 1], tolerance, float(np.abs(corners).max()))
    where = stations.places[kept][:, None, :] + np.einsum("nik,ck->nci", axes[kept], corners)
    for end, cut, inward in zip((0, -1), ends, (1.0, -1.0), strict=True):
        if cut is not None:
            where[end] += inward * cut.short(heights)[:, None] * stations.tangents[end]
    # Seen along the tangent, f and w turn anticlockwise if f × w points along it.
    if float(np.cross(axes[0, :, 0], axes[0, :, 1]) @ stations.tangents[0]) < 0:
        where = where[::-1]
    vertices, triangles = prism(loops, cap, where)
    return TriangleMesh(vertices, triangles)


def _shown(stations: _Stations, webs: Array, tolerance: float, reach: float) -> npt.NDArray[np.int64]:
    """Stations that triangles need: the ends, and each without which they would miss the body.

    A chord d long over a bend by φ misses by φ d/8, d longer by the reach of the section. Over a twist by φ
    the two triangles of a side miss by φ/4 of its width.
    """
    kept = [0]
    for station in range(1, len(webs) - 1):
        last = kept[-1]
        bend = float(np.linalg.norm(stations.tangents[station] - stations.tangents[last]))
        chord = float(np.linalg.norm(stations.places[station] - stations.places[last])) + reach * bend
        twist = abs(float(np.cross(stations.tangents[last], webs[last]) @ webs[station]))
        if bend * chord / 8 > tolerance or twist * reach / 4 > tolerance:
            kept.append(station)
    return np.array([*kept, len(webs) - 1])
