"""Loads from CAD: parts with mass, centre of gravity and inertia."""

from __future__ import annotations

from pathlib import Path

from gantline.arguments import path_of
from gantline.cad.assumptions import Assumptions
from gantline.cad.errors import CadError
from gantline.cad.files import content
from gantline.cad.mesh import TriangleMesh
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
    "read_light_mesh",
    "read_surface",
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
        TypeError: if it is no path.
    """
    place = path_of(path, "a CAD file")
    data = content(place)
    if _is_ocx(place, data):
        model = _kept(place, data, Assumptions(), keep)
        _check_given(place, model, given)
        return model
    return _kept(place, data, given if given is not None else Assumptions(), keep)


def _is_ocx(place: Path, data: bytes) -> bool:
    return place.suffix.lower() in _OCX or b"ocxXML" in data[:4096]


def _check_given(place: Path, model: CadModel, given: Assumptions | None) -> None:
    """OCX files say their units and have z up; anything else that is asked for is a misunderstanding."""
    if given is not None and given.up == "y":
        raise CadError(f"{place}: its axes are those of the ship, as the format has it, so z is up and not y")
    said = model.unit.partition(",")[0].split(" and ")
    if given is not None and given.unit is not None and given.unit not in said:
        raise CadError(
            f"{place}: its lengths are in {' and '.join(said)}, as it says itself, not in {given.unit}"
        )


def _kept(place: Path, data: bytes, assumed: Assumptions, keep: bool, *deflection: float) -> CadModel:
    """From the cache, or read; triangles of STEP and IGES as close as usual, or as asked for."""
    from gantline.cad import cache

    key = cache.digest(data, place.name, assumed, *deflection)
    model = cache.load(key) if keep else None
    if model is None:
        model = _read(place, data, assumed, *deflection)
        if keep:
            cache.store(key, model)
    return model


def read_light_mesh(
    path: str | Path, given: Assumptions | None = None, *, most: int = 4000, keep: bool = True
) -> TriangleMesh:
    """A mesh of at most so many triangles to draw a CAD file with; other arguments as for `read`.

    Raises:
        CadError: if the file cannot be read, or has no geometry.
    """
    from gantline.cad import cache
    from gantline.cad.simplify import light_mesh

    place = path_of(path, "a CAD file")
    key = cache.digest(content(place), place.name, given or Assumptions(), most)
    kept = cache.load(key) if keep else None
    if kept is not None:
        return kept.mesh
    model = read(place, given, keep=keep)
    light = light_mesh(model.mesh, most).mesh
    if keep:
        part = Part(model.name, PartKind.SHELL, None, None, light)
        cache.store(key, CadModel(model.name, model.form, (part,), model.unit))
    return light


def read_surface(
    path: str | Path, given: Assumptions | None = None, *, keep: bool = True
) -> tuple[TriangleMesh, tuple[str, ...]]:
    """The outside of a thing as triangles, whatever it weighs: of a hull for instance.

    Triangles of a file of triangles are those of the file, neither welded nor turned; of STEP and IGES they
    approximate its faces. Arguments as for `read`.

    Returns:
        the triangles [m], z up, in the file's own axes; what is doubtful, a sentence each.

    Raises:
        CadError: if the file cannot be read, or has no geometry.
    """
    from gantline.cad.mesh_file import mesh_format, read_surface_file

    place = path_of(path, "a CAD file")
    if mesh_format(place) is not None:
        return read_surface_file(place, given if given is not None else Assumptions())
    if _is_ocx(place, content(place)):
        raise CadError(f"{place}: an OCX file has plates and no surface of the whole")
    from gantline.cad.step import FINE

    model = _kept(place, content(place), given if given is not None else Assumptions(), keep, FINE)
    if not len(model.mesh.triangles):
        raise CadError(f"{place}: no part has geometry")
    return model.mesh, model.doubts


def _read(place: Path, data: bytes, given: Assumptions, *deflection: float) -> CadModel:
    if _is_ocx(place, data):
        from gantline.cad.ocx.reader import read_ocx

        return read_ocx(data, place.name)
    from gantline.cad.geometry import GEOMETRY_FORMATS, read_geometry

    if not place.name.lower().endswith(tuple(GEOMETRY_FORMATS)):
        known = ", ".join([*_OCX, *GEOMETRY_FORMATS])
        raise CadError(f"{place}: is no CAD file that can be read; these can: {known}")
    return read_geometry(place, given, *deflection)
