"""Shapes of a recording's scene as triangles."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from gantline.results.variable import FloatArray, Indices

__all__ = ["box_faces", "crossings", "skin_of", "solid_of"]

_CORNERS = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=np.float64) / 2
_BOX: Indices = np.array(
    [
        *[(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1)],
        *[(2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)],
    ]
)


def solid_of(shape: Mapping[str, Any] | None) -> tuple[FloatArray, Indices] | None:
    """Vertices (n, 3) [m] and triangles (m, 3) of a shape, in the axes of its joint.

    None for a shape that is not known, or a bare set of points.

    Raises:
        ValueError: If it is a mesh without finite vertices, or with faces of vertices that it has not.
    """
    kind = (shape or {}).get("type")
    if shape is None or kind not in ("box", "boxes", "mesh"):
        return None
    if kind == "mesh":
        vertices = np.asarray(shape["vertices"], dtype=np.float64)
        faces = np.asarray(shape.get("triangles", shape.get("faces")), dtype=np.int64)
        if not np.isfinite(vertices).all() or not 0 <= faces.min(initial=0) <= faces.max(initial=0) < len(
            vertices
        ):
            raise ValueError("a mesh of the scene has no finite vertices, or faces without them")
        return vertices, faces
    boxes = shape["boxes"] if kind == "boxes" else [shape]
    corners = [
        np.asarray(box.get("centre") or np.zeros(3), dtype=np.float64) + _CORNERS * np.asarray(box["size"])
        for box in boxes
    ]
    return np.concatenate(corners), box_faces(len(boxes))


def box_faces(count: int) -> Indices:
    """Triangles of boxes whose corners follow each other, eight of each, x slowest, z fastest; outwards."""
    return np.concatenate([_BOX + 8 * place for place in range(count)])


def skin_of(body: Mapping[str, Any] | None) -> FloatArray:
    """Triangles (n, 3, 3) of a drawn body from its centre of gravity on; none of one that has no solid."""
    solid = None if body is None else solid_of(body.get("shape"))
    if body is None or solid is None:
        return np.empty((0, 3, 3))
    vertices, faces = solid
    skin: FloatArray = (vertices - np.asarray(body.get("centre_of_gravity") or np.zeros(3)))[faces]
    return skin


def crossings(first: FloatArray, last: FloatArray, skin: FloatArray) -> tuple[FloatArray, Indices]:
    """Where lines go through triangles; Moeller and Trumbore 1997.

    Args:
        first: One end of each line, shape (lines, 3) [m].
        last: The other.
        skin: Triangles, shape (triangles, 3, 3) [m].

    Returns:
        Points, shape (n, 3) [m], and which line each is on, in order, shape (n,).
    """
    # Most triangles are far from most lines: lines, then pairs whose boxes do not meet are left out.
    low, high = np.minimum(first, last)[:, None], np.maximum(first, last)[:, None]
    least, most = skin.min(axis=1), skin.max(axis=1)
    near = ((low <= most.max(axis=0)) & (high >= least.min(axis=0))).all(axis=(1, 2)).nonzero()[0]
    line, face = np.nonzero(((low[near] <= most) & (high[near] >= least)).all(axis=-1))
    line = near[line]
    start, along, corner = first[line], (last - first)[line], skin[face, 0]
    one, other = skin[face, 1] - corner, skin[face, 2] - corner
    across = np.cross(along, other)
    volume = np.einsum("ij,ij->i", across, one)
    off = start - corner
    turned = np.cross(off, one)
    # Lines in the plane of a triangle, or but for rounding, touch it and do not go through.
    with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
        u = np.einsum("ij,ij->i", across, off) / volume
        v = np.einsum("ij,ij->i", along, turned) / volume
        share = np.einsum("ij,ij->i", turned, other) / volume
        inside = (u >= 0) & (v >= 0) & (u + v <= 1) & (share >= 0) & (share <= 1) & np.isfinite(share)
    points: FloatArray = start[inside] + share[inside, None] * along[inside]
    return points, line[inside]
