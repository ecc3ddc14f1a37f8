"""Files of plain geometry: STL, OBJ, glTF and GLB, STEP and IGES; what is doubtful or broken in them."""

from __future__ import annotations

import base64
import gzip
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from gantline.cad import _occt, mesh_file, step
from gantline.cad.assumptions import Assumptions
from gantline.cad.errors import CadError
from gantline.cad.geometry import read_geometry
from gantline.cad.mesh import TriangleMesh
from gantline.cad.model import CadModel, PartKind
from solids import box, sphere

SQUARE = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));
ENDSEC;
DATA;
"""


def binary_stl(mesh: TriangleMesh, factor: float = 1.0) -> bytes:
    """Header, count, and for each triangle a normal, three corners and two bytes."""
    rows = np.zeros(len(mesh.triangles), dtype=[("f", "<f4", (4, 3)), ("attribute", "<u2")])
    rows["f"][:, 1:] = mesh.corners * factor
    return bytes(80) + len(rows).to_bytes(4, "little") + rows.tobytes()


def text_stl(mesh: TriangleMesh) -> str:
    lines = ["solid thing"]
    for triangle in mesh.corners.tolist():
        vertices = "".join(f"vertex {x} {y} {z}\n" for x, y, z in triangle)
        lines.append(f"facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet")
    return "\n".join([*lines, "endsolid thing", ""])


def obj(*meshes: TriangleMesh) -> str:
    text, start = "mtllib not_there.mtl\n", 1
    for place, mesh in enumerate(meshes):
        text += f"o part{place}\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in mesh.vertices.tolist())
        text += "".join(f"f {a} {b} {c}\n" for a, b, c in (mesh.triangles + start).tolist())
        start += len(mesh.vertices)
    return text


def read(path: Path, content: bytes | str, **given: object) -> CadModel:
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return read_geometry(path, Assumptions(**given))  # type: ignore[arg-type]


def test_text_and_binary_stl_give_the_same(tmp_path: Path) -> None:
    mesh = box((2, 3, 5), middle=(1, 0, 0))
    one = read(tmp_path / "a.stl", text_stl(mesh))
    other = read(tmp_path / "b.stl", binary_stl(mesh))
    packed = tmp_path / "c.stl.gz"
    packed.write_bytes(gzip.compress(binary_stl(mesh)))
    for model in (one, other, read_geometry(packed, Assumptions())):
        assert [part.kind for part in model.parts] == [PartKind.SOLID]
        assert model.properties.mass == pytest.approx(7850 * 30)
        assert model.properties.centre == pytest.approx([1, 0, 0])
    assert [one.parts[0].name, other.parts[0].name] == ["a", "b"]


def test_a_unit_is_guessed_and_said_or_asked_for(tmp_path: Path) -> None:
    mesh = box((2, 3, 5))
    model = read(tmp_path / "a.stl", binary_stl(mesh, factor=1e3))
    assert model.unit == "mm, guessed"
    assert model.properties.mass == pytest.approx(7850 * 30)
    assert "with it the whole is 6.16 m from corner to corner" in model.doubts[0]
    asked = read(tmp_path / "a.stl", binary_stl(mesh, factor=1e3), unit="cm", density=1000.0)
    assert asked.unit == "cm, as asked for" and asked.doubts == ()
    assert asked.properties.mass == pytest.approx(1000 * 30 * 1e3)


def test_a_cavity_is_taken_off(tmp_path: Path) -> None:
    hollow = TriangleMesh.combined([box((4, 3, 2)), box((3, 2, 1)).flipped()])
    model = read(tmp_path / "a.stl", binary_stl(hollow))
    assert len(model.parts) == 1
    assert model.properties.mass == pytest.approx(7850 * (24 - 6))
    # A piece that faces inwards and lies in none is not a cavity but inside out.
    beside = TriangleMesh.combined([box((4, 3, 2)), box((3, 2, 1), middle=(10, 0, 0)).flipped()])
    model = read(tmp_path / "a.stl", binary_stl(beside))
    assert model.properties.mass == pytest.approx(7850 * (24 + 6))
    assert model.parts[1].doubts == ("all its triangles faced inwards; they are turned",)


def test_flipped_and_repeated_triangles_are_put_right_and_said(tmp_path: Path) -> None:
    mesh = box((4, 3, 2))
    triangles = mesh.triangles.copy()
    triangles[[2, 7]] = triangles[[2, 7]][:, ::-1]
    wrong = TriangleMesh(mesh.vertices, np.vstack([triangles, triangles[:1]]))
    model = read(tmp_path / "a.stl", binary_stl(wrong))
    assert model.properties.mass == pytest.approx(7850 * 24)
    assert model.parts[0].doubts == (
        "1 of 13 triangles are there twice; they count once",
        "2 of 12 triangles faced the wrong side; they are turned",
    )


def test_an_open_surface_weighs_by_its_plate_thickness(tmp_path: Path) -> None:
    tray = box((4, 3, 2)).of(np.arange(10))  # without the two triangles of its side at x = 2
    model = read(tmp_path / "a.stl", binary_stl(tray))
    part = model.parts[0]
    assert part.kind is PartKind.SHELL and part.properties is None
    assert part.doubts[0] == "open surface of 1 piece with 4 free edges"
    assert "no plate thickness" in part.doubts[1]
    model = read(tmp_path / "a.stl", binary_stl(tray), thickness=0.01)
    area = 2 * (4 * 3 + 4 * 2 + 3 * 2) - 3 * 2
    assert model.properties.mass == pytest.approx(78.5 * area)
    # Moments of area about x = 0: only the side at x = −2 has no partner.
    assert model.properties.centre == pytest.approx([-2 * 6 / area, 0, 0], abs=1e-9)
    assert model.parts[0].size == "10 mm"


def test_a_surface_drawn_from_both_sides_counts_once(tmp_path: Path) -> None:
    sheet = box((4, 3, 2)).of(np.arange(2))
    both = TriangleMesh(sheet.vertices, np.vstack([sheet.triangles, sheet.triangles[:, ::-1]]))
    model = read(tmp_path / "a.stl", binary_stl(both), thickness=0.01)
    assert model.properties.mass == pytest.approx(78.5 * 12)
    assert "2 triangles are there from both sides; they count once" in model.parts[0].doubts


def test_objects_of_an_obj_are_parts(tmp_path: Path) -> None:
    model = read(tmp_path / "a.obj", obj(box((1, 1, 1)), sphere(2, 8)))
    assert len(model.parts) == 2
    assert model.parts[0].properties is not None
    assert model.parts[0].properties.mass == pytest.approx(7850)


def glb(mesh: TriangleMesh, translation: tuple[float, float, float], **changes: object) -> bytes:
    points, indices = mesh.vertices.astype("<f4").tobytes(), mesh.triangles.astype("<u4").tobytes()
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "girder", "translation": translation}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(mesh.vertices), "type": "VEC3",
             "min": mesh.box[0].tolist(), "max": mesh.box[1].tolist()},
            {"bufferView": 1, "componentType": 5125, "count": mesh.triangles.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(points)},
            {"buffer": 0, "byteOffset": len(points), "byteLength": len(indices)},
        ],
        "buffers": [{"byteLength": len(points) + len(indices)}],
    } | changes  # fmt: skip
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    body = points + indices
    chunks = (
        len(text).to_bytes(4, "little") + b"JSON" + text + len(body).to_bytes(4, "little") + b"BIN\0" + body
    )
    return b"glTF" + (2).to_bytes(4, "little") + (12 + len(chunks)).to_bytes(4, "little") + chunks


def test_gltf_with_its_buffer_inside(tmp_path: Path) -> None:
    packed = glb(box((2, 3, 5)), (0, 0, 0))
    length = int.from_bytes(packed[12:16], "little")
    document = json.loads(packed[20 : 20 + length])
    body = packed[28 + length :]
    document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(body).decode()
    model = read(tmp_path / "a.gltf", json.dumps(document))
    assert model.form == "glTF"
    assert model.properties.mass == pytest.approx(7850 * 30)


def test_glb_is_in_metres_with_y_up(tmp_path: Path) -> None:
    """A box of 2 × 3 × 5 at (1, 10, 0) in a frame with y up stands 10 m above, 3 m high."""
    data = glb(box((2, 3, 5)), (1, 10, 0))
    model = read(tmp_path / "a.glb", data)
    assert model.parts[0].name == "girder"
    assert model.unit == "m, as the format has it"
    assert model.properties.centre == pytest.approx([1, 0, 10])
    assert model.box[1] - model.box[0] == pytest.approx([2, 5, 3])
    assert "turned from y up" in model.doubts[0]
    as_it_is = read(tmp_path / "a.glb", data, up="z")
    assert as_it_is.properties.centre == pytest.approx([1, 10, 0]) and as_it_is.doubts == ()


def gltf(indices: list[int], size: float = 1.0) -> str:
    """One triangle of the given size, with whatever stands for its corners."""
    points = (np.eye(3) * size).astype("<f4").tobytes()
    body = points + np.array(indices, dtype="<u2").tobytes()
    parts = [(0, len(points)), (len(points), len(body) - len(points))]
    kinds = [(5126, 3, "VEC3"), (5123, len(indices), "SCALAR")]
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "girder"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": view, "componentType": component, "count": count, "type": kind}
            for view, (component, count, kind) in enumerate(kinds)
        ],
        "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": long} for at, long in parts],
        "buffers": [
            {"byteLength": len(body), "uri": f"data:;base64,{base64.b64encode(body).decode('ascii')}"}
        ],
    }
    return json.dumps(document)


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("a.stl", b"", "the file is empty"),
        ("a.stl", binary_stl(sphere(1, 4))[:-70], "cut off: 128 triangles are announced, 126 are there"),
        ("a.stl", b"\xff" * 100, "it is no STL file, or cut off: 4294967295 triangles are announced, 0 are"),
        ("a.stl", text_stl(box((1, 1, 1)))[:-30], "it does not end on 'endsolid'"),
        ("a.stl", binary_stl(TriangleMesh([[0, 0, 0]], np.zeros((0, 3)))), "there are no triangles"),
        ("a.stl", binary_stl(TriangleMesh([[0, 0, 0]], [[0, 0, 0]])), "all vertices are in one place"),
        ("a.stl", text_stl(box((1, 1, 1))).replace("0.5", "nan", 1), "not a finite number"),
        ("a.stl.gz", gzip.compress(b"solid x" * 99, mtime=0)[:-20], "cannot be read"),
        ("a.stl.gz", b"no gzip at all", "cannot be read"),
        ("a.obj", "v 1 2 3\nf 1 2 3\n", "line 2 names vertex 3, but the file has only 1"),
        ("a.obj", "v 1e308 0 0\nv 0 1e308 0\nv 0 0 -1e308\nf 1 2 3\n", "a coordinate is 1e+308, which"),
        ("a.stl", text_stl(box((1, 1, 1))).replace("0.5", "1e200"), "a coordinate is 1e+200, which"),
        ("a.gltf", gltf([0, 1, 2, 0, 2, 77]),
         "'girder' is broken: a triangle names vertex 77, but there are 3 vertices, counted from 0"),
        ("a.gltf", gltf([0, 1, 2, 0]), "the corners of its triangles, or their coordinates, do not come"),
        ("a.gltf", gltf([0, 1, 2], 3e38), "a coordinate is 3e+38, which is no place"),
        ("a.stl", text_stl(box((1, 1, 1))).replace("0.5", "one", 1), "a corner in it is no three numbers"),
        ("a.stl", "solid\nvertex 0 0 0\nvertex 1 0 0\nendsolid\n", "no three corners"),
        ("a.obj", "hello\n", "there are no triangles in this OBJ file"),
        ("a.obj", "v 0 0 0\nv 1 x 0\n", "line 2, 'v 1 x 0'"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "line 3, 'f 1 2'"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "line 4, 'f 1 2 0'"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "line 4, 'f 1 2 -4'"),
        ("a.glb", glb(box((1, 1, 1)), (0, 0, 0))[:200], "it is no GLB file, or a broken one"),
        ("a.glb", b"glTF" + bytes(40), "it is no GLB file, or a broken one"),
        ("a.gltf", "{", "it is no glTF file, or a broken one"),
        ("a.gltf", "[]", "it has no 'asset'"),
        ("a.gltf", json.dumps({"asset": {"version": "2.0"}, "buffers": [{"uri": "/etc/hosts"}]}),
         "it needs the file '/etc/hosts' beside it"),
        ("a.step", "solid", "it is no STEP file"),
        ("a.step", SQUARE, "the STEP file is cut off"),
        ("a.igs", "x" * 200, "it is no IGES file"),
        ("a.igs", (" " * 72 + "S0000001\n") * 3, "the IGES file is cut off"),
    ],
)  # fmt: skip
def test_broken_files_say_what_is_wrong(tmp_path: Path, name: str, content: bytes | str, says: str) -> None:
    with pytest.raises(CadError) as caught:
        read(tmp_path / name, content)
    assert str(caught.value).startswith(str(tmp_path / name))
    assert says in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("body", "says"),
    [
        ("", "none of its entities could be made into a shape"),
        ("#1=MANIFOLD_SOLID_BREP('',#1);\n", "none of its entities could be made into a shape"),
        ("#1=CLOSED_SHELL('',(#2));\n#2=ADVANCED_FACE(", "STEP"),
    ],
)
@pytest.mark.usefixtures("occt_loaded")
def test_step_without_anything_in_it(tmp_path: Path, body: str, says: str) -> None:
    with pytest.raises(CadError, match=says):
        read(tmp_path / "a.step", SQUARE + body + "ENDSEC;\nEND-ISO-10303-21;\n")


#: A program of its own, as the reader is: Open CASCADE is in no process that does anything else.
WRITES_A_BOX = """
import sys
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.STEPCAFControl import STEPCAFControl_Writer
from OCP.TCollection import TCollection_ExtendedString, TCollection_HAsciiString
from OCP.TDocStd import TDocStd_Document
from OCP.XCAFDoc import XCAFDoc_DocumentTool

