"""A load that stood on a table was held there by its friction, or slid off it, as the table was turned.

Friction holds what touches as a lift starts. A load that stands exactly on what is below it is 1e-16 m above
or below that by rounding, and above it friction was left out: a hull section on a table headed 0 deg stayed
where it was, and headed 5, 37 or 217 deg it came to rest on the ground beside the table, 32.6 m away, where
the run then began.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics

#: Where the load's datum and the middle of the table are along the load's length [m], and its height [m].
LOAD, TABLE, TOP = -35.0, -36.0, 3.0


def lift(heading: float) -> str:
    """A hull section on a table, both turned about the origin of the world."""
    x, y = math.cos(math.radians(heading)), math.sin(math.radians(heading))
    return f"""
format: 1
lift: {{title: A hull section on a table}}
duration: 1 s
ground: {{level: 0 m, friction: 0.4}}
load:
  name: hull
  shape: {{box: [43 m, 23 m, 11 m]}}
  position: [{LOAD * x!r} m, {LOAD * y!r} m, {TOP} m]
  heading: {heading} deg
  weight: {{calculated: 350 t}}
  centre_of_gravity: {{at: [-2 m, 0 m, 4.8 m]}}
mechanics:
  bodies:
    table:
      joint: {{type: fixed}}
      at: [{TABLE * x!r} m, {TABLE * y!r} m, 0 m]
      orientation: {{about: [0, 0, 1], angle: {heading} deg}}
      mass: 10 t
      shape: {{box: [20 m, 10 m, {TOP} m], centre: [0 m, 0 m, {TOP / 2} m]}}
  body_contacts:
    on_table: {{between: [hull, table], stiffness: 200 MN/m, damping: 2 MN s/m, friction: 0.3}}
plan: []
"""


@pytest.mark.parametrize("heading", [0.0, 5.0, 37.0, 217.0])
def test_it_stands_where_it_was_put(heading: float) -> None:
    """Held by friction, sunk by W/(4 k) (1 + (a/l)²): a = 1 m off the middle of corners l = 10 m away."""
    scenario = parse_scenario(lift(heading))
    centre = LOAD - 2.0
    wanted = np.array([math.cos(math.radians(heading)), math.sin(math.radians(heading))]) * centre
    rest = Statics(scenario).equilibrium(0.0, losses="held").recording
    for recording in (rest, simulate(scenario)):
        place = recording.column("body_position", "hull")[-1]
        assert np.abs(place[:2] - wanted).max() < 1e-3
        sunk = TOP + 4.8 - place[2]
        assert sunk == pytest.approx(350e3 * 9.81 / (4 * 200e6) * 1.01, rel=2e-3)
