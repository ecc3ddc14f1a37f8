"""STL, OBJ, glTF and GLB, read by trimesh, as parts."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from gantline.cad.assumptions import Assumptions
from gantline.cad.bodies import parts_of_mesh
from gantline.cad.errors import CadError
from gantline.cad.files import content, missing
from gantline.cad.mesh import TriangleMesh
from gantline.cad.model import CadModel, Part

__all__ = ["MESH_FORMATS", "read_mesh_file"]

#: Endings of names, and how the formats are called.
MESH_FORMATS = {".stl": "STL", ".obj": "OBJ", ".gltf": "glTF", ".glb": "GLB"}
#: Triangles of all meshes together: 3 GB and half a minute.
_MOST_TRIANGLES = 2_000_000
#: From y up to z up.
_STAND_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])


def read_mesh_file(path: Path, given: Assumptions) -> CadModel:
    """A file of triangles; a further ending ``.gz`` is unpacked.

    Raises:
        CadError: if it cannot be read, has no triangles or too many, or trimesh is not installed.
    """
    suffix = (path.with_suffix("") if path.suffix.lower() == ".gz" else path).suffix.lower()
    form = MESH_FORMATS[suffix]
    meshes = [*_meshes(path, suffix[1:])]
    used = [mesh for _, mesh in meshes]
    count = sum(len(mesh.triangles) for mesh in used)
    if not count:
        raise CadError(f"{path}: there are no triangles in this {form} file")
    if count > _MOST_TRIANGLES:
        raise _too_many(path)
    doubts = []
    whole = TriangleMesh.combined(used)
    if not whole.size > 0:
        raise CadError(f"{path}: all vertices are in one place")
    standard = form in ("glTF", "GLB")  # their standard says: metres, y up
    if standard and given.unit is None:
        factor, unit = 1.0, "m, as the format has it"
    else:
        factor, unit, doubt = given.scale(whole.size)
        doubts += [doubt] if doubt else []
    turned = (given.up or ("y" if standard else "z")) == "y"
    if turned and given.up is None:
        doubts.append("turned from y up, as the format has it, to z up: x stays, −z becomes y, y becomes z")
    parts: list[Part] = []
    for name, mesh in meshes:
        placed = mesh.scaled(factor)
        if turned:
            placed = placed.moved(_STAND_UP, np.zeros(3))
        try:
            parts += parts_of_mesh(name, placed, factor * whole.size, given)
        except CadError as problem:
            raise CadError(f"{path}: {problem}") from None
    return CadModel(path.name, form, tuple(parts), unit, tuple(doubts))


def _meshes(path: Path, kind: str) -> Iterator[tuple[str, TriangleMesh]]:
    """Meshes of a file, placed, with their names."""
    data = content(path)
    try:
        import trimesh
    except ImportError:
        raise missing(path, "trimesh") from None
    if kind == "stl":
        _check_stl(path, data)
    if kind == "gltf":
        _check_gltf(path, data)
    try:
        # Without a resolver no other file is opened, whatever this one names.
        scene = trimesh.load_scene(
            io.BytesIO(data), file_type=kind, process=False, resolver=_NoOtherFiles(), skip_materials=True
        )
        placed = [(str(node), *scene.graph[node]) for node in scene.graph.nodes_geometry]
    except CadError as problem:
        raise CadError(f"{path}: {problem}") from None
    except MemoryError:
        raise CadError(f"{path}: it needs too much memory") from None
    except Exception as problem:  # whatever a broken file makes of its reader
        reason = str(problem).strip().splitlines()
        raise CadError(
            f"{path}: it is no {MESH_FORMATS['.' + kind]} file, or a broken one: "
            f"{reason[0] if reason else type(problem).__name__}"
        ) from None
    for node, matrix, geometry in placed:
        mesh = scene.geometry[geometry]
        if not isinstance(mesh, trimesh.Trimesh):
            continue
        yield _name(path, str(node), str(geometry)), _placed(path, mesh.vertices, mesh.faces, matrix)


def _placed(path: Path, vertices: npt.ArrayLike, faces: npt.ArrayLike, matrix: npt.ArrayLike) -> TriangleMesh:
    """A mesh where its node puts it; nodes may scale and mirror."""
    place = np.asarray(matrix, dtype=float)
    try:
        mesh = TriangleMesh(np.asarray(vertices, dtype=float) @ place[:3, :3].T + place[:3, 3], faces)
    except ValueError as problem:
        raise CadError(f"{path}: {problem}") from None
    return mesh.flipped() if np.linalg.det(place[:3, :3]) < 0 else mesh


def _name(path: Path, node: str, geometry: str) -> str:
    """What the file calls a mesh, or the file's name where trimesh made up a name."""
    name = geometry if node == "world" else node
    made_up = path.suffix.lower() in (".stl", ".gz") or name.startswith("geometry") or not name
    return path.name.split(".")[0] if made_up else name


def _check_stl(path: Path, data: bytes) -> None:
    """A binary file says how many triangles it has; one that has fewer was cut off."""
    if data[:5].lower() == b"solid" and b"facet" in data[:2000]:
        if b"endsolid" not in data[-2000:].lower():
            raise CadError(f"{path}: the STL file is cut off: it does not end on 'endsolid'")
        return
    count = int.from_bytes(data[80:84], "little")
    if len(data) >= 84 + 50 * count > 84 + 50 * _MOST_TRIANGLES:
        raise _too_many(path)
    if len(data) < 84 or len(data) < 84 + 50 * count:
        held = max(len(data) - 84, 0) // 50
        raise CadError(
            f"{path}: it is no STL file, or cut off: {count} triangles are announced, {held} are there"
        )


def _too_many(path: Path) -> CadError:
    return CadError(f"{path}: more than {_MOST_TRIANGLES} triangles, so it is not read")


def _check_gltf(path: Path, data: bytes) -> None:
    try:
        document = json.loads(data)
    except ValueError as problem:
        raise CadError(f"{path}: it is no glTF file, or a broken one: {problem}") from None
    if not isinstance(document, dict) or "asset" not in document:
        raise CadError(f"{path}: it is no glTF file: it has no 'asset'")


class _NoOtherFiles(Mapping[str, bytes]):
    """Stands where a reader would look for materials, pictures and buffers beside the file."""

    def __getitem__(self, name: str) -> bytes:
        raise CadError(f"it needs the file '{name}' beside it; one that holds everything (GLB) can be read")

    def get(self, name: str, default: Any = None) -> bytes:
        """No file, and no default."""
        return self[name]

    def __iter__(self) -> Iterator[str]:
        return iter(())

    def __len__(self) -> int:
        return 0
