"""A module that stands on a moored barge on its last corners before it is lifted off.

What corners hold follows what presses them, and was followed ever more slowly, by one part in two, three and
so on of each change. Where that takes many rounds they did not come to an end: "its friction and what that
holds find no balance (module.corner_1)", and corner 1 was up in the air. Eight of sixty such lifts had no
equilibrium, and neither had 18 of the 30 cases of a floating crane's lift off a barge.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.scenario import parse_scenario

G, MASS = 9.81, 400.0
LIFT = """\
format: 1
lift: {title: module off a barge}
duration: 400 s
water: {density: 1025 kg/m^3, level: 0 m}
ground: {level: -15 m, friction: 0.4}
ropes:
  sling: {construction: 6x36 IWRC, grade: 1960, diameter: 96 mm}
  line: {construction: 6x36 IWRC, grade: 1960, diameter: 44 mm}
load:
  name: module
  shape: {box: [20 m, 14 m, 10 m]}
  position: [1.2 m, -0.7 m, 2.5 m]
  weight: {calculated: 400 t}
  centre_of_gravity: {at: [-0.87 m, -0.78 m, 4.8 m]}
  lugs:
    A: {at: [ 8 m,  5 m, 10 m]}
    B: {at: [ 8 m, -5 m, 10 m]}
    C: {at: [-8 m,  5 m, 10 m]}
    D: {at: [-8 m, -5 m, 10 m]}
vessels:
  cargo:
    position: [-30 m, 0 m]
    draft: 2 m
    hull: {box: [60 m, 20 m, 4 m]}
    masses: {all: {mass: 2059 t, at: [30 m, 0 m, 2 m]}}
    radii_of_gyration: [6 m, 17 m, 17 m]
mooring_lines:
  1:
    {vessel: cargo, fairlead: [ 0 m,  10 m, 4 m], to: [-120 m,  120 m, -15 m],
     rope: line, pretension: 100 kN, sea_bed: -15 m}
  2:
    {vessel: cargo, fairlead: [ 0 m, -10 m, 4 m], to: [-120 m, -120 m, -15 m],
     rope: line, pretension: 100 kN, sea_bed: -15 m}
  3:
    {vessel: cargo, fairlead: [60 m,  10 m, 4 m], to: [ 120 m,  120 m, -15 m],
     rope: line, pretension: 100 kN, sea_bed: -15 m}
  4:
    {vessel: cargo, fairlead: [60 m, -10 m, 4 m], to: [ 120 m, -120 m, -15 m],
     rope: line, pretension: 100 kN, sea_bed: -15 m}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 32 m], hoist: {speed: 1 m/min, acceleration: 0.01 m/s^2}}
mechanics:
  bodies:
    deck: {parent: cargo, at: [30 m, 0 m, 4.5 m], joint: {type: fixed}, mass: 1 t,
           shape: {box: [24 m, 18 m, 1 m], centre: [0 m, 0 m, -0.5 m]}}
  body_contacts:
    on_deck: {between: [module, deck], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.8}
slings:
  A: {from: hook, to: module.A, length: 22.33 m, rope: sling}
  B: {from: hook, to: module.B, length: 22.34 m, rope: sling}
  C: {from: hook, to: module.C, length: 22.41 m, rope: sling}
  D: {from: hook, to: module.D, length: 21.99 m, rope: sling}
plan:
  - {step: off, hoist: hook, speed: 0.5 m/min, until: {supports: clear}}
  - {step: hold, hold: until_end}
"""


def test_a_module_comes_off_its_last_corners() -> None:
    """Clear of the deck friction holds nothing: both ends are one, and the module hangs in the hook."""
    statics = gantline.Statics(parse_scenario(LIFT))
    held, free = (statics.equilibrium(losses=losses).recording.metrics() for losses in ("held", "none"))
    forces, others = ([one[f"static_sling_tension.sling.{name}"] for name in "ABCD"] for one in (held, free))
    # What searches leave, 1e-9 of the forces, on slings whose lengths decide how they share.
    assert forces == pytest.approx(others, abs=1e-6 * MASS * G * 1e3)
    # 6x36 with steel core, EN 12385-4: 0.409 kg/m for each 100 mm^2 of d^2.
    slings = (22.33 + 22.34 + 22.41 + 21.99) * 0.409 * 96.0**2 / 100.0 / 1e3
    assert held["static_hook_load"] == pytest.approx((MASS + slings) * G * 1e3, rel=1e-4)
    assert held["final_load_transferred"] == 1.0
