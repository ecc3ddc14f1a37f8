"""Files of plain geometry, by the ending of their name."""

from __future__ import annotations

from pathlib import Path

from gantline.cad.assumptions import Assumptions
from gantline.cad.mesh_file import MESH_FORMATS, read_mesh_file
from gantline.cad.model import CadModel
from gantline.cad.step import COARSE, STEP_FORMATS, read_step_file

__all__ = ["GEOMETRY_FORMATS", "read_geometry"]

#: Endings of names, and how the formats are called.
GEOMETRY_FORMATS = {**STEP_FORMATS, **MESH_FORMATS, ".stl.gz": "STL", ".obj.gz": "OBJ"}


def read_geometry(path: Path, given: Assumptions, deflection: float = COARSE) -> CadModel:
    """A file of solids and surfaces without weights of its own: STEP, IGES, STL, OBJ, glTF or GLB.

    Arguments as for `read_step_file`; files of triangles have those that they have.

    Raises:
        CadError: if it cannot be read.
    """
    if path.suffix.lower() in STEP_FORMATS:
        return read_step_file(path, given, deflection)
    return read_mesh_file(path, given)
