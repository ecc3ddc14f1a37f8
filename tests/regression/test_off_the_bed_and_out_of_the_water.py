"""A wreck was lifted off the bed and out of the water, and nothing was said of mud and trapped water.

None of them is simulated: the load comes off as off clean rock, and what water it holds as it comes out has
no weight. The pages say that; the lift of a sunken barge was GO WITH WARNINGS for a dynamic factor alone.
"""

from __future__ import annotations

import gantline
from gantline.assembly import assemble

LIFT = """
format: 1
lift: {title: A wreck}
duration: 60 s
water: {level: 0 m, depth: 6 m}
ground: {level: -6 m, friction: 0.4}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, minimum_breaking_force: 3 MN}
  mud: {axial_stiffness: 400 MN, damping_time: 10 ms}
load:
  name: wreck
  shape: {box: [8 m, 4 m, 2 m]}
  position: [0 m, 0 m, -6 m]
  weight: {calculated: 30 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  stands_on: ground
  in_water: {displaced_volume: 4 m^3, added_mass: [10 t, 20 t, 40 t], drag_coefficients: [1, 1, 1]}
  lugs:
    A: {at: [-3 m, 0 m, 2 m], capacity: 40 t}
    B: {at: [3 m, 0 m, 2 m], capacity: 40 t}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 4 m]
    rated_capacity: 60 t
    hoist: {speed: 24 m/min, acceleration: 0.1 m/s^2}
sling_defaults: {rope: sling}
slings:
  A: {from: hook, to: wreck.A, length: 8.6 m}
  B: {from: hook, to: wreck.B, length: 8.6 m}
plan:
  - {step: up, hoist: hook, speed: 12 m/min, by: 8 m}
  - {step: hang, hold: until_end}
"""
MUD = """
mechanics:
  ropes:
    mud:
      rope: mud
      length: as_routed
      breaks_at: 200 kN
      comes_free: true
      route: [{type: end, body: world, at: [0 m, 0 m, -8 m]}, {type: end, body: wreck, at: [0 m, 0 m, -1 m]}]
"""


def doubts(lift: str) -> list[str]:
    return [one for one in assemble(gantline.parse_scenario(lift)).warnings if "bed under water" in one]


def test_what_holds_a_load_on_the_bed_is_asked_for() -> None:
    [doubt] = doubts(LIFT)
    assert "wreck comes off a bed under water, and no mud or suction holds it there" in doubt
    assert "'breaks_at'" in doubt
    assert doubts(LIFT + MUD) == []
    assert doubts(LIFT.replace("level: 0 m, depth: 6 m", "level: -7 m")) == []
    assert (
        doubts(LIFT.replace("hoist: hook, speed: 12 m/min, by: 8 m", "lower: hook, speed: 12 m/min, by: 1 m"))
        == []
    )


def test_what_is_said_to_stand_for_it_does() -> None:
    """The hook has the rope's 200 kN and what the load weighs in water, 30 t less 4 m3, as that breaks."""
    recording = gantline.simulate(gantline.parse_scenario(LIFT + MUD))
    [(broken, _, _)] = [one for one in recording.events() if one[1] == "broken"]
    peak = float(recording.column("hook_load", "hook").max())
    wet = (30e3 - 4.0 * 1025.0) * 9.81
    assert broken < 20.0
    assert 200e3 + wet < peak < 1.1 * (200e3 + wet)


def warnings(lift: str) -> list[str]:
    told = gantline.simulate(gantline.parse_scenario(lift)).attributes["warnings"]
    return [one for one in told if "out of the water" in one]


def test_water_that_comes_out_with_a_load_is_told() -> None:
    [told] = warnings(LIFT)
    assert "after it was wholly wet: what water is held in it then, and runs off, has no weight here" in told
    assert warnings(LIFT.replace("by: 8 m", "by: 5 m")) == []
