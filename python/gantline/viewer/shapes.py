"""Shapes of the scene as a page may have them: known kinds, finite numbers, limited size."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from gantline.results.variable import FloatArray
from gantline.viewer.arrays import Arrays

_MOST_VERTICES = 400_000


def vector(given: Any, otherwise: Sequence[float] = (0.0, 0.0, 0.0)) -> list[float]:
    """Three finite numbers of a scene; `otherwise` where nothing is given.

    Raises:
        ValueError: If it is something else.
    """
    found = np.asarray(otherwise if given is None else given, dtype=np.float64)
    if found.shape != (3,) or not np.isfinite(found).all():
        raise ValueError("the scene has a point that is not three finite numbers")
    return [float(part) for part in found]


def packed_shape(shape: Mapping[str, Any] | None, name: str, arrays: Arrays) -> dict[str, Any] | None:
    """A shape for a page; meshes go among the arrays.

    Args:
        shape: `box` with `size` and `centre`; `boxes` with several of them; `mesh` with `vertices` and
            `faces` (or `triangles`); `convex` with `points` (or `vertices`). None and kinds that are not
            known are not drawn.
        name: What its arrays are called.
        arrays: Where they go.

    Raises:
        ValueError: If its numbers are none, or too many.
    """
    kind = (shape or {}).get("type")
    if shape is None or kind not in ("box", "boxes", "mesh", "convex"):
        return None
    if kind == "boxes":
        return {"type": "boxes", "boxes": [_box(one) for one in shape["boxes"]]}
    if kind == "box":
        return {"type": "box", **_box(shape)}
    points = shape.get("vertices") if kind == "mesh" else shape.get("points", shape.get("vertices"))
    vertices = _vertices(points)
    arrays.plain(f"{name}.vertices", vertices, "f4")
    if kind == "convex":
        return {"type": "convex", "arrays": name}
    faces = np.asarray(shape.get("faces", shape.get("triangles")), dtype=np.int64)
    is_triangles = faces.ndim == 2 and faces.shape[1] == 3
    if not is_triangles or (faces.size and not 0 <= faces.min() <= faces.max() < len(vertices)):
        raise ValueError("a mesh of the scene has faces that are not three of its vertices each")
    arrays.plain(f"{name}.faces", faces, "u4")
    return {"type": "mesh", "arrays": name}


def _box(shape: Mapping[str, Any]) -> dict[str, Any]:
    return {"size": vector(shape["size"]), "centre": vector(shape.get("centre"))}


def _vertices(given: Any) -> FloatArray:
    vertices = np.asarray(given, dtype=np.float64)
    if vertices.ndim != 2 or vertices.shape[1] != 3 or not np.isfinite(vertices).all():
        raise ValueError("a mesh of the scene has vertices that are not three finite numbers each")
    if len(vertices) > _MOST_VERTICES:
        raise ValueError(f"a mesh of the scene has {len(vertices)} vertices; {_MOST_VERTICES} can be shown")
    return vertices
