"""Chain hoists that pull aslant were rated by the upright part of their pull alone.

A hook of `type: fixed_hook` is the way to say a chain hoist. Two of them at 40 deg from plumb held 20 t with
127 kN, 12.9 t, along each chain; 'hoist_load_of_rated_capacity' compared 98.1 kN with the 12 t of each, 83 %.
That the falls of a crane would lean there is a warning of another check, which a limit of one's own for
the lean of the chains ends.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics

MASS, G, LENGTH = 20e3, 9.81, 5.0


def _lift(lean: float) -> str:
    aside, up = LENGTH * math.sin(math.radians(lean)), LENGTH * math.cos(math.radians(lean))
    hook = "rated_capacity: 12 t, hoist: {speed: 0.5 m/min, acceleration: 0.02 m/s^2}"
    return f"""\
format: 1
lift: {{title: A rudder in two chain hoists}}
duration: 5 s
ropes:
  chain: {{axial_stiffness: 1000 MN, mass: none, minimum_breaking_force: 600 kN}}
load:
  name: rudder
  shape: {{box: [4 m, 2 m, 3 m]}}
  position: [0 m, 0 m, 1 m]
  weight: {{calculated: {MASS / 1e3} t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{W: {{at: [-1 m, 0 m, 3 m]}}, E: {{at: [1 m, 0 m, 3 m]}}}}
cranes:
  W: {{type: fixed_hook, at: [{-1 - aside} m, 0 m, {4 + up} m], {hook}}}
  E: {{type: fixed_hook, at: [{1 + aside} m, 0 m, {4 + up} m], {hook}}}
slings:
  W: {{from: W, to: rudder.W, length: {LENGTH} m, rope: chain}}
  E: {{from: E, to: rudder.E, length: {LENGTH} m, rope: chain}}
plan:
  - {{step: hold, hold: until_end}}
limits: {{rule: yard, falls_out_of_plumb: 60 deg}}
"""


def _rated(lean: float) -> Check:
    rest = Statics(parse_scenario(_lift(lean))).equilibrium()
    (check,) = [one for one in check_recording(rest.recording) if one.name == "hoist_load_of_rated_capacity"]
    return check


def test_the_pull_along_the_chain_is_told() -> None:
    check = _rated(40.0)
    assert check.value == pytest.approx(MASS / 2.0 / 12e3, rel=1e-3)
    assert check.verdict is Verdict.WARNING
    along = 1.0 / math.cos(math.radians(40.0))
    assert "is pulled 40 deg aside" in check.remark
    assert f"it is up to {along:.3g} times as much" in check.remark


def test_a_chain_that_leans_a_little_is_in_order() -> None:
    """At 12 deg it is 2 % more."""
    assert "aside" not in _rated(12.0).remark
