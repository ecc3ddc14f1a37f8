"""A program of its own: reads a STEP or IGES file with Open CASCADE and writes what it holds as arrays.

`gantline.cad.step` runs it as `python _occt.py FILE RESULT DEFLECTION LARGEST_MEMORY`. It stands apart so
that a file on which that library fails, hangs or asks for all memory costs one message and not the session.
It imports nothing of gantline. Lengths are millimetres throughout, the library's unit.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

#: Relative error of the integrals over curved faces.
_PRECISION = 1e-7
#: How far the normal may turn from triangle to triangle [rad].
_TURN = 0.5
#: Triangles of all parts together; a file of more is refused.
_MOST_TRIANGLES = 2_000_000


class Unreadable(Exception):
    """The file cannot be read; the message is the reason."""


def main(path: str, result: str, deflection: float) -> None:
    """Read a file, write its parts."""
    document, unit, doubts = _read(path)
    arrays: dict[str, Any] = {}
    parts = []
    triangles = 0
    for place, (names, density, shape) in enumerate(_bodies(document)):
        part, vertices, faces = _part(shape, deflection)
        triangles += len(faces)
        if triangles > _MOST_TRIANGLES:
            raise Unreadable(f"it makes more than {_MOST_TRIANGLES} triangles")
        parts.append({"names": names, "density": density, **part})
        arrays[f"v{place}"], arrays[f"t{place}"] = vertices, faces
    arrays["parts"] = np.array(json.dumps({"unit": unit, "doubts": doubts, "parts": parts}))
    np.savez(result, **arrays)


def _read(path: str) -> tuple[Any, str, list[str]]:
    """The file as a document with its assembly tree; its unit of length; doubts."""
    from OCP.collections import Sequence_TCollection_AsciiString
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.IGESCAFControl import IGESCAFControl_Reader
    from OCP.STEPCAFControl import STEPCAFControl_Reader
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDocStd import TDocStd_Document

    document = TDocStd_Document(TCollection_ExtendedString("XmlOcaf"))
    if Path(path).suffix.lower() in (".igs", ".iges"):
        reader = IGESCAFControl_Reader()
        if reader.ReadFile(path) != IFSelect_RetDone:
            raise Unreadable("it is no IGES file, or a broken one")
        unit = reader.IGESModel().GlobalSection().UnitName()
        name = unit.ToCString() if unit is not None else ""
        if not reader.Transfer(document):
            raise Unreadable("none of its entities could be made into a shape")
        return document, name, []
    step = STEPCAFControl_Reader()
    step.SetNameMode(True)
    step.SetMatMode(True)
    if step.ReadFile(path) != IFSelect_RetDone:
        raise Unreadable("it is no STEP file, or a broken one")
    names = [Sequence_TCollection_AsciiString() for _ in range(3)]
    step.ChangeReader().FileUnits(*names)
    units = sorted({names[0].Value(place + 1).ToCString() for place in range(names[0].Length())})
    roots = step.NbRootsForTransfer()
    if not step.Transfer(document):
        raise Unreadable("none of its entities could be made into a shape")
    free = len(_free_labels(document))
    doubts = []
    if 0 < free < roots:
        doubts.append(
            f"{roots - free} of the {roots} shapes that the file lists are parts that another one places; "
            "they count once"
        )
    return document, ", ".join(units), doubts


def _labels(sequence: Any) -> list[Any]:
    return [sequence.Value(place + 1) for place in range(sequence.Length())]


def _free_labels(document: Any) -> list[Any]:
    from OCP.collections import Sequence_TDF_Label
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    labels = Sequence_TDF_Label()
    XCAFDoc_DocumentTool.ShapeTool_s(document.Main()).GetFreeShapes(labels)
    return _labels(labels)


def _name(label: Any) -> str:
    from OCP.TDataStd import TDataStd_Name

    name = TDataStd_Name()
    return name.Get().ToExtString().strip() if label.FindAttribute(TDataStd_Name.GetID_s(), name) else ""


def _leaves(label: Any, location: Any, names: list[str]) -> Iterator[tuple[list[str], float, Any]]:
    """Parts below a label of the assembly tree with their names from the top, densities and placed shapes."""
    from OCP.collections import Sequence_TDF_Label
    from OCP.TDF import TDF_Label
    from OCP.XCAFDoc import XCAFDoc_MaterialTool, XCAFDoc_ShapeTool

    if not XCAFDoc_ShapeTool.IsAssembly_s(label):
        shape = XCAFDoc_ShapeTool.GetShape_s(label)
        yield [*names, _name(label)], XCAFDoc_MaterialTool.GetDensityForShape_s(label), shape.Moved(location)
        return
    components = Sequence_TDF_Label()
    XCAFDoc_ShapeTool.GetComponents_s(label, components)
    for component in _labels(components):
        product = TDF_Label()
        XCAFDoc_ShapeTool.GetReferredShape_s(component, product)
        placed = location.Multiplied(XCAFDoc_ShapeTool.GetLocation_s(component))
        yield from _leaves(product, placed, [*names, _name(label)])


def _bodies(document: Any) -> Iterator[tuple[list[str], float, Any]]:
    """Every solid, and every connected surface that belongs to none."""
    from OCP.TopAbs import TopAbs_FACE, TopAbs_SHELL, TopAbs_SOLID
    from OCP.TopLoc import TopLoc_Location

    for label in _free_labels(document):
        for names, density, shape in _leaves(label, TopLoc_Location(), []):
            found = [
                *_explored(shape, TopAbs_SOLID),
                *_sewn(
                    [
                        *_explored(shape, TopAbs_SHELL, TopAbs_SOLID),
                        *_explored(shape, TopAbs_FACE, TopAbs_SHELL),
                    ]
                ),
            ]
            for body in found:
                yield names, density, body


def _explored(shape: Any, wanted: Any, avoided: Any = None) -> list[Any]:
    from OCP.TopExp import TopExp_Explorer

    walk = TopExp_Explorer(shape, wanted) if avoided is None else TopExp_Explorer(shape, wanted, avoided)
    found = []
    while walk.More():
        found.append(walk.Current())
        walk.Next()
    return found


def _sewn(surfaces: list[Any]) -> list[Any]:
    """Loose faces and shells joined where their edges meet; what closes becomes a solid."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid, BRepBuilderAPI_Sewing
    from OCP.BRepLib import BRepLib
    from OCP.TopAbs import TopAbs_FACE, TopAbs_SHELL
    from OCP.TopoDS import TopoDS

    if not surfaces:
        return []
    sewing = BRepBuilderAPI_Sewing(_size(surfaces) * 1e-6)
    for surface in surfaces:
        sewing.Add(surface)
    sewing.Perform()
    whole = sewing.SewedShape()
    found = []
    for shell in _explored(whole, TopAbs_SHELL):
        if BRep_Tool.IsClosed_s(shell):
            solid = BRepBuilderAPI_MakeSolid(TopoDS.Shell(shell)).Solid()
            BRepLib.OrientClosedSolid_s(solid)
            found.append(solid)
        else:
            found.append(shell)
    return [*found, *_explored(whole, TopAbs_FACE, TopAbs_SHELL)]


