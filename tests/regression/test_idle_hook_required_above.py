"""`require: {hook_load: above ...}` counted hooks in which nothing hangs, and failed by their 0 kN."""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: One hook of two}
duration: 6 s
ropes: {sling: {axial_stiffness: 50 MN, damping_time: 10 ms, mass: none}}
load:
  name: box
  shape: {box: [4 m, 2 m, 2 m]}
  position: [0 m, 0 m, 2 m]
  weight: {calculated: 10 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {L1: {at: [0 m, 0 m, 2 m]}, L2: {at: [1 m, 0 m, 2 m]}}
cranes:
  main: {type: fixed_hook, at: [0 m, 0 m, 8 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
  spare: {type: fixed_hook, at: [9 m, 0 m, 8 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
sling_defaults: {rope: sling}
slings:
  S1: {from: main, to: box.L1, length: 4 m}
plan:
  - {step: hold, hold: 5 s, require: {hook_load: above BOUND kN}}
  - {step: end, hold: until_end}
"""
#: Of a second hook whose sling is on, and slack.
SLACK = "  S2: {from: spare, to: box.L2, length: 13 m}\nplan:"


def required(bound: float, text: str = LIFT) -> Check:
    recording = gantline.simulate(parse_scenario(text.replace("BOUND", repr(bound))))
    [check] = [one for one in check_recording(recording) if one.step == "hold"]
    return check


@pytest.mark.parametrize(("bound", "verdict"), [(97.0, Verdict.OK), (99.0, Verdict.FAILED)])
def test_an_idle_hook_does_not_count(bound: float, verdict: Verdict) -> None:
    """10 t are 98.07 kN at the hook that bears them; that the other carries nothing is no matter."""
    check = required(bound)
    assert (check.element, check.verdict) == ("main", verdict)
    assert check.value == pytest.approx(98.07e3, rel=1e-3)


def test_a_hook_whose_sling_is_slack_counts() -> None:
    check = required(97.0, LIFT.replace("plan:", SLACK))
    assert (check.element, check.verdict) == ("spare", Verdict.FAILED)
