"""Slings that the first page leaves out were said to carry less, where they carry as much or more.

Of sixty slings alike sixteen stood in the table, and "44 carry less" below it. And of a lift by a floating
crane and two crawlers the table had the four with the most used ropes, at 555 kN, and "5 carry no more" below
it, where those of the crawlers carried 723 kN by ropes that were stronger yet.
"""

from __future__ import annotations

import math

import gantline
from gantline.report import render_report
from gantline.report.carried import sling_rows
from gantline.report.subject import Subject

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


#: The first by a rope of twice the stiffness and four times the strength.
UNLIKE = LIFT.replace(
    "to: box.L0, length: 9 m, rope: sling", "to: box.L0, length: 9 m, rope: strong"
).replace(
    "ropes: {sling: {axial_stiffness: 20 MN,",
    "ropes: {strong: {axial_stiffness: 40 MN, minimum_breaking_force: 4 MN, damping_time: 20 ms, "
    "mass: none}, "
    "sling: {axial_stiffness: 20 MN, minimum_breaking_force: 1 MN,",
)


def test_what_is_left_out_carries_no_more() -> None:
    """Sixteen stand in the table; the other four are as taut to all digits that are shown."""
    page = render_report(gantline.simulate(gantline.parse_scenario(LIFT)))
    said = "4 are left out; the largest force and the most used rope, shackle and lug are here."
    assert said in page


def test_the_sling_that_carries_most_is_not_left_out() -> None:
    """Also where all others use more of their ropes."""
    subject = Subject(gantline.simulate(gantline.parse_scenario(UNLIKE)))
    (strong, other), said = sling_rows(subject, 2)
    assert strong["name"] == "S0" and float(strong["peak"]) > 1.5 * float(other["peak"])
    assert float(strong["rope"]) < float(other["rope"])
    assert said == "18 are left out; the largest force and the most used rope, shackle and lug are here"
    assert sling_rows(subject, 1)[1] == "19 are left out"
