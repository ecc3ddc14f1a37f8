"""Stops at the ends of a joint's stroke against closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from mechanics import G, Json, Run, adaptive, body, document, hinge, simulate, slider

MASS, STIFFNESS = 50.0, 2e5
OMEGA = math.sqrt(STIFFNESS / MASS)


def thrown(speed: float, damping_time: float = 0.0, **stops: float) -> Json:
    """A mass that slides level from 0 towards its stops; nothing else acts."""
    law = {"stiffness": STIFFNESS, "damping_time": damping_time}
    joint = slider((1, 0, 0), velocity=speed, stops={**stops, **law})
    return document([body("mass", joint, MASS)])


def contact(run: Run) -> tuple[float, float]:
    [(hit, first)], [(left, second)] = run.events("stop_hit"), run.events("stop_left")
    assert first == second == "mass"
    return hit, left


@pytest.mark.parametrize(("end", "sign"), [("upper", 1.0), ("lower", -1.0)])
def test_impact_on_a_stop_without_damping(end: str, sign: float) -> None:
    """Contact for half a sine, π √(m/k); depth v √(m/k); rebound with the same speed."""
    speed, stroke = 0.4, 0.1
    run = adaptive(thrown(sign * speed, **{end: sign * stroke}), 0.5, sample_interval=1e-3)
    hit, left = contact(run)
    assert hit == pytest.approx(stroke / speed, abs=1e-6)
    assert left - hit == pytest.approx(math.pi / OMEGA, abs=1e-6)
    assert sign * run.body("mass", "body_velocity")[-1, 0] == pytest.approx(-speed, rel=1e-6)
    inside = np.sin(OMEGA * (run.time - hit)) * (run.time > hit) * (run.time < left)
    depth = np.maximum(sign * run.joint("mass") - stroke, 0.0)
    assert np.abs(depth - speed / OMEGA * inside).max() < 1e-8
    assert run.energy_remainder < 1e-8


@pytest.mark.parametrize("share", [0.05, 0.3, 0.7])
def test_impact_on_a_damped_stop(share: float) -> None:
    """T = k (e + τ ė) acts while it pushes, half a damped period: rebound v exp(−π ζ/√(1 − ζ²)), ζ = τ ω/2.

    It begins τ v before the end of the stroke, where T = 0, and lasts π/(ω √(1 − ζ²)).
    """
    speed, stroke = 0.4, 0.1
    damping_time = 2 * share / OMEGA
    run = adaptive(thrown(speed, damping_time, upper=stroke), 0.5, sample_interval=1e-3)
    hit, left = contact(run)
    root = math.sqrt(1 - share**2)
    assert hit == pytest.approx(stroke / speed - damping_time, abs=1e-6)
    assert left - hit == pytest.approx(math.pi / (OMEGA * root), abs=1e-6)
    after = speed * math.exp(-math.pi * share / root)
    assert run.body("mass", "body_velocity")[-1, 0] == pytest.approx(-after, rel=1e-6)
    lost = 0.5 * MASS * (speed**2 - after**2)
    assert run.energy("contact_damping")[-1] == pytest.approx(lost, rel=1e-5)
    assert run.energy_remainder < 1e-6


def test_impact_with_fixed_steps() -> None:
    """The same without damping by `del`: duration π √(m/k) to a step, the method's own loss in the books.

    The scheme damps the oscillation by exp(−ω² h t/2), so the rebound is v exp(−π ω h/2) to first order.
    """
    speed, stroke, step = 0.4, 0.1, 1e-4
    run = simulate(thrown(speed, upper=stroke), 0.5, step=step)
    hit, left = contact(run)
    assert hit == pytest.approx(stroke / speed, abs=step)
    assert left - hit == pytest.approx(math.pi / OMEGA, abs=2 * step)
    after = speed * math.exp(-math.pi * OMEGA * step / 2)
    assert run.body("mass", "body_velocity")[-1, 0] == pytest.approx(-after, rel=2e-3)
    assert run.energy_remainder < 1e-9


def test_a_mass_that_rests_on_its_stop() -> None:
    """Settled, it is m g/k beyond the end of its stroke, and the joint transmits what the stop carries."""
    stops: dict[str, Any] = {"lower": -0.2, "stiffness": STIFFNESS, "damping_time": 0.02}
    run = adaptive(document([body("mass", slider(stops=stops), MASS)]), 3.0)
    assert run.joint("mass")[-1] == pytest.approx(-0.2 - MASS * G / STIFFNESS, abs=1e-9)
    assert run.body("mass", "joint_force")[-1] == pytest.approx([0, 0, MASS * G], abs=1e-4)


def test_a_pendulum_between_stops() -> None:
    """A hinged bob let go level meets its stop at φ with ½ ω² = (g/l) sin φ, and rebounds without loss."""
    length, angle = 2.0, 1.2
    stops = {"upper": angle, "stiffness": 1e8}
    arm = body("bob", hinge(stops=stops), MASS, centre_of_gravity=(length, 0, 0))
    run = adaptive(document([arm]), 2.5, sample_interval=1e-3)
    hits, lefts = run.events("stop_hit"), run.events("stop_left")
    assert len(hits) == len(lefts) == 2
    before = np.searchsorted(run.time, hits[0][0]) - 1
    assert run.joint("bob")[before] == pytest.approx(angle, abs=4e-3)
    # Back to rest at the top, to what 1e-3 N lets through.
    top = run.joint("bob")[run.time > lefts[0][0]].min()
    assert top == pytest.approx(0.0, abs=1e-6)
    speed = math.sqrt(2 * G / length * math.sin(angle))
    turning = np.abs(run.body("bob", "body_angular_velocity")[:, 1])
    assert turning.max() == pytest.approx(speed, rel=2e-3)
