"""Strand jacks whose load was clear before they began hauled in nothing, and no line said so.

A bridge section was to come off a barge: half of it over, look, lift off. By a slip the deck lay 1 m below
it, so that it hung in its bundles at 0 s; both steps were over as they began, and the lift was a go. Of hooks
`plan_moves` tells that.
"""

from __future__ import annotations

import gantline
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario

#: Ropes of 20 m from jacks at 24 m to lugs at 4 m; at 0.5 m nothing is under the section.
LIFT = """
format: 1
lift: {title: A section in two strand jacks}
duration: 120 s
ground: {level: 0 m, stiffness: 200 MN/m, damping: 2 MN s/m, friction: 0.4}
ropes:
  bundle: {axial_stiffness: 200 MN, minimum_breaking_force: 3 MN, mass: none, damping_time: 20 ms}
load:
  name: section
  shape: {box: [20 m, 4 m, 4 m]}
  position: [0 m, 0 m, HEIGHT]
  weight: {calculated: 200 t}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  lugs:
    W: {at: [-8 m, 0 m, 4 m], capacity: 150 t}
    E: {at: [ 8 m, 0 m, 4 m], capacity: 150 t}
mechanics:
  drums:
    w: {diameter: 1 m, rotating_mass: 1 t, drive: {speed: 1 m/min, acceleration: 5 mm/s^2}}
    e: {diameter: 1 m, rotating_mass: 1 t, drive: {speed: 1 m/min, acceleration: 5 mm/s^2}}
  ropes:
    w:
      rope: bundle
      length: as_routed
      route: [{type: end, body: world, at: [-8 m, 0 m, 24 m], drum: w}, {type: end, body: section, lug: W}]
    e:
      rope: bundle
      length: as_routed
      route: [{type: end, body: world, at: [8 m, 0 m, 24 m], drum: e}, {type: end, body: section, lug: E}]
plan:
  - {step: half, haul_in: [w, e], speed: 0.1 m/min, until: {load_transferred: 50 %}}
  - {step: off, haul_in: [w, e], speed: 0.1 m/min, until: {supports: clear}}
  - {step: up, haul_in: [w, e], speed: 0.5 m/min, by: 0.2 m}
  - {step: hold, hold: until_end}
"""


def told(height: str) -> Check | None:
    text = LIFT.replace("HEIGHT", height)
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    return next((one for one in checks if one.name == "plan_moves"), None)


def test_jacks_of_a_load_that_stands_are_not_told() -> None:
    """It comes off by them."""
    assert told("0 m") is None


def test_jacks_of_a_load_that_hangs_are_told_with_how_much_does() -> None:
    """Nothing stands under it: all of it hangs at 0 s."""
    found = told("0.5 m")
    assert found is not None and found.verdict is Verdict.WARNING
    assert found.remark == (
        "what it waits for held as it began, and nothing moved: half, off; "
        "100 % of section hangs before the plan begins"
    )
