"""Statics put slings on that were metres too short, and told of a load that they had turned by 30 degrees.

A run ends where a sling is to be put on that does not reach: "it is to be put on here, is 12.000 m long and
5.327 m too short". `gantline statics --steps` of the same lift went on with the sling stretched, so that the
load hung askew on it, and named two steps that ended at one moment. It has no equilibrium from there on now.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.statics import NoEquilibriumError, Statics
from gantline.study import run_steps

LIFT = """
format: 1
lift: {title: A module slung anew}
duration: 200 s
ground: {level: 0 m, friction: 0.4}
ropes:
  sling: {axial_stiffness: 150 MN, damping_time: 50 ms, minimum_breaking_force: 6 MN}
load:
  name: module
  shape: {box: [12 m, 6 m, 4 m]}
  position: [0 m, 0 m, 0 m]
  stands_on: ground
  weight: {calculated: 120 t}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  lugs:
    fore: {at: [3 m, 0 m, 4 m]}
    aft: {at: [-3 m, 0 m, 4 m]}
    outer: {at: [5 m, 0 m, 4 m]}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 11 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
sling_defaults: {rope: sling}
slings:
  fore: {from: hook, to: module.fore, length: 8 m}
  aft: {from: hook, to: module.aft, length: 8 m}
  outer: {from: hook, to: module.outer, length: 7 m}
plan:
  - {step: clear, hoist: hook, speed: 3 m/min, by: 1.5 m}
  - {step: on, hold: 20 s, attach: sling.outer}
  - {step: hang, hold: until_end}
"""
# Two slings of 8 m bear 60 t each over the cosine of sqrt(8^2 - 3^2)/8, 635 kN, and stretch by 4.23e-3 to
# 8.034 m: the hook is sqrt(8.034^2 - 3^2) = 7.453 m over the lugs, the outer one 5 m aside.
SHORT = (7.453**2 + 5.0**2) ** 0.5 - 7.0


def test_it_has_no_equilibrium_once_it_should_be_on() -> None:
    question = Statics(gantline.parse_scenario(LIFT))
    assert question.equilibrium(30.0).recording.column("rope_tension", "sling.fore")[-1] > 500e3
    with pytest.raises(NoEquilibriumError) as refused:
        question.equilibrium(100.0)
    message = str(refused.value)
    assert "sling.outer" in message
    assert "it is to be put on at 30.5" in message
    assert f"{SHORT:.2f}" in message
    names = [
        one.name for one in run_steps(Statics(gantline.parse_scenario(LIFT))) if one.state.rest is not None
    ]
    assert names == ["start", "clear"]


def test_one_that_reaches_is_on() -> None:
    question = Statics(gantline.parse_scenario(LIFT.replace("length: 7 m", "length: 9 m")))
    assert [one.name for one in run_steps(question)] == ["start", "clear", "on", "end of the lift"]
