"""What ropes turn, by `del`: light bodies under great tension, in steps far longer than their own motion."""

from __future__ import annotations

import numpy as np
import pytest

from mechanics import (
    Floats,
    G,
    Json,
    body,
    document,
    end,
    finished,
    free,
    hinge,
    rope,
    simulation,
)

#: Arm from the hinge, mass at its end and inertia about that: a sheave block [m, kg, kg m^2].
ARM, MASS, INERTIA = 1.0, 1.0, 1.0 / 6.0
#: Rope from the arm's end straight down [m], its tension [N], EA [N], and by how much it is stretched [m].
DOWN, TENSION, EA = 10.0, 5e5, 1e10
STRETCH = DOWN * TENSION / (EA + TENSION)
#: At the start [rad].
ANGLE = 1e-6

#: Stiffness of the arm under the tension, of the arm with the chord's turn, and of its own weight [N m].
BY_ARM, BY_CHORD, BY_WEIGHT = TENSION * ARM, TENSION * ARM**2 / DOWN, MASS * G * ARM
ABOUT_HINGE = INERTIA + MASS * ARM**2


def hung_arm(angle: float) -> Json:
    """The arm, hanging from its hinge at the origin, turned by an angle [rad]."""
    inertia = (INERTIA, INERTIA, INERTIA)
    joint = hinge(position=angle, velocity=0.0)
    return body("arm", joint, MASS, centre_of_gravity=(0, 0, -ARM), inertia=inertia)


def held_arm() -> Json:
    """The arm with a rope to the ground that is stretched by what its tension asks for."""
    route = [end("arm", (0, 0, -ARM)), end(None, (0, 0, -ARM - DOWN))]
    return document([hung_arm(ANGLE)], ropes=[rope("rope", DOWN - STRETCH, route, EA)])


def angles(step: float, count: int) -> Floats:
    """Angle of the arm at the end of every step [rad]."""
    run = simulation(held_arm(), count * step, step=step)
    result = finished(run, run.run())
    found: Floats = result.columns["joint_position"][:, 0]
    return found


def recurrence(step: float, count: int) -> Floats:
    """The same by the step of `del` for one coordinate, (DL1) with (DL3): weight at the start of the step,
    arm and chord each with their own weight of the velocity after it.
    """
    theta, speed, found = ANGLE, 0.0, [ANGLE]
    stiffness = np.array([BY_ARM, BY_CHORD])
    beyond = step**2 * stiffness / ABOUT_HINGE
    after = 0.25 + 0.75 * beyond / (1 + beyond)
    for _ in range(count):
        momentum = (ABOUT_HINGE + step**2 * stiffness.sum() / 4) * speed
        momentum -= step * (stiffness.sum() + BY_WEIGHT) * theta
        speed = momentum / (ABOUT_HINGE + step**2 * (after * stiffness).sum())
        theta += step * speed
        found.append(theta)
    return np.array(found)


@pytest.mark.parametrize("step", [1e-2, 1e-3, 1e-4])
def test_an_arm_under_tension_follows_its_recurrence(step: float) -> None:
    """A sheave block of 1 kg on an arm of 1 m under 500 kN, hω = 6.9, 0.69 and 0.069: 100 steps as the
    formula of one coordinate has them. Beside it stands the rope's own stiffness, EA/ℓ (r (1 + r/ℓ) θ)²,
    a share of 2e-9.
    """
    found, expected = angles(step, 100), recurrence(step, 100)
    assert np.abs(found - expected).max() < 1e-7 * ANGLE


def test_an_arm_under_tension_swings_at_its_frequency() -> None:
    """ω² = (T r (1 + r/ℓ) + m g r)/I: three periods in steps of 1/400 and 1/800 of one follow the cosine
    with errors of first order or better. What is damped per period is of third order, π 3/4 (hω)³/hω,
    0.06 % in the first; the velocity of the first step is late by half of it, hω/2, 0.8 %.
    """
    omega = np.sqrt((BY_ARM + BY_CHORD + BY_WEIGHT) / ABOUT_HINGE)
    errors = []
    for parts in (400, 800):
        step = 2 * np.pi / omega / parts
        found = angles(step, 3 * parts)
        time = step * np.arange(3 * parts + 1)
        errors.append(np.abs(found - ANGLE * np.cos(omega * time)).max() / ANGLE)
    assert errors[0] < 0.01
    assert errors[1] < 0.55 * errors[0]


def test_what_hangs_between_two_ropes_does_not_spin_up() -> None:
    """A turnbuckle of 1 kg between two ropes under 500 kN, hω = 23: 200 steps from a turn of 1 mrad/s. It
    never turns further than in the first step, 10 µrad, comes to rest, and the ropes carry what they
    carried.
    """
    turning = free((0, 0, 0), angular_velocity=[1e-3, 2e-4, 0])
    buckle = body("buckle", turning, 1.0, inertia=(0.1, 0.1, 0.1))
    ropes = [
        rope(name, DOWN - STRETCH, [end("buckle", (0, 0, at)), end(None, (0, 0, at + along))], EA)
        for name, at, along in (("upper", 0.5, DOWN), ("lower", -0.5, -DOWN))
    ]
    run = simulation(document([buckle], gravity=[0, 0, 0], ropes=ropes), 2.0, step=1e-2)
    result = finished(run, run.run())
    assert result.tension("upper") == pytest.approx(TENSION, rel=1e-5)
    turned = np.abs(result.body("buckle", "body_orientation")[:, 1:3]).max(axis=1) * 2
    assert turned.max() <= 1e-5 * (1 + 1e-9)
    assert turned[-1] < 1e-9


def test_a_rope_within_a_crane_does_not_brake_the_crane() -> None:
    """Arm and rope on a frame that floats in space and turns at 0.5 rad/s: what the rope resists is the
    arm's turn against the frame. Against the world, its α would brake a frame of 500 kg m² with h 3/4 T
    r = 3.75 kN m s, to nothing in a second. Centrifugal force on the arm is 1e-6 of the tension.
    """
    frame = body("frame", free((0, 0, 0), angular_velocity=[0, 0.5, 0]), 1e4, inertia=(500, 500, 500))
    route = [end("arm", (0, 0, -ARM)), end("frame", (0, 0, -ARM - DOWN))]
    own = {**hung_arm(ANGLE), "parent": "frame"}
    system = document([frame, own], gravity=[0, 0, 0], ropes=[rope("rope", DOWN - STRETCH, route, EA)])
    run = simulation(system, 5.0, step=1e-2)
    result = finished(run, run.run())
    spin = result.body("frame", "body_angular_velocity")[:, 1]
    assert spin[1:] == pytest.approx(0.5, rel=1e-4)
    assert np.abs(result.joint("arm")).max() < 2 * ANGLE + 1e-4
