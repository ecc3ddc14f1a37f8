"""A load that the lift file has hanging, and that stands in the equilibrium, got a verdict all the same.

An equilibrium keeps, before its one sample that counts, how the lift file has everything, where no support
is pressed on yet. Whether a load is lifted was asked of both samples: of a pump that hangs at the start and
stands at the end of its plan `gantline statics` said GO WITH WARNINGS, with 0 % transferred, and ended with
0; `gantline cases` was "all sound" of a lift whose slings stay slack. So it was where a motor of 20 kN was to
hold 26 kN at each rope: its hook had run down until the pump stood, and what was left was 86 % of the motor.
It is NO VERDICT now, code 4.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.checks import Outcome, check_recording, outcome_of
from gantline.scenario import parse_scenario
from program import called

LIFT = """\
format: 1
lift: {title: A pump is set down}
duration: 60 s
ground: {level: 0 m, friction: 0.4}
ropes:
  sling: {axial_stiffness: 50 MN, damping_time: 10 ms, mass: none, minimum_breaking_force: 700 kN}
  hoist: {axial_stiffness: 30 MN, damping_time: 10 ms, mass: none, minimum_breaking_force: 400 kN}
load:
  name: pump
  shape: {box: [2 m, 2 m, 2 m]}
  position: [0 m, 0 m, 0.4 m]
  weight: {calculated: 3 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {L1: {at: [0 m, 0 m, 2 m], capacity: 5 t}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 5.4 m]
    rated_capacity: 20 t
    rating_includes_hook_block: true
    block: {mass: 5 t, height: 2 m}
    reeving: {ropes: 1, parts_each: 3, rope: hoist, sheave_diameter: 0.5 m, upper_sheaves_at: 30 m}
    drum: {diameter: 0.6 m, rotating_mass: 1 t}
    hoist: {speed: 12 m/min, acceleration: 0.1 m/s^2, capacity: MOTOR}
slings: {S1: {from: hook, to: pump.L1, length: 3 m, rope: sling}}
plan:
  - {step: look, hold: 10 s}
  - {step: down, lower: hook, by: WAY, speed: 12 m/min}
  - {step: end, hold: until_end}
limits: {rule: yard, load_tilt: 1 deg}
"""


def lift(way: str, motor: str = "60 kN") -> str:
    """The pump, 0.4 m over the ground, let down by a way."""
    return LIFT.replace("WAY", way).replace("MOTOR", motor)


@pytest.mark.parametrize(
    ("way", "outcome"), [("0.1 m", Outcome.GO_WITH_WARNINGS), ("0.6 m", Outcome.NO_VERDICT)]
)
def test_what_stands_at_the_end_has_no_verdict(way: str, outcome: Outcome) -> None:
    statics = gantline.Statics(parse_scenario(lift(way)))
    assert outcome_of(check_recording(statics.equilibrium().recording)) is outcome
    before = statics.equilibrium(time=5.0).recording
    assert outcome_of(check_recording(before)) is Outcome.GO_WITH_WARNINGS


def test_what_a_weak_motor_let_down_has_none(tmp_path: Path) -> None:
    """8 t on three parts are 26.2 kN at each rope, more than the 20 kN of the motor."""
    pull = 8e3 * 9.81 / 3  # N
    assert pull > 20e3
    file = tmp_path / "lift.yaml"
    file.write_text(lift("0.1 m", "20 kN"), encoding="utf-8")
    said = called("statics", file)
    assert said.returncode == 4
    assert "NO VERDICT: 'pump' is not lifted, 0 % of its weight hangs at most" in said.stdout
