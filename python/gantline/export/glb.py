"""A glTF 2.0 file put together piece by piece: arrays, accessors, meshes, nodes, one animation.

Written after the specification (Khronos Group, glTF 2.0, 2021). Numbers below are its constants.
"""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

_FLOAT, _UNSIGNED_INT = 5126, 5125
_ARRAY, _ELEMENTS = 34962, 34963
_MAGIC, _JSON, _BIN = 0x46546C67, 0x4E4F534A, 0x004E4942
_WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}

Array = npt.NDArray[Any]


@dataclass
class Document:
    """A scene that grows.

    Attributes:
        nodes: Nodes in order; each has a name.
        meshes: Meshes.
        materials: Materials.
        channels: What the animation moves.
        samplers: How.
    """

    nodes: list[dict[str, Any]] = field(default_factory=list)
    meshes: list[dict[str, Any]] = field(default_factory=list)
    materials: list[dict[str, Any]] = field(default_factory=list)
    channels: list[dict[str, Any]] = field(default_factory=list)
    samplers: list[dict[str, Any]] = field(default_factory=list)
    _accessors: list[dict[str, Any]] = field(default_factory=list)
    _views: list[dict[str, Any]] = field(default_factory=list)
    _parts: list[bytes] = field(default_factory=list)
    _size: int = 0

    def accessor(self, values: Array, kind: str, *, target: int | None = None, bounds: bool = False) -> int:
        """Add an array of float32 or, of indices, uint32; its number among the accessors.

        Args:
            values: Shape (n,) of a `SCALAR`, else (n, 3) or (n, 4).
            kind: `SCALAR`, `VEC3` or `VEC4`.
            target: What a graphics card uses it for; None of animations.
            bounds: Whether least and largest values are said, as places and times must be.
        """
        is_index = np.asarray(values).dtype.kind in "iu"
        array = np.ascontiguousarray(values, dtype="<u4" if is_index else "<f4")
        view: dict[str, Any] = {"buffer": 0, "byteOffset": self._size, "byteLength": array.nbytes}
        if target is not None:
            view["target"] = target
        self._views.append(view)
        self._parts.append(array.tobytes())  # always whole fours of bytes
        self._size += array.nbytes
        entry: dict[str, Any] = {
            "bufferView": len(self._views) - 1,
            "componentType": _UNSIGNED_INT if is_index else _FLOAT,
            "count": array.size // _WIDTHS[kind],
            "type": kind,
        }
        if bounds:
            flat = array.reshape(-1, _WIDTHS[kind])
            entry["min"], entry["max"] = flat.min(axis=0).tolist(), flat.max(axis=0).tolist()
        self._accessors.append(entry)
        return len(self._accessors) - 1

    def material(self, name: str, colour: tuple[float, float, float], alpha: float = 1.0) -> int:
        """Add a plain material in a colour of linear light; its number."""
        entry: dict[str, Any] = {
            "name": name,
            "pbrMetallicRoughness": {
                "baseColorFactor": [*colour, alpha],
                "metallicFactor": 0.0,
                "roughnessFactor": 0.8,
            },
            "doubleSided": True,
        }
        if alpha < 1.0:
            entry["alphaMode"] = "BLEND"
        self.materials.append(entry)
        return len(self.materials) - 1

    def mesh(self, name: str, vertices: Array, faces: Array, material: int) -> int:
        """Add a mesh of flat triangles; its number.

        Args:
            name: Its name.
            vertices: Shape (n, 3) [m].
            faces: Three vertices of each triangle, shape (m, 3); those without area are left out.
            material: Number of its material.
        """
        corners = vertices[faces]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        size = np.linalg.norm(normals, axis=1)
        whole = size > 0.0
        places = corners[whole].reshape(-1, 3)
        upright = np.repeat(normals[whole] / size[whole, None], 3, axis=0)
        primitive = {
            "attributes": {
                "POSITION": self.accessor(places, "VEC3", target=_ARRAY, bounds=True),
                "NORMAL": self.accessor(upright, "VEC3", target=_ARRAY),
            },
            "material": material,
        }
        self.meshes.append({"name": name, "primitives": [primitive]})
        return len(self.meshes) - 1

    def node(self, name: str, parent: int | None = None, **given: Any) -> int:
        """Add a node, below another one or none; its number."""
        self.nodes.append({"name": name, **given})
        if parent is not None:
            self.nodes[parent].setdefault("children", []).append(len(self.nodes) - 1)
        return len(self.nodes) - 1

    def animate(self, node: int, path: str, times: int, values: Array) -> None:
        """Move a node over time, on straight lines between the times.

        Args:
            node: Its number.
            path: `translation`, `rotation` or `scale`.
            times: Number of the accessor of the times.
            values: Shape (times, 3), or (times, 4) of unit quaternions x y z w.
        """
        output = self.accessor(values, "VEC4" if path == "rotation" else "VEC3")
        self.samplers.append({"input": times, "output": output, "interpolation": "LINEAR"})
        target = {"node": node, "path": path}
        self.channels.append({"sampler": len(self.samplers) - 1, "target": target})

    def binary(self, title: str, version: str) -> bytes:
        """The file: a head, the document as JSON, and the arrays."""
        document: dict[str, Any] = {
            "asset": {"version": "2.0", "generator": f"gantline {version}"},
            "scene": 0,
            "scenes": [{"name": title or "lift", "nodes": [0]}],
            "nodes": self.nodes,
            "buffers": [{"byteLength": self._size}],
            "bufferViews": self._views,
            "accessors": self._accessors,
        }
        for name in ("meshes", "materials"):
            if getattr(self, name):
                document[name] = getattr(self, name)
        if self.channels:
            document["animations"] = [{"name": "lift", "channels": self.channels, "samplers": self.samplers}]
        text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode("utf-8")
        text += b" " * (-len(text) % 4)
        data = b"".join(self._parts)
        head = struct.pack("<III", _MAGIC, 2, 12 + 8 + len(text) + 8 + len(data))
        chunks = struct.pack("<II", len(text), _JSON) + text + struct.pack("<II", len(data), _BIN) + data
        return head + chunks
