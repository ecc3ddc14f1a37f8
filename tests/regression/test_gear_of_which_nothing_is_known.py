"""A lift of whose gear no strength is known was a GO.

60 t on three slings without a breaking force, below lugs and a hook without a capacity, were GO WITH
WARNINGS, "6 not checked": the one thing that was held against anything was that the slings pull their hook
aside. With `load_tilt: 5 deg` and plumb slings it was a GO. It is NO VERDICT now, until the first strength is
known.
"""

from __future__ import annotations

import pytest

from gantline.checks import LIMITS, Outcome, check_recording, outcome_of, verdict_of
from gantline.checks.check import _STRENGTHS
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from lift_text import changed

_LIFT = """\
format: 1
lift: {title: Nothing is known}
duration: 40 s
ground: {level: 0 m}
ropes:
  steel: {axial_stiffness: 30 MN, damping_time: 10 ms, mass: none}
load:
  name: box
  shape: {box: [6 m, 4 m, 3 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 60 t, contingency: 1.05}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  stands_on: ground
  lugs:
    A: {at: [ 2 m,  1.5 m, 3 m]}
    B: {at: [ 2 m, -1.5 m, 3 m]}
    C: {at: [-2 m,  0 m, 3 m]}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 11 m], hoist: {speed: 6 m/min, acceleration: 0.2 m/s^2}}
slings:
  SA: {from: hook, to: box.A, length: 8.4 m, rope: steel}
  SB: {from: hook, to: box.B, length: 8.4 m, rope: steel}
  SC: {from: hook, to: box.C, length: 8.3 m, rope: steel}
plan:
  - {step: hoist, hoist: hook, speed: 3 m/min, by: 1.2 m}
  - {step: hold, hold: 10 s}
"""
_SAID = "NO VERDICT: no force has been held against what bears it: capacities of hooks and lugs, "


@pytest.mark.parametrize("limits", ["", "limits: {load_tilt: 5 deg}\n"])
def test_without_any_strength_there_is_no_verdict(limits: str) -> None:
    """A limit of tilt does not make it one; of a run, and at rest."""
    lift = parse_scenario(_LIFT + limits, "lift.yaml")
    for recording in (simulate(lift), Statics(lift).equilibrium().recording):
        checks = check_recording(recording)
        assert outcome_of(checks) is Outcome.NO_VERDICT
        # At rest, without a limit, nothing at all was checked.
        assert verdict_of(checks).startswith((_SAID, "NO VERDICT: nothing has been checked"))


@pytest.mark.parametrize(
    ("known", "unknown"),
    [
        ("type: fixed_hook, rated_capacity: 100 t", "type: fixed_hook"),
        ("A: {at: [ 2 m,  1.5 m, 3 m], capacity: 60 t}", "A: {at: [ 2 m,  1.5 m, 3 m]}"),
        ("mass: none, diameter: 36 mm, minimum_breaking_force: 1500 kN", "mass: none"),
    ],
)
def test_the_first_strength_that_is_known_counts(known: str, unknown: str) -> None:
    """What is not known of the rest is told, as ever."""
    checks = check_recording(simulate(parse_scenario(changed(_LIFT, (unknown, known)), "lift.yaml")))
    assert outcome_of(checks) is Outcome.GO_WITH_WARNINGS


def test_strengths_are_checks_that_there_are() -> None:
    """One that is renamed would count for nothing, and its lifts have no verdict."""
    assert set(LIMITS) >= _STRENGTHS
