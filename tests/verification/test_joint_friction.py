"""Dry friction of hinges: held, slipping, and stopping, in closed form."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from gantline._core import Simulation
from mechanics import G, Json, Run, body, document, finished, hinge


def swung(bodies: list[Json], duration: float, **settings: Any) -> Run:
    integrator = {"type": "adaptive", "tension_tolerance": 0.01, "position_tolerance": 1e-9}
    run = Simulation(
        json.dumps(document(bodies)),
        json.dumps({"integrator": integrator, "duration": duration, "sample_interval": 0.01, **settings}),
    )
    result = finished(run, run.run())
    assert result.energy_remainder < 1e-10
    return result


def test_a_disc_runs_down() -> None:
    """Constant friction M: at rest after ω I/M at ω² I/2M, and ½ I ω² has become heat."""
    inertia, friction, speed = 12.0, 3.0, 2.0
    disc = body("disc", hinge((0, 0, 1), velocity=speed, friction=friction), 5.0, inertia=(1, 1, inertia))
    run = swung([disc], 12.0)
    angle = run.joint("disc")
    assert angle[-1] == pytest.approx(speed**2 * inertia / (2 * friction), abs=1e-9)
    at_rest = run.time[angle >= angle[-1] - 1e-12][0]
    assert at_rest == pytest.approx(speed * inertia / friction, abs=0.011)  # a sample
    assert run.energy("friction")[-1] == pytest.approx(inertia * speed**2 / 2, abs=1e-9)


def test_a_pendulum_loses_the_same_angle_in_every_half_swing_and_then_rests() -> None:
    """Small swings: each half swing ends 2 M/(m g L) closer to the middle; where |m g L θ| < M it stays."""
    mass, length, start = 100.0, 2.0, 0.02
    weight = mass * G * length
    friction = 0.1 * weight * start
    pendulum = body(
        "pendulum", hinge(position=start, friction=friction), mass, centre_of_gravity=(0, 0, -length)
    )
    run = swung([pendulum], 25.0)
    angle = run.joint("pendulum")
    # ±0.02 → ∓0.016 → ±0.012 → ∓0.008 → ±0.004 → 0, where it stays; sin θ is θ to θ²/6 = 7e-5.
    turns = angle[1:-1][(np.diff(angle[:-1]) * np.diff(angle[1:]) < 0.0)]
    assert turns[:3] == pytest.approx([-0.016, 0.012, -0.008], abs=2e-6)
    assert abs(angle[-1]) <= friction / weight * (1 + 1e-9)
    assert np.ptp(angle[-300:]) == 0.0


def test_a_pendulum_below_its_friction_does_not_creep() -> None:
    """m g L sin θ < M: not 1e-12 rad in an hour."""
    angle = 0.01
    weight = 100.0 * G * 2.0
    assert weight * math.sin(angle) < 30.0
    pendulum = body("pendulum", hinge(position=angle, friction=30.0), 100.0, centre_of_gravity=(0, 0, -2.0))
    run = swung([pendulum], 3600.0, sample_interval=60.0)
    assert np.abs(run.joint("pendulum") - angle).max() < 1e-12
