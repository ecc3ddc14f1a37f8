"""A body of a GLB file that has faces in two colours: it had no weight.

glTF stores what differs in colour apart, so either part was an open surface; and the names that parts then
had were drawn at random, so the same file gave other names in every run. A file whose coordinates are whole
numbers that an extension scales was weighed by these numbers.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline.cad import Assumptions, CadError, read
from solids import box


def coloured(path: Path, **changes: Any) -> Path:
    """A GLB file of a box of 2 × 3 × 5 m, half of its triangles in one colour and half in the other."""
    mesh = box((2, 3, 5))
    points, indices = mesh.vertices.astype("<f4").tobytes(), mesh.triangles.astype("<u4").tobytes()
    half = len(indices) // 2
    faces = {"componentType": 5125, "count": 18, "type": "SCALAR"}
    place = {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"}
    lengths = [(0, len(points)), (len(points), half), (len(points) + half, half)]
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "girder", "translation": [1.0, 10.0, 0.0]}],
        "meshes": [
            {"primitives": [{"attributes": {"POSITION": 0}, "indices": k, "material": k - 1} for k in (1, 2)]}
        ],
        "materials": [{}, {}],
        "accessors": [place, {"bufferView": 1, **faces}, {"bufferView": 2, **faces}],
        "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size in lengths],
        "buffers": [{"byteLength": len(points) + len(indices)}],
    } | changes
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    body = points + indices
    chunks = b"".join(
        len(data).to_bytes(4, "little") + kind + data for kind, data in ((b"JSON", text), (b"BIN\0", body))
    )
    path.write_bytes(b"glTF" + (2).to_bytes(4, "little") + (12 + len(chunks)).to_bytes(4, "little") + chunks)
    return path


def test_it_is_one_solid(tmp_path: Path) -> None:
    """m (b² + c²)/12 about the middle, and the name that the file has."""
    found = read(coloured(tmp_path / "a.glb"), Assumptions(up="z"), keep=False)
    assert [part.name for part in found.parts] == ["girder"]
    assert found.properties.mass == pytest.approx(7850 * 30)
    assert found.properties.centre == pytest.approx([1, 10, 0])
    expected = np.diag([34, 29, 13]) * 7850 * 30 / 12
    assert found.properties.inertia == pytest.approx(expected, abs=1.0)


@pytest.mark.parametrize("name", ["KHR_mesh_quantization", "KHR_draco_mesh_compression"])
def test_extensions_that_move_vertices_are_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(CadError, match=f"it needs the extension '{name}' of glTF, which is not read"):
        read(coloured(tmp_path / "a.glb", extensionsRequired=[name]), keep=False)


def test_extensions_of_looks_are_read_past(tmp_path: Path) -> None:
    path = coloured(tmp_path / "a.glb", extensionsRequired=["KHR_materials_unlit"])
    assert read(path, keep=False).properties.mass == pytest.approx(7850 * 30)


_FAN = {"attributes": {"POSITION": 0}, "indices": 1, "mode": 6}
_MOVED = {"attributes": {"POSITION": 0}, "indices": 1, "targets": [{"POSITION": 0}]}
_MANY = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 0}}}


@pytest.mark.parametrize(
    ("changes", "what"),
    [
        ({"meshes": [{"primitives": [_FAN]}]}, "fans of triangles"),
        ({"meshes": [{"primitives": [_MOVED]}]}, "morph targets"),
        ({"accessors": [{"sparse": {"count": 1}}]}, "sparse accessors"),
        ({"nodes": [{"mesh": 0, "skin": 0}]}, "skins"),
        ({"nodes": [{"mesh": 0, "extensions": _MANY}]}, "instances of meshes"),
    ],
)
def test_triangles_that_are_read_past_are_refused(tmp_path: Path, changes: dict[str, Any], what: str) -> None:
    """Fans were left out beside other triangles, and eight instances weighed as one, without a word."""
    with pytest.raises(CadError, match=f"it has {what}, which are not read"):
        read(coloured(tmp_path / "a.glb", **changes), keep=False)