def _size(shapes: list[Any]) -> float:
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib

    box = Bnd_Box()
    for shape in shapes:
        BRepBndLib.Add_s(shape, box)
    return 1.0 if box.IsVoid() else float(box.SquareExtent()) ** 0.5


def _part(shape: Any, deflection: float) -> tuple[dict[str, Any], Any, Any]:
    """Volume or area, first and second moments of a shape, and its triangles."""
    from OCP.BRepGProp import BRepGProp
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.GProp import GProp_GProps
    from OCP.TopAbs import TopAbs_SOLID

    solid = shape.ShapeType() == TopAbs_SOLID
    found = GProp_GProps()
    if solid:
        BRepGProp.VolumeProperties_s(shape, found, _PRECISION, False)
    else:
        BRepGProp.SurfaceProperties_s(shape, found, _PRECISION)
    centre, matrix = found.CentreOfMass(), found.MatrixOfInertia()
    BRepMesh_IncrementalMesh(shape, max(deflection * _size([shape]), 1e-3), False, _TURN)
    vertices, triangles = _triangles(shape)
    part = {
        "solid": solid,
        "content": found.Mass(),
        "centre": [centre.X(), centre.Y(), centre.Z()],
        "inertia": [[matrix.Value(row + 1, column + 1) for column in range(3)] for row in range(3)],
    }
    return part, vertices, triangles


def _triangles(shape: Any) -> tuple[Any, Any]:
    from OCP.BRep import BRep_Tool
    from OCP.TopAbs import TopAbs_FACE, TopAbs_REVERSED
    from OCP.TopLoc import TopLoc_Location
    from OCP.TopoDS import TopoDS

    vertices: list[tuple[float, float, float]] = []
    triangles: list[tuple[int, int, int]] = []
    for found in _explored(shape, TopAbs_FACE):
        face = TopoDS.Face(found)
        location = TopLoc_Location()
        mesh = BRep_Tool.Triangulation_s(face, location)
        if mesh is None:
            continue
        start = len(vertices) - 1
        placed = location.Transformation()
        for place in range(1, mesh.NbNodes() + 1):
            point = mesh.Node(place).Transformed(placed)
            vertices.append((point.X(), point.Y(), point.Z()))
        backwards = face.Orientation() == TopAbs_REVERSED
        for place in range(1, mesh.NbTriangles() + 1):
            triangle = mesh.Triangle(place)
            a, b, c = (start + triangle.Value(corner) for corner in (1, 2, 3))
            triangles.append((a, c, b) if backwards else (a, b, c))
    return np.array(vertices, dtype=float).reshape(-1, 3), np.array(triangles, dtype=np.int32).reshape(-1, 3)


def _limit_memory(most: int) -> None:
    try:
        import resource
    except ImportError:  # not on every system; the time limit remains
        return
    resource.setrlimit(resource.RLIMIT_AS, (most, most))


if __name__ == "__main__":
    _limit_memory(int(sys.argv[4]))
    try:
        main(sys.argv[1], sys.argv[2], float(sys.argv[3]))
    except Unreadable as reason:
        print(reason, file=sys.stderr)
        sys.exit(2)
    except MemoryError:
        print("it needs too much memory", file=sys.stderr)
        sys.exit(2)
