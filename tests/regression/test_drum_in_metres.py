"""A drum of 60 m, meant as 60 cm, was in order, and no rope ran off it.

A hook on three parts goes down by 7 m, so that 21 m of rope come off a drum with 14 turns: 11.1 turns of
0.6 m, and fewer than the 3 that have to stay are left. Of 60 m it was a ninth of a turn, and the lift a GO
without a warning. So it was with a `layer_step` of 250 mm for rope of 28 mm, by which speed and pull of a
layer are ten times as far from those of the first. Both are told now.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: A pump on three parts}
duration: 60 s
ropes:
  sling: {construction: 6x36 IWRC, grade: 1960, diameter: 32 mm, damping_time: 10 ms}
  hoist: {construction: 6x36 IWRC, grade: 1960, diameter: 28 mm, damping_time: 10 ms}
load:
  name: pump
  shape: {box: [2 m, 2 m, 2 m]}
  position: [0 m, 0 m, 10 m]
  weight: {calculated: 3 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {L1: {at: [0 m, 0 m, 2 m], capacity: 5 t}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 15 m]
    rated_capacity: 20 t
    rating_includes_hook_block: true
    block: {mass: 0.5 t, height: 2 m}
    reeving: {ropes: 1, parts_each: 3, rope: hoist, sheave_diameter: 0.5 m, upper_sheaves_at: 30 m}
    drum: {diameter: 0.6 m, layers: 2, wraps_per_layer: 15, wraps_at_start: 14, layer_step: 25 mm,
      spare_turns: 3, rotating_mass: 1 t}
    hoist: {speed: 12 m/min, acceleration: 0.1 m/s^2}
slings: {S1: {from: hook, to: pump.L1, length: 3 m, rope: sling}}
plan: [{step: down, lower: hook, by: 7 m, speed: 12 m/min}, {step: hold, hold: until_end}]
limits: {rule: yard, load_tilt: 1 deg}
"""
#: Half a turn more, so that 3.4 are left.
IN_ORDER = LIFT.replace("wraps_at_start: 14,", "wraps_at_start: 14.5,")
WINCH = """\
format: 1
lift: {title: A winch with two ropes}
duration: 1 s
ropes: {hoist: {axial_stiffness: 50 MN, diameter: 28 mm, damping_time: 10 ms}}
mechanics:
  bodies:
    left: {at: [-1 m, 0 m, 0 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 1 t}
    right: {at: [1 m, 0 m, 0 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 1 t}
  drums: {winch: {diameter: 0.6 m, rotating_mass: 1 t, brake: 50 kN}}
  ropes:
    one: {rope: hoist, length: as_routed, route: [{type: end, body: left},
      {type: end, body: world, at: [-1 m, 0 m, 9 m], drum: winch}]}
    two: {rope: hoist, length: as_routed, route: [{type: end, body: right},
      {type: end, body: world, at: [1 m, 0 m, 9 m], drum: winch}]}
"""


def warnings_of(text: str) -> list[str]:
    """What assembling a lift file warns of, each behind its path."""
    return [f"{one.path}: {one.sentence}" for one in assemble(parse_scenario(text)).doubts]


def test_a_drum_in_order_is_not_told() -> None:
    assert not warnings_of(IN_ORDER)
    assert not warnings_of(WINCH)


def test_turns_that_a_slip_hid() -> None:
    """21 m of rope on 0.6 m and on 60 m, by hand; the run has them too."""
    way, turns = 3 * 7.0, 14.0
    assert turns - way / (math.pi * 0.6) == pytest.approx(2.859, abs=5e-4)
    recording = gantline.simulate(parse_scenario(LIFT.replace("0.6 m", "60 m")))
    left = float(recording.column("drum_wraps", "hook.drum").min())
    assert left == pytest.approx(turns - way / (math.pi * 60.0), rel=1e-12)
    [told] = warnings_of(LIFT.replace("0.6 m", "60 m"))
    assert "cranes.hook.drum.diameter: the drum of hook has a diameter of 60 m" in told
    assert "2143 times its rope of 28 mm" in told


def test_layers_ten_times_too_thick() -> None:
    [told] = warnings_of(IN_ORDER.replace("layer_step: 25 mm", "layer_step: 250 mm"))
    assert "cranes.hook.drum.layer_step: each layer of the drum of hook adds 250 mm to its radius" in told


def test_a_drum_of_mechanics_is_told_once() -> None:
    [told] = warnings_of(WINCH.replace("0.6 m", "60 m"))
    assert "mechanics.drums.winch.diameter: drum winch has a diameter of 60 m" in told


def test_the_diameter_of_one_rope_is_told_where_it_stands() -> None:
    [told] = warnings_of(
        WINCH.replace("9 m], drum: winch}]}\n    two", "9 m], drum: winch, drum_diameter: 6 m}]}\n    two")
    )
    assert "mechanics.ropes.one.route[2].drum_diameter: drum winch has a diameter of 6 m" in told
