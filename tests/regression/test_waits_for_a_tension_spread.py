"""A step that waits for a tension spread that inclined slings never come to does not say how near it is.

Sheaves that move give all slings the same pull along plumb, so that a sling at 25° carries a tenth more than
one that is plumb: `until: {tension_spread: 5 %}` never holds, and the step hoists on until the run ends. That
it waits for that is all that is said, where other conditions tell how far they come.
"""

from __future__ import annotations

import math
import re

import pytest

from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import checks_of

#: Outer lugs stand so much farther out than their sheaves, and slings go down so far [m].
ASIDE, DEEP = 2.8, 6.0
#: Height of the load [m]: so far below its lugs its weight keeps it upright between slings that spread.
TALL = 12.0

LIFT = f"""\
format: 1
lift: {{title: Inclined slings below an equalizer}}
duration: 60 s
ground: {{level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}}
ropes:
  sling: {{axial_stiffness: 190 MN, damping_time: 10 ms, minimum_breaking_force: 3 MN, mass: none}}
  equalizing: {{axial_stiffness: 100 MN, damping_time: 10 ms, minimum_breaking_force: 2 MN, mass: none,
    diameter: 46 mm}}
load:
  name: load
  shape: {{box: [12 m, 6 m, {TALL} m]}}
  weight: {{calculated: 90 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 2 m]}}
  stands_on: ground
  lugs:
    A: {{at: [{-1.6 - ASIDE} m, 0 m, {TALL} m]}}
    B: {{at: [0 m, 0 m, {TALL} m]}}
    C: {{at: [{1.6 + ASIDE} m, 0 m, {TALL} m]}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, {TALL + DEEP + 5.5 - 0.05} m]
    hoist: {{speed: 2 m/min, acceleration: 0.02 m/s^2}}
equalizer_types:
  three:
    rated_capacity: 150 t
    frame: {{mass: 6 t, length: 6 m, width: 1.2 m, height: 2.5 m, centre_of_gravity_below_hook: 3 m,
      inertia_about_vertical: 25000 kg m^2}}
    hinge: {{axis: vertical, friction: 2 kN m}}
    rope: equalizing
    rope_ends: {{along: [-2.0 m, 2.0 m], below_hook: 4 m}}
    fixed_sheaves: {{along: [-0.8 m, 0.8 m], below_hook: 4 m, pitch_diameter: 0.8 m, efficiency: 1.0}}
    moving_sheaves: {{along: [-1.6 m, 0 m, 1.6 m], below_hook: 5.5 m, pitch_diameter: 0.8 m,
      efficiency: 1.0, mass: 200 kg, guided: vertical}}
    travel: {{up: 1 m, down: 1.2 m, locked: false, stops: true}}
equalizers: {{E: {{type: three, hangs_from: hook, heading: 0 deg}}}}
sling_defaults: {{rope: sling}}
slings:
  A: {{from: E.1, to: load.A, length: {math.hypot(ASIDE, DEEP)} m}}
  B: {{from: E.2, to: load.B, length: {DEEP} m}}
  C: {{from: E.3, to: load.C, length: {math.hypot(ASIDE, DEEP)} m}}
plan:
  - {{step: equalise, hoist: hook, speed: 1 m/min, until: {{tension_spread: 5 %}}}}
  - {{step: hold, hold: until_end}}
"""


def test_a_spread_that_is_never_met_is_told_with_what_it_comes_to() -> None:
    (check,) = checks_of(simulate(parse_scenario(LIFT)), "plan_finished")
    found = re.fullmatch(
        r"the run ends at 60 s in 'equalise', which waits for tension spread below 5 %: "
        r"(\S+) % then, (\S+) % to (\S+) % since it began; not begun: hold",
        check.remark,
    )
    assert found is not None, check.remark
    now, least, most = map(float, found.groups())
    # T = f/cos of the angle from plumb with the same f: (1/cos - 1)/mean of (1/cos, 1, 1/cos).
    outer = 1.0 / math.cos(math.atan(ASIDE / DEEP))
    assert now == pytest.approx(100.0 * (outer - 1.0) / ((2.0 * outer + 1.0) / 3.0), rel=0.01)
    assert 5.0 < least <= now <= most
