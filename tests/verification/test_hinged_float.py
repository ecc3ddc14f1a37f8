"""A float on a hinge, with a full matrix of added mass, against the equation of its angle.

Aside of the hinge, which lies above the water along y, a box goes into the water and out of it. All of it
turns about the hinge with the one speed w, so that water and body have the inertia and damping

    J = I + m c² + jᵀ A j        D = d + jᵀ B j        j = (z, -x, 1)

of surge, heave and pitch at the place (x, z) of the matrices A and B, both in body axes. Buoyancy is ρ g
times breadth times the area of the clipped rectangle, at its centroid; scipy's LSODA solves
J θ'' = M(θ) - D θ'.
"""

from __future__ import annotations

import json
import math
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from mechanics import Floats, G

SEA, HIGH, START, LASTS = 1025.0, 2.0, -0.45, 20.0
MASS, INERTIA, CENTRE, HINGE = 30e3, 4e5, np.array([6.0, -1.2]), 2e4
SIZE, KEEL, PLACE = np.array([6.0, 4.0, 2.5]), np.array([8.0, -3.0]), np.array([7.5, -2.5])
ADDED = np.diag([5e3, 1e3, 4e4, 1e4, 8e4, 1e4])
ADDED[0, 4] = ADDED[4, 0] = 6e3
ADDED[2, 4] = ADDED[4, 2] = -9e3
ADDED[0, 2] = ADDED[2, 0] = 2e3
DAMPING = np.diag([2e3, 0.0, 3e4, 0.0, 5e4, 0.0])
IN_PLANE = np.ix_([0, 2, 4], [0, 2, 4])
#: Surge, heave and pitch at the place of the matrices, per radian per second.
WAY = np.array([PLACE[1], -PLACE[0], 1.0])
WHOLE = INERTIA + MASS * CENTRE @ CENTRE + WAY @ ADDED[IN_PLANE] @ WAY
RESISTANCE = HINGE + WAY @ DAMPING[IN_PLANE] @ WAY


def below(corners: Floats) -> Floats:
    """What of a polygon in x and z is under water."""
    kept = []
    for one, other in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        if one[1] <= 0:
            kept.append(one)
        if (one[1] <= 0) != (other[1] <= 0):
            kept.append(one + (other - one) * one[1] / (one[1] - other[1]))
    return np.array(kept).reshape(-1, 2)


def moment(angle: float) -> float:
    """Of weight and buoyancy about the hinge, along y [N m]."""
    turned = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    length, breadth, depth = SIZE
    box = KEEL + np.array([[-length / 2, 0], [length / 2, 0], [length / 2, depth], [-length / 2, depth]])
    wet = below(box @ turned + [0.0, HIGH])
    (x, z), (x_next, z_next) = wet.T, np.roll(wet, -1, axis=0).T
    crossed = x * z_next - x_next * z
    # Area times the x of its centroid.
    lever = float(((x + x_next) * crossed).sum() / 6)
    return MASS * G * float(CENTRE @ turned[:, 0]) - SEA * G * float(breadth) * lever


@cache
def lift() -> Scenario:
    """The lift file."""

    def metres(*values: float) -> list[str]:
        return [f"{float(value)!r} m" for value in values]

    units = [["kg", "kg m"], ["kg m", "kg m^2"]]
    matrix = [[f"{float(ADDED[i, j])!r} {units[i // 3][j // 3]}" for j in range(6)] for i in range(6)]
    at = metres(PLACE[0], 0, PLACE[1])
    afloat: dict[str, Any] = {
        "at": metres(0, 0, HIGH),
        "joint": {
            "type": "hinge",
            "axis": [0, 1, 0],
            "position": f"{START} rad",
            "damping": f"{HINGE} N m s",
        },
        "mass": f"{MASS} kg",
        "centre_of_gravity": metres(CENTRE[0], 0, CENTRE[1]),
        "inertia": {"xx": "300 t m^2", "yy": f"{INERTIA} kg m^2", "zz": "300 t m^2"},
        "hull": {"box": metres(*SIZE), "keel": metres(KEEL[0], 0, KEEL[1])},
        "added_mass": {"at": at, "matrix": matrix},
        "water_damping": {"at": at, "surge": "2 kN s/m", "heave": "30 kN s/m", "pitch": "50 kN m s"},
    }
    given = {
        "format": 1,
        "lift": {"title": "A float on a hinge"},
        "duration": f"{LASTS} s",
        "start": "as_given",
        "water": {"density": f"{SEA} kg/m^3"},
        "mechanics": {"bodies": {"float": afloat}},
    }
    return parse_scenario(json.dumps(given))


def test_it_swings_into_the_water() -> None:
    """Its angle over 20 s, let go 0.45 rad above level, to 1e-8: ten times the tolerance of a step."""
    run = simulate(lift(), position_tolerance=1e-9, tension_tolerance=1e-2)
    solved = solve_ivp(
        lambda _, state: [state[1], (moment(state[0]) - RESISTANCE * state[1]) / WHOLE],
        (0, LASTS),
        [START, 0.0],
        "LSODA",
        run.time,
        rtol=1e-10,
        atol=1e-12,
        max_step=0.02,
    )
    found = run.column("joint_position", "float")
    assert np.ptp(found) > 0.6
    assert np.abs(found - solved.y[0]).max() < 1e-8


def test_how_it_comes_to_rest_and_its_mode() -> None:
    """M(θ) = 0 by brentq to rounding; ω² = -M'/J by differences, right to 1e-10, and ζ = D/2Jω."""
    statics = Statics(lift())
    rest = statics.equilibrium()
    found = rest.recording.column("joint_position", "float")[-1]
    angle = brentq(moment, found - 0.1, found + 0.1, xtol=1e-14)
    assert found == pytest.approx(angle, abs=1e-12)
    step = 1e-5
    square = (moment(angle - step) - moment(angle + step)) / (2 * step) / WHOLE
    (mode,) = statics.modes(1)
    assert mode.square == pytest.approx(square, rel=1e-9)
    assert mode.damping_ratio == pytest.approx(RESISTANCE / (2 * WHOLE * math.sqrt(square)), rel=1e-9)
