"""Flat areas as triangles, and thin bodies around them, to draw and to touch.

Ears are cut off one after another (Meisters, American Mathematical Monthly 82, 1975); openings are joined
to the rim by a bridge first (Eberly, Triangulation by ear clipping, 2002). Weights never come from these
triangles.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

__all__ = ["prism", "simplified", "triangulated"]

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]

_ASKEW = np.array([0.36, 0.48, 0.80])  # along no axis
_MOST_CORNERS = 2000  # of one polygon
_BRIDGES = 1000  # that are tried, from the shortest on


def simplified(points: Array, tolerance: float) -> Array:
    """A closed polygon (n, 2) without the corners that its sides miss by less than a tolerance [m]."""
    if len(points) > 1 and np.linalg.norm(points[0] - points[-1]) <= tolerance:
        points = points[:-1]
    if len(points) <= 3:
        return points
    kept = _kept(points, tolerance)
    while len(kept) > _MOST_CORNERS:  # whoever draws a line so fine will not miss it
        tolerance *= 2.0
        kept = _kept(points, tolerance)
    return kept


def _kept(points: Array, tolerance: float) -> Array:
    far = int(np.argmax(np.linalg.norm(points - points[0], axis=1)))
    halves = (points[: far + 1], np.concatenate([points[far:], points[:1]]))
    return np.concatenate([_thinned(half, tolerance)[:-1] for half in halves])


def _thinned(points: Array, tolerance: float) -> Array:
    """Douglas and Peucker, Cartographica 10 (1973): ends kept, and what is further off their chord."""
    keep = np.zeros(len(points), dtype=bool)
    keep[[0, -1]] = True
    stack = [(0, len(points) - 1)]
    while stack:
        low, high = stack.pop()
        if high - low < 2:
            continue
        way = points[high] - points[low]
        between = points[low + 1 : high] - points[low]
        length = float(np.hypot(*way))
        if length > 0:
            away = np.abs(way[0] * between[:, 1] - way[1] * between[:, 0]) / length
        else:
            away = np.linalg.norm(between, axis=1)
        worst = int(np.argmax(away))
        if away[worst] > tolerance:
            keep[low + 1 + worst] = True
            stack += [(low, low + 1 + worst), (low + 1 + worst, high)]
    return points[keep]


def triangulated(rim: Array, holes: Sequence[Array] = ()) -> tuple[Array, Whole]:
    """Triangles of a polygon with openings.

    Args:
        rim: corners (n, 2), in either direction.
        holes: corners of each opening (k, 2); they lie within the rim and apart from one another.

    Returns:
        all corners, rim first (m, 2), and triangles over them (t, 3), anticlockwise.
    """
    loops = [rim if _area(rim) >= 0 else rim[::-1]]
    loops += [hole if _area(hole) <= 0 else hole[::-1] for hole in holes]
    points = np.concatenate(loops)
    starts = np.cumsum([0, *map(len, loops)])
    rings = [list(range(starts[which], starts[which + 1])) for which in range(len(loops))]
    chain, rest = rings[0], sorted(rings[1:], key=lambda ring: -float(points[ring, 0].max()))
    while rest:
        chain = _bridged(points, chain, rest[0], rest)
        rest = rest[1:]
    return points, _ears(points, chain)


def _area(loop: Array) -> float:
    following = np.roll(loop, -1, axis=0)
    return float((loop[:, 0] * following[:, 1] - loop[:, 1] * following[:, 0]).sum()) / 2


def _bridged(points: Array, chain: list[int], hole: list[int], rings: list[list[int]]) -> list[int]:
    """A rim with an opening let into it, over the shortest bridge that crosses neither rim nor openings."""
    begins = points[[*chain, *(corner for ring in rings for corner in ring)]]
    following = [*chain[1:], chain[0], *(corner for ring in rings for corner in [*ring[1:], ring[0]])]
    ends = points[following]
    away = np.linalg.norm(points[hole][:, None] - points[chain][None], axis=2)
    order = np.argsort(away, axis=None, kind="stable")
    for pair in order[:_BRIDGES]:
        begin, at = divmod(int(pair), len(chain))
        if not _is_cut(points[hole[begin]], points[chain[at]], begins, ends):
            break
    else:
        begin, at = divmod(int(order[0]), len(chain))
    return [*chain[: at + 1], *hole[begin:], *hole[: begin + 1], *chain[at:]]


def _is_cut(one: Array, other: Array, begins: Array, ends: Array) -> bool:
    """Whether a line crosses any of these sides between their ends."""

    def side(a: Array, b: Array, c: Array) -> Array:
        return np.asarray(
            (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1])
            - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])
        )

    apart = side(one, other, begins) * side(one, other, ends) < 0
    return bool(np.any(apart & (side(begins, ends, one) * side(begins, ends, other) < 0)))


def _ears(points: Array, chain: list[int]) -> Whole:
    triangles: list[tuple[int, int, int]] = []
    left = np.array(chain)
    at = 0
    misses = 0
    while len(left) > 3:
        at %= len(left)
        before, here, after = left[at - 1], left[at], left[(at + 1) % len(left)]
        a, b, c = points[before], points[here], points[after]
        turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        # After a whole round without an ear, what is left is degenerate: any corner will do.
        if misses > len(left) or (
            turn > 0 and not _holds_any(a, b, c, points[left], left, (before, here, after))
        ):
            if turn > 0:
                triangles.append((int(before), int(here), int(after)))
            left = np.delete(left, at)
            misses = 0
            at -= 1
        else:
            at += 1
            misses += 1
    if len(left) == 3:
        triangles.append((int(left[0]), int(left[1]), int(left[2])))
    return np.array(triangles, dtype=np.int64).reshape(-1, 3)


def _holds_any(a: Array, b: Array, c: Array, others: Array, which: Whole, own: tuple[int, int, int]) -> bool:
    """Whether a triangle holds any other corner, on its sides too; corners at the same place are its own."""
    x, y = others.T
    (ax, ay), (bx, by), (cx, cy) = a.tolist(), b.tolist(), c.tolist()
    inside = (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0
    inside &= (cx - bx) * (y - by) - (cy - by) * (x - bx) >= 0
    inside &= (ax - cx) * (y - cy) - (ay - cy) * (x - cx) >= 0
    within = np.flatnonzero(inside)
    corners = {(ax, ay), (bx, by), (cx, cy)}
    apart = (at for at in within.tolist() if (float(x[at]), float(y[at])) not in corners)
    return any(int(which[at]) not in own for at in apart)


def prism(loops: Sequence[Array], cap: Whole, stations: Array) -> tuple[Array, Whole]:
    """A closed body between two caps, swept over stations.

    Args:
        loops: number of corners is what counts: rim and openings, as `triangulated` orders and turns them.
        cap: triangles over the corners (t, 3), anticlockwise seen against the direction of the sweep.
        stations: where the corners are at each station (stations, corners, 3) [m].

    Returns:
        vertices (n, 3) and triangles (m, 3), anticlockwise seen from outside.
    """
    count = stations.shape[1]
    last = (len(stations) - 1) * count
    triangles = [cap[:, ::-1], cap + last]
    start = 0
    # Opposite faces of a thin web get parallel diagonals: where it twists, both bulge to one side.
    rank = stations[0] @ _ASKEW
    for loop in loops:
        own = start + np.arange(len(loop))
        following = start + (np.arange(len(loop)) + 1) % len(loop)
        is_up = (rank[own] <= rank[following])[:, None]
        for station in range(len(stations) - 1):
            low, high = station * count, (station + 1) * count
            a, b, c, d = own + low, following + low, following + high, own + high
            one = np.where(is_up, np.stack([a, b, c], axis=1), np.stack([a, b, d], axis=1))
            other = np.where(is_up, np.stack([a, c, d], axis=1), np.stack([b, c, d], axis=1))
            triangles += [one, other]
        start += len(loop)
    return stations.reshape(-1, 3), np.concatenate(triangles)