document = TDocStd_Document(TCollection_ExtendedString("XmlOcaf"))
shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
materials = XCAFDoc_DocumentTool.MaterialTool_s(document.Main())
label = shapes.AddShape(BRepPrimAPI_MakeBox(1000.0, 2000.0, 3000.0).Solid(), False)
names = ("aluminium", "alu", "density measure", "POSITIVE_RATIO_MEASURE")
name, text, measure, kind = (TCollection_HAsciiString(each) for each in names)
materials.SetMaterial(label, name, text, 2.7, measure, kind)
writer = STEPCAFControl_Writer()
writer.SetMaterialMode(True)
writer.Transfer(document)
writer.Write(sys.argv[1])
"""


@pytest.fixture(scope="module")
def step_of_aluminium(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A STEP file with a box of 1 × 2 × 3 m as Open CASCADE writes it."""
    path = tmp_path_factory.mktemp("box") / "a.step"
    subprocess.run([sys.executable, "-c", WRITES_A_BOX, str(path)], check=True, capture_output=True)
    return path.read_text(encoding="utf-8")


def weighed(path: Path, content: str, density: str, mass: str, length: str, powers: tuple[int, int]) -> CadModel:
    """The box of this file, its density written another way."""
    for old, new in (
        ("POSITIVE_RATIO_MEASURE(2.7)", f"POSITIVE_RATIO_MEASURE({density})"),
        ("SI_UNIT($,.GRAM.)", f"SI_UNIT({mass},.GRAM.)"),
        ("SI_UNIT(.CENTI.,.METRE.)", f"SI_UNIT({length},.METRE.)"),
        (",3.);", f",{powers[0]}.);"),
        (",2.);", f",{powers[1]}.);"),
    ):
        assert old in content
        content = content.replace(old, new)
    path.write_text(content, encoding="utf-8")
    return read_geometry(path, Assumptions())


