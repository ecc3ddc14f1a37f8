"""Where the deck of a hull ends: points that should stay above the water; and the edge of its bottom."""

from __future__ import annotations

import math
from collections import defaultdict

import numpy as np
import numpy.typing as npt

from gantline.assembly.afloat.hulls import HullMesh
from gantline.assembly.spatial import Array
from gantline.cad.mesh import connected

__all__ = ["bottom_edge", "deck_edge", "sunk_share"]

#: A triangle of a hull is part of its deck where the cosine of its slope is more than this.
_DECK = 0.5
#: The lowest pieces of what looks up that are no deck, together, of all of it: bulbs, skegs, knuckles.
_BULB = 0.02
#: The same with those under water as the vessel floats: what is more than this is its deck.
_SUNK = 0.5
#: Least part of the rectangle about a hull that its deck fills, whether or not the mesh has one.
_FILLED = 0.5

Bools = npt.NDArray[np.bool_]
Whole = npt.NDArray[np.int64]
#: Triangles on both sides of each side of a mesh, which is a pair of vertices.
_Sides = dict[frozenset[int], list[int]]


def deck_edge(mesh: HullMesh, apart: float | None = None, draft: float = -math.inf) -> list[list[float]]:
    """A deck's edge, where its triangles meet others that are no deck, or end.

    Args:
        mesh: The hull.
        apart: How far apart its points may be at most [m]; None: its corners alone.
        draft: At which it floats, above z = 0 [m]: pieces all of which is under water then, up to half of
            what looks up, are pontoons and no deck.
    """
    between = _between(mesh)
    sides = _ends(between, _deck(mesh, between, draft))
    found = _corners(mesh, sides)
    if apart is None:
        return found
    for side in sides:
        first, last = (mesh.vertices[at] for at in sorted(side))
        pieces = math.ceil(float(np.linalg.norm(last - first)) / apart)
        found += [(first + (last - first) * k / pieces).tolist() for k in range(1, pieces)]
    return found


def sunk_share(mesh: HullMesh, draft: float) -> float:
    """Share of what looks up that is taken for no deck because it is under water at a draft [m]."""
    between = _between(mesh)
    with_it, without = (_deck(mesh, between, one) for one in (-math.inf, draft))
    areas = _plan_areas(mesh)
    return float(areas[with_it & ~without].sum() / max(areas[with_it].sum(), 1e-300))


def bottom_edge(mesh: HullMesh) -> list[list[float]]:
    """Corners of the edge of a hull's bottom, found from below as a deck's edge is from above."""
    return _corners(mesh, _ends(_between(mesh), _looks(mesh, -1.0)))


def _across(mesh: HullMesh) -> Array:
    """Normals of triangles, as long as twice their areas (n, 3) [m^2]."""
    corners = mesh.vertices[mesh.triangles]
    across: Array = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return across


def _looks(mesh: HullMesh, upwards: float) -> Bools:
    """Triangles that look upwards (1) or downwards (-1)."""
    across = _across(mesh)
    found: Bools = upwards * across[:, 2] > _DECK * np.linalg.norm(across, axis=1)
    return found


def _plan_areas(mesh: HullMesh) -> Array:
    """Of triangles, seen from above (n,) [m^2]."""
    areas: Array = np.abs(_across(mesh)[:, 2]) / 2
    return areas


def _between(mesh: HullMesh) -> _Sides:
    sides: _Sides = defaultdict(list)
    for place, triangle in enumerate(mesh.triangles.tolist()):
        for corner in range(3):
            sides[frozenset((triangle[corner - 1], triangle[corner]))].append(place)
    return sides


def _deck(mesh: HullMesh, between: _Sides, draft: float) -> Bools:
    """Triangles that look up, without the lowest pieces that are bulbs, and pontoons under water.

    The top of a bulb, of a sonar dome or of a skeg looks up as well, and is under water as it should be.
    """
    looks = _looks(mesh, 1.0)
    areas, heights = _plan_areas(mesh), mesh.vertices[mesh.triangles][:, :, 2]
    whole = max(float(areas[looks].sum()), _FILLED * float(np.prod(np.ptp(mesh.box, axis=0)[:2])))
    pieces = sorted(_pieces(looks, between), key=lambda piece: float(heights[piece].min()))
    dropped = 0.0
    for piece in pieces:
        dropped += float(areas[piece].sum()) / whole
        # One of which a part is dry is a deck awash.
        if dropped > (_SUNK if heights[piece].max() < draft else _BULB):
            break
        looks[piece] = False
    return looks


def _pieces(looks: Bools, between: _Sides) -> list[Whole]:
    """Triangles that hang together along sides, of those that are wanted."""
    wanted = np.flatnonzero(looks)
    if not len(wanted):
        return []
    beside = ([place for place in both if looks[place]] for both in between.values())
    pairs = [(first, other) for first, *others in filter(None, beside) for other in others]
    groups = connected(len(looks), np.array(pairs, dtype=np.int64).reshape(-1, 2))
    order = wanted[np.argsort(groups[wanted], kind="stable")]
    return np.split(order, np.flatnonzero(np.diff(groups[order])) + 1)


def _ends(between: _Sides, wanted: Bools) -> list[frozenset[int]]:
    """Sides of a mesh along which what is wanted ends, and those at which the mesh does."""
    return [
        side
        for side, beside in between.items()
        if len(beside) == 1 or {bool(wanted[place]) for place in beside} == {True, False}
    ]


def _corners(mesh: HullMesh, sides: list[frozenset[int]]) -> list[list[float]]:
    return [
        [float(part) for part in mesh.vertices[at]] for at in sorted({at for side in sides for at in side})
    ]
