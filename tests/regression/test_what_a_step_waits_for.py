"""A section to be turned until 80° hung at 77.6° below one hook, and 690 m of rope ran off the other.

"The run ends at 2400 s in 'turn'" was all that was said: neither what the step waits for, nor that it had
been as near to that as it ever comes for half an hour.
"""

from __future__ import annotations

import math
import re

import pytest

from gantline.checks import check_recording
from gantline.scenario import Scenario, parse_scenario, template
from gantline.simulation import simulate

LIFT = """
format: 1
lift: {title: A plate is turned by two hooks}
duration: 150 s
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 50 ms, mass: none}
load:
  name: plate
  shape: {box: [10 m, 4 m, 2 m]}
  position: [0 m, 0 m, 10 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs:
    A: {at: [-5 m, 0 m, 2 m]}
    B: {at: [ 5 m, 0 m, 2 m]}
cranes:
  a: {type: fixed_hook, at: [-5 m, 0 m, 20.01 m], hoist: {speed: 12 m/min, acceleration: 0.05 m/s^2}}
  b: {type: fixed_hook, at: [ 5 m, 0 m, 20.01 m], hoist: {speed: 12 m/min, acceleration: 0.05 m/s^2}}
sling_defaults: {rope: sling, length: 8 m}
slings:
  A: {from: a, to: plate.A}
  B: {from: b, to: plate.B}
plan:
  - {step: hang, hold: 10 s}
  - {step: turn, lower: b, speed: 3 m/min, until: {load_tilt: {above: 85 deg}}}
  - {step: end, hold: until_end}
"""


@pytest.fixture(scope="module")
def lift() -> Scenario:
    return parse_scenario(LIFT)


def _said(lift: Scenario) -> str:
    return next(check.remark for check in check_recording(simulate(lift)) if check.name == "plan_finished")


def test_a_tilt_that_is_never_met_is_told_with_what_it_comes_to(lift: Scenario) -> None:
    """Below its lug A alone the plate hangs at 90° - atan(1 m/5 m) = 78.69°, and swings about that."""
    said = _said(lift.changed({"duration": "350 s"}))
    assert said.startswith("the run ends at 350 s in 'turn', which waits for tilt above 85 deg: ")
    now = float(said.split(": ", 1)[1].split(" deg then, ")[0])
    assert now == pytest.approx(90.0 - math.degrees(math.atan(1.0 / 5.0)), abs=1.0)
    assert said.endswith("deg since it began; not begun: end")


def test_a_share_of_the_weight_is_told() -> None:
    """The lift of `gantline new`, ended while its load comes off the ground."""
    said = _said(parse_scenario(template()).changed({"duration": "12 s"}))
    found = re.fullmatch(
        r"the run ends at 12 s in 'lift off', which waits for supports clear: "
        r"(\S+) % then, (\S+) % to (\S+) % since it began; not begun: .*",
        said,
    )
    assert found is not None, said
    now, least, most = map(float, found.groups())
    assert least < now <= most < 100.0


def test_a_step_that_waits_for_nothing_says_nothing_of_that(lift: Scenario) -> None:
    way = {"step": "turn", "lower": "b", "speed": "1 m/min", "by": "4 m"}
    said = _said(lift.changed({"plan.2": way, "duration": "20 s"}))
    assert said == "the run ends at 20 s in 'turn'; not begun: end"
