"""A crane barge with everything that water does to it, and a load that swings, against equations of their
own, `tests/support/crane_barge.py`, which scipy's DOP853 solves.
"""

from __future__ import annotations

import json

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

from crane_barge import FALLS, TIP, inertia_of_all, rates, rotation, system
from gantline._core import Statics
from lagrange import quaternion, yaw_pitch_roll
from mechanics import Floats, adaptive


@pytest.mark.parametrize(
    ("orientation", "height", "heel"),
    [((0.99, 0.08, -0.03, 0.1), 3.5, (-8.1, 9.3)), ((0.8, 0.45, -0.15, 0.1), 4.5, (58.4, 180.0))],
    ids=["upright", "turning over"],
)
def test_a_crane_barge_moves_as_its_own_equations_say(
    orientation: tuple[float, ...], height: float, heel: tuple[float, float]
) -> None:
    """Place, attitude, load, and what drag takes; upright, and as it turns over with its deck under water."""
    duration, centre = 4.0, np.array([0.3, -0.2, height])
    q = np.array(orientation) / np.linalg.norm(orientation)
    turn, place = rotation(q), np.array([0, 0, -3.2])
    velocity = turn.T @ np.array([0.5, 0.3, -0.4])
    load = place + turn @ TIP + np.array([1.0, 2.0, -11.8])
    start = np.concatenate([place, q, velocity, [0.05, 0.03, 0.02], load, np.zeros(3)])
    times = np.linspace(0, duration, 9)
    given = (centre, inertia_of_all(centre))
    found = solve_ivp(rates, (0, duration), start, "DOP853", times, rtol=1e-8, atol=1e-9, args=given)
    own = found.y.T
    run = adaptive(
        system(start, centre),
        duration,
        tension_tolerance=0.1,
        position_tolerance=1e-7,
        sample_interval=duration / 8,
    )
    turns = [rotation(one) for one in own[:, 3:7]]
    places = np.array([one[:3] + turn @ centre for one, turn in zip(own, turns, strict=True)])
    # Tolerances of 0.1 µm and 0.1 N in a step; where a corner of the deck goes under, the stiffness of the
    # water jumps within a step: 1 µm was found.
    assert np.abs(run.body("barge") - places).max() < 5e-6
    assert np.abs(run.body("load") - own[:, 13:16]).max() < 5e-6
    alike = (run.body("barge", "body_orientation") * own[:, 3:7]).sum(axis=1)
    norm = np.linalg.norm(own[:, 3:7], axis=1)
    assert np.abs(np.abs(alike / norm) - 1.0).max() < 1e-12
    ups = np.array([turn[2] for turn in turns])
    angle = np.degrees(np.arctan2(ups[:, 1], ups[:, 2]))
    assert heel[0] - 1.0 < angle.min() and angle.max() < heel[1] + 1.0
    assert run.energy_remainder < 1e-7


def test_modes_of_a_barge_with_a_load_that_hangs_from_it() -> None:
    """ω² of nine motions, three of which nothing holds, against differences of the accelerations at rest."""
    centre = np.array([0.3, -0.2, 3.5])
    inertia = inertia_of_all(centre)

    def accelerations(turn: Floats, place: Floats, load: Floats) -> Floats:
        """Of the barge along its axes and about them, and of the load, from rest (9,)."""
        state = np.concatenate([place, quaternion(turn), np.zeros(6), load, np.zeros(3)])
        return rates(0.0, state, centre, inertia, resists=False)[[7, 8, 9, 10, 11, 12, 16, 17, 18]]

    def lying(found: Floats) -> tuple[Floats, Floats, Floats]:
        """Attitude, place and load of height, two angles and the load's place."""
        turn = yaw_pitch_roll(np.array([[0.02, found[1], found[2]]]))[0]
        return turn, np.array([0, 0, found[0]]), found[3:]

    def unbalanced(found: Floats) -> Floats:
        return accelerations(*lying(found))

    guess = np.concatenate([[-3.0, -0.02, -0.06], TIP + np.array([1.2, 1.0, -3.0 - FALLS])])
    rest = least_squares(unbalanced, guess, xtol=1e-15, ftol=1e-15, gtol=1e-15)
    assert np.abs(rest.fun).max() < 1e-9
    turn, place, load = lying(rest.x)

    def moved(by: Floats) -> Floats:
        """Accelerations along the axes at rest, moved and turned along and about these."""
        further = yaw_pitch_roll(by[None, [5, 4, 3]])[0]
        found = accelerations(turn @ further, place + turn @ by[:3], load + by[6:])
        return np.concatenate([further @ found[:3], found[3:]])

    step = 1e-4
    slopes = [
        (8 * (moved(way) - moved(-way)) - moved(2 * way) + moved(-2 * way)) / (12 * step)
        for way in step * np.eye(9)
    ]
    squares = np.sort(-np.linalg.eigvals(np.array(slopes).T).real)
    state = np.concatenate([place, quaternion(turn), np.zeros(6), load, np.zeros(3)])
    document_at_rest = system(state, centre)
    for force in document_at_rest["forces"]:
        if force["type"] == "drag":
            force["stream"] = [0.0, 0.0, 0.0]
    statics = Statics(json.dumps(document_at_rest))
    statics.settle()
    found = np.sort(statics.modes()["square"])
    # Differences of fourth order at 0.1 mrad: 1e-8 and less. Surge, sway and yaw have none.
    assert np.abs(found[:3]).max() < 1e-9
    assert found[3:] == pytest.approx(squares[3:], rel=1e-6)
