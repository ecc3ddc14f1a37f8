"""A load without lugs, in baskets or on ropes of `mechanics`.

Its file could not be written: `lugs: {}` was answered by `is empty; leave it out or fill it`, and a load that
left it out by `'lugs' is missing; the load needs it`.
"""

from __future__ import annotations

import math

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from gantline.statics import Statics
from mechanics import G

LIFT = """\
format: 1
lift: {title: A pipe in two baskets}
duration: 1 s
ropes: {soft: {axial_stiffness: 20 MN, damping_time: 10 ms}}
load:
  name: pipe
  shape: {box: [10 m, 1 m, 1 m]}
  position: [0 m, 0 m, 2 m]
  weight: {calculated: 10 t}
  centre_of_gravity: {at: [0 m, 0 m, 0.4 m]}
cranes:
  west: {type: fixed_hook, at: [-3 m, 0 m, 7.5 m], hoist: {speed: 6 m/min, acceleration: 1 m/s^2}}
  east: {type: fixed_hook, at: [ 3 m, 0 m, 7.5 m], hoist: {speed: 6 m/min, acceleration: 1 m/s^2}}
mechanics:
  ropes:
"""
for name, x in (("west", -3), ("east", 3)):
    eyes = ", ".join(f"{{type: eye, body: pipe, at: [{x} m, {y} m, 0.1 m]}}" for y in (0.5, -0.5))
    end = f"{{type: end, body: {name}}}"
    LIFT += f"    {name}: {{rope: soft, length: 11 m, route: [{end}, {eyes}, {end}]}}\n"


def test_baskets_bear_it() -> None:
    """Both legs of both baskets carry W/(4 cos α), sin α = 0.5 m over the leg of 5 m and its stretch."""
    rest = Statics(parse_scenario(LIFT)).equilibrium()
    tension = rest.tension("west")
    stretched = 11.0 * (1 + tension / 20e6)
    leg = 0.5 * (stretched - 1.0)
    alpha = math.asin(0.5 / leg)
    assert tension == pytest.approx(10e3 * G / (4 * math.cos(alpha)), rel=1e-6)
    assert rest.tension("east") == pytest.approx(tension, rel=1e-6)


def test_what_is_empty_may_be_left_out() -> None:
    """As the message says."""
    with pytest.raises(ScenarioError, match=r"load\.lugs: is empty; leave it out or fill it"):
        parse_scenario(LIFT.replace("cranes:", "  lugs: {}\ncranes:"))
