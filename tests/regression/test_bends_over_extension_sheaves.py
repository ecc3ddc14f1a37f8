"""A lift whose only rope over a sheave is a sling over an extension sheave was told by
`rope_load_of_breaking_force` that "a guide of 'type: sheave' has a diameter, luffing tackles a
'sheave_diameter'": a sling has no guides.
"""

from __future__ import annotations

from gantline import Statics
from gantline.checks import check_recording
from gantline.scenario import parse_scenario

LIFT = """
format: 1
lift: {title: A beam on an extension sheave}
duration: 10 s
ground: {level: 0 m}
ropes: {sling: {construction: 6x36 IWRC, diameter: 40 mm, grade: 1770}}
load:
  name: box
  weight: {calculated: 20 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  shape: {box: [8 m, 3 m, 3 m]}
  position: [0 m, 0 m, 1 m]
  lugs: {L1: {at: [-3 m, 0 m, 3 m]}, L2: {at: [3 m, 0 m, 3 m]}}
sling_defaults: {rope: sling}
extension_sheaves: {X1: {mass: 200 kg}}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 13.2 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
slings:
  S0: {from: hook, to: X1, length: 2 m}
  S1: {over: X1, to: [box.L1, box.L2], length: 16 m}
plan: [{step: hold, hold: until_end}]
rules: {preset: nd_0027_onshore, termination_factor: 1.12}
"""


def test_a_sling_is_not_told_of_guides() -> None:
    recording = Statics(parse_scenario(LIFT)).equilibrium().recording
    said = next(one for one in check_recording(recording) if one.name == "rope_load_of_breaking_force").remark
    assert "bends about an extension sheave" in said
    assert "type: sheave" not in said