@pytest.mark.parametrize(
    ("density", "mass", "length", "powers", "kg_per_m3"),
    [
        ("2700.", ".KILO.", "$", (1, -3), 2700.0),
        ("2.7", "$", ".CENTI.", (1, -3), 2700.0),
        ("2.7", "$", ".CENTI.", (3, 2), 2700.0),  # as Open CASCADE itself writes it
        ("0.00785", "$", ".MILLI.", (1, -3), 7850.0),
    ],
)
@pytest.mark.usefixtures("occt_loaded")
def test_materials_of_step_have_their_density(
    tmp_path: Path,
    step_of_aluminium: str,
    density: str,
    mass: str,
    length: str,
    powers: tuple[int, int],
    kg_per_m3: float,
) -> None:
    model = weighed(tmp_path / "a.step", step_of_aluminium, density, mass, length, powers)
    assert model.properties.mass == pytest.approx(6 * kg_per_m3)
    assert model.properties.centre == pytest.approx([0.5, 1, 1.5])
    # A box: m/12 (b² + c²).
    expected = np.diag([13.0, 10.0, 5.0]) * model.properties.mass / 12
    assert model.properties.inertia == pytest.approx(expected, abs=1e-6 * model.properties.mass)


@pytest.mark.usefixtures("occt_loaded")
def test_a_density_of_no_material_is_not_used(tmp_path: Path, step_of_aluminium: str) -> None:
    model = weighed(tmp_path / "a.step", step_of_aluminium, "0.05", "$", ".MILLI.", (1, -3))  # 50 t/m³
    assert model.properties.mass == pytest.approx(6 * 7850)
    assert "density that is that of no material" in model.parts[0].doubts[0]


