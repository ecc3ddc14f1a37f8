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

#: Relative error at which the library ends to refine its integrals over a face. It judges volume or area
#: alone, and moments lag behind: at 1e-7 the centre of a cylinder of revolution is 2 mm off.
_PRECISION = 1e-12
#: Of boundaries that IGES gives twice, in space and on the surface, those that the file prefers, then those
#: in space. Of faces of revolution the library breaks some by the one, some by the other, and may turn them.
_BOUNDARIES = (0, 3)
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
    for place, (names, density, shape, sewn) in enumerate(_bodies(document)):
        part, vertices, faces = _part(shape, sewn, deflection)
        triangles += len(faces)
        if triangles > _MOST_TRIANGLES:
            raise Unreadable(f"it makes more than {_MOST_TRIANGLES} triangles")
        parts.append({"names": names, "density": density, **part})
        arrays[f"v{place}"], arrays[f"t{place}"] = vertices, faces
    arrays["parts"] = np.array(json.dumps({"unit": unit, "doubts": doubts, "parts": parts}))
    np.savez(result, **arrays)


def _read(path: str) -> tuple[Any, str, list[str]]:
    """The file as a document with its assembly tree; its unit of length; doubts."""
    return _read_iges(path) if Path(path).suffix.lower() in (".igs", ".iges") else _read_step(path)


def _read_iges(path: str) -> tuple[Any, str, list[str]]:
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.IGESCAFControl import IGESCAFControl_Reader
    from OCP.Interface import Interface_Static

    IGESCAFControl_Reader()  # it makes the setting known
    found = []
    for boundaries in _BOUNDARIES:
        Interface_Static.SetIVal_s("read.surfacecurve.mode", boundaries)
        reader = IGESCAFControl_Reader()
        if reader.ReadFile(path) != IFSelect_RetDone:
            raise Unreadable("it is no IGES file, or a broken one")
        document = _document()
        if not reader.Transfer(document):
            raise Unreadable("none of its entities could be made into a shape")
        found.append((_broken_faces(document), document))
        if not found[-1][0]:
            break
    broken, document = min(found, key=lambda one: one[0])
    unit = reader.IGESModel().GlobalSection().UnitName()
    doubts = [f"{broken} of its faces are broken, so its mass may be wrong"] if broken else []
    return document, unit.ToCString() if unit is not None else "", doubts


def _broken_faces(document: Any) -> int:
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.TopAbs import TopAbs_FACE
    from OCP.XCAFDoc import XCAFDoc_ShapeTool

    return sum(
        not BRepCheck_Analyzer(face).IsValid()
        for label in _free_labels(document)
        for face in _explored(XCAFDoc_ShapeTool.GetShape_s(label), TopAbs_FACE)
    )


def _read_step(path: str) -> tuple[Any, str, list[str]]:
    from OCP.collections import Sequence_TCollection_AsciiString
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.STEPCAFControl import STEPCAFControl_Reader

    step = STEPCAFControl_Reader()
    step.SetNameMode(True)
    step.SetMatMode(True)
    if step.ReadFile(path) != IFSelect_RetDone:
        raise Unreadable("it is no STEP file, or a broken one")
    names = [Sequence_TCollection_AsciiString() for _ in range(3)]
    step.ChangeReader().FileUnits(*names)
    units = sorted({names[0].Value(place + 1).ToCString() for place in range(names[0].Length())})
    roots = step.NbRootsForTransfer()
    document = _document()
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


def _document() -> Any:
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDocStd import TDocStd_Document

    return TDocStd_Document(TCollection_ExtendedString("XmlOcaf"))


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


def _bodies(document: Any) -> Iterator[tuple[list[str], float, Any, bool]]:
    """Every solid, and every connected surface that belongs to none; whether it was put together here.

    What calls itself a solid and has gaps is a surface.
    """
    from OCP.TopAbs import TopAbs_FACE, TopAbs_SHELL, TopAbs_SOLID
    from OCP.TopLoc import TopLoc_Location

    for label in _free_labels(document):
        for names, density, shape in _leaves(label, TopLoc_Location(), []):
            surfaces = []
            for solid in _explored(shape, TopAbs_SOLID):
                shells = _explored(solid, TopAbs_SHELL)
                if all(_closed(shell) for shell in shells):
                    yield names, density, solid, False
                else:
                    surfaces += shells
            surfaces += _explored(shape, TopAbs_SHELL, TopAbs_SOLID)
            surfaces += _explored(shape, TopAbs_FACE, TopAbs_SHELL)
            for body in _sewn(surfaces):
                yield names, density, body, True


def _explored(shape: Any, wanted: Any, avoided: Any = None) -> list[Any]:
    from OCP.TopExp import TopExp_Explorer

    walk = TopExp_Explorer(shape, wanted) if avoided is None else TopExp_Explorer(shape, wanted, avoided)
    found = []
    while walk.More():
        found.append(walk.Current())
        walk.Next()
    return found


def _sewn(surfaces: list[Any]) -> list[Any]:
    """Loose faces and shells joined where their edges meet; what closes becomes a solid.

    Edges are first joined whole, and cut into pieces only of what does not close by that: where one plate
    stands on another, a piece of an edge of one lies on an edge of the other, though they are two bodies.
    """
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid
    from OCP.BRepLib import BRepLib
    from OCP.TopoDS import TopoDS

    closed: list[Any] = []
    others = surfaces
    for cutting in (False, True):
        shells, others = _joined(others, cutting), []
        for shell in shells:
            for piece in _apart(shell):
                (closed if _closed(piece) else others).append(piece)
    solids = []
    for shell in closed:
        solid = BRepBuilderAPI_MakeSolid(TopoDS.Shell(shell)).Solid()
        BRepLib.OrientClosedSolid_s(solid)
        solids.append(solid)
    return [*_hollowed(solids), *others]


