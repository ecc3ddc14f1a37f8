"""Rope that climbs over the flange of a drum was a warning among others.

A crawler crane took a blade up by 60 m with 200 turns on a drum for 240: 319 came on it, `gantline check` had
found the file in order, and the run said so as a warning of no check. A drum whose rope runs off had failed.
"""

from __future__ import annotations

import math

import gantline
from gantline.assembly import assemble
from gantline.checks import Verdict
from of_recording import checks_of

#: Turns of the drum: at the start, in a layer, layers; its diameter [m]; parts of line.
START, TURNS, LAYERS, DIAMETER, PARTS = 30, 20, 2, 0.8, 4
LIFT = f"""\
format: 1
lift: {{title: A drum and its turns}}
duration: 200 s
ground: {{level: 0 m, friction: 0.4}}
ropes:
  sling: {{axial_stiffness: 50 MN, damping_time: 20 ms, mass: none}}
  fall: {{axial_stiffness: 30 MN, damping_time: 20 ms, mass: none, diameter: 24 mm}}
load:
  name: box
  shape: {{box: [2 m, 2 m, 2 m]}}
  position: [0 m, 0 m, 12 m]
  weight: {{calculated: 8 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{top: {{at: [0 m, 0 m, 2 m]}}}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 17 m]
    rated_capacity: 20 t
    block: {{mass: 0.5 t, height: 1 m}}
    reeving: {{ropes: 1, parts_each: {PARTS}, rope: fall, sheave_diameter: 0.5 m, upper_sheaves_at: 40 m}}
    drum: {{diameter: {DIAMETER} m, layers: {LAYERS}, wraps_per_layer: {TURNS}, wraps_at_start: {START},
      spare_turns: 3, layer_step: 0 m}}
    hoist: {{speed: 12 m/min, acceleration: 0.05 m/s^2}}
slings: {{s: {{from: hook, to: box.top, length: 3 m, rope: sling}}}}
plan:
  - {{step: move, WAY, speed: 12 m/min}}
  - {{step: end, hold: until_end}}
"""


def _way(turns: float) -> float:
    """What the hook goes for so many turns of the drum [m]."""
    return turns * math.pi * DIAMETER / PARTS


def _lift(words: str) -> gantline.Scenario:
    return gantline.parse_scenario(LIFT.replace("WAY", words))


def test_more_turns_than_there_is_room_for_fail() -> None:
    scenario = _lift(f"hoist: hook, by: {_way(12):.3f} m")
    [doubt] = [text for text in assemble(scenario).warnings if "its drum" in text]
    assert "step 'move' hoists hook: its drum has 42.0 turns or more then, and room for 40" in doubt
    [check] = checks_of(gantline.simulate(scenario), "turns_on_drum")
    assert check.verdict is Verdict.FAILED
    assert check.remark == "42.0 turns come on it, and its layers take 40: rope climbs over its flange"


def test_a_drum_that_is_just_full_is_in_order() -> None:
    scenario = _lift(f"hoist: hook, by: {_way(9.9):.3f} m")
    assert not [text for text in assemble(scenario).warnings if "its drum" in text]
    assert not checks_of(gantline.simulate(scenario), "turns_on_drum")


def test_too_few_turns_are_told_before_the_run() -> None:
    """30 turns, of which 28 go down: 2 are left, and 3 have to stay."""
    scenario = _lift(f"lower: hook, by: {_way(28):.3f} m")
    [doubt] = [text for text in assemble(scenario).warnings if "its drum" in text]
    assert "step 'move' lowers hook: its drum has 2.0 turns or fewer then, and 3 have to stay" in doubt
