"""A winch of a mooring line that is too weak for what its step of the plan asks for.

`haul: ahead, by: 4 m` came to its end in time and said nothing: its winch of 80 kN had slipped for 22 s
against one of 90 kN astern, and hauled in 1.2 m. Winches of `mechanics` were looked at, and no other.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import gantline
from gantline.checks import Check, Verdict
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray
from gantline.scenario import parse_scenario
from of_recording import checks_of

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


#: Mass [kg], stiffness ahead and astern, EA over the unstretched lengths [N/m], damping time [s], forces [N].
_MASS, _TAU, _PRETENSION, _CAPACITY = 500e3, 0.1, 60e3, 80e3
_AHEAD, _ASTERN = (20e6 / length * (1 + _PRETENSION / 20e6) for length in (50.0, 60.0))


def told(capacity: str, **overrides: float) -> tuple[list[Check], Recording]:
    """What is said of winches, and the run."""
    lift = parse_scenario(_LIFT.replace(", CAPACITY", capacity))
    recording = gantline.simulate(lift, on_progress=None, **overrides)
    return checks_of(recording, "winch_follows"), recording


def hauled(recording: Recording) -> FloatArray:
    """How much line the winch ahead has hauled in over time [m]."""
    return -recording.column("joint_position", "mooring.ahead.winch")


def rates(time: float, state: FloatArray) -> list[float]:
    """Of the pontoon's place and speed, and what is hauled in: as asked until the winch pulls all it can."""
    place, speed, taken = state
    asked = min(0.05 * time, 0.15)
    stretched = _PRETENSION + _AHEAD * (taken - place)
    pull = stretched + _AHEAD * _TAU * (asked - speed)
    if pull > _CAPACITY:
        pull, asked = _CAPACITY, speed + (_CAPACITY - stretched) / (_AHEAD * _TAU)
    astern = _PRETENSION + _ASTERN * (place + _TAU * speed)
    return [speed, (pull - astern) / _MASS, asked]


def test_a_winch_that_slips_is_told() -> None:
    """It hauls in 0.16 m at most and no 4 m, as by its own equations while the motor is asked to haul.

    These know no inertia of the winch, 1 kg, nor the tolerance of 10 N: 4e-5 m together, 1e-4 m with 100 N.
    """
    checks, recording = told(", capacity: 80 kN", tension_tolerance=10.0, position_tolerance=1e-7)
    assert [(check.element, check.verdict) for check in checks] == [("mooring.ahead.winch", Verdict.WARNING)]
    assert "motor or brake pull all they can" in checks[0].remark
    slips = recording.time < 28.0
    own = solve_ivp(rates, (0.0, 28.0), np.zeros(3), t_eval=recording.time[slips], rtol=1e-9, max_step=0.02)
    assert hauled(recording)[slips] == pytest.approx(own.y[2], abs=8e-5)
    assert hauled(recording).max() == pytest.approx(0.16, abs=1e-4)


def test_one_that_takes_whatever_it_takes_says_nothing() -> None:
    """Without a capacity it hauls in what the plan says."""
    checks, recording = told("")
    assert checks == []
    assert hauled(recording)[-1] == pytest.approx(4.0, abs=1e-9)
