"""Lighter stand-ins for a model: a mesh to draw, a hull to touch with, flat sides to stand on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from gantline.cad.errors import CadError
from gantline.cad.mesh import TriangleMesh

if TYPE_CHECKING:
    from scipy.spatial import ConvexHull

__all__ = ["ContactHull", "HullSides", "LightMesh", "contact_hull", "hull_sides", "light_mesh"]

Array = npt.NDArray[np.float64]

#: Triangles that come into question for the nearest one to a point.
_CANDIDATES = 24
_CHUNK = 20_000
_HALVINGS = 20
#: Facets of a hull whose corners are within this share of its size of one plane are one side.
_FLAT = 1e-6


@dataclass(frozen=True, eq=False)
class LightMesh:
    """A mesh of few triangles.

    Attributes:
        mesh: the triangles.
        error: largest distance between it and what it stands for, either way, at all vertices and middles of
            triangles [m]; not less than it is.
    """

    mesh: TriangleMesh
    error: float


@dataclass(frozen=True, eq=False)
class ContactHull:
    """A convex body within the convex hull of a mesh.

    Attributes:
        vertices: its corners (n, 3) [m], corners of the convex hull all.
        error: how far a corner of the convex hull that is left out stands out of it at most [m].
    """

    vertices: Array
    error: float


@dataclass(frozen=True, eq=False)
class HullSides:
    """The flat sides of a convex body within the convex hull of a mesh.

    Attributes:
        outlines: of each side its corners (n, 3), anticlockwise as seen from outside [m].
        error: how far a corner of the convex hull that is left out stands out of it at most [m].
    """

    outlines: tuple[Array, ...]
    error: float


def light_mesh(mesh: TriangleMesh, most: int) -> LightMesh:
    """At most so many triangles that look like a mesh: vertices within a cell of a grid are made one.

    The grid is the finest that leaves few enough triangles. None of the vertices moves farther than the
    diagonal of a cell; plates and profiles that are thinner than a cell become sheets and lines. The same
    mesh gives the same triangles.

    Args:
        mesh: closed, open, or of many pieces.
        most: triangles, at least 12.

    Raises:
        CadError: if the mesh has no triangles, or none is left.
    """
    if not len(mesh.triangles):
        raise CadError("a mesh without triangles cannot be made lighter")
    welded = mesh.welded(1e-6 * mesh.size)
    if len(welded.triangles) <= most:
        return LightMesh(welded, 0.0)
    fine, coarse, light = 0.0, welded.size, None
    for _ in range(_HALVINGS):
        cell = (fine + coarse) / 2
        found = _in_cells(welded, cell)
        if len(found.triangles) > most:
            fine = cell
            continue
        coarse = cell
        light = found if len(found.triangles) else light
    if light is None:
        raise CadError(f"nothing is left of a mesh that is made lighter to {most} triangles")
    return LightMesh(light, max(_farthest(welded, light), _farthest(light, welded)))


def _in_cells(mesh: TriangleMesh, cell: float) -> TriangleMesh:
    """Each vertex at the first of those in its cell; triangles that became lines or backs left out."""
    places = np.floor((mesh.vertices - mesh.box[0]) / cell).astype(np.int64)
    _, first, group = np.unique(places, axis=0, return_index=True, return_inverse=True)
    a, b, c = triangles = first[group.reshape(-1)][mesh.triangles].T
    light = TriangleMesh(mesh.vertices, triangles.T[(a != b) & (b != c) & (c != a)])
    return light.without(light.backs) if len(light.triangles) else light


def _farthest(one: TriangleMesh, other: TriangleMesh) -> float:
    """Largest distance of one mesh's vertices and middles from the other's surface, from above."""
    from scipy.spatial import cKDTree

    points = np.concatenate([one.vertices, one.corners.mean(axis=1)])
    corners = other.corners
    # Large triangles are found by points all over them, each a fraction of the whole apart.
    spacing = max(other.size / 60, 1e-12)
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    parts = np.clip(np.ceil(longest / spacing), 1, 60)
    samples, owner = [], []
    for count in np.unique(parts).astype(int):
        chosen = np.flatnonzero(parts == count)
        grid = [(i, j, count - i - j) for i in range(count + 1) for j in range(count + 1 - i)]
        weights = np.array(grid, dtype=float) / count
        samples.append(np.einsum("gc,tcx->tgx", weights, corners[chosen]).reshape(-1, 3))
        owner.append(np.repeat(chosen, len(weights)))
    tree, of = cKDTree(np.concatenate(samples)), np.concatenate(owner)
    worst = 0.0
    for start in range(0, len(points), _CHUNK):
        chunk = points[start : start + _CHUNK]
        _, near = tree.query(chunk, k=min(_CANDIDATES, len(of)))
        near = of[np.asarray(near).reshape(len(chunk), -1)]
        worst = max(worst, float(np.sqrt(_squared(chunk, corners[near]).min(axis=1)).max()))
    return worst


def _squared(points: Array, corners: Array) -> Array:
    """Squared distances of points (n, 3) from k triangles each (n, k, 3 corners, 3)."""
    a, b, c = (corners[:, :, place] for place in range(3))
    p = points[:, None]
    normal = np.cross(b - a, c - a)
    area = np.einsum("nkx,nkx->nk", normal, normal)
    inside = area > 0
    for start, end in ((a, b), (b, c), (c, a)):
        inside &= np.einsum("nkx,nkx->nk", np.cross(end - start, p - start), normal) >= 0
    height = np.einsum("nkx,nkx->nk", p - a, normal)
    found = np.where(inside, height**2 / np.where(area > 0, area, 1.0), np.inf)
    for start, end in ((a, b), (b, c), (c, a)):
        side = end - start
        length = np.einsum("nkx,nkx->nk", side, side)
        along = np.einsum("nkx,nkx->nk", p - start, side) / np.where(length > 0, length, 1.0)
        foot = start + np.clip(along, 0.0, 1.0)[..., None] * side
        found = np.minimum(found, ((p - foot) ** 2).sum(axis=2))
    return np.asarray(found)


def contact_hull(mesh: TriangleMesh, tolerance: float, most: int = 64) -> ContactHull:
    """A convex body of few corners in the convex hull of a mesh.

    It starts from the corners that are farthest out along eight diagonals and six axes, and takes in
    whichever corner of the convex hull stands out most, until none does by more than the tolerance or there
    are enough.

    Args:
        mesh: any.
        tolerance: how far a corner may stand out [m].
        most: corners, at least 8.

    Raises:
        CadError: if the mesh is flat, so that it has no convex hull.
    """
    from scipy.spatial import ConvexHull, QhullError

    try:
        corners, chosen = _corners_to_start_from(mesh)
        while True:
            hull = ConvexHull(corners[chosen])
            # Facets with their outward normals and distances from the origin: n·x + d > 0 is outside.
            out = (corners @ hull.equations[:, :3].T + hull.equations[:, 3]).max(axis=1)
            worst = int(np.argmax(out))
            if out[worst] <= tolerance or len(chosen) >= most or worst in chosen:
                return ContactHull(corners[np.sort(chosen)], max(float(out[worst]), 0.0))
            chosen.append(worst)
    except (QhullError, ValueError):
        raise CadError("the geometry is flat or has no extent, so it has no convex hull") from None


def _corners_to_start_from(mesh: TriangleMesh) -> tuple[Array, list[int]]:
    """Corners of the convex hull of a mesh (n, 3) [m], and which of them are farthest out.

    Raises:
        QhullError, ValueError: if the mesh is flat.
    """
    from scipy.spatial import ConvexHull

    points = mesh.vertices[np.unique(mesh.triangles)]
    corners = points[np.sort(ConvexHull(points).vertices)]
    return corners, _outermost(corners)


def _outermost(corners: Array) -> list[int]:
    middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
    size = np.maximum(np.ptp(corners, axis=0), 1e-12)
    unit = (corners - middle) / size
    diagonals = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    ways = np.array([*diagonals, *np.eye(3), *-np.eye(3)], dtype=float)
    found = np.argmax(unit @ ways.T, axis=0)
    # The axes are only of use where the diagonals have not found that side.
    taken = list(dict.fromkeys(found[:8].tolist()))
    for place, way in zip(found[8:].tolist(), ways[8:], strict=True):
        if float((unit[taken] @ way).max()) < float(unit[place] @ way) - 1e-9:
            taken.append(place)
    return taken


def hull_sides(mesh: TriangleMesh, tolerance: float, most: int = 400) -> HullSides:
    """The sides of a convex body in the convex hull of a mesh, facets in one plane made one side.

    It starts like `contact_hull`, and takes in the corner of the convex hull that stands out most over each
    facet, until none does by more than the tolerance or there are enough.

    Args:
        mesh: any.
        tolerance: how far a corner may stand out [m].
        most: corners, at least 8.

    Raises:
        CadError: if the mesh is flat, so that it has no convex hull.
    """
    from scipy.spatial import ConvexHull, QhullError

    try:
        corners, chosen = _corners_to_start_from(mesh)
        while True:
            hull = ConvexHull(corners[chosen])
            out = corners @ hull.equations[:, :3].T + hull.equations[:, 3]
            error = max(float(out.max()), 0.0)
            farthest = np.argmax(out, axis=0)
            order = np.argsort(-out.max(axis=0), kind="stable")
            wanted = [int(farthest[facet]) for facet in order if out[farthest[facet], facet] > tolerance]
            more = [corner for corner in dict.fromkeys(wanted) if corner not in chosen]
            if not more or len(chosen) >= most:
                return HullSides(tuple(_sides(hull, _FLAT * mesh.size)), error)
            chosen += more[: most - len(chosen)]
    except (QhullError, ValueError):
        raise CadError("the geometry is flat or has no extent, so it has no convex hull") from None


def _sides(hull: ConvexHull, flat: float) -> Iterator[Array]:
    """Outlines of the facets of a hull, those within a height of the plane of the largest made one."""
    a, b, c = hull.points[hull.simplices].transpose(1, 0, 2)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    taken = np.zeros(len(areas), dtype=bool)
    for seed in np.argsort(-areas, kind="stable").tolist():
        if taken[seed]:
            continue
        taken[seed] = True
        normal, level = hull.equations[seed, :3], hull.equations[seed, 3]
        off = np.abs(hull.points @ normal + level)
        group = [seed]
        for facet in group:
            for other in hull.neighbors[facet].tolist():
                if not taken[other] and off[hull.simplices[other]].max() <= flat:
                    taken[other] = True
                    group.append(other)
        places = hull.points[np.unique(hull.simplices[group])]
        outline = _outline(places - np.outer(places @ normal + level, normal), normal, flat)
        if len(outline) >= 3:
            yield outline


def _outline(points: Array, normal: Array, flat: float) -> Array:
    """Corners of the convex outline of points in a plane, those that stand out by more than a height."""
    first = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    first /= np.linalg.norm(first)
    along, across = points @ first, points @ np.cross(normal, first)
    order = np.lexsort((across, along)).tolist()

    def half(places: list[int]) -> list[int]:
        chain: list[int] = []
        for place in places:
            while len(chain) > 1 and not stands_out(chain[-2], chain[-1], place):
                chain.pop()
            chain.append(place)
        return chain

    def stands_out(before: int, corner: int, after: int) -> bool:
        """Whether a corner is to the right of the line from the one before to the one after."""
        x, y = along[after] - along[before], across[after] - across[before]
        turn = x * (across[corner] - across[before]) - y * (along[corner] - along[before])
        return bool(-turn > flat * np.hypot(x, y))

    chain = half(order)[:-1] + half(order[::-1])[:-1]
    if len(chain) > 3 and not stands_out(chain[-1], chain[0], chain[1]):
        chain = chain[1:]
    return points[chain]
