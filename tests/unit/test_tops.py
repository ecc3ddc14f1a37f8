"""Where a convex body bears on the top of a support, (SU1): the least of f over what is over the top."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from cad_loads import convex
from gantline.assembly.loads.tops import Sides
from gantline.assembly.spatial import rotation_matrix
from gantline.cad.simplify import hull_sides
from gantline.results.variable import FloatArray

Pair = tuple[float, float]

#: Half sides of tops of most cases [m].
HALF = (0.4, 0.25)


def top(x: float = 0.0, y: float = 0.0, angle: float = 0.0, half: Pair = HALF) -> dict[str, Any]:
    return {"at": [x, y, 0.0], "along": [math.cos(angle), math.sin(angle), 0.0], "half": list(half)}


def roof(rise: float, ridge: float = 0.0, low: float = 0.0) -> Sides:
    """A ridge along y at a place along x, upside down: its two sides rise by so much away from it."""
    far, high = 4.0, 10.0 * max(rise, 1.0)
    section = [(-far, low + rise * (far + ridge)), (ridge, low), (far, low + rise * (far - ridge))]
    points = [(x, y, z) for x, z in [*section, (-far, high), (far, high)] for y in (-4.0, 4.0)]
    return Sides(hull_sides(convex(points), 0.0).outlines)


def dome(places: FloatArray, half: Pair) -> FloatArray:
    """φ(x) + φ(y) = 0.2 |x| + 0.15 x²/h and the same of y, of places (n, 2) [m]."""
    x, y = np.abs(places).T
    found: FloatArray = 0.2 * (x + y) + 0.15 * (x**2 / half[0] + y**2 / half[1])
    return found


@pytest.mark.parametrize("seed", range(12))
def test_f_is_nowhere_less(seed: int) -> None:
    """Random convex bodies over random tops: f at the place against f all over the top, on a grid.

    Planes of sides that look down say how high a body is, those that look up and those around it where it is
    at all. Bodies of which anything over the top is steeper than 60° are left to other tests.
    """
    rng = np.random.default_rng(seed)
    sides = hull_sides(convex(rng.normal(0.0, 1.0, (40, 3)) * (2.0, 2.0, 0.6)), 0.0).outlines
    none = compared = 0
    for _ in range(60):
        quaternion = np.append(1.0, rng.normal(0.0, 0.1, 3))
        turned = rotation_matrix((quaternion / np.linalg.norm(quaternion)).tolist())
        there = [side @ turned.T for side in sides]
        half: Pair = (rng.uniform(0.05, 0.6), rng.uniform(0.05, 0.6))
        x, y, angle = (*rng.uniform(-4.0, 4.0, 2), rng.uniform(0.0, 6.3))
        found = Sides(tuple(there)).over(top(x, y, angle, half))
        along = np.linspace(-1.0, 1.0, 61)
        own = np.stack(np.meshgrid(half[0] * along, half[1] * along), axis=-1).reshape(-1, 2)
        axes = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
        at = np.array([x, y]) + own @ axes
        normals = np.array([np.cross(side[1] - side[0], side[2] - side[1]) for side in there])
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        offsets = np.array([side[0] @ normal for side, normal in zip(there, normals, strict=True)])
        down = normals[:, 2] < 0.0
        levels = (offsets - at @ normals[:, :2].T) / normals[:, 2]
        low, high = levels[:, down].max(axis=1), levels[:, ~down].min(axis=1)
        if not (over := low <= high).any():
            none += 1
            continue
        steepest = -normals[down, 2][np.argmax(levels[:, down], axis=1)][over]
        if found is None or steepest.min() < 0.5 or over.sum() < 20:
            continue
        compared += 1
        place = (found.place[:2] - (x, y)) @ axes.T
        assert (np.abs(place) <= np.array(half) * (1.0 + 1e-9)).all()
        value = found.place[2] + dome(place[None], half)[0]
        least = (low + dome(own, half))[over].min()
        # Within a step of the grid f changes by slopes of 0.5 along both sides and of 60° at most.
        assert least - (0.7 + 1.8) * math.hypot(*half) / 60 <= value <= least + 1e-9
    assert none > 5 and compared > 5


@pytest.mark.parametrize(
    ("rise", "place"),
    [(0.0, 0.0), (0.19, 0.0), (0.2, 0.0), (0.35, 0.5), (0.5, 1.0), (0.8, 1.0)],
)
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_where_one_side_bears(rise: float, place: float, sign: float) -> None:
    """0 = ±rise + 0.2 + 0.3 x/h: in the middle up to 0.2, at the rim from 0.5 on, halfway at 0.35."""
    found = roof(rise, ridge=-sign * 3.0).over(top())
    assert found is not None and found.rise == pytest.approx(rise)
    assert found.place[:2] == pytest.approx([-sign * place * HALF[0], 0.0], abs=1e-9)
    assert found.place[2] == pytest.approx(rise * (3.0 - place * HALF[0]), abs=1e-9)


def test_it_turns_with_its_top() -> None:
    """The same along y of a top that is turned by 90°, and beside the origin."""
    found = roof(0.35, ridge=-3.0).over(top(0.5, 0.2, math.radians(90.0), (0.25, 0.4)))
    assert found is not None
    assert found.place == pytest.approx([0.5 - 0.2, 0.2, 0.35 * (3.5 - 0.2)], abs=1e-9)


@pytest.mark.parametrize("share", [0.3, 0.9])
def test_a_ridge_over_a_top_bears_itself(share: float) -> None:
    """Sides that rise by 1 from the ridge are steeper than the dome is; within the top it is the place."""
    found = roof(1.0, ridge=share * HALF[0]).over(top())
    assert found is not None
    assert found.place == pytest.approx([share * HALF[0], 0.0, 0.0], abs=1e-9)


@pytest.mark.parametrize(("degrees", "is_over"), [(59.9, True), (60.1, False)])
def test_steep_sides_lie_on_nothing(degrees: float, is_over: bool) -> None:
    """Beyond 60°, where nothing flatter is over the top: at the rim."""
    found = roof(math.tan(math.radians(degrees)), ridge=-3.0).over(top())
    assert (found is not None) == is_over
    if found is not None:
        assert found.place[0] == pytest.approx(-HALF[0])


@pytest.mark.parametrize(("share", "is_over"), [(1.0 - 1e-8, True), (1.0, False), (1.001, False)])
def test_a_steep_edge_bears_within_the_top(share: float, is_over: bool) -> None:
    """Sides of 68° from a ridge: it bears as the lowest of all, but on the rim it lies on nothing."""
    found = roof(2.5, ridge=share * HALF[0]).over(top())
    assert (found is not None) == is_over
    if found is not None:
        assert found.place == pytest.approx([share * HALF[0], 0.0, 0.0], abs=1e-6)


def test_nothing_is_over_what_is_beside() -> None:
    """A body that ends at x = 4 m, over tops of 0.8 m: their rims touch its end or do not reach it."""
    level = roof(0.1)
    for x, is_over in ((4.0 + HALF[0] - 1e-6, True), (4.0 + HALF[0] + 1e-6, False)):
        found = level.over(top(x))
        assert (found is not None) == is_over
        if found is not None:
            assert found.place == pytest.approx([4.0, 0.0, 0.4], abs=2e-6)


@pytest.mark.parametrize(("share", "place"), [(0.3, 0.0), (-0.3, -0.3)])
def test_a_steep_side_beside_a_flat_one_bears_nothing(share: float, place: float) -> None:
    """A level underside that ends at an edge, a side of 68° beyond it: what both share is the flat one's."""
    edge = share * HALF[0]
    section = [(-4.0, 0.0), (edge, 0.0), (4.0, 2.5 * (4.0 - edge)), (-4.0, 2.5 * (4.0 - edge))]
    sides = hull_sides(convex([(x, y, z) for x, z in section for y in (-4.0, 4.0)]), 0.0)
    found = Sides(sides.outlines).over(top())
    assert found is not None and found.rise == pytest.approx(0.0, abs=1e-9)
    assert found.place == pytest.approx([place * HALF[0], 0.0, 0.0], abs=1e-9)
