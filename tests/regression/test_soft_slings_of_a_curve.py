"""Slings with a curve were doubted by the one stiffness that has its energy, not by what they stretch.

Slings that stretch by 25 % under 49 kN, their part of the load, and by 30 % under 600 kN have the energy
of an EA of 8.05 MN. By that it was 0.6 %, and nothing was said.
"""

from __future__ import annotations

import gantline
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: A load on two slings of nylon}
duration: 1 s
start: as_given
ropes:
  nylon:
    curve: {strain: [25 %, 30 %], tension: [49.05 kN, 600 kN]}
    mass: none
    minimum_breaking_force: 600 kN
ground: {level: 0 m}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 12 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
load:
  name: box
  shape: {box: [8 m, 3 m, 2 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 10 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  stands_on: ground
  lugs: {A: {at: [-3 m, 0 m, 2 m]}, B: {at: [3 m, 0 m, 2 m]}}
slings:
  A: {from: hook, to: box.A, length: 11 m, rope: nylon}
  B: {from: hook, to: box.B, length: 11 m, rope: nylon}
plan: [{step: hold, hold: until_end}]
"""


def test_slings_are_doubted_by_their_curve() -> None:
    """Half of 10 t is 49.05 kN: the first point, 25 %."""
    doubts = [one.sentence for one in gantline.Simulation(parse_scenario(LIFT)).assembly.doubts]
    [found] = [one for one in doubts if one.startswith("rope nylon")]
    assert found == (
        "rope nylon has a curve: its slings would stretch by 25 % under their part of the load; a unit has "
        "slipped, kN for MN"
    )
