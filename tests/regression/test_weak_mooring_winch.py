"""A winch of a mooring line that is too weak for what its step of the plan asks for.

`haul: ahead, by: 4 m` came to its end in time and said nothing: its winch of 80 kN had slipped for 22 s
against one of 90 kN astern, and hauled in 1.2 m. Winches of `mechanics` were looked at, and no other.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario

_LIFT = """\
format: 1
lift: {title: A pontoon between two winches}
duration: 40 s
start: as_given
ropes:
  moor: {axial_stiffness: 20 MN, damping_time: 0.1 s}
mechanics:
  bodies:
    pontoon: {at: [0 m, 0 m, 0 m], joint: {type: slider, axis: [1, 0, 0]}, mass: 500 t}
mooring_lines:
  ahead: {vessel: pontoon, type: spring, fairlead: [10 m, 0 m, 0 m], to: [60 m, 0 m, 0 m], rope: moor,
          pretension: 60 kN, winch: {speed: 12 m/min, acceleration: 0.05 m/s^2, CAPACITY}}
  astern: {vessel: pontoon, type: spring, fairlead: [-10 m, 0 m, 0 m], to: [-70 m, 0 m, 0 m], rope: moor,
           pretension: 60 kN, winch: {speed: 12 m/min, acceleration: 0.05 m/s^2}}
plan:
  - {step: haul, haul: ahead, speed: 9 m/min, by: 4 m}
  - {step: hold, hold: until_end}
"""


def told(capacity: str) -> tuple[list[Check], float]:
    """What is said of winches, and how much line the one ahead has hauled in [m]."""
    recording = gantline.simulate(parse_scenario(_LIFT.replace(", CAPACITY", capacity)))
    checks = [check for check in check_recording(recording) if check.name == "winch_follows"]
    return checks, -float(recording.column("joint_position", "mooring.ahead.winch")[-1])


def test_a_winch_that_slips_is_told() -> None:
    """At rest between stiff lines 80 kN haul in (80 − 60) kN (50 + 60) m/20 MN = 0.11 m, and no 4 m.

    The pontoon swings about that on the line astern, k = 20 MN/60 m, after which the winch holds what it has:
    by (F − 60 kN)/k again at most, 0.06 m.
    """
    checks, hauled = told(", capacity: 80 kN")
    assert [(check.element, check.verdict) for check in checks] == [("mooring.ahead.winch", Verdict.WARNING)]
    assert "motor or brake pull all they can" in checks[0].remark
    assert hauled == pytest.approx(0.11, abs=0.06)


def test_one_that_takes_whatever_it_takes_says_nothing() -> None:
    """Without a capacity it hauls in what the plan says."""
    checks, hauled = told("")
    assert checks == []
    assert hauled == pytest.approx(4.0, abs=1e-9)
