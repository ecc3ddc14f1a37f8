"""The form of the attribute `scene` of a recording: what is needed to draw a lift, SI."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gantline.results.file.form import FormError, Quaternion, Range, Vector, hold_form

__all__ = ["hold_scene"]


@dataclass(frozen=True)
class _Box:
    size: Vector
    centre: Vector | None = None
    orientation: Quaternion | None = None


@dataclass(frozen=True)
class _Boxes:
    boxes: Sequence[_Box]


@dataclass(frozen=True)
class _Body:
    name: str
    kind: str = "body"
    shape: Mapping[str, Any] | None = None
    centre_of_gravity: Vector | None = None


@dataclass(frozen=True)
class _Sheave:
    body: str
    centre: Vector
    axis: Vector
    radius: float
    kind: str = "fixed"


@dataclass(frozen=True)
class _Rope:
    name: str
    kind: str = "rope"


@dataclass(frozen=True)
class _Contact:
    name: str
    at: Vector
    body: str | None = None


@dataclass(frozen=True)
class _Hole:
    x: Range
    y: Range
    floor: float


@dataclass(frozen=True)
class _Ground:
    level: float
    holes: Sequence[_Hole] | None = None


@dataclass(frozen=True)
class _Water:
    level: float


@dataclass(frozen=True)
class _Structure:
    name: str
    kind: str
    boxes: Sequence[_Box]


@dataclass(frozen=True)
class _Scene:
    bodies: Sequence[_Body] = ()
    sheaves: Sequence[_Sheave] = ()
    ropes: Sequence[_Rope] = ()
    contacts: Sequence[_Contact] = ()
    ground: _Ground | None = None
    water: _Water | None = None
    structures: Sequence[_Structure] = ()


#: Shapes made of boxes; of other kinds than these and meshes nothing is drawn.
_OF_BOXES = {"box": _Box, "boxes": _Boxes}


def hold_scene(scene: Any, place: str) -> None:
    """Hold the attribute `scene` against what drawings read of it.

    Args:
        scene: What `json.loads` gave.
        place: What messages call it.

    Raises:
        FormError: At the first difference.
    """
    hold_form(scene, _Scene, place)
    for at, body in enumerate(scene.get("bodies", ())):
        shape, at_shape = body.get("shape") or {}, f"{place}.bodies[{at}].shape"
        kind = shape.get("type")
        if not isinstance(kind, str | None):
            raise FormError(f"{at_shape}.type is {kind!r:.40}; expected text")
        if kind in _OF_BOXES:
            hold_form(shape, _OF_BOXES[kind], at_shape)
        elif kind == "mesh":
            vertices = _rows(shape, ("vertices",), at_shape)
            faces = _rows(shape, ("triangles", "faces"), at_shape)
            if faces.size and not 0 <= faces.min() <= faces.max() < len(vertices):
                raise FormError(
                    f"{at_shape} has triangles of vertices that it has not; it has {len(vertices)}"
                )
        elif kind == "convex":
            _rows(shape, ("points", "vertices"), at_shape)


def _rows(shape: Mapping[str, Any], keys: Sequence[str], place: str) -> np.ndarray[Any, np.dtype[Any]]:
    """Rows of three finite numbers under the first of the keys that is there."""
    key = next((one for one in keys if one in shape), None)
    if key is None:
        raise FormError(f"{place} has no '{keys[0]}'")
    try:
        # A list of no rows has no second axis.
        found = np.asarray(shape[key] or np.empty((0, 3)), dtype=np.float64)
    except (TypeError, ValueError):
        found = np.full(1, np.nan)
    if found.ndim != 2 or found.shape[1] != 3 or not np.isfinite(found).all():
        raise FormError(f"{place}.{key} is something else than rows of three numbers")
    return found
