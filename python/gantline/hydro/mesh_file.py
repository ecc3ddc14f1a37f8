"""Hulls from files, read as CAD files are: STL and OBJ, GLB, STEP and IGES."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from gantline.cad import Assumptions, CadError, read_surface
from gantline.cad.mesh_file import MESH_FORMATS, mesh_format
from gantline.hydro.hull import Hull
from gantline.hydro.shapes import box_hull
from gantline.units import DIMENSIONS, UnitError, quantity

__all__ = ["HullError", "read_hull"]


class HullError(ValueError):
    """A hull that cannot be read; the message says what is wrong."""


def read_hull(given: str | Path, unit: str | None = None, *, up: Literal["y", "z"] | None = None) -> Hull:
    """A hull from a file, or `box:100m,30m,8m` for a box of that length, breadth and depth.

    Args:
        given: CAD file of the hull, see `gantline.cad.read_surface`, or a box.
        unit: unit of length in the file; None takes what the file says, or metres where it says none.
        up: axis of the file that points up; None for the format's own: y in glTF, z in all others.

    Raises:
        HullError: if there is no such file, or it holds no hull.
    """
    text = str(given)
    try:
        if unit is not None and unit not in DIMENSIONS["length"]:
            raise HullError(f"'{unit}' is no unit of length; there are {', '.join(DIMENSIONS['length'])}")
        if text.startswith("box:"):
            return _box(text)
        path = Path(given)
        if unit is None and MESH_FORMATS.get(mesh_format(path) or "") in ("STL", "OBJ"):
            unit = "m"
        mesh, doubts = read_surface(path, Assumptions(unit=unit, up=up))
        return Hull(path.name, mesh.vertices, mesh.triangles, doubts=doubts)
    except (HullError, CadError) as problem:
        raise HullError(str(problem)) from None
    except ValueError as problem:
        raise HullError(f"{text}: {problem}") from None


def _box(text: str) -> Hull:
    parts = text.removeprefix("box:").split(",")
    if len(parts) != 3:
        raise HullError(f"'{text}' is no box; it would be right as box:100m,30m,8m: length, breadth, depth")
    try:
        return box_hull([quantity(part.strip(), "length") for part in parts], text)
    except UnitError as problem:
        raise HullError(f"'{text}': {problem}") from None
