"""A body under water with full matrices of added mass and damping, against its momenta.

With the momentum P and angular momentum L of body and water about the body's origin, in body axes, and the
velocity v and angular velocity ω there (Lamb, chapter VI),

    Ṗ = F − ω × P        L̇ = N − ω × L − v × P        (P, L) = M (v, ω)

M is made of the 6 × 6 matrices of body and water, each moved from its own point: the added mass is about a
point that is neither centre of gravity nor origin, the resistance about another. scipy's DOP853 solves that.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from floating import SEA, box_hull, buoyancy
from mechanics import Floats, G, adaptive, body, document, free
from rigid import cross

MASS, CENTRE, INERTIA = 700.0, np.array([-0.3, 0.25, -0.1]), np.array([120.0, 160.0, 200.0])
SIZE, WATER_AT, DRAG_AT = (1.6, 1.0, 0.55), np.array([0.4, -0.2, 0.3]), np.array([-0.5, 0.1, 0.2])
STREAM = np.array([0.8, -0.5, 0.0])
QUADRATIC = np.array([60.0, 90.0, 120.0, 30.0, 40.0, 50.0])
LASTS = 5.0


def positive(seed: int, scale: float, diagonal: list[float]) -> Floats:
    """A full symmetric matrix without negative eigenvalues."""
    drawn = np.random.default_rng(seed).normal(size=(6, 6))
    matrix: Floats = scale * drawn @ drawn.T + np.diag(diagonal)
    return matrix


ADDED = positive(5, 80.0, [200, 600, 900, 50, 80, 90])
DAMPING = positive(6, 2.0, [30, 40, 50, 20, 25, 30])


def crossed(a: Floats) -> Floats:
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def moved(matrix: Floats, at: Floats) -> Floats:
    """A matrix about the point `at` as one about the origin: v there is v + ω × `at`."""
    velocity = np.eye(6)
    velocity[:3, 3:] = -crossed(at)
    whole: Floats = velocity.T @ matrix @ velocity
    return whole


def axes(q: Floats) -> Floats:
    """World axes from body axes: R = 1 + 2 w [u] + 2 [u]²."""
    unit = q / np.linalg.norm(q)
    turn = crossed(unit[1:])
    rotation: Floats = np.eye(3) + 2 * unit[0] * turn + 2 * turn @ turn
    return rotation


@pytest.mark.parametrize("resists", [False, True])
def test_a_body_that_tumbles_under_water(resists: bool) -> None:
    """Its centre of gravity over 5 s to 1e-6 m, over 20 m of way; with and without a current that resists."""
    whole = moved(np.diag([MASS] * 3 + INERTIA.tolist()), CENTRE) + moved(ADDED, WATER_AT)
    volume, middle = math.prod(SIZE), np.array([0, 0, SIZE[2] / 2])

    def rates(_: float, y: Floats) -> list[float]:
        rotation, momentum = axes(y[3:7]), y[7:]
        motion = np.asarray(np.linalg.solve(whole, momentum), np.float64)
        v, w = motion[:3], motion[3:]
        weight, lift = -G * MASS * rotation[2], G * SEA * volume * rotation[2]
        force, moment = weight + lift, cross(CENTRE, weight) + cross(middle, lift)
        if resists:
            against = v + cross(w, DRAG_AT) - rotation.T @ STREAM
            speeds = np.array([np.linalg.norm(against)] * 3 + np.abs(w).tolist())
            drag = -DAMPING @ [*against, *w] - QUADRATIC * speeds * [*against, *w]
            force, moment = force + drag[:3], moment + drag[3:] + cross(DRAG_AT, drag[:3])
        pushed = force - cross(w, momentum[:3])
        spun = moment - cross(w, momentum[3:]) - cross(v, momentum[:3])
        turning = 0.5 * np.array([-y[4:7] @ w, *(y[3] * w + cross(y[4:7], w))])
        return [*(rotation @ v), *turning, *pushed, *spun]

    place, attitude = [0.0, 0.0, -40.0], np.array([0.8, 0.3, -0.4, math.sqrt(0.11)])
    velocity, spin = np.array([1.0, -2.0, 0.5]), np.array([0.5, 1.2, -0.7])
    first = [*place, *attitude, *(whole @ [*(axes(attitude).T @ velocity), *spin])]
    times = np.linspace(0, LASTS, 51)
    own = solve_ivp(rates, (0, LASTS), first, "DOP853", times, rtol=1e-10, atol=1e-10).y.T
    centres = np.array([y[:3] + axes(y[3:7]) @ CENTRE for y in own])
    assert centres[:, 2].max() < -2.0, "it must stay under water"

    start = {
        "orientation": attitude.tolist(),
        "velocity": velocity.tolist(),
        "angular_velocity": spin.tolist(),
    }
    one = body("b", free(place, **start), MASS, centre_of_gravity=CENTRE.tolist(), inertia=INERTIA.tolist())
    added = {
        "type": "added_mass",
        "name": "added",
        "body": "b",
        "at": WATER_AT.tolist(),
        "matrix": ADDED.tolist(),
    }
    drag = {"type": "drag", "name": "drag", "body": "b", "at": DRAG_AT.tolist(), "stream": STREAM.tolist()}
    drag |= {"damping": DAMPING.tolist(), "quadratic": QUADRATIC.tolist()}
    forces = [buoyancy("b", box_hull(SIZE)), added, *([drag] if resists else [])]
    # Tolerances of 1 nm a step.
    run = adaptive(
        document([one], forces=forces),
        LASTS,
        tension_tolerance=1e-4,
        position_tolerance=1e-9,
        sample_interval=LASTS / 50,
    )
    assert np.abs(run.body("b") - centres).max() < 1e-6
