"""The warning that a hoist's motor or brake pulled all it could and its drum did not follow."""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: a motor for two tonnes}
duration: 60 s
ground: {level: 0 m}
ropes:
  hoist: {axial_stiffness: 36 MN, damping_time: 20 ms}
  sling: {axial_stiffness: 36 MN, damping_time: 10 ms}
load:
  name: LOAD
  shape: {box: [2 m, 2 m, 2 m]}
  weight: {calculated: WEIGHT, contingency: 1.0}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  stands_on: ground
  lugs: {A: {at: [0 m, 0 m, 2 m]}}
cranes:
  crane:
    type: fixed_hook
    at: [0 m, 0 m, 7.99 m]
    block: {mass: 100 kg, height: 1 m}
    reeving: {ropes: 1, parts_each: 2, rope: hoist, sheave_diameter: 0.4 m, upper_sheaves_at: 14 m}
    drum: {diameter: 0.4 m, layers: 1, rotating_mass: 500 kg}
    hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2, capacity: 12 kN}
slings:
  S: {from: crane, to: LOAD.A, length: 6 m, rope: sling}
plan:
  - {step: hoist, hoist: crane, speed: 1 m/min, by: 0.5 m}
  - {step: hold, hold: until_end}
"""


@pytest.mark.parametrize(("weight", "is_too_weak"), [("2 t", False), ("3 t", True)])
def test_a_motor_that_cannot_lift_is_told(weight: str, is_too_weak: bool) -> None:
    """Two parts of 12 kN hold 2.45 t, hook block and load together."""
    recording = gantline.simulate(parse_scenario(LIFT.replace("WEIGHT", weight)))
    found = [check for check in check_recording(recording) if check.name == "hoist_follows"]
    assert bool(found) is is_too_weak
    for check in found:
        assert check.verdict is Verdict.WARNING
        assert check.remark.endswith("motor or brake pull all they can")


def test_a_hook_that_runs_away_before_the_lift_begins_fails() -> None:
    """A brake in N for kN: the hook block of 100 kg pulls 490 N, and goes down until its sling holds it."""
    weak = LIFT.replace("WEIGHT", "2 t").replace("capacity: 12 kN", "capacity: 12 N, brake: 12 N")
    checks = check_recording(gantline.simulate(parse_scenario(weak)))
    found = next(check for check in checks if check.name == "hoist_follows")
    assert found.verdict is Verdict.FAILED
    assert "and the hook runs away: it begins" in found.remark
    # The sling of 6 m hangs down past the top of the load until it is taut.
    below = float(found.remark.split("begins ")[-1].split(" m below")[0])
    assert below > 5.9
