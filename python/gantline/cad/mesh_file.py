"""STL and OBJ, and glTF and GLB, which trimesh reads: as parts, or as the surface that they are."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from gantline.cad.assumptions import STAND_UP, Assumptions
from gantline.cad.bodies import parts_of_mesh
from gantline.cad.errors import CadError
from gantline.cad.files import content, missing
from gantline.cad.mesh import TriangleMesh
from gantline.cad.model import CadModel, Part
from gantline.cad.plain import TooManyTrianglesError, read_obj, read_stl

__all__ = ["MESH_FORMATS", "mesh_format", "read_mesh_file", "read_surface_file"]

#: Endings of names, and how the formats are called.
MESH_FORMATS = {".stl": "STL", ".obj": "OBJ", ".gltf": "glTF", ".glb": "GLB"}
#: Triangles of all meshes together: 3 GB and half a minute.
_MOST_TRIANGLES = 2_000_000
#: Largest coordinate, in whatever unit: volumes and inertias of larger ones leave what numbers can hold.
_LARGEST = 1e12
#: Mode of a primitive of glTF that is a fan of triangles.
_FAN = 6
#: How names of extensions of glTF begin that only change how things look.
_OF_LOOKS = ("KHR_materials", "KHR_texture", "KHR_lights", "EXT_texture", "MSFT_texture")


def mesh_format(path: Path) -> str | None:
    """Ending of a file of triangles, before a ``.gz``; None of another file."""
    suffix = (path.with_suffix("") if path.suffix.lower() == ".gz" else path).suffix.lower()
    return suffix if suffix in MESH_FORMATS else None


class _Placed(NamedTuple):
    """Meshes of a file in metres, z up, with their names; the unit; doubts; the diagonal of all [m]."""

    meshes: list[tuple[str, TriangleMesh]]
    unit: str
    doubts: list[str]
    size: float


def read_mesh_file(path: Path, given: Assumptions) -> CadModel:
    """A file of triangles; a further ending ``.gz`` is unpacked.

    Raises:
        CadError: if it cannot be read, has no triangles or too many, or trimesh is not installed.
    """
    found = _read(path, given)
    parts: list[Part] = []
    for name, mesh in found.meshes:
        try:
            parts += parts_of_mesh(name, mesh, found.size, given)
        except CadError as problem:
            raise CadError(f"{path}: {problem}") from None
    form = MESH_FORMATS[mesh_format(path) or ""]
    return CadModel(path.name, form, tuple(parts), found.unit, tuple(found.doubts))


def read_surface_file(path: Path, given: Assumptions) -> tuple[TriangleMesh, tuple[str, ...]]:
    """All triangles of a file as they stand there, in metres and z up, and what is doubtful.

    Raises:
        CadError: as `read_mesh_file`.
    """
    found = _read(path, given)
    return TriangleMesh.combined([mesh for _, mesh in found.meshes]), tuple(found.doubts)


def _read(path: Path, given: Assumptions) -> _Placed:
    suffix = mesh_format(path) or ""
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
    largest = float(np.abs(whole.vertices).max())
    if largest > _LARGEST:
        raise CadError(
            f"{path}: a coordinate is {largest:.3g}, which is no place of a thing that is lifted or floats; "
            f"expected less than {_LARGEST:g} in any unit"
        )
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
    placed = [(name, mesh.scaled(factor)) for name, mesh in meshes]
    if turned:
        placed = [(name, mesh.moved(STAND_UP, np.zeros(3))) for name, mesh in placed]
    return _Placed(placed, unit, doubts, factor * whole.size)


def _meshes(path: Path, kind: str) -> Iterator[tuple[str, TriangleMesh]]:
    """Meshes of a file, placed, with their names."""
    data = content(path)
    own = path.name.split(".")[0]
    try:
        if kind == "stl":
            yield own, read_stl(data, _MOST_TRIANGLES)
        elif kind == "obj":
            for name, mesh in read_obj(data, _MOST_TRIANGLES).items():
                yield name or own, mesh
    except TooManyTrianglesError:
        raise _too_many(path) from None
    except ValueError as problem:
        raise CadError(f"{path}: {problem}") from None
    if kind in ("gltf", "glb"):
        yield from _scene(path, kind, data)


def _scene(path: Path, kind: str, data: bytes) -> Iterator[tuple[str, TriangleMesh]]:
    """Meshes of a glTF scene where its nodes put them."""
    try:
        import trimesh
    except ImportError:
        raise missing(path, "trimesh") from None
    _check_gltf(path, kind, data)
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
        said = reason[0] if reason else type(problem).__name__
        if "reshape" in said:
            said = "the corners of its triangles, or their coordinates, do not come in threes"
        raise CadError(f"{path}: it is no {MESH_FORMATS['.' + kind]} file, or a broken one: {said}") from None
    names: dict[str, str] = {}
    found: dict[str, list[TriangleMesh]] = {}
    for node, matrix, geometry in placed:
        mesh = scene.geometry[geometry]
        if not isinstance(mesh, trimesh.Trimesh):
            continue
        # What differs in colour stands below the node of its mesh, under a name drawn at random.
        whole = scene.graph.transforms.parents[node] if mesh.metadata.get("from_gltf_primitive") else node
        name = _name(path, str(whole), str(geometry))
        found.setdefault(str(whole), []).append(
            _placed(f"{path}: '{name}'", mesh.vertices, mesh.faces, matrix)
        )
        names[str(whole)] = name
    for whole, meshes in found.items():
        yield names[whole], TriangleMesh.combined(meshes)


def _placed(what: str, vertices: npt.ArrayLike, faces: npt.ArrayLike, matrix: npt.ArrayLike) -> TriangleMesh:
    """A mesh where its node puts it; nodes may scale and mirror."""
    place = np.asarray(matrix, dtype=float)
    try:
        mesh = TriangleMesh(np.asarray(vertices, dtype=float) @ place[:3, :3].T + place[:3, 3], faces)
    except ValueError as problem:
        raise CadError(f"{what} is broken: {problem}") from None
    return mesh.flipped() if np.linalg.det(place[:3, :3]) < 0 else mesh


def _name(path: Path, node: str, geometry: str) -> str:
    """What the file calls a mesh, or the file's name where trimesh made up a name."""
    name = geometry if node == "world" else node
    return path.name.split(".")[0] if name.startswith("geometry") or not name else name


