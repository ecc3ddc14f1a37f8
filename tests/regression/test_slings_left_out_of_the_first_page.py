"""Slings that the first page leaves out were said to carry less, where they carry as much.

Of sixty slings alike sixteen stood in the table, and "44 carry less" below it.
"""

from __future__ import annotations

import math

import gantline
from gantline.report import render_report

#: On a circle about the hook, so that all are alike.
PLACES = [(4.0 * math.cos(angle), 4.0 * math.sin(angle)) for angle in [math.tau * k / 20 for k in range(20)]]
LUGS = "\n".join(f"    L{k}: {{at: [{x:.9f} m, {y:.9f} m, 3 m]}}" for k, (x, y) in enumerate(PLACES))
SLINGS = "\n".join(f"  S{k}: {{from: hook, to: box.L{k}, length: 9 m, rope: sling}}" for k in range(20))
LIFT = f"""
format: 1
lift: {{title: Twenty slings alike}}
duration: 5 s
ropes: {{sling: {{axial_stiffness: 20 MN, damping_time: 20 ms, mass: none}}}}
load:
  name: box
  shape: {{box: [10 m, 10 m, 3 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 100 t, contingency: 1.0}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs:
{LUGS}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 11.05 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
slings:
{SLINGS}
plan: [{{step: hold, hold: until_end}}]
"""


def test_what_is_left_out_carries_no_more() -> None:
    """Sixteen stand in the table; the other four are as taut to all digits that are shown."""
    page = render_report(gantline.simulate(gantline.parse_scenario(LIFT)))
    assert "The 16 most loaded ones; 4 carry no more." in page