def test_reading_is_given_up_in_time_and_memory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = SQUARE + "ENDSEC;\nEND-ISO-10303-21;\n"
    monkeypatch.setattr(step, "_LONGEST", 1e-3)
    with pytest.raises(CadError, match=r"took longer than 0\.001 s and was given up"):
        read(tmp_path / "a.step", text)
    monkeypatch.setattr(step, "_LONGEST", 60.0)
    monkeypatch.setattr(step, "_MOST_MEMORY", 200_000_000)
    with pytest.raises(CadError, match="Open CASCADE could not read this STEP file"):
        read(tmp_path / "a.step", text)


def test_too_many_triangles_are_refused_before_they_are_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mesh_file, "_MOST_TRIANGLES", 11)
    for name, content in (("a.stl", binary_stl(box((1, 1, 1)))), ("a.obj", obj(box((1, 1, 1))).encode())):
        with pytest.raises(CadError, match="more than 11 triangles, so it is not read"):
            read(tmp_path / name, content)


def test_without_the_extra_one_sentence_says_how_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "trimesh", None)
    with pytest.raises(CadError, match=r"needs trimesh; install it with: pip install 'gantline\[cad\]'"):
        read(tmp_path / "a.glb", glb(box((1, 1, 1)), (0, 0, 0)))
    for name, content in (("a.stl", text_stl(box((1, 1, 1)))), ("a.obj", obj(box((1, 1, 1))))):
        assert read(tmp_path / name, content).properties.mass == pytest.approx(
            7850
        )  # the base install reads it
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    with pytest.raises(
        CadError, match=r"needs Open CASCADE .*; install it with: pip install 'gantline\[cad\]'"
    ):
        read(tmp_path / "a.step", SQUARE + "ENDSEC;\nEND-ISO-10303-21;\n")


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    for name in ("a.stl", "a.step"):
        with pytest.raises(CadError, match=r"cannot be read \(no such file or directory\)"):
            read_geometry(tmp_path / name, Assumptions())


def test_a_file_whose_name_is_nearly_that_of_one(tmp_path: Path) -> None:
    (tmp_path / "Module.stl").touch()
    with pytest.raises(CadError, match=r"no such file or directory\); is 'Module\.stl' meant\?"):
        read_geometry(tmp_path / "module.stl", Assumptions())


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"unit": "inch"}, "'inch' is no unit of length"),
        ({"density": 0.0}, "not that of a material"),
        ({"thickness": 12.0}, "plate thickness of 12 m is not possible"),
    ],
)
def test_assumptions_that_cannot_be(given: dict[str, object], says: str) -> None:
    with pytest.raises(CadError, match=says):
        Assumptions(**given)  # type: ignore[arg-type]


def test_the_program_for_step_stands_alone() -> None:
    """It runs without gantline on its path, so it must import nothing of it."""
    source = Path(_occt.__file__).read_text(encoding="utf-8")
    assert "import gantline" not in source and "from gantline" not in source
