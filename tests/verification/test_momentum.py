"""Momentum of all bodies: its closed form at a known motion, what weight gives it, and what nothing takes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from mechanics import G, Json, Run, adaptive, body, document, end, free, hinge, rope, simulate

#: Inertia about the centre of gravity [kg m²] and centre of gravity in body axes [m] of both bodies.
INERTIA = ((40.0, 70.0, 90.0), (25.0, 20.0, 30.0))
CENTRE = ((0.3, 0.0, -0.2), (0.0, 0.1, 0.4))
MASS = (200.0, 90.0)
VELOCITY = ((0.4, -0.2, 0.1), (-1.1, 0.5, 0.3))
SPIN = ((0.5, 0.2, -0.3), (-0.4, 0.9, 0.6))


def tied(centres: Sequence[Sequence[float]] = CENTRE) -> Json:
    """Two bodies in free space that turn and fly apart, until the rope between them goes taut."""
    bodies = [
        body(
            name,
            free((3.0 * index, 0.5, 1.0), velocity=list(VELOCITY[index]), angular_velocity=list(SPIN[index])),
            MASS[index],
            centre_of_gravity=centres[index],
            inertia=INERTIA[index],
        )
        for index, name in enumerate(("a", "b"))
    ]
    tie = rope("tie", 2.5, [end("a", (0.5, 0, 0)), end("b", (-0.4, 0.2, 0))], 2e5, 5e-3)
    return {**document(bodies, ropes=[tie]), "gravity": [0, 0, 0]}


def spread(run: Run, column: str) -> float:
    """Largest change of a momentum from its start."""
    return float(np.abs(run.columns[column] - run.columns[column][0]).max())


def test_momentum_at_the_start_is_that_of_its_bodies() -> None:
    """p = Σ m (v + ω × r) and L = Σ c × m (v + ω × r) + I ω, with r from where the joint sits; level axes."""
    run = adaptive(tied(), 0.01)
    linear, angular = np.zeros(3), np.zeros(3)
    for index in range(2):
        centre = np.array([3.0 * index, 0.5, 1.0]) + CENTRE[index]
        moving = MASS[index] * (np.array(VELOCITY[index]) + np.cross(SPIN[index], CENTRE[index]))
        linear += moving
        angular += np.cross(centre, moving) + np.array(INERTIA[index]) * SPIN[index]
    assert run.columns["momentum"][0] == pytest.approx(linear, rel=1e-14, abs=1e-12)
    assert run.columns["angular_momentum"][0] == pytest.approx(angular, rel=1e-14, abs=1e-12)


def test_a_rope_between_bodies_changes_no_momentum() -> None:
    """Taut and slack again, off both centres: what one gets the other loses, along one line."""
    run = adaptive(tied(), 6.0, position_tolerance=1e-9)
    assert {name for _, name in run.events("taut")} == {"tie"}
    assert run.tension("tie").max() > 1e3
    size = np.abs(run.columns["angular_momentum"][0]).max()
    # 6 s of steps that are right to 1e-9 m, of 300 kg at some m/s.
    assert spread(run, "momentum") < 1e-6 * np.abs(run.columns["momentum"][0]).max()
    assert spread(run, "angular_momentum") < 1e-6 * size


def test_what_del_takes_of_momentum_falls_with_its_step() -> None:
    """A step pulls along the lines and with the levers of its start: of first order. p is right to rounding
    where joints sit in the centres of gravity, whose velocities are then coordinates.
    """
    coarse, fine = (simulate(tied(), 6.0, step=step, sample_interval=0.05) for step in (1e-3, 5e-4))
    # What is of second order in the step is some hundredths of it at 1 ms.
    for column in ("momentum", "angular_momentum"):
        assert spread(coarse, column) / spread(fine, column) == pytest.approx(2.0, rel=0.1), column
    central = simulate(tied(((0, 0, 0), (0, 0, 0))), 6.0, sample_interval=0.05)
    assert central.tension("tie").max() > 1e3
    assert spread(central, "momentum") < 1e-12 * np.abs(central.columns["momentum"][0]).max()


def test_weight_gives_momentum_at_its_rate() -> None:
    """A pendulum in a falling frame: the pair falls with p = -m g t, and L by the moment of their weight."""
    frame = body("frame", free((0, 0, 0), angular_velocity=[0, 0.4, 0]), 50.0, inertia=(5.0, 6.0, 7.0))
    arm = body(
        "arm",
        hinge(velocity=1.3),
        20.0,
        parent="frame",
        position=(0.5, 0, 0),
        centre_of_gravity=(0, 0, -0.8),
        inertia=(1.0, 1.0, 0.2),
    )
    run = adaptive(document([frame, arm]), 2.0, position_tolerance=1e-10, sample_interval=0.01)
    momentum, angular = run.columns["momentum"], run.columns["angular_momentum"]
    fallen = momentum[:, 2] - momentum[0, 2]
    assert fallen == pytest.approx(-70.0 * G * run.time, rel=1e-9, abs=1e-7)
    assert np.abs(momentum[:, :2] - momentum[0, :2]).max() < 1e-7
    # L_y from dL/dt = c × (-m g z) of the common centre of gravity, which goes aside steadily.
    centre = (50.0 * run.body("frame")[:, 0] + 20.0 * run.body("arm")[:, 0]) / 70.0
    aside = 70.0 * G * (centre[0] * run.time + momentum[0, 0] / 70.0 * run.time**2 / 2)
    assert angular[:, 1] - angular[0, 1] == pytest.approx(aside, rel=1e-8, abs=1e-6)
