"""Energy of what hangs on lines: slope and curvature against differences; rotations and quaternions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from gantline.assembly.ropes.balance import Hung, Line, Pose, _energy, balance
from gantline.assembly.spatial import rotation_matrix, rotation_quaternion, rotation_vector
from gantline.scenario.gear import RopeMaterial

HUNG = [Hung(3e4, np.array([0.1, 0.05, -0.1]), turns=True), Hung(2e3, np.zeros(3), turns=False)]
HOOK = (None, np.array([0.0, 0.0, 16.0]))


def line(points: tuple[tuple[int | None, np.ndarray], ...], length: float, stiffness: float) -> Line:
    """A line of EA over length [N/m]."""
    return Line(points, length, RopeMaterial.model_construct(axial_stiffness=stiffness * length))


LINES = [
    line((HOOK, (0, np.array([-4.0, 0.0, 0.2]))), 8.0, 1e7),
    line((HOOK, (0, np.array([4.0, 0.0, 0.2]))), 8.2, 1e7),
    line(((0, np.array([3.0, 0.0, -0.2])), (1, np.zeros(3)), (0, np.array([2.0, 1.0, -0.2]))), 4.0, 1e6),
]
START = Pose(np.array([[0.0, 0.0, 9.0], [2.5, 0.5, 6.0]]), np.array([np.eye(3)] * 2))

turns = st.lists(st.floats(-3.0, 3.0), min_size=3, max_size=3)
steps = st.lists(st.floats(-0.3, 0.3), min_size=9, max_size=9)


@given(turns)
def test_a_quaternion_gives_back_its_rotation(turn: list[float]) -> None:
    matrix = rotation_matrix(rotation_vector(turn))
    assert rotation_matrix(rotation_quaternion(matrix)) == pytest.approx(matrix, abs=1e-14)


@pytest.mark.parametrize("axis", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)])
def test_half_a_turn(axis: tuple[float, float, float]) -> None:
    """Where three of the four squares vanish."""
    matrix = rotation_matrix([0.0, *axis])
    assert np.abs(rotation_quaternion(matrix)) == pytest.approx([0.0, *axis], abs=1e-15)


# Each example compares all nine slopes and 45 curvatures.
@settings(max_examples=25)
@given(steps)
def test_slope_and_curvature(step: list[float]) -> None:
    """Central differences over places and turns: 1e-7 of the largest slope, 1e-5 of the largest curvature."""
    pose = START.moved(np.append(step, np.zeros(3)).reshape(2, 6))

    def energy(by: np.ndarray) -> float:
        return _energy(HUNG, LINES, pose.moved(by.reshape(2, 6)))[0]

    _, slope, curve = _energy(HUNG, LINES, pose)
    lines = [
        float(np.linalg.norm(np.diff([pose.point(*p) for p in line.points], axis=0), axis=1).sum())
        for line in LINES
    ]
    # Differences do not reach over the length at which a line comes taut.
    assume(all(abs(length - line.length) > 1e-2 for length, line in zip(lines, LINES, strict=True)))
    unit, size, wide = np.eye(12)[:9], 1e-5, 5e-4
    middle = energy(np.zeros(12))
    found = [(energy(size * one) - energy(-size * one)) / (2 * size) for one in unit]
    assert found == pytest.approx(slope[:9], abs=1e-7 * np.abs(slope).max())
    bent = [energy(wide * one) + energy(-wide * one) - 2 * middle for one in unit]
    for i in range(9):
        for j in range(i + 1):
            both = wide * (unit[i] + unit[j])
            second = (energy(both) + energy(-both) - 2 * middle - bent[i] - bent[j]) / (2 * wide**2)
            assert second == pytest.approx(curve[i, j], abs=1e-5 * np.abs(curve).max())


def test_a_body_on_two_lines() -> None:
    """Level under a hook: T cos a = weight / 2, by hand, to the 1e-9 at which the search ends."""
    bar = [Hung(3e4, np.zeros(3), turns=True)]
    lines = [line((HOOK, (0, np.array([x, 0.0, 0.2]))), 8.0, 1e7) for x in (-4.0, 4.0)]
    found = balance(
        bar, lines, Pose(np.array([[0.3, 0.2, 8.0]]), rotation_matrix(rotation_vector([0.1, 0.2, 0.0]))[None])
    )
    assert found is not None
    way = HOOK[1] - found.point(0, np.array([4.0, 0.0, 0.2]))
    length = float(np.linalg.norm(way))
    assert 1e7 * (length - 8.0) * way[2] / length == pytest.approx(1.5e4, rel=1e-8)
    assert math.hypot(*found.places[0][:2]) < 1e-6


def test_nothing_holds_it() -> None:
    nothing = line((HOOK, (0, np.array([0.0, 0.0, 0.2]))), 8.0, -1.0)
    assert (
        balance(
            [Hung(3e4, np.zeros(3), turns=True)],
            [nothing],
            Pose(np.array([[0.0, 0.0, 7.0]]), np.eye(3)[None]),
        )
        is None
    )
