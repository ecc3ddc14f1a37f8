"""Flat sides of the convex hull of a mesh, and how low triangles come over a rectangle."""

from __future__ import annotations

import numpy as np
import pytest

from cad_loads import convex, half_cylinder
from gantline.cad.errors import CadError
from gantline.cad.mesh import TriangleMesh
from gantline.cad.simplify import HullSides, hull_sides
from gantline.cad.underside import lowest_over
from solids import box, sphere


def planes(sides: HullSides) -> list[tuple[np.ndarray, np.ndarray]]:
    """Normal by the corners' own order, and corners, of each side."""
    found = []
    for side in sides.outlines:
        normal = np.cross(side[1:-1] - side[0], side[2:] - side[0]).sum(axis=0)
        found.append((normal / np.linalg.norm(normal), side))
    return found


def test_a_box_has_six_sides_and_a_noisy_one_too() -> None:
    """Noise of 1 µm in 4 m is within a millionth of the size; what is within the hull leaves none."""
    rng = np.random.default_rng(3)
    plain = box((4.0, 2.0, 1.0))
    noisy = TriangleMesh(plain.vertices + rng.normal(0.0, 3e-7, plain.vertices.shape), plain.triangles)
    beside = TriangleMesh.combined([plain, box((1.0, 1.0, 0.5), (0.5, 0.2, 0.0))])
    for mesh in (plain, noisy, beside):
        found = hull_sides(mesh, 2e-4)
        assert sorted(len(side) for side in found.outlines) == [4] * 6
        assert found.error < 1e-5


@pytest.mark.parametrize("tolerance", [5e-2, 5e-3, 5e-4])
def test_sides_are_flat_convex_turned_outwards_and_as_near_as_said(tolerance: float) -> None:
    """Of a sphere of 2 m: no vertex is farther outside of any side than the error, none within it."""
    mesh = sphere(2.0, 12)
    found = hull_sides(mesh, tolerance, most=2000)
    out = np.full(len(mesh.vertices), -np.inf)
    for normal, side in planes(found):
        level = side.mean(axis=0) @ normal
        assert level > 0.0
        assert np.abs(side @ normal - level).max() < 1e-12
        ways = np.roll(side, -1, axis=0) - side
        assert (np.cross(ways, np.roll(ways, -1, axis=0)) @ normal > 0.0).all()
        out = np.maximum(out, mesh.vertices @ normal - level)
    assert out.max() == pytest.approx(found.error, abs=1e-9) and found.error <= tolerance


def test_too_many_corners_are_bounded_with_what_that_costs() -> None:
    """50 corners of a sphere of 2 m: facets are about R √(4 π/100) = 0.7 m wide, 30 mm off and more."""
    found = hull_sides(sphere(2.0, 24), 1e-4, most=50)
    assert len({tuple(corner) for side in found.outlines for corner in np.round(side, 9)}) <= 50
    assert 0.03 < found.error < 0.3


def test_sides_of_a_cylinder_run_along_it() -> None:
    """Strips of a half cylinder of 5 m within 1 mm are 2 √(2 · 1 mm/R) = 40 mrad wide, so 78 at least."""
    found = hull_sides(half_cylinder(5.0, 16.0), 1e-3)
    assert found.error <= 1e-3
    around = [normal for normal, _ in planes(found) if abs(normal[0]) < 1e-2 and normal[2] < 0.99]
    assert 78 <= len(around) <= 4 * 78


def test_what_is_flat_has_no_sides() -> None:
    with pytest.raises(CadError, match="no convex hull"):
        hull_sides(TriangleMesh(np.eye(3), [(0, 1, 2)]), 1e-3)


def test_the_lowest_of_a_roof_over_a_rectangle_is_at_its_rim() -> None:
    """A pyramid upside down, 4 m wide and 1 m high, beside the top: z = 1.3/2 at the near rim."""
    mesh = convex([(0.0, 0.0, 0.0), *((x, y, 1.0) for x in (-2.0, 2.0) for y in (-2.0, 2.0))])
    corners = mesh.corners + np.array((1.6, 0.0, 0.0))
    assert lowest_over(corners, (0.3, 0.3)) == pytest.approx(1.3 / 2)
    assert lowest_over(mesh.corners, (0.3, 0.3)) == pytest.approx(0.0)
    assert lowest_over(mesh.corners + np.array((2.4, 0.0, 0.0)), (0.3, 0.3)) is None
    # A triangle whose box is over the rectangle and that is not.
    aside = np.array([[[-3.0, -0.2, 0.0], [-0.2, -3.0, 0.0], [-3.0, -3.0, 0.0]]])
    assert lowest_over(aside, (0.3, 0.3)) is None


def lowest_of_all(corners: np.ndarray, half: tuple[float, float]) -> float | None:
    """The same by listing every corner that a piece of a triangle over the rectangle can have."""
    found = []
    for triangle in corners:
        for start, end in zip(triangle, np.roll(triangle, -1, axis=0), strict=True):
            shares = [0.0]
            for axis, most in enumerate(half):
                for side in (-most, most):
                    shares.append((side - start[axis]) / (end[axis] - start[axis]))
            places = [start + share * (end - start) for share in shares if 0.0 <= share <= 1.0]
            found += [at[2] for at in places if (np.abs(at[:2]) <= np.array(half) + 1e-12).all()]
        for x in (-half[0], half[0]):
            for y in (-half[1], half[1]):
                weights = np.linalg.solve(np.vstack([triangle[:, :2].T, np.ones(3)]), [x, y, 1.0])
                if (weights >= 0.0).all():
                    found.append(float(weights @ triangle[:, 2]))
    return min(found, default=None)


def test_the_lowest_of_random_triangles_over_rectangles() -> None:
    """Small ones and large, beside the rectangle, over its corners and all of it; nothing is over a third."""
    rng = np.random.default_rng(20)
    without = 0
    for _ in range(400):
        half = (rng.uniform(0.1, 1.0), rng.uniform(0.1, 1.0))
        middles = rng.uniform(-2.0, 2.0, (rng.integers(1, 6), 1, 3))
        corners = middles + rng.uniform(-1.0, 1.0, (len(middles), 3, 3)) * rng.choice([0.2, 1.0, 4.0])
        found, wanted = lowest_over(corners, half), lowest_of_all(corners, half)
        without += wanted is None
        assert found == (None if wanted is None else pytest.approx(wanted, abs=1e-9))
    assert 80 < without < 320


def test_a_triangle_that_touches_the_rim_is_over_the_rectangle() -> None:
    """By a corner at x = 1/4, by an edge along it; a micrometre further out nothing is."""
    for touching in (
        [(0.25, 0.0, 1.0), (1.0, 0.5, 2.0), (1.0, -0.5, 3.0)],
        [(0.25, -0.125, 2.0), (1.0, 0.0, 3.0), (0.25, 0.125, 1.0)],
    ):
        corners = np.array([touching])
        for turned in (corners, corners * (-1.0, 1.0, 1.0), corners[:, :, [1, 0, 2]]):
            assert lowest_over(turned, (0.25, 0.25)) == 1.0
        assert lowest_over(corners + np.array([1e-6, 0.0, 0.0]), (0.25, 0.25)) is None
