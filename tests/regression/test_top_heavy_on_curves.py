"""A load that turned over on slings that get softer was in order.

Whether what hangs stays upright came from one stiffness for the whole curve of its slings. At 307 kN, past
the bend of a curve, they give way ten times as easily: no word of a centre of gravity 0.66 m too high.
"""

from __future__ import annotations

import pytest

from gantline.results.upright import top_heavy
from gantline.scenario import parse_scenario
from gantline.statics import Statics

LIFT = """\
format: 1
lift: {{title: A tall module on four soft slings}}
duration: 1 s
start: rest
ropes:
  sling: {{curve: {{strain: [1 %, 3 %], tension: [300 kN, 330 kN]}}, mass: none, damping_time: 10 ms}}
load:
  name: module
  shape: {{box: [8 m, 6 m, 12 m]}}
  position: [0 m, 0 m, 6 m]
  weight: {{calculated: 115 t}}
  centre_of_gravity: {{at: [0 m, 0 m, {height!r} m]}}
  lugs:
    A: {{at: [ 3 m,  2 m, 4 m]}}
    B: {{at: [ 3 m, -2 m, 4 m]}}
    C: {{at: [-3 m,  2 m, 4 m]}}
    D: {{at: [-3 m, -2 m, 4 m]}}
cranes:
  crane: {{type: fixed_hook, at: [0 m, 0 m, 18.1 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: sling}}
slings:
  A: {{from: crane, to: module.A, length: 9 m}}
  B: {{from: crane, to: module.B, length: 9 m}}
  C: {{from: crane, to: module.C, length: 9 m}}
  D: {{from: crane, to: module.D, length: 9 m}}
plan:
  - {{step: hold, hold: until_end}}
"""


@pytest.mark.parametrize(("height", "too_high"), [(4.0, None), (5.30, None), (5.38, 0.04), (6.0, 0.66)])
def test_what_hangs_is_told_to_turn_over_where_statics_have_it(height: float, too_high: float | None) -> None:
    """It turns over where the equilibrium of the core is unstable, which takes slopes from its rows.

    By how much it is too high is height less the 5.34 m between, to 1 cm.
    """
    rest = Statics(parse_scenario(LIFT.format(height=height))).equilibrium()
    found = [one.too_high for one in top_heavy(rest.recording)]
    assert rest.is_stable == (too_high is None)
    assert found == ([] if too_high is None else [pytest.approx(too_high, abs=0.01)])
