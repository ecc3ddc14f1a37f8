"""Loads from CAD: parts with mass, centre of gravity and inertia."""

from __future__ import annotations

from pathlib import Path

from gantline.cad.assumptions import Assumptions
from gantline.cad.errors import CadError
from gantline.cad.files import content
from gantline.cad.model import CadModel, Comparison, DeclaredWeight, Part, PartKind

__all__ = [
    "Assumptions",
    "CadError",
    "CadModel",
    "Comparison",
    "DeclaredWeight",
    "Part",
    "PartKind",
    "read",
]

_OCX = (".3docx", ".ocx", ".xml")


def read(path: str | Path, given: Assumptions | None = None, *, keep: bool = True) -> CadModel:
    """Read a CAD file.

    Args:
        path: an OCX file (`.3docx`, `.ocx`, or `.xml`), STEP, IGES, STL, OBJ, glTF or GLB.
        given: what to take where the file says nothing; OCX says everything itself.
        keep: whether the user's cache is used: a model that was read before taken from it, this one kept.

    Returns:
        Its parts, in the file's own axes.

    Raises:
        CadError: if it cannot be read, with one plain sentence.
    """
    from gantline.cad import cache

    place = Path(path)
    assumed = given if given is not None else Assumptions()
    data = content(place)
    key = cache.digest(data, place.name, assumed)
    model = cache.load(key) if keep else None
    if model is None:
        model = _read(place, data, assumed)
        if keep:
            cache.store(key, model)
    return model


def _read(place: Path, data: bytes, given: Assumptions) -> CadModel:
    if place.suffix.lower() in _OCX or b"ocxXML" in data[:4096]:
        from gantline.cad.ocx.reader import read_ocx

        if given.unit is not None:
            raise CadError(f"{place}: an OCX file says its units itself; no other can be asked for")
        return read_ocx(data, place.name)
    from gantline.cad.geometry import GEOMETRY_FORMATS, read_geometry

    if not place.name.lower().endswith(tuple(GEOMETRY_FORMATS)):
        known = ", ".join([*_OCX, *GEOMETRY_FORMATS])
        raise CadError(f"{place}: is no CAD file that can be read; these can: {known}")
    return read_geometry(place, given)
