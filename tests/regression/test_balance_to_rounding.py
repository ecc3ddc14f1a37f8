"""Spreaders and extension sheaves were in balance in one place of the world, and in another not held.

The start looks for where they hang until forces balance to 1e-9 of the lightest weight. Places have 16
digits: 80 m up, or 60 km from the origin of a mine's grid, rounding alone makes stiff slings pull by more. A
bar under a trolley was refused where the load headed 180 deg, and hung in balance where it headed 0 deg; two
extension sheaves were refused 60 km east: "no place was found where the extension sheaves hang at rest: they
are not held in balance".
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics


def under_a_trolley(side: int) -> str:
    """A bar that turns across as it hangs, on slings of 20 GN, whose load heads 0 (1) or 180 deg (-1)."""
    return f"""
format: 1
lift: {{title: A bar under a trolley}}
duration: 10 s
ropes:
  hoist: {{axial_stiffness: 20000 MN, damping_time: 10 ms, mass: none, diameter: 42 mm}}
  sling: {{axial_stiffness: 20000 MN, damping_time: 10 ms, mass: none}}
hook_types:
  H:
    block: {{mass: 5 t, height: 2 m}}
    reeving: {{parts_each: 4, rope: hoist, sheave_diameter: 1 m, upper_sheaves_at: 80 m}}
    drum: {{diameter: 1.6 m}}
    hoist: {{speed: 10 m/min, acceleration: 0.05 m/s^2}}
cranes:
  gol:
    type: goliath
    span: 148 m
    girder: {{underside: 78 m, mass: 2600 t}}
    legs: {{fixed: 700 t, hinged: 450 t}}
    trolleys:
      one:
        mass: 100 t
        position: {-9.5 * side} m
        traverse: {{speed: 10 m/min, acceleration: 0.05 m/s^2, range: [-60 m, 60 m]}}
        hooks: {{A: {{type: H, height: 38 m}}}}
      two:
        mass: 100 t
        position: {9.5 * side} m
        traverse: {{speed: 10 m/min, acceleration: 0.05 m/s^2, range: [-60 m, 60 m]}}
        hooks: {{B: {{type: H, height: 38 m}}}}
load:
  name: column
  shape: {{box: [20 m, 3 m, 3 m]}}
  position: [0 m, 0 m, 28.5 m]
  heading: {0 if side > 0 else 180} deg
  weight: {{calculated: 100 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  lugs:
    {{a: {{at: [-9.5 m, 0 m, 1.5 m]}}, b: {{at: [9.5 m, 1.2 m, 1.5 m]}}, c: {{at: [9.5 m, -1.2 m, 1.5 m]}}}}
sling_defaults: {{rope: sling}}
spreaders:
  bar:
    mass: 3 t
    size: [2.8 m, 0.4 m, 0.4 m]
    lugs: {{T1: {{at: [1.2 m, 0 m, 0.2 m]}}, T2: {{at: [-1.2 m, 0 m, 0.2 m]}},
      B1: {{at: [1.2 m, 0 m, -0.2 m]}}, B2: {{at: [-1.2 m, 0 m, -0.2 m]}}}}
slings:
  S1: {{from: gol.A, to: column.a, length: 8 m}}
  T1: {{from: gol.B, to: bar.T1, length: 4 m}}
  T2: {{from: gol.B, to: bar.T2, length: 4 m}}
  S2: {{from: bar.B1, to: column.b, length: 3.784 m}}
  S3: {{from: bar.B2, to: column.c, length: 3.784 m}}
plan: [{{step: hold, hold: until_end}}]
"""


def on_extension_sheaves(east: float, north: float) -> str:
    """A load on two extension sheaves, one below the other, at a place of the world [m]."""
    return f"""
format: 1
lift: {{title: Extension sheaves}}
duration: 60 s
start: as_given
ground: {{level: 0 m}}
ropes: {{sling: {{axial_stiffness: 100 MN, damping_time: 20 ms, mass: none}}}}
load:
  name: box
  shape: {{box: [8 m, 6 m, 3 m]}}
  position: [{east} m, {north} m, 0 m]
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [-1 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs: {{L1: {{at: [-3 m, -2 m, 3 m]}}, L2: {{at: [-3 m, 2 m, 3 m]}}, L3: {{at: [3 m, 0 m, 3 m]}}}}
cranes:
  hook:
    type: fixed_hook
    at: [{east - 1.0} m, {north} m, 25 m]
    hoist: {{speed: 6 m/min, acceleration: 0.02 m/s^2}}
sling_defaults: {{rope: sling}}
extension_sheaves:
  X1: {{mass: 150 kg, pitch_diameter: 0.6 m}}
  X2: {{mass: 150 kg}}
slings:
  S: {{from: hook, to: X1, length: 5.4 m}}
  S1: {{over: X1, to: [X2, box.L3], length: 30 m}}
  S2: {{over: X2, to: [box.L1, box.L2], length: 10 m}}
plan: [{{step: hoist, hoist: hook, speed: 6 m/min, by: 5 m}}, {{step: hold, hold: until_end}}]
"""


def tensions(text: str) -> np.ndarray:
    """Of all ropes at rest at the end [N]."""
    found: np.ndarray = Statics(parse_scenario(text)).equilibrium().recording["rope_tension"].values[-1]
    return found


@pytest.mark.parametrize("side", [1, -1])
def test_a_bar_hangs_whichever_way_its_load_heads(side: int) -> None:
    """Column, half of 100 t, and bar, 3 t: what hangs in each hook, to 1e-9."""
    recording = Statics(parse_scenario(under_a_trolley(side))).equilibrium().recording
    assert recording.column("hook_load", "gol.A")[-1] == pytest.approx(50e3 * 9.81, rel=1e-9)
    assert recording.column("hook_load", "gol.B")[-1] == pytest.approx(53e3 * 9.81, rel=1e-9)


def test_sheaves_hang_far_from_the_origin() -> None:
    """Tensions are those at the origin, but for rounding: 1e-11 m of 70 km, in slings of 19 MN/m."""
    here, there = tensions(on_extension_sheaves(0.0, 0.0)), tensions(on_extension_sheaves(60e3, -70e3))
    assert np.abs(there - here).max() < 0.01
