"""Hulls that displaced what they do not, without a word or with a word and wrong figures all the same.

A box within a box, or one through another, displaced twice: 1840 m³ for 1440 m³. A file with one side of a
hull was taken for all of it, one in millimetres for a hull of 40 km, and the density of water was taken as
1.025 kg/m³. One triangle that faces the wrong side made BM 2.353 m of 2.778 m; it is turned now.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from gantline.cad.mesh import TriangleMesh
from gantline.cli.app import app
from gantline.hydro import Attitude, Hull, hydrostatics, read_hull
from gantline.hydro.skin import inner_share
from solids import box

BARGE = box((40.0, 10.0, 6.0), (20.0, 0.0, 3.0))
TWICE = "of its skin lies within other parts of it, which displace twice there"


def hull_of(folder: Path, *parts: TriangleMesh) -> Hull:
    mesh = TriangleMesh.combined(parts)
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in mesh.vertices.tolist()]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in mesh.triangles.tolist()]
    path = folder / "hull.obj"
    path.write_text("\n".join(lines), encoding="utf-8")
    return read_hull(path)


def test_a_hull_in_order_has_no_doubts(tmp_path: Path) -> None:
    """Nor has one with a moon pool's walls, or two hulls side by side."""
    assert hull_of(tmp_path, BARGE).doubts() == []
    assert hull_of(tmp_path, BARGE, box((6.0, 6.0, 2.0), (20.0, 0.0, 3.0)).flipped()).doubts() == []
    assert hull_of(tmp_path, *(box((40.0, 4.0, 6.0), (20.0, y, 3.0)) for y in (-6.0, 6.0))).doubts() == []


@pytest.mark.parametrize(
    "other",
    [
        box((15.0, 4.0, 3.0), (12.5, 0.0, 2.5)),  # within
        box((20.0, 16.0, 2.0), (20.0, 0.0, 1.0)),  # across, with no corner in the other
        BARGE,
    ],
)
def test_parts_that_displace_twice_are_told(tmp_path: Path, other: TriangleMesh) -> None:
    assert any(TWICE in doubt for doubt in hull_of(tmp_path, BARGE, other).doubts())


def test_the_share_is_that_of_the_area() -> None:
    """Of a box of 700 + 400 + 400 m² of skin and one of 174 m² within it, the latter."""
    within = box((15.0, 4.0, 3.0), (12.5, 0.0, 2.5))
    both = TriangleMesh.combined([BARGE, within])
    # Points stand evenly: at most one more or less on each of 24 triangles, of 2000.
    assert inner_share(both) == pytest.approx(within.area / both.area, abs=24 / 2000)
    assert inner_share(BARGE) == 0.0


def test_half_of_a_hull_is_told(tmp_path: Path) -> None:
    (doubt,) = hull_of(tmp_path, box((40.0, 10.0, 6.0), (20.0, 5.0, 3.0))).doubts()
    assert doubt.startswith("all of it is on one side of the centre plane y = 0")


def test_a_hull_of_kilometres_is_told(tmp_path: Path) -> None:
    (doubt,) = hull_of(tmp_path, BARGE.scaled(1000.0)).doubts()
    assert doubt == "it is 4e+04 m long; no hull is, so its unit may be another"


@pytest.mark.parametrize("which", [[0], [0, 5, 7], list(range(12))])
def test_triangles_that_face_the_wrong_side_are_turned(tmp_path: Path, which: list[int]) -> None:
    """BM is B²/(12 T) whichever of them do."""
    triangles = np.array(BARGE.triangles)
    triangles[which] = triangles[which, ::-1]
    hull = hull_of(tmp_path, TriangleMesh(BARGE.vertices, triangles))
    found = hydrostatics(hull, Attitude(3.0, 0.0, 0.0, 20.0))
    assert found.volume == pytest.approx(1200.0)
    assert found.bm_transverse == pytest.approx(100 / 36)
    assert len(hull.doubts()) == 1 and "turned" in hull.doubts()[0]


@pytest.mark.parametrize("density", ["1.025 kg/m^3", "1025 t/m^3", "7850 kg/m^3"])
def test_a_density_of_no_water_is_refused(density: str) -> None:
    result = CliRunner().invoke(app, ["hydro", "box:40m,10m,6m", "--density", density])
    assert result.exit_code == 2
    assert "is not the density of water; sea water has '1.025 t/m^3'" in result.stderr
