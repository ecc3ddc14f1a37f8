"""A load that slides and spins on three feet, against Coulomb's law for rigid feet.

Each foot is braked by μ N against its own velocity. The friction acts below the centre of gravity, so it
shifts the normal forces, on which it depends: with d the unit vectors against the velocities and (x, y) from
the centre of gravity, which is h above the feet,

    Σ N = m g        Σ (y + h μ d_y) N = 0        Σ (x + h μ d_x) N = 0

are three linear equations, for the load does not tilt. scipy's DOP853 solves the motion.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp

from mechanics import Floats, G, adaptive, body, contact, document, free

MASS, YAW_INERTIA, HEIGHT, FRICTION = 1200.0, 900.0, 0.6, 0.3
FEET = np.array([[1.05, 0.33], [-1.11, 0.67], [-0.28, -0.86]])
SPEED, SPIN = (2.5, 0.4), 4.0
LASTS = 1.3


def brakes(angle: float, velocity: Floats, spin: float) -> tuple[Floats, Floats, Floats]:
    """Normal forces of the feet [N], their friction [N], and where they are from the centre of gravity."""
    c, s = math.cos(angle), math.sin(angle)
    feet = FEET @ np.array([[c, s], [-s, c]])
    speeds = velocity + spin * np.stack([-feet[:, 1], feet[:, 0]], axis=1)
    against = -speeds / np.linalg.norm(speeds, axis=1)[:, None]
    tilting = feet + HEIGHT * FRICTION * against
    normal = np.linalg.solve(np.vstack([np.ones(3), tilting.T]), [MASS * G, 0, 0])
    return normal, FRICTION * normal[:, None] * against, feet


def rates(_: float, y: Floats) -> list[float]:
    friction, feet = brakes(y[2], y[3:5], y[5])[1:]
    turning = float(np.sum(feet[:, 0] * friction[:, 1] - feet[:, 1] * friction[:, 0])) / YAW_INERTIA
    return [*y[3:], *(friction.sum(axis=0) / MASS), turning]


def test_a_load_that_slides_and_spins() -> None:
    """Way and heading until shortly before rest, the normal forces on it, and the energy lost."""
    times = np.linspace(0, LASTS, 27)
    first = [0, 0, 0, *SPEED, SPIN]
    own = solve_ivp(rates, (0, LASTS), first, "DOP853", times, rtol=1e-10, atol=1e-10).y.T
    stiffness = 1e10
    sunk = MASS * G / 3 / stiffness
    start = {"velocity": [*SPEED, 0], "angular_velocity": [0, 0, SPIN]}
    load = body("load", free((0, 0, HEIGHT - sunk), **start), MASS, inertia=(600, 600, YAW_INERTIA))
    law = {"stiffness": stiffness, "friction": FRICTION, "damping_time": 2e-4}
    feet = [contact(f"c{k}", "load", (x, y, -HEIGHT), **law) for k, (x, y) in enumerate(FEET)]
    run = adaptive(document([load], contacts=feet), LASTS, tension_tolerance=0.1, sample_interval=LASTS / 26)
    # A foot's force lags behind its velocity by some μ N/k of its way, 0.1 µm: what that leaves falls with
    # 1/k, 3e-5 m at 1e8 N/m, 3e-7 m here.
    assert np.abs(run.body("load")[:, :2] - own[:, :2]).max() < 1e-6
    turned = run.body("load", "body_orientation")
    assert np.abs(2 * np.arctan2(turned[:, 3], turned[:, 0]) - own[:, 2]).max() < 1e-6
    normal = np.array([brakes(y[2], y[3:5], y[5])[0] for y in own])
    # At the start nothing has been deflected yet, and friction is that of the dampers; thereafter as above.
    assert np.abs(run.columns["contact_force"][1:] - normal[1:]).max() < 0.1
    assert np.ptp(normal, axis=0).max() > 0.1 * MASS * G, "friction must shift the normal forces"
    final = MASS * float(own[-1, 3:5] @ own[-1, 3:5]) / 2 + YAW_INERTIA * own[-1, 5] ** 2 / 2
    begin = MASS * float(np.dot(SPEED, SPEED)) / 2 + YAW_INERTIA * SPIN**2 / 2
    assert abs(run.energy("friction")[-1] - (begin - final)) < 1e-5 * begin
