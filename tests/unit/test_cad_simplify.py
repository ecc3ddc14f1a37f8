"""Lighter stand-ins: meshes of few triangles, convex hulls of few corners."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial import ConvexHull

import gantline.cad as cad
from gantline.cad import CadError, read_light_mesh
from gantline.cad.mesh import TriangleMesh
from gantline.cad.ocx_writer import write_ocx
from gantline.cad.ship_block import ShipBlockSizes, ship_block
from gantline.cad.simplify import contact_hull, light_mesh
from solids import box, sphere


def test_a_light_mesh_is_itself() -> None:
    mesh = box((2, 3, 5))
    light = light_mesh(mesh, 20)
    assert light.error == 0.0 and len(light.mesh.triangles) == 12


def test_a_sphere_keeps_its_shape() -> None:
    """An inscribed polyhedron of n triangles has a sagitta of about 4 π r/(n √3) at best: 0.018 m of 400."""
    fine = sphere(1.0, 24)
    light = light_mesh(fine, 400)
    assert 300 <= len(light.mesh.triangles) <= 400
    assert light.error < 0.05
    assert light.mesh.volume == pytest.approx(fine.volume, rel=0.05)


def test_plates_become_sheets_and_do_not_vanish() -> None:
    """A hall of 40 thin plates in 60 triangles: each is still there, within the error that is said."""
    plates = [box((10, 0.01, 5), middle=(0, y, 0)) for y in range(20)]
    light = light_mesh(TriangleMesh.combined(plates), 60)
    assert len(light.mesh.triangles) <= 60
    assert light.error < 0.1
    assert set(np.round(light.mesh.vertices[:, 1]).astype(int)) == set(range(20))


def test_the_error_is_that_of_what_is_left_out() -> None:
    """A speck beside a large sheet is given up first, and its distance is the error."""
    grid = [box((1, 1, 0.001), middle=(x, y, 0)) for x in range(6) for y in range(6)]
    speck = box((0.01, 0.01, 0.01), middle=(3, 3, 2))
    light = light_mesh(TriangleMesh.combined([*grid, speck]), 100)
    assert light.error >= 1.99 or np.any(light.mesh.vertices[:, 2] > 1.9)


def test_the_same_mesh_gives_the_same_triangles() -> None:
    mesh = sphere(1.0, 16)
    one, other = light_mesh(mesh, 300), light_mesh(mesh, 300)
    assert np.array_equal(one.mesh.vertices, other.mesh.vertices)
    assert np.array_equal(one.mesh.triangles, other.mesh.triangles)


def test_the_hull_of_a_box_is_its_corners() -> None:
    hull = contact_hull(TriangleMesh.combined([box((2, 3, 5)), sphere(0.9, 8)]), 1e-9)
    assert len(hull.vertices) == 8 and hull.error == pytest.approx(0, abs=1e-12)


def test_a_hull_stays_within_and_comes_as_near_as_it_says() -> None:
    """Largest distance of left-out corners from the reduced hull, by its facets."""
    mesh = sphere(1.0, 24)
    hull = contact_hull(mesh, 0.02, most=200)
    assert 20 < len(hull.vertices) < 200 and hull.error <= 0.02
    equations = ConvexHull(hull.vertices).equations
    out = mesh.vertices @ equations[:, :3].T + equations[:, 3]
    assert out.max() == pytest.approx(hull.error, abs=1e-12)
    fewer = contact_hull(mesh, 0.0, most=24)
    assert len(fewer.vertices) == 24 and fewer.error > hull.error


def test_the_hull_of_a_ship_block_is_nearly_its_box() -> None:
    mesh = ship_block(ShipBlockSizes(43, 23, 11, 300e3)).model.mesh
    hull = contact_hull(mesh, 0.01)
    assert len(hull.vertices) <= 12
    # 0.01 m, which the hull may miss, at either end, plates standing out by half of their 6 to 9 mm.
    assert np.ptp(hull.vertices, axis=0) == pytest.approx([43, 23, 11], abs=0.02)


def test_what_has_no_hull_or_no_triangles_is_refused() -> None:
    with pytest.raises(CadError, match="flat"):
        contact_hull(box((1, 1, 1)).of(np.arange(2)), 0.01)
    with pytest.raises(CadError, match="without triangles"):
        light_mesh(TriangleMesh.combined([]), 100)


def test_light_meshes_are_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A second time nothing is read; another budget is another mesh."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    path = tmp_path / "block.3docx"
    path.write_bytes(write_ocx(ship_block(ShipBlockSizes(20, 12, 9, 120e3))))
    first = read_light_mesh(path, most=1000)
    assert 0 < len(first.triangles) <= 1000
    monkeypatch.setattr(cad, "read", None)
    again = read_light_mesh(path, most=1000)
    assert np.array_equal(first.vertices, again.vertices)
    with pytest.raises(TypeError):
        read_light_mesh(path, most=900)
