"""How far a load could stand from where it does, and friction would still hold it."""

from __future__ import annotations

import pytest

import gantline

WEIGHT, FRICTION = 10e3 * 9.81, 0.3
LIFT = gantline.parse_scenario("""\
format: 1
lift: {title: A load that stands below a hook and is pulled}
duration: 20 s
ground: {level: 0 m, friction: 0.3, stiffness: 200 MN/m, damping: 1 MN s/m}
ropes: {s: {axial_stiffness: 10 MN, damping_time: 20 ms, mass: none}}
load:
  name: box
  shape: {box: [4 m, 4 m, 1 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 10 t}
  centre_of_gravity: {at: [0 m, 0 m, 0.5 m]}
  stands_on: ground
  lugs: {L: {at: [0 m, 0 m, 1 m]}}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 11 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
slings: {L: {from: hook, to: box.L, length: 10.01 m, rope: s}}
plan:
  - {step: pull, hoist: hook, speed: 1 m/min, by: 0.06 m}
  - {step: hold, hold: until_end}
""")


def test_between_both_ends_friction_holds() -> None:
    """T sin α = μ (W − T cos α) at both ends, as far to one side as to the other of a symmetric lift."""
    ends = gantline.Statics(LIFT).stick_range((1.0, 0.0, 0.0))
    places = []
    for end in ends:
        assert end is not None
        at = end.recording.column("body_position", "box")[-1]
        # The lug is half a metre above the centre of gravity of a load that stands level.
        aside, up = float(at[0]), 11.06 - float(at[2]) - 0.5
        length = (aside**2 + up**2) ** 0.5
        tension = end.tension("sling.L")
        support = WEIGHT - tension * up / length
        assert tension * abs(aside) / length == pytest.approx(FRICTION * support, rel=1e-3)
        places.append(aside)
    assert places[0] == pytest.approx(-places[1], rel=1e-6)
