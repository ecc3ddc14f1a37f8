"""A crawler crane that stood 2 degrees askew lifted 100 t and was a GO.

Its boom leaned aside by as much, so that 3.5 % of what hung pulled across it, where lattice booms are made
for 2 % of the rated load. Falls hang plumb all the same: `side_lead`, which is their angle from plumb, was
0.1 degrees. A chart with `heel` and `trim` was held against the lean, and most charts have neither.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.results.rotation import tilt
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from of_recording import checks_of

LENGTH = 9.0
#: Where its hook hangs by how much the front of both tracks is higher [m].
HANGS = {0.0: (0.0, 16.0), 0.31: (-2.2, 15.95)}


def lift(higher: float, chart: str = "") -> Scenario:
    x, y = HANGS[higher]
    return parse_scenario(f"""\
format: 1
lift: {{title: A crawler on a slope}}
duration: 60 s
start: rest
ground: {{level: 0 m, friction: 0.4, stiffness: 400 MN/m, damping: 4 MN s/m}}
ropes:
  sling: {{axial_stiffness: 265 MN, minimum_breaking_force: 4030 kN, damping_time: 10 ms, mass: none}}
  hoist: {{axial_stiffness: 36 MN, minimum_breaking_force: 489 kN, damping_time: 10 ms, mass: none}}
load:
  name: box
  shape: {{box: [8 m, 4 m, 3 m]}}
  position: [{x} m, {y} m, 0 m]
  weight: {{calculated: 100 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  stands_on: ground
  lugs:
    A: {{at: [-3 m, 0 m, 3 m], capacity: 110 t}}
    B: {{at: [ 3 m, 0 m, 3 m], capacity: 110 t}}
cranes:
  c:
    type: crawler
    position: [0 m, 0 m]
    heading: 0 deg
    slew: 90 deg
    rating_includes_hook_block: true
    tracks:
      {{length: {LENGTH} m, width: 1.5 m, gauge: 8.4 m, mats: 6 m, allowed_pressure: 250 kPa,
        levels: {{left.front: {higher} m, right.front: {higher} m}}}}
    base_mass: 190 t
    central_ballast: 95 t
    counterweight: {{mass: 250 t, behind: 6.5 m}}
    boom:
      {{heel_pins: {{ahead: 1.6 m, height: 2.5 m}}, length: 63 m, radius: 16 m, mass: 60 t,
        centre_of_gravity: 45 %}}
    rating: {{radius: [12 m, 16 m, 20 m, 28 m], rated: [360 t, 231 t, 168 t, 104 t]{chart}}}
    hooks:
      H:
        height: 13.4 m
        rated_capacity: 250 t
        block: {{mass: 7 t, height: 2 m}}
        reeving: {{ropes: 1, parts_each: 14, rope: hoist, sheave_diameter: 0.7 m, below_head: 1 m,
          sheave_block_mass: 2 t}}
        drum: {{diameter: 0.8 m}}
        hoist: {{speed: 6 m/min, acceleration: 0.02 m/s^2}}
sling_defaults: {{rope: sling, length: 11.6 m}}
slings:
  A: {{from: H, to: box.A}}
  B: {{from: H, to: box.B}}
plan:
  - {{step: up, hoist: H, speed: 3 m/min, by: 1.6 m}}
  - {{step: hold, hold: until_end}}
""")


def at_rest(higher: float, chart: str = "") -> Recording:
    return Statics(lift(higher, chart)).equilibrium().recording


def leans(recording: Recording) -> float:
    return float(np.degrees(tilt(recording.column("body_orientation", "c.tracks"))[-1]))


def test_one_that_leans_is_told() -> None:
    rest = at_rest(0.31)
    # The ground gives by what the load tips the crane to its side, a fifth of a degree across that.
    assert leans(rest) == pytest.approx(math.degrees(math.atan(0.31 / LENGTH)), abs=0.1)
    (found,) = checks_of(rest, "stands_level")
    assert (found.verdict, found.element, found.time) == (Verdict.WARNING, "c", None)
    assert f"lean by {leans(rest):.2f} deg, 3.5 %, under load" in found.remark


def test_so_it_is_of_a_run() -> None:
    (found,) = checks_of(simulate(lift(0.31)), "stands_level")
    assert found.verdict is Verdict.WARNING
    assert found.time is not None


def test_level_ground_gives_by_less() -> None:
    rest = at_rest(0.0)
    assert 0.0 < leans(rest) < math.degrees(math.atan(0.01))
    assert not checks_of(rest, "stands_level")


def test_a_chart_that_says_within_what_it_holds_is_held_against_that() -> None:
    rest = at_rest(0.31, ", heel: 3 deg, trim: 3 deg")
    assert not checks_of(rest, "stands_level")
    (found,) = checks_of(at_rest(0.31, ", heel: 1 deg, trim: 1 deg"), "attitude_of_rating")
    assert found.verdict is Verdict.FAILED
