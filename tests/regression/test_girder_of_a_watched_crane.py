"""A load in the girder of a crane that is watched against it as a whole.

What is watched over the whole lift is judged by its distance, and not by `no_overlap`. A Goliath crane has
distances of its legs alone, and a floating crane of its boom: with `between: [tower, gol]` a tower that went
through a trolley into the girder stood 47 m clear of the crane, and nothing else was told. Hook blocks have
no distances either: one in the load of a crawler crane that was watched was not told.
"""

from __future__ import annotations

import pytest

from crawler_lift import crawler_lift
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics

#: Underside of the girder over the rails, height of the tower [m].
GIRDER, TALL = 80.0, 30.0

_LIFT = """\
format: 1
lift: {{title: A tower between two hooks}}
duration: 1 s
start: as_given
ropes:
  hoist: {{axial_stiffness: 10000 MN, damping_time: 10 ms, mass: none, diameter: 42 mm}}
  sling: {{axial_stiffness: 1000 MN, damping_time: 10 ms, mass: none, diameter: 60 mm}}
load:
  name: tower
  shape: {{box: [6 m, 6 m, 30 m]}}
  position: [-20 m, 0 m, {bottom} m]
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{A: {{at: [0 m, 3.9 m, 3 m]}}, B: {{at: [0 m, -3.9 m, 3 m]}}}}
hook_types:
  H:
    block: {{mass: 12 t, height: 3 m}}
    reeving: {{parts_each: 8, rope: hoist, sheave_diameter: 1 m, upper_sheaves_at: 88 m}}
    drum: {{diameter: 1.6 m}}
    hoist: {{speed: 10 m/min, acceleration: 0.05 m/s^2}}
cranes:
  gol:
    type: goliath
    span: 148 m
    girder: {{underside: 80 m, mass: 2600 t}}
    legs: {{fixed: 700 t, hinged: 450 t}}
    trolleys:
      one:
        mass: 300 t
        position: -20 m
        traverse: {{speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-60 m, 60 m]}}
        hooks:
          P: {{type: H, across: 3.9 m, height: 60 m}}
          S: {{type: H, across: -3.9 m, height: 60 m}}
slings:
  A: {{from: gol.P, to: tower.A, length: {sling} m, rope: sling}}
  B: {{from: gol.S, to: tower.B, length: {sling} m, rope: sling}}
{watch}plan:
  - {{step: hold, hold: until_end}}
"""


def checked(bottom: float, watch: str = "") -> list[Check]:
    """Checks of the tower at rest, its underside about so high [m]."""
    sling = 60.0 - bottom - 3.0  # plumb, from hooks at 60 m to lugs 3 m above the underside
    text = _LIFT.format(bottom=bottom, sling=sling, watch=watch)
    return check_recording(Statics(parse_scenario(text)).equilibrium(time=0.0).recording)


def in_one_place(bottom: float, watch: str = "") -> dict[str, Verdict]:
    return {one.element: one.verdict for one in checked(bottom, watch) if one.name == "no_overlap"}


@pytest.mark.parametrize("watched", ["gol", "gol.legs"])
def test_a_load_in_the_girder_of_a_watched_crane(watched: str) -> None:
    """2 m in the girder, drawn 8.9 m high: a warning. Through the trolley, 2 m high below it: a failure."""
    watch = f"watch: [{{between: [tower, {watched}], smallest: 2 m}}]\n"
    found = in_one_place(GIRDER + 2.0 - TALL, watch)
    assert found == {"gol.girder to tower": Verdict.WARNING, "gol.one to tower": Verdict.FAILED}
    margin = next(one for one in checked(GIRDER + 2.0 - TALL, watch) if one.name == "clearance_margin")
    assert margin.verdict is Verdict.OK
    # From the nearer leg, 4 m wide, 54 m from the middle of the tower: 54 - 2 - 3 m.
    assert margin.value == pytest.approx(49.0 - 2.0, abs=1e-3)


def test_below_the_girder_nothing_is_told() -> None:
    assert in_one_place(GIRDER - 5.0 - TALL, "watch: [{between: [tower, gol], smallest: 2 m}]\n") == {}


@pytest.mark.parametrize("watch", ["", "watch: [{between: [tower, c1], smallest: 1 m}]\n"])
def test_a_hook_in_the_load_of_a_watched_crane(watch: str) -> None:
    """A hook block 2 m high in the middle of a tower, from 5 m over its underside to 3 m below its top."""
    lift = """\
load:
  name: tower
  shape: {box: [6 m, 6 m, 10 m]}
  position: [3 m, 14 m, 25 m]
  weight: {calculated: 30 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {A: {at: [0 m, 3.9 m, 3 m]}, B: {at: [0 m, -3.9 m, 3 m]}}
slings:
  A: {from: c1.H, to: tower.A, length: 4.4 m, rope: hoist}
  B: {from: c1.H, to: tower.B, length: 4.4 m, rope: hoist}
"""
    text = crawler_lift(7.1e3, start="as_given", more=lift + watch)
    recording = Statics(parse_scenario(text)).equilibrium(time=0.0).recording
    told = [one.element for one in check_recording(recording) if one.name == "no_overlap"]
    assert told == ["c1.H to tower"]
