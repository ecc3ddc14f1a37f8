"""A hook that begins below z = 0 was refused: "'-2.5 m' is negative; this length has to be above zero".

The floor of a dry dock lies below the rails, and a template in the sea hangs from a hook block that is under
water. Steps took such heights, `to: -1 m`, and so did `at` of a fixed hook; `height` of hooks of trolleys and
booms did not, and neither 0 m.
"""

from __future__ import annotations

import pytest

from gantline.results import series
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics

G = 9.81

LIFT = """
format: 1
lift: {title: A section of 60 t comes off the floor of a dry dock}
duration: 90 s
ground: {level: 0 m, friction: 0.4}
structures: {dock: {type: dock, x: [10 m, 60 m], y: [-40 m, 40 m], floor: -15 m}}
ropes:
  sling: {axial_stiffness: 150 MN, damping_time: 20 ms, mass: none}
  hoist: {axial_stiffness: 60 MN, damping_time: 20 ms, mass: none}
load:
  name: section
  shape: {box: [8 m, 6 m, 3 m]}
  position: [30 m, 0 m, -14 m]
  weight: {calculated: 60 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  stands_on: stools
  lugs:
    A: {at: [ 3 m,  2 m, 3 m]}
    B: {at: [ 3 m, -2 m, 3 m]}
    C: {at: [-3 m,  2 m, 3 m]}
    D: {at: [-3 m, -2 m, 3 m]}
supports:
  stools: {under: section, grid: {x: [-3 m, 3 m], y: [-2 m, 2 m]}, foot: -15 m, height: 1 m,
           stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.4}
cranes:
  crane:
    type: floating_crane
    position: [0 m, 0 m, 0 m]
    boom: {heel_pins: {at: [0 m, 0 m, 5 m], apart: 6 m}, length: 60 m, angle: 60 deg, mass: 60 t,
           centre_of_gravity: 45 %}
    hooks:
      H:
        height: -2.95 m
        block: {mass: 4 t, height: 2 m}
        reeving: {ropes: 1, parts_each: 6, rope: hoist, sheave_diameter: 0.8 m, below_head: 1 m,
                  sheave_block_mass: 2 t}
        drum: {diameter: 1 m, layers: 1, wraps_at_start: 20}
        hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}
sling_defaults: {rope: sling, length: 8.9 m}
slings:
  A: {from: crane.H, to: section.A}
  B: {from: crane.H, to: section.B}
  C: {from: crane.H, to: section.C}
  D: {from: crane.H, to: section.D}
plan:
  - {step: lift off, hoist: H, speed: 2 m/min, until: {supports: clear}}
  - {step: up, hoist: H, speed: 6 m/min, to: -1 m}
  - {step: hold, hold: until_end}
"""


@pytest.fixture(scope="module")
def lift() -> Scenario:
    return parse_scenario(LIFT)


def test_the_section_hangs_in_the_dock_with_its_weight(lift: Scenario) -> None:
    """60 t in the hook; -1 m of its step less W L/(6 EA) = 90 mm of 55 m of falls, to 1 cm."""
    recording = simulate(lift)
    assert series.static_value(recording, recording.column("hook_load", "crane.H")) == pytest.approx(
        60e3 * G, rel=1e-4
    )
    assert recording.column("hook_height", "crane.H")[-1] == pytest.approx(-1.09, abs=0.01)


def test_a_hook_may_begin_at_zero(lift: Scenario) -> None:
    higher = {"cranes.crane.hooks.H.height": "0 m", "sling_defaults.length": "12 m", "plan.2.to": "5 m"}
    assert Statics(lift.changed(higher)).equilibrium(0.0).recording.column("hook_height", "crane.H")[
        -1
    ] == pytest.approx(0.0, abs=0.05)
