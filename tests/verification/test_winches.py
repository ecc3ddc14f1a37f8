"""Drums whose motors have a limited force and power: a load on one rope, in closed form.

The drum's inertia over its radius squared is I [kg], the load's mass m; both move as one where the rope is
stiff. Stretch shows by its strain, 2.5e-6 here, and by the damped oscillation that each ramp starts.
"""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

from gantline._core import Simulation
from mechanics import Floats, G, Run, body, document, drum, end, finished, flow, rope, slider

MASS, INERTIA, EA = 1e4, 500.0, 4e10
WEIGHT = MASS * G
STRAIN = WEIGHT / EA


def winch(ramps: list[tuple[float, float, float]], duration: float, **motor: Any) -> Run:
    """A load under a drum; `ramps` are (start [s], duration [s], velocity [m/s], down positive)."""
    system = document(
        [
            body("load", slider(), MASS, position=(0, 0, -30)),
            flow("drum", INERTIA, drive="winch", **motor),
        ],
        ropes=[rope("fall", 30.0 * (1.0 - STRAIN), [drum(None, (0, 0, 0), "drum"), end("load")], EA, 0.02)],
        drives=[
            {
                "name": "winch",
                "ramps": [{"at": at, "duration": lasts, "velocity": v} for at, lasts, v in ramps],
            }
        ],
    )
    settings = {
        "integrator": {"type": "adaptive", "tension_tolerance": 1.0, "position_tolerance": 1e-7},
        "duration": duration,
        "sample_interval": 0.01,
    }
    run = Simulation(json.dumps(system), json.dumps(settings))
    result = finished(run, run.run())
    assert result.energy_remainder < 1e-10
    return result


def speed(run: Run) -> Floats:
    """Of the load, downwards [m/s]."""
    return -run.body("load", "body_velocity")[:, 2]


def slipping(run: Run) -> list[tuple[float, str]]:
    """When the drum stopped following its drive, and when it did again."""
    kinds = ("drum_slips", "drum_holds")
    return sorted((time, kind) for kind in kinds for time, name in run.events(kind) if name == "drum")


def slope(run: Run, start: float, stop: float) -> float:
    within = (run.time > start) & (run.time < stop)
    return float(np.polyfit(run.time[within], speed(run)[within], 1)[0])


def test_a_motor_that_is_strong_enough_follows_its_drive() -> None:
    """Way of a plan with two ramps, 0.5 m/s (1 + 7 + 0.5) s, and tensions of a drive without limit."""
    # Two ramps of 2 s and 1 s and 7 s between them: 0.5 m/s (1 + 7 + 0.5) s.
    ramps = [(1.0, 2.0, -0.5), (10.0, 1.0, 0.0)]
    strong = winch(ramps, 14.0, capacity=1.2 * WEIGHT)
    assert strong.joint("drum")[-1] == pytest.approx(-4.25, abs=1e-12)
    # It is the drive that prescribes its motion, to the rounding of positions.
    prescribed = winch(ramps, 14.0)
    assert np.abs(strong.tension("fall") - prescribed.tension("fall")).max() < 1e-6 * WEIGHT
    # Rope that pays out at the strain with which it was wound does not slip on the drum.
    assert abs(strong.energy("friction")[-1]) < 1e-9
    assert slipping(strong) == []


def test_a_motor_that_is_too_weak_lets_the_load_down() -> None:
    """Acceleration (m g − F)/(m + I), tension m (g − a), heat of the brake F s."""
    force = 0.5 * WEIGHT
    run = winch([], 3.0, capacity=force)
    # (m + I) a = m g − F; the rope carries m (g − a).
    expected = (WEIGHT - force) / (MASS + INERTIA)
    assert slope(run, 0.5, 3.0) == pytest.approx(expected, rel=5e-6)
    assert run.tension("fall")[-1] == pytest.approx(MASS * (G - expected), rel=5e-6)
    # What the brake takes is its force times its way. The rope on the drum had been wound under the weight,
    # and comes off under less: it slips on the drum and loses EA (ε − ε_d)²/2 per length, here 5e-7 of it.
    way = run.joint("drum")[-1]
    slipped = (WEIGHT - MASS * (G - expected)) ** 2 / (2 * EA) * way
    # While it rings, in the first 1 % of the way, it slips a little more.
    assert run.energy("friction")[-1] == pytest.approx(force * way + slipped, abs=0.01 * slipped)


def test_a_motor_at_its_limit_needs_its_time_to_come_to_speed() -> None:
    """Acceleration (F − m g)/(m + I), and the time at which it meets its drive."""
    force = 1.05 * WEIGHT
    run = winch([(1.0, 0.1, -1.0)], 8.0, capacity=force)
    expected = (force - WEIGHT) / (MASS + INERTIA)
    assert slope(run, 1.3, 2.5) == pytest.approx(-expected, rel=1e-4)
    # In 0.1 s of the ramp the drive runs away; the flow meets its speed after v/a.
    at_speed = run.time[speed(run) < -1.0 + 1e-6][0]
    assert at_speed == pytest.approx(1.0 + 1.0 / expected, abs=0.03)
    # It slips as soon as the ramp asks for more, and that is told, till then.
    (begin, first), (end, last) = slipping(run)[:1] + slipping(run)[-1:]
    assert (first, last) == ("drum_slips", "drum_holds")
    assert 1.0 <= begin < 1.1
    # The rope rings with millimetres a second about that: 3e-7 s were found.
    assert end == pytest.approx(1.0 + 1.0 / expected, abs=1e-5)
    # Rope winds up as it is, stretched: the load goes as fast as the rim. Ringing has 2e-9 m/s left.
    assert speed(run)[-1] == pytest.approx(-1.0, abs=5e-9)


def test_power_limits_the_speed_of_hoisting() -> None:
    """Speed P/(m g) going up, the drive's own going down."""
    run = winch([(1.0, 2.0, -1.0)], 12.0, capacity=2.0 * WEIGHT, power=0.5 * WEIGHT)
    # P = m g v.
    assert speed(run)[-1] == pytest.approx(-0.5, rel=5e-6)
    assert slipping(run)[-1][1] == "drum_slips"
    # Lowering takes no power of the motor.
    lowered = winch([(1.0, 2.0, 1.0)], 6.0, capacity=2.0 * WEIGHT, power=0.5 * WEIGHT)
    assert speed(lowered)[-1] == pytest.approx(1.0, abs=1e-9)


def test_constant_tension() -> None:
    """A winch that hauls with less than the weight: tension of a load that falls with (m g − F)/(m + I)."""
    force = 0.3 * WEIGHT
    run = winch([(0.0, 0.01, -2.0)], 2.0, capacity=force)
    accelerated = MASS * (G - (WEIGHT - force) / (MASS + INERTIA))
    assert run.tension("fall")[-1] == pytest.approx(accelerated, rel=1e-5)


def test_an_emergency_stop_slips_until_the_load_rests() -> None:
    """Way of slipping to rest, v² (m + I)/2(F − m g)."""
    force = 1.3 * WEIGHT
    run = winch([(1.0, 1.0, 1.0), (4.0, 0.001, 0.0)], 8.0, capacity=force)
    # 0.5 m in the ramp, 2 m at speed, then v²/2a with (m + I) a = F − m g.
    expected = 0.5 + 2.0 + 0.5 * (MASS + INERTIA) / (force - WEIGHT)
    assert run.joint("drum")[-1] == pytest.approx(expected, abs=1e-3)
    assert run.peak("fall") < 1.31 * WEIGHT
