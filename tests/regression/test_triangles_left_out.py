"""Triangles of a file that were not read, or weighed twice, without a word.

A binary STL file with a number in its head that is too small, as two files joined to one have it, lost all
that comes after: two thirds of the weight in the case here. A cavity whose faces look outwards weighed as a
solid. An OBJ file with a byte order mark lost its first vertex.
"""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

from gantline.cad import Assumptions, CadError, read
from gantline.cad.bodies import parts_of_mesh
from gantline.cad.doubts import doubts_of_the_whole
from gantline.cad.mesh import TriangleMesh
from solids import box

ONE, TWO = box((1.0, 1.0, 1.0)), box((2.0, 1.0, 1.0), (5.0, 0.0, 0.0))
WITHIN = "it lies within another solid, and both weigh; a cavity has to face inwards"


def binary(mesh: TriangleMesh, announced: int, rest: bytes = b"") -> bytes:
    rows = (struct.pack("<12fH", 0, 0, 0, *corners.ravel(), 0) for corners in mesh.corners)
    return b"\0" * 80 + struct.pack("<I", announced) + b"".join(rows) + rest


@pytest.mark.parametrize(
    ("data", "held"),
    [
        (binary(TriangleMesh.combined([ONE, TWO]), 12), 24),
        (binary(ONE, 12, binary(TWO, 12)), 25),
    ],
)
def test_a_file_that_holds_more_than_it_announces_is_refused(tmp_path: Path, data: bytes, held: int) -> None:
    path = tmp_path / "load.stl"
    path.write_bytes(data)
    with pytest.raises(CadError) as caught:
        read(path, Assumptions(unit="m"), keep=False)
    assert f"12 triangles are announced, but there are bytes of {held}" in str(caught.value)


def test_some_bytes_after_the_last_triangle_are_none(tmp_path: Path) -> None:
    """Some programs write colours or a name there, fewer bytes than a triangle has."""
    path = tmp_path / "load.stl"
    path.write_bytes(binary(TWO, 12, b"made by no one"))
    assert read(path, Assumptions(unit="m"), keep=False).properties.mass == pytest.approx(2 * 7850.0)


@pytest.mark.parametrize(("mark", "end"), [(b"\xef\xbb\xbf", "\n"), (b"", "\r\n"), (b"", "\r")])
def test_marks_and_ends_of_lines_do_not_matter(tmp_path: Path, mark: bytes, end: str) -> None:
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in TWO.vertices.tolist()]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in TWO.triangles.tolist()]
    path = tmp_path / "load.obj"
    path.write_bytes(mark + end.join(lines).encode())
    found = read(path, Assumptions(unit="m"), keep=False).properties
    assert found.mass == pytest.approx(2 * 7850.0)
    assert found.centre == pytest.approx([5.0, 0.0, 0.0])


def told(*shells: TriangleMesh) -> list[str]:
    mesh = TriangleMesh.combined(shells)
    found = parts_of_mesh("tank", mesh, mesh.size, Assumptions(unit="m"))
    return [doubt for part in found for doubt in part.doubts]


def test_a_solid_in_the_material_of_another_is_told() -> None:
    """What it is meant to be only who drew it knows; in a cavity it is in its place."""
    outer, inner, core = (box((size, size, size)) for size in (4, 3, 1))
    assert told(outer, inner) == [WITHIN]
    assert told(outer, inner.flipped()) == []
    assert told(outer, inner.flipped(), core) == []


def test_a_solid_that_two_objects_have_is_told(tmp_path: Path) -> None:
    text = ""
    for count, name in enumerate("AB"):
        text += f"o {name}\n" + "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in ONE.vertices.tolist())
        faces = ONE.triangles + 1 + count * len(ONE.vertices)
        text += "".join(f"f {a} {b} {c}\n" for a, b, c in faces.tolist())
    path = tmp_path / "load.obj"
    path.write_text(text, encoding="utf-8")
    found = [*doubts_of_the_whole(read(path, Assumptions(unit="m"), keep=False))]
    assert found == ["counted twice, since others just like them are in the same place: B"]


def test_a_surface_that_runs_through_itself_has_no_weight() -> None:
    """Closed, but with one corner drawn through the rest of it: no body has such moments."""
    whole = box((2.0, 1.0, 1.0))
    vertices = whole.vertices.copy()
    vertices[6] = (2.0, 0.0, -3.0)
    mesh = TriangleMesh(vertices, whole.triangles)
    (part,) = parts_of_mesh("tank", mesh, mesh.size, Assumptions(unit="m"))
    assert part.properties is None
    assert part.doubts[-1] == "its surface runs through itself, so it has no weight"
