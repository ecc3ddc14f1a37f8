"""A fixed hook without a hook block was lowered into its own load without a word.

Nothing is drawn of such a hook, so that nothing was held against the load: only hook blocks were. Its top is
at 2 m; the hook, at 6 m plus what lifting off takes, goes down by as much as the step says.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: A hook in its load}
duration: 40 s
ground: {level: 0 m, friction: 0.5}
ropes: {sling: {axial_stiffness: 50 MN, damping_time: 10 ms, minimum_breaking_force: 900 kN}}
load:
  name: box
  shape: {box: [4 m, 2 m, 2 m]}
  weight: {calculated: 10 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs:
    L1: {at: [1 m, 0 m, 2 m], capacity: 20 t, main_plate: xz}
    L2: {at: [-1 m, 0 m, 2 m], capacity: 20 t, main_plate: xz}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 6 m], rated_capacity: 20 t,
    hoist: {speed: 12 m/min, acceleration: 0.1 m/s^2}}
sling_defaults: {rope: sling}
slings:
  S1: {from: hook, to: box.L1, length: 4.2 m}
  S2: {from: hook, to: box.L2, length: 4.2 m}
plan:
  - {step: lift off, hoist: hook, speed: 3 m/min, until: {supports: clear}}
  - {step: hold, hold: 6 s}
  - {step: down, lower: hook, speed: 12 m/min, by: BY m}
  - {step: rest, hold: until_end}
limits: {rule: yard, load_tilt: 5 deg}
"""
#: Top of the load, and what the hook reaches below its bearing [m].
TOP, REACH = 2.0, 0.1


def lowered(by: float) -> tuple[float, list[Check]]:
    """How high the hook ends [m], and what the run says of it."""
    recording = gantline.simulate(parse_scenario(LIFT.replace("BY", repr(by))))
    found = [one for one in check_recording(recording) if one.name == "no_overlap"]
    return float(recording.column("body_position", "hook")[-1, 2]), found


@pytest.mark.parametrize("by", [0.5, 3.5, 3.95])
def test_nothing_is_said_of_a_hook_above_it(by: float) -> None:
    height, found = lowered(by)
    assert height - REACH > TOP
    assert found == []


def test_a_hook_that_touches_it_is_a_warning() -> None:
    height, [check] = lowered(4.05)
    assert TOP < height < TOP + REACH
    assert (check.element, check.verdict) == ("box to hook", Verdict.WARNING)


@pytest.mark.parametrize("by", [4.2, 5.0])
def test_a_hook_within_it_fails(by: float) -> None:
    height, [check] = lowered(by)
    assert height < TOP
    assert (check.element, check.verdict) == ("box to hook", Verdict.FAILED)
    assert f"{min(TOP + REACH - height, TOP / 2):.2f} m deep" in check.remark or by == 5.0