def _too_many(path: Path) -> CadError:
    return CadError(f"{path}: more than {_MOST_TRIANGLES} triangles, so it is not read")


def _check_gltf(path: Path, kind: str, data: bytes) -> None:
    """Refuse what is no glTF, and what needs an extension that moves vertices: trimesh reads past it."""
    form = MESH_FORMATS["." + kind]
    if kind == "glb" and not data.startswith(b"glTF"):
        raise CadError(f"{path}: it is no {form} file: 'glTF' does not stand at its beginning")
    try:
        # A GLB file: twelve bytes, then length and kind of the first chunk, which is the document.
        text = data if kind == "gltf" else data[20 : 20 + int.from_bytes(data[12:16], "little")]
        document = json.loads(text)
    except UnicodeDecodeError:
        said = "its JSON is not UTF-8 text"
        raise CadError(f"{path}: it is no {form} file, or a broken one: {said}") from None
    except ValueError as problem:
        raise CadError(f"{path}: it is no {form} file, or a broken one: {problem}") from None
    if not isinstance(document, dict) or "asset" not in document:
        raise CadError(f"{path}: it is no {form} file: it has no 'asset'")
    needed = document.get("extensionsRequired")
    for name in needed if isinstance(needed, list) else []:
        if not str(name).startswith(_OF_LOOKS):
            raise CadError(
                f"{path}: it needs the extension '{name}' of glTF, which is not read; "
                "one that is exported without compression can be"
            )
    for what in _not_followed(document):
        raise CadError(
            f"{path}: it has {what}, which are not read; one that is exported as plain triangles can be"
        )


def _not_followed(document: Mapping[str, Any]) -> Iterator[str]:
    """What a glTF document has by which there are other triangles than trimesh reads, without a word."""

    def listed(holder: Any, key: str) -> list[Mapping[str, Any]]:
        found = holder.get(key) if isinstance(holder, dict) else None
        return [one for one in found if isinstance(one, dict)] if isinstance(found, list) else []

    primitives = [one for mesh in listed(document, "meshes") for one in listed(mesh, "primitives")]
    if any(one.get("mode") == _FAN for one in primitives):
        yield "fans of triangles"
    if any("sparse" in one for one in listed(document, "accessors")):
        yield "sparse accessors"
    if any(one.get("targets") for one in primitives):
        yield "morph targets"
    nodes = listed(document, "nodes")
    if any("skin" in node for node in nodes):
        yield "skins"
    extensions = [node["extensions"] for node in nodes if isinstance(node.get("extensions"), dict)]
    if any("EXT_mesh_gpu_instancing" in one for one in extensions):
        yield "instances of meshes"


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
