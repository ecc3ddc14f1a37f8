"""Ropes and weights that drives alone move: what they pull is a function of time."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from mechanics import Floats, G, Json, Run, adaptive, body, document, end, hinge, rope, slider

MASS, ARM = 1000.0, 2.0
EA, LENGTH, TAU = 1e6, 5.0, 0.01
STIFFNESS = EA / LENGTH
#: Where the rope is held above the shaft [m], the speed of the shaft [rad/s], the time to get there [s].
ABOVE, SPEED, RAMP = 6.0, 1.0, 1.0


def turned(time: Floats | float) -> Floats:
    """Angle of a shaft that comes to its speed steadily [rad]."""
    time = np.asarray(time)
    return np.asarray(np.where(time < RAMP, 0.5 * SPEED / RAMP * time**2, SPEED * (time - 0.5 * RAMP)))


def stretch(time: Floats | float) -> tuple[Floats, Floats]:
    """e and ė of a rope from (0, ABOVE) to the arm's end ARM (cos φ, −sin φ) [m, m/s].

    ℓ² = R² + H² + 2 R H sin φ, so ℓ̇ = R H cos φ φ̇/ℓ.
    """
    angle, rate = turned(time), np.minimum(np.asarray(time) / RAMP, 1.0) * SPEED
    length = np.sqrt(ARM**2 + ABOVE**2 + 2 * ARM * ABOVE * np.sin(angle))
    return length - LENGTH, ARM * ABOVE * np.cos(angle) * rate / length


def pull(time: Floats | float) -> Floats:
    """k (e + τ ė), which is below zero where the rope is slack [N]."""
    e, rate = stretch(time)
    return STIFFNESS * (e + TAU * rate)


def crank(duration: float, *, tolerance: float | None) -> Run:
    """A rope on the arm of a shaft that a drive turns."""
    shaft = body("shaft", hinge(drive="turn"), MASS, centre_of_gravity=(ARM, 0, 0), inertia=(1, 1, 1))
    ropes = [rope("r", LENGTH, [end("shaft", (ARM, 0, 0)), end(None, (0, 0, ABOVE))], EA, TAU)]
    drives = [{"name": "turn", "ramps": [{"at": 0.0, "duration": RAMP, "velocity": SPEED}]}]
    return adaptive(document([shaft], ropes=ropes, drives=drives), duration, tension_tolerance=tolerance)


def changes(duration: float) -> list[float]:
    """When the pull changes its sign [s]."""
    times = np.linspace(0, duration, 2000)
    values = pull(times)
    at = np.flatnonzero(values[:-1] * values[1:] < 0)
    return [float(brentq(pull, times[k], times[k + 1], xtol=1e-13)) for k in at]


def test_a_crank_stretches_a_rope() -> None:
    """T(t) = max(0, k (e + τ ė)) with ℓ² = R² + H² + 2 R H sin φ; it goes slack and taut where that is zero.

    Samples lie on polynomials through looks that must foretell each other to a tolerance of 1 N, of 6e5 N;
    changes of sides are found on them to that over the slope of the force at zero, 4e4 N/s and more.
    """
    run = crank(60.0, tolerance=None)
    assert np.abs(run.tension("r") - np.maximum(0.0, pull(run.time))).max() < 1.0
    assert run.peak("r") == pytest.approx(float(pull(np.linspace(0, 60, 600001)).max()), abs=1.0)
    found = sorted(time for kind in ("slack", "taut") for time, _ in run.events(kind))
    assert found == pytest.approx(changes(60.0), abs=1.0 / 4e4)


def damping_loss(duration: float) -> float:
    """∫ k τ ė² dt while the rope is taut, and the spring's ½ k e² at each change of sides [J].

    It goes slack with e > 0, which is lost, and is caught with e < 0, which the damper has not taken yet.
    """
    bounds = [0.0, *changes(duration), duration]
    lost = float(sum(np.sign(e) * 0.5 * STIFFNESS * e**2 for e, _ in map(stretch, bounds[1:-1])))
    for begin, stop in itertools.pairwise(bounds):
        if pull(0.5 * (begin + stop)) > 0.0:
            power = lambda t: STIFFNESS * TAU * float(stretch(t)[1]) ** 2  # noqa: E731
            lost += quad(power, begin, stop, points=[RAMP], epsrel=1e-12, limit=200)[0]
    return lost


def test_the_drive_of_a_crank_pays_for_what_the_damper_loses() -> None:
    """∫ M φ̇ dt = ½ (I + m R²) φ̇² − m g R sin φ + Δ ½ k max(e, 0)² + what the damper has lost, to 1e-9.

    That is the share of the largest energy that a tolerance of 1 mN in 6e5 N leaves in 20 s.
    """
    duration = 20.0
    run = crank(duration, tolerance=1e-3)
    lost = damping_loss(duration)
    first, last = (0.5 * STIFFNESS * max(0.0, float(stretch(time)[0])) ** 2 for time in (0.0, duration))
    moved = 0.5 * (MASS * ARM**2 + 1.0) * SPEED**2 - MASS * G * ARM * np.sin(turned(duration))
    assert run.energy("rope_damping")[-1] == pytest.approx(lost, rel=1e-9)
    assert run.energy("drive_work")[-1] == pytest.approx(float(moved) + last - first + lost, rel=1e-9)
    assert run.energy_remainder < 1e-9


def test_a_rope_on_a_slider_that_passes_by() -> None:
    """T = k (√(x² + h²) − L) at constant speed, slack while |x| < √(L² − h²) = 3 m: from 7.25 to 13.25 s."""
    height, stiffness = 4.0, EA / LENGTH
    car = body("car", slider((1, 0, 0), drive="go"), MASS, position=(-10, 0, 0))
    ropes = [rope("r", LENGTH, [end("car"), end(None, (0, 0, height))], EA)]
    drives = [{"name": "go", "ramps": [{"at": 0.0, "duration": 0.5, "velocity": 1.0}]}]
    system: Json = document([car], ropes=ropes, drives=drives)
    run = adaptive(system, 25.0, tension_tolerance=None)
    x = run.body("car")[:, 0]
    expected = np.maximum(0.0, stiffness * (np.hypot(x, height) - LENGTH))
    assert np.abs(run.tension("r") - expected).max() < 1.0
    times = run.events("slack")[0][0], run.events("taut")[0][0]
    # 1 N over the slope of the force there, k · 3/5 · 1 m/s = 1.2e5 N/s.
    assert times == pytest.approx((7.25, 13.25), abs=1.0 / 1.2e5)


@pytest.mark.parametrize("speed", [3.0, -3.0])
def test_an_arm_turns_by_no_more_than_a_radian_in_a_step(speed: float) -> None:
    """A balanced rotor in free bearings on an arm that goes round notices nothing of it: steps would be as
    long as the run, and samples of energy straight lines over it. Steps are as many as radians at least,
    either way.
    """
    shaft = body("shaft", hinge(drive="turn"), MASS, centre_of_gravity=(ARM, 0, 0), inertia=(1, 1, 1))
    rotor = body("rotor", hinge(), 500.0, parent="shaft", inertia=(5, 5, 5))
    drives = [{"name": "turn", "ramps": [{"at": 0.0, "duration": RAMP, "velocity": speed}]}]
    run = adaptive(document([shaft, rotor], drives=drives), 20.0, sample_interval=0.1)
    turned_by = abs(speed) * (20.0 - 0.5 * RAMP)
    assert abs(run.joint("shaft")[-1]) == pytest.approx(turned_by, rel=1e-12)
    assert run.counters["steps"] >= turned_by
    assert run.energy_remainder < 1e-7
