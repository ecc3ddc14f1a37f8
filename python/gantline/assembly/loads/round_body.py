"""A round load cut into flat sides, for pictures, hulls that meet and what lies on supports.

Corners lie on the rims, so a body of n sides is within the round one, by (RL5) of
docs/concepts/round_loads.md: radius times 1 − cos(π/n).
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from gantline.assembly.spatial import Array
from gantline.cad.mesh import TriangleMesh
from gantline.scenario.loads.cylinder import Cylinder

Whole = npt.NDArray[np.int64]

__all__ = ["cells_along", "drawn", "hull", "rims", "sides", "surface", "touching"]

#: How far a hull that is touched and watched may be within the round body, and the sides on supports [m].
_HULL_ERROR, _SIDES_ERROR = 1e-3, 2e-4
#: Flat sides of pictures; at least and at most of what is touched, a multiple of four: one is lowest.
_DRAWN, _FEWEST, _MOST = 48, 32, 400
#: Plates of an end, of four corners each, how far the hull ends within them [m], more than what makes two
#: places one, and how thick they are, in radii.
_PLATES, _INSET, _THICK = 4, 2e-3, 0.1


def hull(given: Cylinder) -> Array:
    """Corners of a convex body to touch and to watch, from the load's bottom centre (n, 3) [m]."""
    around = _around(_count(given, _HULL_ERROR))
    return np.concatenate([_rim(given, end, radius, around) for end, radius in enumerate(given.radii)])


def touching(given: Cylinder) -> tuple[Array, ...]:
    """Convex parts of it that meet others, from the load's bottom centre: hull, and what its ends stand on.

    Of an end with many corners the contact library takes four side by side. So ends are plates with four
    corners each, turned against one another, and the hull ends a little within them.
    """
    inner = _between(given, _INSET, _around(_count(given, _HULL_ERROR)))
    plates = []
    for which in range(_PLATES):
        square = _turned(4, math.pi / 2.0 * which / _PLATES)
        whole = _between(given, 0.0, square)
        thick = _between(given, min(_THICK * given.widest, 0.5 * given.length), square)
        plates += [np.concatenate([whole[:4], thick[:4]]), np.concatenate([whole[4:], thick[4:]])]
    return (inner, *plates)


def _between(given: Cylinder, inset: float, around: Array) -> Array:
    """Both ends moved inwards [m], with places around each (2 n, 3) [m]."""
    first, last = (_rim(given, end, radius, around) for end, radius in enumerate(given.radii))
    way = min(inset / given.length, 0.5) * (last - first)
    return np.concatenate([first + way, last - way])


def sides(given: Cylinder) -> tuple[Array, ...]:
    """Flat sides that may lie on supports, the corners (n, 3) of each anticlockwise from outside [m]."""
    around = _around(_count(given, _SIDES_ERROR))
    first, last = (_rim(given, end, radius, around) for end, radius in enumerate(given.radii))
    strips = zip(first, np.roll(first, -1, axis=0), np.roll(last, -1, axis=0), last, strict=True)
    return (first[::-1], last, *(np.array(strip) for strip in strips))


def surface(given: Cylinder) -> TriangleMesh:
    """Its skin with as many sides, from the load's bottom centre."""
    return _mesh(given, _count(given, _SIDES_ERROR))


def drawn(given: Cylinder) -> TriangleMesh:
    """Triangles for pictures, from the load's bottom centre."""
    return _mesh(given, _DRAWN)


def rims(given: Cylinder) -> list[tuple[Array, Array, float]]:
    """Both circles: middle from the load's bottom centre (3,) [m], axis (3,), radius [m]."""
    axis = np.array([1.0, 0.0, 0.0] if given.along == "x" else [0.0, 0.0, 1.0])
    return [
        (_rim(given, end, 0.0, np.zeros((1, 2)))[0], axis, radius) for end, radius in enumerate(given.radii)
    ]


def cells_along(given: Cylinder) -> int:
    """Pieces of a lying one for its cells in water: each about two diameters long."""
    return min(max(round(given.length / (4.0 * given.widest)), 1), 4)


def _count(given: Cylinder, error: float) -> int:
    """Sides of which none is farther than an error within the round body, (RL5)."""
    share = min(error / given.widest, 1.0)
    wanted = math.pi / math.acos(1.0 - share)
    return min(max(4 * math.ceil(wanted / 4.0), _FEWEST), _MOST)


def _around(count: int) -> Array:
    """Unit vectors from the lowest on, anticlockwise as seen against the axis (count, 2)."""
    return _turned(count, -math.pi / 2.0)


def _turned(count: int, start: float) -> Array:
    angles = 2.0 * math.pi * np.arange(count) / count + start
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


def _rim(given: Cylinder, end: int, radius: float, around: Array) -> Array:
    """Places around an end, anticlockwise as seen against the axis, from the bottom centre (n, 3) [m]."""
    one, other = radius * around[:, 0], radius * around[:, 1]
    if given.along == "x":
        along = np.full(len(around), (end - 0.5) * given.length)
        return np.stack([along, one, other + given.widest], axis=1)
    return np.stack([one, other, np.full(len(around), end * given.length)], axis=1)


def _mesh(given: Cylinder, count: int) -> TriangleMesh:
    around = _around(count)
    first, last = (_rim(given, end, radius, around) for end, radius in enumerate(given.radii))
    this = np.arange(count, dtype=np.int64)
    following = np.roll(this, -1)
    skin = _strip(this, following, count)
    if given.wall is None:
        middles = np.array([_rim(given, end, 0.0, np.zeros((1, 2)))[0] for end in (0, 1)])
        foot, head = np.full_like(this, 2 * count), np.full_like(this, 2 * count + 1)
        ends = _stack([(foot, following, this), (head, this + count, following + count)])
        return TriangleMesh(np.concatenate([first, last, middles]), np.concatenate([*skin, *ends]))
    inner = [_rim(given, end, radius, around) for end, radius in enumerate(given.bores)]
    bore = [triangles[:, ::-1] for triangles in _strip(this + 2 * count, following + 2 * count, count)]
    rings = _stack(
        [
            (this, this + 2 * count, following),
            (following, this + 2 * count, following + 2 * count),
            (this + count, following + count, this + 3 * count),
            (following + count, following + 3 * count, this + 3 * count),
        ]
    )
    return TriangleMesh(np.concatenate([first, last, *inner]), np.concatenate([*skin, *bore, *rings]))


def _strip(this: Whole, following: Whole, count: int) -> list[Whole]:
    """Triangles between a rim and the one whose places are `count` on, seen from outside."""
    return _stack([(this, following, following + count), (this, following + count, this + count)])


def _stack(triangles: list[tuple[Whole, Whole, Whole]]) -> list[Whole]:
    return [np.stack(one, axis=1) for one in triangles]
