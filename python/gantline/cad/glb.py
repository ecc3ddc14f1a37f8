"""Models as binary glTF 2.0, which viewers open: a node for each part, turned to the standard's y up."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from gantline.cad.model import CadModel, Part, PartKind

__all__ = ["write_glb"]

_FLOAT, _UNSIGNED = 5126, 5125
_VERTICES, _INDICES = 34962, 34963
#: Red, green, blue of each kind of part.
_COLOURS = {
    PartKind.PLATE: (0.62, 0.66, 0.70),
    PartKind.STIFFENER: (0.80, 0.52, 0.25),
    PartKind.BRACKET: (0.45, 0.60, 0.45),
    PartKind.PILLAR: (0.35, 0.45, 0.70),
    PartKind.EDGE_REINFORCEMENT: (0.70, 0.45, 0.45),
    PartKind.SOLID: (0.62, 0.66, 0.70),
    PartKind.SHELL: (0.62, 0.66, 0.70),
}


def write_glb(model: CadModel) -> bytes:
    """The model as the bytes of a GLB file; parts without triangles are left out."""
    parts = [part for part in model.parts if len(part.mesh.triangles)]
    kinds = sorted({part.kind for part in parts})
    writer = _Writer()
    meshes = [writer.mesh(part, kinds.index(part.kind)) for part in parts]
    # x stays, z becomes y, y becomes −z: a turn by −90° about x.
    half = float(np.sqrt(0.5))
    nodes: list[dict[str, Any]] = [
        {"name": model.name, "children": list(range(1, len(parts) + 1)), "rotation": [-half, 0.0, 0.0, half]}
    ]
    nodes += [{"name": part.name, "mesh": place} for place, part in enumerate(parts)]
    document = {
        "asset": {"version": "2.0", "generator": "gantline"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": nodes,
        "meshes": meshes,
        "materials": [_material(kind) for kind in kinds],
        "accessors": writer.accessors,
        "bufferViews": writer.views,
        "buffers": [{"byteLength": len(writer.body)}],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    chunks = _chunk(b"JSON", text, b" ") + _chunk(b"BIN\0", bytes(writer.body), b"\0")
    return b"glTF" + _word(2) + _word(12 + len(chunks)) + chunks


class _Writer:
    """Collects arrays in one buffer."""

    def __init__(self) -> None:
        self.body = bytearray()
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, Any]] = []

    def mesh(self, part: Part, material: int) -> dict[str, Any]:
        """A part's triangles."""
        vertices = part.mesh.vertices.astype("<f4")
        bounds = {"min": vertices.min(axis=0).tolist(), "max": vertices.max(axis=0).tolist()}
        position = self._array(vertices.tobytes(), _VERTICES, _FLOAT, "VEC3", len(vertices), bounds)
        indices = part.mesh.triangles.astype("<u4")
        faces = self._array(indices.tobytes(), _INDICES, _UNSIGNED, "SCALAR", indices.size, {})
        return {
            "primitives": [{"attributes": {"POSITION": position}, "indices": faces, "material": material}]
        }

    def _array(
        self, data: bytes, target: int, component: int, form: str, count: int, more: dict[str, Any]
    ) -> int:
        self.views.append(
            {"buffer": 0, "byteOffset": len(self.body), "byteLength": len(data), "target": target}
        )
        self.body += data
        view = len(self.views) - 1
        self.accessors.append(
            {"bufferView": view, "componentType": component, "count": count, "type": form, **more}
        )
        return len(self.accessors) - 1


def _material(kind: PartKind) -> dict[str, Any]:
    colour = [*_COLOURS[kind], 1.0]
    metal = {"baseColorFactor": colour, "metallicFactor": 0.2, "roughnessFactor": 0.8}
    return {"name": str(kind), "doubleSided": True, "pbrMetallicRoughness": metal}


def _word(value: int) -> bytes:
    return value.to_bytes(4, "little")


def _chunk(kind: bytes, data: bytes, filler: bytes) -> bytes:
    padded = data + filler * (-len(data) % 4)
    return _word(len(padded)) + kind + padded
