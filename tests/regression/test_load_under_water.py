"""A load that was lowered through the surface as if there were no water.

Hulls of vessels and of bodies of `mechanics` displace water, a load has no hull: a module that would float
went down to the sea bed with all of its weight in the hook, without a word.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: a module is lowered beside a barge}
duration: 60 s
ground: {level: -30 m}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 10 ms}
load:
  name: module
  shape: {box: [4 m, 4 m, 3 m]}
  position: [60 m, 0 m, 2 m]
  weight: {calculated: 20 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  lugs:
    A: {at: [0 m, 0 m, 3 m]}
vessels:
  barge:
    draft: 2 m
    hull: {box: [40 m, 12 m, 4 m]}
    masses:
      hull: {mass: 984 t, at: [20 m, 0 m, 2 m]}
    radii_of_gyration: [4 m, 11 m, 11 m]
cranes:
  hook: {type: fixed_hook, at: [60 m, 0 m, 10 m], hoist: {speed: 12 m/min, acceleration: 0.1 m/s^2}}
slings:
  A: {from: hook, to: module.A, length: 5 m, rope: sling}
plan:
  - {step: lower, lower: hook, speed: 12 m/min, by: LOWERED}
  - {step: hold, hold: until_end}
"""


@pytest.mark.parametrize(("lowered", "is_told"), [("3 m", False), ("6 m", True)])
def test_it_is_told_once_its_centre_of_gravity_is_under(lowered: str, is_told: bool) -> None:
    recording = gantline.simulate(parse_scenario(LIFT.replace("LOWERED", lowered)))
    told = [one for one in recording.attributes["warnings"] if "module is under water" in one]
    assert bool(told) is is_told
    if is_told:
        # From 3.5 m above the water, less what the sling stretches: 0.2 m/s, reached in 2 s, so 1 s later
        # than at once. Told is the first sample after it.
        stretched = 20e3 * 9.81 * 5.0 / 100e6
        exact = (3.5 - stretched) / 0.2 + 1.0
        when = float(told[0].split(" at ")[1].split(" s")[0])
        assert exact <= when <= exact + float(recording.time[1])
