"""A hook that slings pull aslant for a moment, while little hangs in it, was told to bear more than it does.

Four slings of which two are 30 mm short: these go taut before the others, and pull the hook aside by as much
as they lean, with 40 % of the load. 'hoist_load_of_rated_capacity' warned that what pulls along the hook is
"up to 1.11 times as much" as what it compares, 1/cos 26 deg; with all four taut it is pulled plumb, and along
the pull there is never more than then. So a GO was a GO WITH WARNINGS, by a figure that nothing has.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import Outcome, Verdict, check_recording, outcome_of
from gantline.results.cranes.pulled_aside import pull_aside
from gantline.results.loads.hook_peaks import hook_peak
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

#: Half of the distance between lugs, height of the hook over them [m].
HALF, UP = 3.0, 7.0
LIFT = f"""\
format: 1
lift: {{title: Two slings that go taut first}}
duration: 24 s
ground: {{level: 0 m, friction: 0.5}}
ropes:
  sling: {{axial_stiffness: 90 MN, mass: none, minimum_breaking_force: 1.3 MN, damping_time: 10 ms}}
load:
  name: box
  shape: {{box: [8 m, 3 m, 3 m]}}
  weight: {{calculated: 40 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs:
    NW: {{at: [-{HALF} m, 1 m, 3 m], capacity: 25 t}}
    SW: {{at: [-{HALF} m, -1 m, 3 m], capacity: 25 t}}
    NE: {{at: [{HALF} m, 1 m, 3 m], capacity: 25 t}}
    SE: {{at: [{HALF} m, -1 m, 3 m], capacity: 25 t}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, {3.0 + UP} m]
    rated_capacity: 60 t
    hoist: {{speed: 6 m/min, acceleration: 0.02 m/s^2}}
sling_defaults: {{rope: sling}}
slings:
  NW: {{from: hook, to: box.NW, length: 7.70 m}}
  SW: {{from: hook, to: box.SW, length: 7.70 m}}
  NE: {{from: hook, to: box.NE, length: 7.73 m}}
  SE: {{from: hook, to: box.SE, length: 7.73 m}}
plan:
  - {{step: up, hoist: hook, speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: clear, hoist: hook, speed: 1 m/min, by: 0.2 m}}
  - {{step: hold, hold: until_end}}
limits: {{rule: yard, sling_factor_on_breaking_force: 5}}
"""


def test_what_pulls_aslant_is_held_against_what_is_compared() -> None:
    recording = simulate(parse_scenario(LIFT))
    (hook,) = recording.rig.hooks
    upright, aside = recording.column("hook_load", "hook"), pull_aside(recording, hook)
    # Two slings alone lean by atan(half/up) = 23.2 deg, and bear more than a quarter of the most then.
    leans = aside > 0.9 * HALF / UP * upright
    assert upright[leans].max() > 0.25 * upright.max()
    # Along the pull it is no more than upright while all four carry: sqrt(1 + tan(lean)^2) is 1 + lean^2/2.
    lean = math.radians(1.0)
    assert (upright**2 + aside**2).max() <= (upright.max() * (1.0 + lean**2 / 2.0)) ** 2
    checks = check_recording(recording)
    (rated,) = [one for one in checks if one.name == "hoist_load_of_rated_capacity"]
    # Of a hook by itself that is the largest of all steps, which samples may miss by a little.
    most, _ = hook_peak(recording, "hook", "hoist_load")
    assert upright.max() <= most <= 1.001 * upright.max()
    assert rated.value == pytest.approx(most / (60e3 * recording.rig.gravity), rel=1e-6)
    assert rated.verdict is Verdict.OK and "aside" not in rated.remark
    assert outcome_of(checks) is Outcome.GO
