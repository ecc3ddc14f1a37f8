"""Loads from CAD: parts with mass, centre of gravity and inertia."""

from __future__ import annotations

from pathlib import Path

from gantline.cad.errors import CadError
from gantline.cad.model import CadModel, Comparison, DeclaredWeight, Part, PartKind

__all__ = ["CadError", "CadModel", "Comparison", "DeclaredWeight", "Part", "PartKind", "read"]

_OCX = {".3docx", ".ocx", ".xml"}
_MOST_BYTES = 512_000_000


def read(path: str | Path, *, keep: bool = True) -> CadModel:
    """Read a CAD file.

    Args:
        path: an OCX file (`.3docx`, `.ocx`, or `.xml`).
        keep: whether the user's cache is used: a model that was read before taken from it, this one kept.

    Returns:
        Its parts, in the file's own axes.

    Raises:
        CadError: if it cannot be read, with one plain sentence.
    """
    from gantline.cad import cache

    place = Path(path)
    data = _content(place)
    key = cache.digest(data, place.name)
    model = cache.load(key) if keep else None
    if model is None:
        model = _read(place, data)
        if keep:
            cache.store(key, model)
    return model


def _read(place: Path, data: bytes) -> CadModel:
    if place.suffix.lower() in _OCX or b"ocxXML" in data[:4096]:
        from gantline.cad.ocx.reader import read_ocx

        return read_ocx(data, place.name)
    raise CadError(f"{place}: is no CAD file that can be read; these can: {', '.join(sorted(_OCX))}")


def _content(place: Path) -> bytes:
    try:
        if place.stat().st_size > _MOST_BYTES:
            raise CadError(f"{place}: is larger than {_MOST_BYTES // 1_000_000} MB, so it is not read")
        return place.read_bytes()
    except OSError as problem:
        raise CadError(f"{place}: cannot be read ({(problem.strerror or str(problem)).lower()})") from None
