"""A load that came down with an edge by what is pumped from one of its tanks to the other is told.

210 t hang clear by 0.3 m, and 20 t are pumped from its one end to the other. It tilts until an edge stands on
the ground: GO WITH WARNINGS, and none of them says so, under an equalizer with a tenth of the weight on that
edge. A step that pumps counts as one that lowers the load, as ballast does what it hangs from or is to stand
on. What is pumped within a load lowers it by nothing.
"""

from __future__ import annotations

from math import atan, hypot, sin, tan

import pytest

from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import checks_of

#: Half of the load's length, how far it is hoisted, hook above its underside as it stands [m].
HALF, CLEAR, HOOK = 8.0, 0.3, 12.0
#: Of the load, what is in both tanks together [t]; middles of these from the middle of the load [m].
OWN, INSIDE, ARM = 150.0, 60.0, 4.0
#: Tanks are so long and broad; their floors are 0.5 m above the underside of the load [m].
SIDE, FLOOR = 5.0, 0.5
#: Centre of gravity of the load above its underside, and of what is in its tanks, half of its depth up [m].
HEIGHT, WATER = 3.0, FLOOR + INSIDE / 2.0 / SIDE**2 / 2.0


def run(pumped: float) -> Recording:
    lugs = {"NE": (6, 3), "NW": (-6, 3), "SE": (6, -3), "SW": (-6, -3)}
    length = hypot(6.0, 3.0, HOOK - 6.0) + 0.05
    listed = "\n".join(
        f"    {name}: {{at: [{x} m, {y} m, 6 m], capacity: 200 t}}" for name, (x, y) in lugs.items()
    )
    slings = "\n".join(f"  {name}: {{from: hook, to: tank.{name}, length: {length} m}}" for name in lugs)
    return simulate(
        parse_scenario(f"""\
format: 1
lift: {{title: Two tanks}}
duration: 150 s
ground: {{level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}}
ropes:
  sling: {{axial_stiffness: 500 MN, damping_time: 20 ms, minimum_breaking_force: 9 MN, mass: none}}
load:
  name: tank
  shape: {{box: [{2.0 * HALF} m, 8 m, 6 m]}}
  weight: {{calculated: {OWN} t}}
  centre_of_gravity: {{at: [0 m, 0 m, {HEIGHT} m]}}
  stands_on: ground
  tanks:
    fore: {{box: [{SIDE} m, {SIDE} m, 4 m], bottom: [{ARM} m, 0 m, {FLOOR} m], content: {INSIDE / 2.0} t}}
    aft: {{box: [{SIDE} m, {SIDE} m, 4 m], bottom: [{-ARM} m, 0 m, {FLOOR} m], content: {INSIDE / 2.0} t}}
  lugs:
{listed}
cranes:
  hook:
    {{type: fixed_hook, at: [0 m, 0 m, {HOOK} m], rated_capacity: 400 t,
      hoist: {{speed: 2 m/min, acceleration: 0.02 m/s^2}}}}
sling_defaults: {{rope: sling}}
slings:
{slings}
plan:
  - {{step: lift off, hoist: hook, speed: 0.5 m/min, until: {{supports: clear}}}}
  - {{step: clear, hoist: hook, speed: 1 m/min, by: {CLEAR} m}}
  - {{step: look, hold: 10 s}}
  - {{step: trim, pump: {{from: tank.fore, to: tank.aft}}, rate: 3000 t/h, by: {pumped} t}}
  - {{step: end, hold: until_end}}
limits: {{load_tilt: 10 deg}}
""")
    )


def slope(pumped: float) -> float:
    """By hand, tan(tilt) = e/(h - I/V) below a hook: the free surfaces of both tanks take I/V of h [1]."""
    shift = pumped * 2.0 * ARM / (OWN + INSIDE)
    below = HOOK - (OWN * HEIGHT + INSIDE * WATER) / (OWN + INSIDE)
    return shift / (below - 2.0 * SIDE**4 / 12.0 / (OWN + INSIDE))


def drop(pumped: float) -> float:
    """How far an edge would come down at most [m]."""
    return HALF * sin(atan(slope(pumped)))


def test_an_edge_that_comes_down_as_tanks_are_pumped_is_told() -> None:
    assert drop(20.0) > 1.5 * CLEAR
    found = run(20.0)
    (check,) = checks_of(found, "stays_clear")
    assert (check.verdict, check.element) == (Verdict.WARNING, "tank")
    assert check.remark.startswith("it meets what is in its way in 'trim', after ")
    assert "how it tilts by what is pumped in it, wind, tag lines" in check.remark
    assert float(found.column("load_transferred", "tank")[-1]) < 0.99


def test_so_little_that_it_hangs_clear_is_not() -> None:
    assert drop(4.0) < 0.6 * CLEAR
    found = run(4.0)
    assert not checks_of(found, "stays_clear")
    # A hundredth: it swings a little, and what was pumped has another depth in each tank.
    assert tan(float(found.column("load_tilt", "tank")[-1])) == pytest.approx(slope(4.0), rel=0.01)
