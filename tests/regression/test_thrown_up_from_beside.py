"""A load that came over a support from beside was thrown up, and its run told of steps that are too long.

A module that a luffing boom let down on its stools was drawn on, and came over the next two 60 mm below
their tops. Each pushes with its stiffness times that, at once, as the page of supports says: energy from
nowhere, by `adaptive`, whose steps nobody chooses. What to mend in the lift was not said.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.scenario import parse_scenario
from trolley_pair import TROLLEYS

#: A box that two trolleys take 5 m along the girder, over a support whose edge is 1 m ahead of it.
LIFT = (
    TROLLEYS.replace("duration: 400 s", "duration: 40 s")
    + """\
load:
  name: box
  shape: {box: [24 m, 4 m, 3 m]}
  position: [0 m, 0 m, 5 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  lugs:
    A: {at: [-8.3 m, 0 m, 3 m]}
    B: {at: [8.8 m, 0 m, 3 m]}
supports:
  post: {under: box, measured_from: world, places: {p: {at: [13.5 m, 0 m]}}, foot: 0 m, height: HEIGHT m,
    top: [1 m, 1 m], stiffness: 200 MN/m, damping: 2 MN s/m, friction: 0.3}
slings:
  A: {from: gol.A, to: box.A, length: 5.61 m, rope: sling}
  B: {from: gol.B, to: box.B, length: 5.61 m, rope: sling}
plan:
  - {step: along, traverse: [one, two], speed: 20 m/min, by: 4 m}
  - {step: end, hold: until_end}
"""
)


@pytest.mark.parametrize(("over", "is_thrown"), [(0.06, True), (-0.06, False)])
def test_a_load_that_comes_over_a_support_from_beside(over: float, is_thrown: bool) -> None:
    """At 60 mm 200 MN/m hold 0.36 MJ; below its underside the support is in the way of nothing."""
    run = gantline.simulate(parse_scenario(LIFT.replace("HEIGHT", f"{5.0 + over:g}")))
    told = [one for one in run.attributes["warnings"] if "come from nowhere" in one]
    thrown = "support.post.p pushes up a load that comes over it from beside, below its top, or slides on it"
    assert [thrown in one for one in told] == [True] * is_thrown
