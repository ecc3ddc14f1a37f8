"""Ropes, sheaves and their unilateral law against closed forms, integrator `del`."""

from __future__ import annotations

import math

import numpy as np
import pytest

from mechanics import G, body, document, end, half_turn, point, rope, simulate, slider
from one_rope import DROP_PEAK, LIFT_OFF, LIFT_OFF_FACTOR, TAUT, WEIGHT, drop, lift_off, two_sheaves


def test_pulleys_tension_is_exact() -> None:
    """T = 5 g/(4/20 + 4/20 + 1/11) = 275 g/27 at every step after the first."""
    run = simulate(two_sheaves(), 5.0, step=1e-3)
    exact = 275 * G / 27
    assert np.abs(run.tension("rope")[2:] / exact - 1).max() < 1e-6


def test_pulleys_displacement_converges_with_the_step() -> None:
    """Box −½(2 g/27) t², sheaves +½ (g/54) t²; from rest the scheme gives ½ a t² (1 + h/t): order 1."""
    box, sheave = 0.5 * (2 * G / 27) * 25, 0.5 * (G / 54) * 25
    assert (box, sheave) == pytest.approx((9.08333, 2.27083), abs=1e-5)  # the paper page's figures
    errors = []
    for step in (2e-3, 1e-3, 5e-4):
        run = simulate(two_sheaves(), 5.0, step=step)
        found = np.array([-run.joint("box")[-1], run.joint("left")[-1], run.joint("right")[-1]])
        errors.append(np.abs(found / [box, sheave, sheave] - 1).max())
    assert errors[1] < 1e-3
    assert errors[0] / errors[1] == pytest.approx(2, abs=0.01)
    assert errors[1] / errors[2] == pytest.approx(2, abs=0.01)


def test_atwood_machine() -> None:
    """a = (m₂ − m₁) g/(m₁ + m₂), T = 2 m₁ m₂ g/(m₁ + m₂); the held sheave carries 2 T."""
    m1, m2 = 10.0, 12.0
    system = document(
        [
            body("light", slider(), m1, position=(-0.5, 0, 5)),
            body("heavy", slider(), m2, position=(0.5, 0, 5)),
        ],
        ropes=[
            rope(
                "r",
                10 + math.pi * 0.5,
                [end("light"), half_turn(None, (0, 0, 10), 0.5, over=True), end("heavy")],
                None,
            )
        ],
    )
    run = simulate(system, 1.0)
    acceleration = (m2 - m1) * G / (m1 + m2)
    velocity = run.body("heavy", "body_velocity")[:, 2]
    assert np.abs(velocity[1:] + acceleration * run.time[1:]).max() < 1e-10
    assert np.abs(run.tension("r")[2:] - 2 * m1 * m2 * G / (m1 + m2)).max() < 1e-8


def test_slack_to_taut_drop() -> None:
    """A mass that falls h before an undamped rope goes taut: peak T = m g (1 + √(1 + 2 k h/(m g)))."""
    errors = []
    for step in (4e-4, 2e-4, 1e-4):
        run = simulate(drop(), 0.6, step=step)
        errors.append(abs(run.peak("r") / DROP_PEAK - 1))
        assert run.events("taut")[0][0] == pytest.approx(TAUT, abs=step)
    # The scheme damps at h ω²/2: in the half period up to the peak, ω = 31.6 rad/s, it loses at most
    # h ω π/2 = 0.5 % of the amplitude at h = 1e-4.
    assert errors[-1] < 5e-3
    assert errors[0] / errors[2] == pytest.approx(4, rel=0.25)
    assert run.energy_remainder < 1e-4


def test_lift_off_at_constant_speed() -> None:
    """Hoisted off the ground at v by an undamped rope of stiffness k: dynamic factor 1 + v √(k/m)/g."""
    run = simulate(lift_off(), 2.0, step=5e-5, sample_interval=1e-3)
    # The rigid ground and the step cost less than 0.02 % of the factor.
    assert run.peak("r") / WEIGHT == pytest.approx(LIFT_OFF_FACTOR, rel=2e-4)
    assert [name for _, name in run.events("lift_off")] == ["load"]
    assert run.events("lift_off")[0][0] == pytest.approx(LIFT_OFF, abs=2e-3)


def test_slack_ropes_carry_nothing_and_never_push() -> None:
    """A mass thrown up on a rope flies freely: T = 0 to the last bit, path of free fall."""
    system = document(
        [body("m", point((0, 0, 0), (1.0, 0, 4.0)), 5.0)],
        ropes=[rope("r", 10.0, [end(None, (0, 0, 5)), end("m")], 1e6)],
    )
    run = simulate(system, 1.0)
    assert np.all(run.tension("r") == 0.0)
    path = 4.0 * run.time - 0.5 * G * run.time * (run.time + 1e-3)  # the scheme's own free fall
    assert np.abs(run.body("m")[:, 2] - path).max() < 1e-12


def test_rope_damping_is_lost_by_its_formula() -> None:
    """A mass bobbing on a damped rope under tension: loss = ∫ k τ ė² dt, from the recorded velocities."""
    mass, ea, length, tau = 1000.0, 1e7, 10.0, 0.01
    k = ea / length
    system = document(
        [body("m", slider(velocity=0.2), mass, position=(0, 0, -mass * G / k))],
        ropes=[rope("r", length, [end(None, (0, 0, length)), end("m")], ea, tau)],
    )
    run = simulate(system, 2.0, step=1e-4)
    assert run.tension("r").min() > 0
    rate = run.body("m", "body_velocity")[:, 2]
    expected = float(np.sum(k * tau * rate[1:] ** 2) * 1e-4)
    assert run.energy("rope_damping")[-1] == pytest.approx(expected, rel=1e-9)
    assert run.energy_remainder < 1e-9  # vertical: nothing is nonlinear
