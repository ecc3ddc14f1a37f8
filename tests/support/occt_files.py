"""STEP and IGES files of small bodies, written by Open CASCADE in a process of its own; millimetres."""

from __future__ import annotations

import json
import subprocess
import sys
from functools import cache
from pathlib import Path

#: Reads a line with path and body for each file, and says when it is written; ends with its input.
_PROGRAM = """
import json
import sys
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.BRep import BRep_Builder
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder, BRepPrimAPI_MakeSphere
from OCP.IGESControl import IGESControl_Writer
from OCP.STEPControl import STEPControl_StepModelType, STEPControl_Writer
from OCP.TopAbs import TopAbs_FACE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS_Compound, TopoDS_Shell, TopoDS_Solid

def box(sizes, corner):
    return BRepPrimAPI_MakeBox(gp_Pnt(*corner), *sizes).Shape()

def cylinder(radius, height, foot):
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(*foot), gp_Dir(0, 0, 1)), radius, height).Shape()

def sphere(radius, centre):
    return BRepPrimAPI_MakeSphere(gp_Pnt(*centre), radius).Shape()

def cut(body, *tools):
    for tool in tools:
        body = BRepAlgoAPI_Cut(body, tool).Shape()
    return body

def together(*bodies):
    builder, whole = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(whole)
    for body in bodies:
        builder.Add(whole, body)
    return whole

def without_a_face(body):
    builder, shell, solid = BRep_Builder(), TopoDS_Shell(), TopoDS_Solid()
    builder.MakeShell(shell)
    walk = TopExp_Explorer(body, TopAbs_FACE)
    walk.Next()
    while walk.More():
        builder.Add(shell, walk.Current())
        walk.Next()
    builder.MakeSolid(solid)
    builder.Add(solid, shell)
    return solid

def write(path, body):
    if path.endswith(".igs"):
        writer = IGESControl_Writer("MM", 0)  # trimmed surfaces, which is what IGES files mostly hold
        writer.AddShape(body)
        writer.ComputeModel()
    else:
        writer = STEPControl_Writer()
        writer.Transfer(body, STEPControl_StepModelType.STEPControl_AsIs)
    writer.Write(path)

for line in sys.stdin:
    path, body = json.loads(line)
    write(path, eval(body))
    print("\\nWRITTEN", flush=True)
"""


@cache
def _writer() -> subprocess.Popen[str]:
    """One process for all files: Open CASCADE takes most of a second to load."""
    program = [sys.executable, "-c", _PROGRAM]
    return subprocess.Popen(program, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def written(path: Path, body: str) -> Path:
    """A file of one body: of its surfaces if the name ends on ``.igs``, of solids if on ``.step``.

    Args:
        path: the file.
        body: Python that makes it, in millimetres, of the functions above.
    """
    process = _writer()
    assert process.stdin is not None and process.stdout is not None
    print(json.dumps([str(path), body]), file=process.stdin, flush=True)
    # Before that the library tells of its work.
    assert any(line == "WRITTEN\n" for line in process.stdout), f"{body}: could not be written"
    return path
