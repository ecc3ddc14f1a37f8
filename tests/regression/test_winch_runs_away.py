"""A winch of `mechanics` that is too weak for what hangs on it.

A motor of 10 kN under a pull of 50 kN let the load fall for 20 s; 1646 m of rope ran off, and neither
table nor exit code said a word: hoists of hooks were looked at, and no other drum.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: a winch with one part of rope}
duration: 12 s
ropes:
  hoist: {axial_stiffness: 36 MN, damping_time: 20 ms}
mechanics:
  bodies:
    load: {at: [0 m, 0 m, 2 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 10 t}
  drums:
    winch:
      diameter: 0.8 m
      rotating_mass: 2 t
      drive: {speed: 30 m/min, acceleration: 0.2 m/s^2, capacity: 150 kN, brake: 110 kN}
  ropes:
    fall:
      {rope: hoist, length: as_routed, route: [{type: end, body: load},
       {type: end, body: world, at: [0 m, 0 m, 12 m], drum: winch}]}
plan:
  - {step: lower, pay_out: winch, speed: 6 m/min, emergency_stop_at: 10 s}
"""


def told(brake: str) -> list[Check]:
    recording = gantline.simulate(parse_scenario(LIFT.replace("brake: 110 kN", f"brake: {brake}")))
    return [check for check in check_recording(recording) if check.name == "winch_follows"]


def test_a_load_that_runs_away_is_told() -> None:
    """From 0.1 m/s with (m g - F)/(m + I/r2) = (98.1 - 50) kN/12 t = 4.01 m/s2, for 2 s.

    The rope of 11 m comes from 98 kN to 58 kN meanwhile, and rings: 12 mm of its stretch.
    """
    (check,) = told("50 kN")
    assert (check.element, check.verdict) == ("winch", Verdict.WARNING)
    assert check.remark.startswith(
        "from 10 s on, for 2 s, motor or brake pull all they can, and do not hold: "
    )
    run_out = float(check.remark.split("hold: ")[1].split(" m of rope")[0])
    assert run_out == pytest.approx(0.1 * 2.0 + 0.5 * 48.1e3 / 12e3 * 2.0**2, abs=0.024)


def test_a_brake_that_holds_says_nothing() -> None:
    """110 kN stop 0.1 m/s within 0.1 s."""
    assert told("110 kN") == []
