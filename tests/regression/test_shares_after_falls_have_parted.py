"""Shares of hooks after the hoist rope of one of them has parted.

Its hook block hangs from its slings then, on the load, and its hook load is below zero. Hold points shared
that out: of a girder in two hooks, of which one lost its falls, the table and the first page of the report
said that these carried -14 and 114 % of it.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.checks.readings import hold_points, hook_readings

HOOK = (
    "{type: fixed_hook, at: [AT m, 0 m, 5 m], rated_capacity: 20 t, block: {mass: 1 t, height: 1 m}, "
    "reeving: {ropes: 1, parts_each: 4, rope: fall, sheave_diameter: 0.5 m, upper_sheaves_at: 20 m}, "
    "drum: {diameter: 0.8 m}, hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}"
)
LIFT = f"""\
format: 1
lift: {{title: Falls that part}}
duration: 40 s
ground: {{level: 0 m, friction: 0.4, stiffness: 20 MN/m, damping: 1 MN s/m}}
ropes:
  sling: {{axial_stiffness: 20 MN, damping_time: 50 ms, mass: none}}
  fall: {{axial_stiffness: 10 MN, damping_time: 50 ms, mass: none, diameter: 24 mm}}
load:
  name: girder
  shape: {{box: [12 m, 2 m, 2 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 20 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  stands_on: ground
  lugs: {{w: {{at: [-5 m, 0 m, 2 m]}}, e: {{at: [5 m, 0 m, 2 m]}}}}
cranes:
  west: {HOOK.replace("AT", "-5")}
  east: {HOOK.replace("AT", "5")}
slings:
  w: {{from: west, to: girder.w, length: 3.02 m, rope: sling}}
  e: {{from: east, to: girder.e, length: 3.02 m, rope: sling}}
plan:
  - {{step: up, hoist: [west, east], speed: 6 m/min, by: 0.3 m}}
  - {{step: both, hold: 5 s}}
  - {{step: one, hold: until_end, cut: hoist.west.1}}
"""


def test_a_hook_without_falls_carries_none_of_it() -> None:
    recording = gantline.simulate(gantline.parse_scenario(LIFT))
    both, one = (
        {reading.name: reading for reading in hook_readings(recording, point.at)}
        for point in hold_points(recording)
    )
    assert [both[name].share for name in ("west", "east")] == pytest.approx([0.5, 0.5], rel=1e-3)
    assert one["west"].hook_load < 0.0
    assert [one[name].share for name in ("west", "east")] == [0.0, 1.0]
    # Recorded as simulated: the hook block is on the load.
    assert float(np.min(recording.column("hook_load", "west"))) < 0.0
