"""A body that could turn about a line on which all of its mass was failed in its first step.

A ball joint with the centre of gravity straight below it and no `inertia` was refused, by name and with what
is missing. With the centre of gravity aside as well, every axis of the body has some inertia and the line to
the centre none: the run ended as singular, and at rest "no step brings its forces closer to balance".
"""

from __future__ import annotations

import math

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import Simulation

SENTENCE = "it has no inertia in a direction that it can move: give it mass or inertia"


def lift(centre: str, start: str, inertia: str = "") -> str:
    return f"""
format: 1
lift: {{title: A bob on a ball joint}}
duration: 1 s
start: {start}
mechanics:
  bodies:
    bob: {{at: [5 m, 0 m, 61.3 m], joint: {{type: ball}}, mass: 2.7 t, centre_of_gravity: {centre}{inertia}}}
"""


@pytest.mark.parametrize("start", ["rest", "as_given"])
@pytest.mark.parametrize("centre", ["[0 m, 0 m, -1.1 m]", "[0.3 m, 0.7 m, -1.1 m]"])
def test_it_is_told_what_is_missing(centre: str, start: str) -> None:
    with pytest.raises(ScenarioError, match=SENTENCE) as caught:
        Simulation(parse_scenario(lift(centre, start)))
    assert "mechanics.bodies.bob" in str(caught.value)


def test_with_inertia_it_hangs_plumb() -> None:
    """Its centre of gravity is at rest as far below the joint as it is from it."""
    inertia = ", inertia: {xx: 1 t m^2, yy: 1 t m^2, zz: 1 t m^2}"
    run = Simulation(parse_scenario(lift("[0.3 m, 0.7 m, -1.1 m]", "rest", inertia)))
    run.run()
    height = run.recording()["body_position"].values[-1, 0, 2]
    assert height == pytest.approx(61.3 - math.hypot(0.3, 0.7, 1.1), abs=1e-6)