def _joined(surfaces: list[Any], cutting: bool) -> list[Any]:
    """Shells of faces and shells that are joined where edges meet, or pieces of edges.

    Over whole edges all faces are joined, however many: by twos it may be the wrong ones. See `_apart`.
    """
    from OCP.BRepBuilderAPI import BRepBuilderAPI_Sewing
    from OCP.TopAbs import TopAbs_FACE, TopAbs_SHELL

    if not surfaces:
        return []
    sewing = BRepBuilderAPI_Sewing(_size(surfaces) * 1e-6, True, True, cutting, not cutting)
    for surface in surfaces:
        sewing.Add(surface)
    sewing.Perform()
    whole = sewing.SewedShape()
    shells = _explored(whole, TopAbs_SHELL)
    return shells + [_shell_of(face) for face in _explored(whole, TopAbs_FACE, TopAbs_SHELL)]


def _apart(shell: Any) -> list[Any]:
    """The shell, or the bodies in it, where these are closed and have edges of more than two faces in common.

    Joined over such an edge, one body is seen from inside and the other from outside.
    """
    from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE

    faces = _explored(shell, TopAbs_FACE)
    of_edge: dict[int, set[int]] = {}
    for place, face in enumerate(faces):
        for edge in _explored(face, TopAbs_EDGE):
            of_edge.setdefault(hash(edge), set()).add(place)
    body = list(range(len(faces)))
    for pair in of_edge.values():
        if len(pair) == 2:
            one, other = (body[place] for place in pair)
            body = [one if which == other else which for which in body]
    groups: dict[int, list[Any]] = {}
    for face, which in zip(faces, body, strict=True):
        groups.setdefault(which, []).append(face)
    pieces = [_shell_of(*group) for group in groups.values()]
    return pieces if len(pieces) > 1 and all(_closed(piece) for piece in pieces) else [shell]


def _closed(shell: Any) -> bool:
    """Whether a shell has no free edge."""
    from OCP.BRepCheck import BRepCheck_NoError, BRepCheck_Shell
    from OCP.TopoDS import TopoDS

    return bool(BRepCheck_Shell(TopoDS.Shell(shell)).Closed() == BRepCheck_NoError)


def _shell_of(*faces: Any) -> Any:
    """Faces as a shell; a sphere or a torus is closed by itself."""
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Shell

    shell = TopoDS_Shell()
    builder = BRep_Builder()
    builder.MakeShell(shell)
    for face in faces:
        builder.Add(shell, face)
    return shell


def _hollowed(solids: list[Any]) -> list[Any]:
    """Solids made of loose faces, which say nothing of their sides: one that lies within another is a cavity.

    Within a cavity there may be a solid again, and so on.
    """
    from OCP.BRep import BRep_Builder
    from OCP.TopAbs import TopAbs_SHELL

    sizes = [_size([solid]) for solid in solids]
    within = [
        [
            other
            for other, outer in enumerate(solids)
            if sizes[other] > sizes[place] and _contains(outer, inner)
        ]
        for place, inner in enumerate(solids)
    ]
    builder = BRep_Builder()
    bodies = []
    for place, inner in enumerate(solids):
        if len(within[place]) % 2 == 0:
            bodies.append(inner)
            continue
        outer = solids[min(within[place], key=lambda other: sizes[other])]
        for shell in _explored(inner, TopAbs_SHELL):
            builder.Add(outer, shell.Reversed())
    return bodies


def _contains(outer: Any, inner: Any) -> bool:
    """Whether a corner of one solid lies within the other."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepClass3d import BRepClass3d_SolidClassifier
    from OCP.TopAbs import TopAbs_IN, TopAbs_VERTEX
    from OCP.TopoDS import TopoDS

    box, other = _box([outer]), _box([inner])
    if box.IsOut(other):
        return False
    corner = BRep_Tool.Pnt_s(TopoDS.Vertex(_explored(inner, TopAbs_VERTEX)[0]))
    return bool(BRepClass3d_SolidClassifier(outer, corner, 1e-6 * _size([outer])).State() == TopAbs_IN)


def _box(shapes: list[Any]) -> Any:
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib

    box = Bnd_Box()
    for shape in shapes:
        BRepBndLib.Add_s(shape, box)
    return box


def _size(shapes: list[Any]) -> float:
    box = _box(shapes)
    return 1.0 if box.IsVoid() else float(box.SquareExtent()) ** 0.5


def _part(shape: Any, sewn: bool, deflection: float) -> tuple[dict[str, Any], Any, Any]:
    """Volume or area, first and second moments of a shape, what is doubtful of it, and its triangles."""
    from OCP.BRepGProp import BRepGProp
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.GProp import GProp_GProps
    from OCP.TopAbs import TopAbs_SHELL, TopAbs_SOLID

    solid = shape.ShapeType() == TopAbs_SOLID
    shells = _explored(shape, TopAbs_SHELL) if solid else []
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
        "agree": all(_agree(shell) for shell in shells),
        "cavities": len(shells) - 1 if sewn and solid else 0,
        "content": found.Mass(),
        "centre": [centre.X(), centre.Y(), centre.Z()],
        "inertia": [[matrix.Value(row + 1, column + 1) for column in range(3)] for row in range(3)],
    }
    return part, vertices, triangles


def _agree(shell: Any) -> bool:
    """Whether neighbouring faces of a shell agree on which side is outside."""
    from OCP.BRepCheck import BRepCheck_NoError, BRepCheck_Shell
    from OCP.TopoDS import TopoDS

    return bool(BRepCheck_Shell(TopoDS.Shell(shell)).Orientation() == BRepCheck_NoError)


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
