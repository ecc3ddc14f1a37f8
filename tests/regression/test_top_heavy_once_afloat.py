"""A boat that was set afloat from slings with a negative GM was a GO: no run pushes it, and slings told no
more.

In its slings it hung stably; afloat, let go, it stood upright on its tip for 200 s. `gantline statics` called
it unstable. Now a run asks statics of loads of which water bears a part, as of those in ropes of `mechanics`.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario

LENGTH, BREADTH, DEPTH, MASS, DENSITY = 20.0, 3.4, 3.0, 90e3, 1025.0
DRAFT = MASS / (DENSITY * LENGTH * BREADTH)
#: Metacentre of a box over its bottom: T/2 + B^2/12 T [m].
METACENTRE = DRAFT / 2 + BREADTH**2 / (12 * DRAFT)


def checked(centre: float, let_go: str = "detach: [sling.F, sling.A]") -> list[Check]:
    """A boat with its centre of gravity so high over its bottom [m] is lowered until its slings are slack."""
    text = f"""\
format: 1
lift: {{title: A boat is set afloat}}
duration: 90 s
water: {{density: {DENSITY} kg/m^3, level: 0 m}}
ropes: {{belt: {{axial_stiffness: 60 MN, damping_time: 20 ms, mass: none}}}}
load:
  name: boat
  shape: {{box: [{LENGTH} m, {BREADTH} m, {DEPTH} m]}}
  position: [0 m, 0 m, -1 m]
  weight: {{calculated: {MASS} kg}}
  centre_of_gravity: {{at: [0 m, 0 m, {centre} m]}}
  in_water:
    displaced_volume: {LENGTH * BREADTH * DEPTH} m^3
    added_mass: [10 t, 40 t, 90 t]
    drag_coefficients: [0.5, 1, 1]
  lugs: {{F: {{at: [7 m, 0 m, 3 m]}}, A: {{at: [-7 m, 0 m, 3 m]}}}}
cranes:
  fore: {{type: fixed_hook, at: [7 m, 0 m, 12 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
  aft: {{type: fixed_hook, at: [-7 m, 0 m, 12 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
slings:
  F: {{from: fore, to: boat.F, length: 10 m, rope: belt}}
  A: {{from: aft, to: boat.A, length: 10 m, rope: belt}}
plan:
  - {{step: lower, lower: [fore, aft], speed: 2 m/min, until: {{slings: slack}}}}
  - {{step: slack, lower: [fore, aft], speed: 2 m/min, by: 0.5 m}}
  - {{step: afloat, hold: until_end, {let_go}}}
"""
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    return [one for one in checks if one.name == "hangs_stably"]


def test_with_a_negative_gm_it_fails() -> None:
    """T = 1.29 m, so that KM = 1.39 m; 0.1 m above that nothing rights it."""
    assert pytest.approx(1.392, abs=1e-3) == METACENTRE
    [check] = checked(METACENTRE + 0.1)
    assert check.verdict is Verdict.FAILED
    assert check.remark.startswith("at rest it is unstable: boat turns about x; any push sets that going")


def test_with_a_positive_gm_nothing_is_said() -> None:
    assert not checked(METACENTRE - 0.1)
