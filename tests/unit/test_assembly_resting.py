"""Static equilibrium of a load on the springs under its corners."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from gantline.assembly.loads.resting import TipsOver, rest_on_ground
from gantline.assembly.spatial import Array, rotation_matrix, rotation_vector

WEIGHT = 300e3 * 9.81
STIFFNESS = 2e8


def corners(x: float, y: float, z: float = 2.5, sizes: tuple[float, float, float] = (10, 10, 5)) -> Array:
    """Corners of a box from a centre of gravity at x, y from its middle and z above its bottom."""
    length, breadth, height = sizes
    around = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    places = [(i * length / 2 - x, j * breadth / 2 - y, k - z) for k in (0.0, height) for i, j in around]
    return np.array(places)


def assert_in_balance(points: Array, weight: float, stiffness: float) -> None:
    """Forces add up to the weight and have no moment about the centre of gravity, each only pushing."""
    resting = rest_on_ground(points, weight, stiffness)
    turned = points @ rotation_matrix(rotation_vector(resting.turn)).T
    depths = np.maximum(0.0, -(resting.height + turned[:, 2]))
    assert resting.forces == pytest.approx(stiffness * depths)
    size = float(np.abs(points).max())
    rounding = 1e-9 * weight + 1e-14 * stiffness * size  # a depth is a small difference of heights
    assert resting.forces.sum() == pytest.approx(weight, abs=rounding)
    assert resting.forces @ turned[:, 0] == pytest.approx(0, abs=rounding * size)
    assert resting.forces @ turned[:, 1] == pytest.approx(0, abs=rounding * size)
    assert resting.turn[2] == 0.0


def test_over_the_middle_all_corners_carry_alike() -> None:
    resting = rest_on_ground(corners(0, 0), WEIGHT, STIFFNESS)
    assert resting.height == pytest.approx(2.5 - WEIGHT / (4 * STIFFNESS), abs=1e-14)
    assert resting.turn == pytest.approx((0, 0, 0), abs=1e-15)
    assert resting.forces == pytest.approx([WEIGHT / 4] * 4 + [0] * 4)


def test_shares_by_moments_while_all_corners_carry() -> None:
    # forces W/4 (1 ± x/5 ± y/5) for a rigid box on equal springs, up to the shift of the tilted box (0.1 %)
    forces = rest_on_ground(corners(1.0, 0.5), WEIGHT, STIFFNESS).forces
    signs = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    shares = [WEIGHT / 4 * (1 + i * 1.0 / 5 + j * 0.5 / 5) for i, j in signs]
    assert forces[:4] == pytest.approx(shares, rel=1e-3)


def test_a_corner_lifts_off() -> None:
    forces = rest_on_ground(corners(4.0, 4.0), WEIGHT, STIFFNESS).forces
    assert forces[0] == 0.0 and all(forces[1:4] > 0)
    # three corners carry by moments: (5, 5) takes what makes the centre 4 m out, the others share the rest
    assert forces[2] == pytest.approx(WEIGHT * 0.8, rel=5e-3)
    assert_in_balance(corners(4.0, 4.0), WEIGHT, STIFFNESS)


# Tall and light: the iteration comes down to rounding, where it must end and not cycle.
@example(0.0, 0.147764418923772, 0.8348567386919509, (2.0, 2.0, 21.82775328036814), 0.0006600646027593729)
@given(
    st.floats(-0.45, 0.45),
    st.floats(-0.45, 0.45),
    st.floats(0.05, 0.95),
    st.tuples(*[st.floats(1.0, 40.0)] * 3),
    st.floats(1e-5, 1e-3),
)
def test_any_load_well_within_its_corners_rests(
    x: float, y: float, z: float, sizes: tuple[float, float, float], softness: float
) -> None:
    length, breadth, height = sizes
    narrow = min(length, breadth)
    weight = STIFFNESS * softness * narrow * min(1.0, narrow / height) * 0.1
    assert_in_balance(corners(x * length, y * breadth, z * height, sizes), weight, STIFFNESS)


@pytest.mark.parametrize("x", [5.0, 5.001, 7.0])
def test_beyond_the_corners_it_tips(x: float) -> None:
    with pytest.raises(TipsOver):
        rest_on_ground(corners(x, 0), WEIGHT, STIFFNESS)
