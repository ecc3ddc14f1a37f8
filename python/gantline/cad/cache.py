"""Models that have been read before, kept by what was in the file.

A model is kept under a digest of the file's bytes, of what was assumed, and of the readers' own source: a
file that was changed, or a reader, is never answered from the cache. What is kept are numbers and text in
NumPy's archive format without pickled objects; it is read back with all checks of the types, and anything
that is wrong with it is as if it were not there. A cache that cannot be written is done without.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import os
import tempfile
import zipfile
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh
from gantline.cad.model import CadModel, DeclaredWeight, Part, PartKind

__all__ = ["digest", "folder", "load", "store"]

_MOST_FILES = 64
_BROKEN = (OSError, ValueError, KeyError, TypeError, EOFError, IndexError, zipfile.BadZipFile)


def folder() -> Path:
    """Where models are kept: `gantline/cad` in the user's cache folder ($XDG_CACHE_HOME, or ~/.cache)."""
    base = os.environ.get("XDG_CACHE_HOME", "")
    root = Path(base) if os.path.isabs(base) else Path.home() / ".cache"
    return root / "gantline" / "cad"


def digest(data: bytes, *assumed: object) -> str:
    """Name under which the model of a file is kept."""
    total = hashlib.sha256(_readers())
    total.update(repr(assumed).encode())
    total.update(data)
    return total.hexdigest()


@cache
def _readers() -> bytes:
    """Digest of the source that models come from."""
    total = hashlib.sha256()
    for path in sorted(Path(__file__).parent.rglob("*.py")):
        total.update(path.read_bytes())
    return total.digest()


def load(key: str) -> CadModel | None:
    """A model that was kept; None if there is none, or it is damaged."""
    path = folder() / f"{key}.npz"
    try:
        with np.load(path, allow_pickle=False) as archive:
            text = json.loads(archive["text"].tobytes())
            model = _model(text, archive["vertices"], archive["triangles"])
        os.utime(path)
    except _BROKEN:
        return None
    return model


def store(key: str, model: CadModel) -> None:
    """Keep a model; the oldest of too many are removed. Trouble with the folder is passed over."""
    archive = io.BytesIO()
    meshes = [part.mesh for part in model.parts]
    np.savez(
        archive,
        text=np.frombuffer(json.dumps(_text(model)).encode(), dtype=np.uint8),
        vertices=np.concatenate([mesh.vertices for mesh in meshes]),
        triangles=np.concatenate([mesh.triangles for mesh in meshes]),
    )
    place = folder()
    with contextlib.suppress(OSError):
        place.mkdir(parents=True, exist_ok=True)
        handle, temporary = tempfile.mkstemp(prefix=".part.", dir=place)
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(archive.getbuffer())
            os.replace(temporary, place / f"{key}.npz")
        except BaseException:
            Path(temporary).unlink(missing_ok=True)
            raise
        kept = sorted(place.glob("*.npz"), key=lambda path: path.stat().st_mtime, reverse=True)
        for path in kept[_MOST_FILES:]:
            path.unlink(missing_ok=True)


def _text(model: CadModel) -> dict[str, Any]:
    return {
        "name": model.name,
        "form": model.form,
        "unit": model.unit,
        "doubts": list(model.doubts),
        "parts": [_part_text(part) for part in model.parts],
    }


def _part_text(part: Part) -> dict[str, Any]:
    own, declared = part.properties, part.declared
    return {
        "name": part.name,
        "kind": part.kind.value,
        "properties": None if own is None else [own.mass, own.centre.tolist(), own.inertia.tolist()],
        "declared": None
        if declared is None
        else [declared.mass, None if declared.centre is None else declared.centre.tolist()],
        "vertices": len(part.mesh.vertices),
        "triangles": len(part.mesh.triangles),
        "material": part.material,
        "size": part.size,
        "group": part.group,
        "doubts": list(part.doubts),
    }


def _model(text: dict[str, Any], vertices: Any, triangles: Any) -> CadModel:
    parts = []
    v = t = 0
    for each in text["parts"]:
        own, declared = each["properties"], each["declared"]
        points, corners = vertices[v : v + each["vertices"]], triangles[t : t + each["triangles"]]
        v, t = v + each["vertices"], t + each["triangles"]
        parts.append(
            Part(
                name=str(each["name"]),
                kind=PartKind(each["kind"]),
                properties=None if own is None else MassProperties(*own),
                declared=None if declared is None else _declared(*declared),
                mesh=TriangleMesh(points, corners),
                material=str(each["material"]),
                size=str(each["size"]),
                group=str(each["group"]),
                doubts=tuple(map(str, each["doubts"])),
            )
        )
    doubts = tuple(map(str, text["doubts"]))
    return CadModel(str(text["name"]), str(text["form"]), tuple(parts), str(text["unit"]), doubts)


def _declared(mass: float, centre: list[float] | None) -> DeclaredWeight:
    return DeclaredWeight(float(mass), None if centre is None else np.array(centre, dtype=float))
