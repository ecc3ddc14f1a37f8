"""A plan that slews before it lifts off, as steps in the wrong order do.

Without its step `until: {supports: clear}` a crane slewed by 90° with 2 % of a pump skid in its slings. The
lift file was in order; the run failed four checks, none of which said that the skid stood on its trailer.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario

_LIFT = """
format: 1
lift: {{title: A load under a trolley}}
duration: 200 s
ground: {{level: 0 m, friction: 0.4}}
ropes:
  sling: {{axial_stiffness: 60 MN, damping_time: 10 ms}}
  hoist: {{axial_stiffness: 80 MN, damping_time: 10 ms, mass: none, diameter: 42 mm}}
load:
  name: skid
  shape: {{box: [6 m, 4 m, 3 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 40 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs: {{A: {{at: [-2.5 m, 0 m, 3 m]}}, B: {{at: [2.5 m, 0 m, 3 m]}}}}
cranes:
  gol:
    type: goliath
    rated_capacity: 150 t
    rating_includes_hook_block: true
    span: 60 m
    girder: {{underside: 40 m, mass: 600 t}}
    legs: {{fixed: 200 t, hinged: 150 t, bogies: 200 t}}
    trolleys:
      one:
        mass: 50 t
        position: 0 m
        traverse: {{speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-25 m, 25 m]}}
        hooks:
          H:
            rated_capacity: 100 t
            height: 11 m
            highest: 36 m
            block: {{mass: 4 t, height: 2 m}}
            reeving: {{parts_each: 8, rope: hoist, sheave_diameter: 1 m, upper_sheaves_at: 42 m}}
            drum: {{diameter: 1.2 m}}
            hoist: {{speed: 10 m/min, acceleration: 0.05 m/s^2}}
slings:
  A: {{from: H, to: skid.A, length: 8.4 m, rope: sling}}
  B: {{from: H, to: skid.B, length: 8.4 m, rope: sling}}
plan:
{plan}
"""
SLACK = "{step: slack, hoist: H, speed: 1 m/min, until: {load_transferred: 2 %}}"
OFF = "{step: off, hoist: H, speed: 1 m/min, until: {supports: clear}}"
AWAY = "{step: away, traverse: one, speed: 20 m/min, by: 10 m}"
DOWN = "{step: down, lower: H, speed: 1 m/min, until: {load_transferred: 2 %}}"
LOOSE = "{step: loose, hold: 30 s, detach: [sling.A, sling.B]}"


def _told(*plan: str) -> list[tuple[str, str]]:
    lines = "\n".join(f"  - {step}" for step in (*plan, "{step: end, hold: until_end}"))
    doubts = assemble(parse_scenario(_LIFT.format(plan=lines))).doubts
    return [(one.path, one.sentence) for one in doubts if "drags" in one.sentence]


@pytest.mark.parametrize("before", [(), (SLACK,), (SLACK, OFF, DOWN)])
def test_a_load_that_stands_is_dragged(before: tuple[str, ...]) -> None:
    """Before anything is hoisted, with a part of it in the slings, and once it has been set down."""
    sentence = (
        "step 'away' takes gol.H away with slings on while skid stands, and drags it along: "
        "lift it off before, 'until: {supports: clear}', or take its slings off"
    )
    assert _told(*before, AWAY) == [(f"plan[{len(before) + 1}]", sentence)]


@pytest.mark.parametrize(
    "plan",
    [
        (SLACK, OFF, AWAY),
        (SLACK, "{step: up, hoist: H, speed: 1 m/min, by: 1 m}", AWAY),
        (SLACK, OFF, DOWN, LOOSE, AWAY),
        (SLACK, AWAY.replace("10 m}", "0.5 m}"), OFF),
        (SLACK, AWAY.replace("by: 10 m", "until: {falls_out_of_plumb: 0.2 deg}"), OFF),
    ],
)
def test_one_that_hangs_or_is_let_go_is_not(plan: tuple[str, ...]) -> None:
    """Nor is one whose hook is brought over it: by half a metre, or until its falls are plumb."""
    assert _told(*plan) == []
