"""A case that moved the centre of gravity moved the ropes of `mechanics` on the load along with it.

Places of `mechanics` on a load count from its centre of gravity, and a case changed that alone: the ropes
went 0.5 m along the load, and bore what they bore before. A module of 220 t under two slings and two chain
hoists had 1186 kN in its worst sling by that in place of 918 kN, and two of its eight corners did not start
since ropes had got too short. Ropes that hold a load at two places x1 and x2 plumb bear by moments

    T1 = W (x2 - e)/(x2 - x1),    T2 = W - T1,

with e where the centre of gravity is. Ropes stretch by 1e-5 here, so that the load tilts by next to nothing.
"""

from __future__ import annotations

import pytest

from gantline.scenario import load_scenario, parse_scenario
from gantline.statics import Equilibrium, Statics
from gantline.study import run_cases
from gantline.study.sweep import run_sweep

WEIGHT = 40e3 * 9.81  # [N]
LIFT = """
format: 1
lift: {title: A beam by two ropes}
duration: 20 s
ground: {friction: 0.5}
ropes:
  stiff: {axial_stiffness: 40 GN, damping_time: 10 ms, minimum_breaking_force: 900 kN}
load:
  name: beam
  shape: {box: [10 m, 1 m, 1 m]}
  position: [0 m, 0 m, 0.5 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [1 m, 0 m, 0.5 m], envelope: [0.5 m, 0 m, 0 m]}
cranes:
  west: {type: fixed_hook, at: [-3 m, 0 m, 6.5 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
  east: {type: fixed_hook, at: [5 m, 0 m, 6.5 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
mechanics:
  ropes:
    west:
      rope: stiff
      length: 5 m
      route: [{type: end, body: west}, {type: end, body: beam, at: [-4 m, 0 m, 0.5 m]}]
    east:
      rope: stiff
      length: 5 m
      route: [{type: end, body: east}, {type: end, body: beam, at: [4 m, 0 m, 0.5 m]}]
plan:
  - {step: hang, hold: until_end}
cases:
  cog: {vary: load.centre_of_gravity.envelope, corners: all}
  elsewhere: {set: {load.centre_of_gravity.at: [0 m, 0 m, 0.5 m]}}
"""


def west(centre: float) -> float:
    """Tension of the western rope [N], the centre of gravity being there [m]."""
    return WEIGHT * (5.0 - centre) / 8.0


def tension(rest: Equilibrium) -> float:
    return float(rest.recording.column("rope_tension", "west")[-1])


def test_ropes_stay_where_they_are_on_the_load() -> None:
    result = run_cases(parse_scenario(LIFT))
    found = {(one.case, one.label): tension(one.rest) for one in result.states if one.rest is not None}
    assert found["", ""] == pytest.approx(west(1.0), rel=1e-4)
    assert found["cog", "−x"] == pytest.approx(west(0.5), rel=1e-4)
    assert found["cog", "+x"] == pytest.approx(west(1.5), rel=1e-4)
    assert found["elsewhere", ""] == pytest.approx(west(0.0), rel=1e-4)


def test_so_do_they_of_a_sweep_and_of_a_lift_that_is_changed() -> None:
    lift = parse_scenario(LIFT)
    path = "load.centre_of_gravity.at.x"
    points = run_sweep(lift, path, "0 m", "1 m", 2)
    tensions = [tension(point.state.rest) for point in points if point.state.rest is not None]
    assert tensions == pytest.approx([west(0.0), west(1.0)], rel=1e-4)
    once = lift.changed({path: "0.5 m"})
    twice = once.changed({path: "2 m", "load.weight.calculated": "40 t"})
    back = twice.changed({path: "1 m"})
    for other, centre in ((once, 0.5), (twice, 2.0), (back, 1.0)):
        assert tension(Statics(other).equilibrium()) == pytest.approx(west(centre), rel=1e-4)


def test_a_file_is_read_as_it_stands() -> None:
    """Where a file has its centre of gravity, its places count from there."""
    other = parse_scenario(LIFT.replace("at: [1 m, 0 m, 0.5 m]", "at: [0.5 m, 0 m, 0.5 m]"))
    assert other.centre_moved == (0.0, 0.0, 0.0)
    assert load_scenario("goliath").changed({"duration": "10 s"}).centre_moved == (0.0, 0.0, 0.0)
