"""Triangle meshes: welding, pieces, closedness, sides."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from gantline.cad.mesh import TriangleMesh, connected
from solids import box, sphere


def soup(mesh: TriangleMesh) -> TriangleMesh:
    """Three vertices of its own for each triangle, as STL has it."""
    return TriangleMesh(mesh.corners.reshape(-1, 3), np.arange(3 * len(mesh.triangles)).reshape(-1, 3))


def test_a_box_is_closed_and_measured() -> None:
    mesh = box((2, 3, 5), middle=(1, 0, 0))
    assert mesh.is_closed and mesh.is_consistent
    assert mesh.volume == pytest.approx(30)
    assert mesh.area == pytest.approx(2 * (6 + 10 + 15))
    assert mesh.box.tolist() == [[0, -1.5, -2.5], [2, 1.5, 2.5]]
    assert mesh.size == pytest.approx(np.sqrt(4 + 9 + 25))
    assert mesh.flipped().volume == pytest.approx(-30)


def test_triangles_without_common_vertices_are_open_until_welded() -> None:
    loose = soup(box((2, 3, 5)))
    assert not loose.is_closed
    assert len(loose.boundary_edges) == 36
    welded = loose.welded()
    assert welded.is_closed and len(welded.vertices) == 8


def test_welding_closes_gaps_up_to_its_tolerance() -> None:
    mesh = soup(box((2, 3, 5)))
    shaken = TriangleMesh(mesh.vertices + 1e-5 * np.sin(np.arange(108)).reshape(36, 3), mesh.triangles)
    assert not shaken.welded().is_closed
    assert not shaken.welded(1e-7).is_closed
    closed = shaken.welded(1e-4)
    assert closed.is_closed and len(closed.vertices) == 8


def test_welding_drops_triangles_that_lose_their_area() -> None:
    mesh = TriangleMesh(
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1e-9, 0.0, 0.0]], [[0, 1, 2], [0, 3, 2]]
    )
    assert len(mesh.welded(1e-6).triangles) == 1


def test_pieces() -> None:
    mesh = TriangleMesh.combined([box((1, 1, 1)), box((2, 2, 2), middle=(5, 0, 0)), sphere(1, 4)])
    volumes = [shell.volume for shell in mesh.shells()]
    assert volumes[:2] == pytest.approx([1, 8])
    assert len(volumes) == 3
    assert TriangleMesh.combined([]).shells() == []


def test_bodies_that_touch_along_an_edge_stay_two() -> None:
    mesh = TriangleMesh.combined([box((1, 1, 1)), box((1, 1, 1), middle=(1, 1, 0))]).welded()
    assert len(mesh.vertices) == 14
    shells = mesh.shells()
    assert [shell.is_closed for shell in shells] == [True, True]
    assert [shell.volume for shell in shells] == pytest.approx([1, 1])


def test_plates_that_meet_in_a_tee_are_pieces_of_their_own() -> None:
    vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1]]
    tee = TriangleMesh(vertices, [[0, 1, 2], [1, 0, 3], [0, 1, 4]])
    assert len(tee.shells()) == 3


def test_bodies_that_touch_along_a_whole_face_stay_two() -> None:
    """Plates side by side, of the same thickness: the common face is there from both sides."""
    rng = np.random.default_rng(1)
    mesh = TriangleMesh.combined(
        [box((1, 2, 3), middle=(x, y, 0)) for x in (0, 1, 2) for y in (0, 2)]
    ).welded()  # fmt: skip
    shuffled = TriangleMesh(mesh.vertices, rng.permutation(mesh.triangles))
    shells = shuffled.shells()
    assert [shell.volume for shell in shells] == pytest.approx([6.0] * 6)
    assert all(shell.is_closed and len(shell.triangles) == 12 for shell in shells)
    assert len(mesh.backs) == 2 * 7 and len(mesh.duplicates) == 0


def test_surfaces_that_run_through_one_another_do_not_hang_together() -> None:
    """Four sheets about one edge, all of one turn: no two of them have material between them."""
    vertices = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
    star = TriangleMesh(vertices, [[0, 1, 2], [0, 1, 3], [1, 0, 4], [1, 0, 5]])
    assert len(star.shells()) == 4


def test_duplicates_and_backs() -> None:
    mesh = box((1, 1, 1))
    doubled = TriangleMesh(mesh.vertices, np.vstack([mesh.triangles, mesh.triangles[3, [1, 2, 0]]]))
    assert doubled.duplicates.tolist() == [12] and doubled.backs.tolist() == [12]
    assert len(doubled.without(doubled.duplicates).triangles) == 12
    assert mesh.duplicates.tolist() == [] and mesh.without(mesh.duplicates) is mesh
    both = TriangleMesh(mesh.vertices, np.vstack([mesh.triangles, mesh.triangles[:, ::-1]]))
    assert len(both.duplicates) == 0 and both.backs.tolist() == list(range(12, 24))


@given(st.sets(st.integers(0, 11)), st.sets(st.integers(0, 127)))
def test_any_sides_are_put_right(of_box: set[int], of_sphere: set[int]) -> None:
    parts = [box((1, 2, 3)), sphere(1.0, 4)]
    mixed = []
    for part, chosen in zip(parts, (of_box, of_sphere), strict=True):
        triangles = part.triangles.copy()
        for triangle in chosen:
            triangles[triangle] = triangles[triangle, ::-1]
        mixed.append(TriangleMesh(part.vertices, triangles))
    mesh, flipped = TriangleMesh.combined(mixed).oriented()
    assert flipped == len(of_box) + len(of_sphere)
    assert mesh.is_consistent
    assert [shell.volume for shell in mesh.shells()] == pytest.approx([part.volume for part in parts])


def test_of_an_open_sheet_the_fewer_triangles_are_flipped() -> None:
    sheet = box((1, 1, 1)).of(np.arange(2, 12))
    one = sheet.triangles.copy()
    one[4] = one[4, ::-1]
    mesh, flipped = TriangleMesh(sheet.vertices, one).oriented()
    assert flipped == 1
    assert np.array_equal(np.sort(mesh.normals, axis=0), np.sort(sheet.normals, axis=0))


def test_a_surface_with_one_side_stays_inconsistent() -> None:
    """A Möbius strip of five triangles: triangle i has the vertices i, i + 1, i + 2 modulo 5."""
    vertices = [[np.cos(a), np.sin(a), 0.3 * (-1) ** i] for i, a in enumerate(np.arange(5) * 2 * np.pi / 5)]
    strip = TriangleMesh(vertices, [[i, (i + 1) % 5, (i + 2) % 5] for i in range(5)])
    assert not strip.oriented()[0].is_consistent


def test_moving_and_mirroring_keep_the_outside() -> None:
    mesh = box((1, 2, 3))
    mirrored = mesh.moved(np.diag([1.0, -1.0, 1.0]), np.array([0, 5, 0]))
    assert mirrored.volume == pytest.approx(6)
    assert mirrored.middle == pytest.approx([0, 5, 0])
    assert mesh.scaled(0.001).volume == pytest.approx(6e-9)


def test_what_is_no_mesh_is_refused() -> None:
    with pytest.raises(ValueError, match="not a finite number"):
        TriangleMesh([[0, 0, np.nan]], [[0, 0, 0]])
    with pytest.raises(ValueError, match="names vertex 3, but there are 3 vertices"):
        TriangleMesh(np.eye(3), [[0, 1, 3]])
    with pytest.raises(ValueError, match="names vertex -1"):
        TriangleMesh(np.eye(3), [[0, 1, -1]])
    with pytest.raises(ValueError, match="no box"):
        _ = TriangleMesh.combined([]).box


@given(count=st.integers(1, 30), data=st.data())
def test_groups_are_those_of_scipy(count: int, data: st.DataObject) -> None:
    """Numbers of groups too: both count up in the order of their first things."""
    thing = st.integers(0, count - 1)
    pairs = np.array(data.draw(st.lists(st.tuples(thing, thing), max_size=50)), dtype=np.int64).reshape(-1, 2)
    links = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    expected = connected_components(links, directed=False)[1]
    np.testing.assert_array_equal(connected(count, pairs), expected)


def test_a_long_chain_in_disorder_is_one_group() -> None:
    """A hundred thousand links, whose ends are numbered at random: no round for each of them."""
    order = np.random.default_rng(1).permutation(100_000)
    assert not connected(len(order), np.column_stack([order[1:], order[:-1]])).any()
