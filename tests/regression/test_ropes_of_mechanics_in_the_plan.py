"""The plan on the first page left out ropes of `mechanics` that carry the load beside its slings.

A module on two slings and two chain hoists hung on two slings at one end there, and on four in the side view.
Falls are left out of the plan, since they would cover where slings are.
"""

from __future__ import annotations

import gantline
from gantline.report.sketch import sketches
from gantline.report.subject import Subject

LIFT = """
format: 1
lift: {title: A module on two slings and two chain hoists}
duration: 6 s
ground: {friction: 0.5}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, minimum_breaking_force: 1000 kN}
load:
  name: module
  shape: {box: [6 m, 4 m, 2 m]}
  position: [0 m, 0 m, 0.5 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs:
    B: {at: [2 m, 1.5 m, 2 m], capacity: 40 t}
    D: {at: [2 m, -1.5 m, 2 m], capacity: 40 t}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 10 m]
    rated_capacity: 60 t
    hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}
sling_defaults: {rope: sling}
slings:
  B: {from: hook, to: module.B, length: 7.9 m}
  D: {from: hook, to: module.D, length: 7.9 m}
mechanics:
  ropes:
    A:
      rope: sling
      length: 7.9 m
      route: [{type: end, body: hook}, {type: end, body: module, at: [-2 m, 1.5 m, 1 m]}]
    C:
      rope: sling
      length: 7.9 m
      route: [{type: end, body: hook}, {type: end, body: module, at: [-2 m, -1.5 m, 1 m]}]
plan:
  - {step: hang, hold: until_end}
"""


def test_both_views_have_all_four() -> None:
    found = sketches(Subject(gantline.simulate(gantline.parse_scenario(LIFT))))
    assert [one.title.split()[0] for one in found] == ["side", "plan"]
    for view in found:
        kinds = [mark.style for mark in view.marks if mark.style in ("sk-sling", "sk-rope")]
        assert sorted(kinds) == ["sk-rope", "sk-rope", "sk-sling", "sk-sling"], view.title
