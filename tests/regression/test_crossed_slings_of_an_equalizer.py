"""Slings of an equalizer that cross were in order, and the lift a go.

A ship block under a Goliath crane hung by two equalizers of two sheaves each, along the rails. Their frames
had heading 90 deg, and the slings went in the order of the lugs, from +y to −y: each pair crossed.
`gantline check` found nothing, the run ended in GO WITH WARNINGS, and statics called it stable, since the
hinges had 2 kN m of friction: a frame that stands exactly the wrong way round is pushed by nothing. Half a
degree beside that it turns round.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import gantline
from gantline.assembly.assemble import assemble
from gantline.scenario import parse_scenario

#: Sheaves at ±1.5 m along the frame, lugs at ±2 m across the load, some 9.5 m below them.
LIFT = """
format: 1
lift: {title: Two slings below an equalizer}
duration: 40 s
ground: {level: 0 m, friction: 0.5, stiffness: 100 MN/m, damping: 1 MN s/m}
ropes: {rope: {axial_stiffness: 60 MN, damping_time: 20 ms, minimum_breaking_force: 1 MN, mass: none}}
load:
  name: module
  shape: {box: [6 m, 6 m, 2 m]}
  weight: {calculated: 20 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  stands_on: ground
  lugs:
    N: {at: [0 m,  2 m, 2 m], capacity: 30 t}
    S: {at: [0 m, -2 m, 2 m], capacity: 30 t}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 16 m]
    rated_capacity: 40 t
    hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}
equalizers:
  e:
    hangs_from: hook
    heading: 90 deg
    frame: {mass: 2 t, length: 4 m, width: 1 m, height: 2 m, centre_of_gravity_below_hook: 2 m}
    hinge: {friction: 0 kN m}
    rope: rope
    rope_ends: {along: [-2 m, 2 m], below_hook: 3 m}
    fixed_sheaves: {along: [0 m], below_hook: 3 m, pitch_diameter: 0.8 m}
    moving_sheaves: {along: [-1.5 m, 1.5 m], below_hook: 4.5 m, pitch_diameter: 0.8 m, mass: 100 kg}
    travel: {up: 1 m, down: 1 m}
slings:
  N: {from: e.2, to: module.N, length: 10.3 m, rope: rope}
  S: {from: e.1, to: module.S, length: 10.3 m, rope: rope}
plan:
  - {step: off, hoist: hook, speed: 3 m/min, by: 1.2 m}
  - {step: hold, hold: until_end}
"""
CROSSED = LIFT.replace("from: e.2", "from: e.9").replace("from: e.1", "from: e.2").replace("e.9", "e.1")


def told(text: str) -> list[str]:
    return [one for one in assemble(parse_scenario(text)).warnings if "cross" in one]


def test_crossed_slings_are_told_with_the_heading_that_is_right() -> None:
    """With r = ∓1.5 m and l = ±2 m, Σ r · l = −6 m², and 90 deg + 180 deg is where they lead."""
    assert told(LIFT) == []
    [sentence] = told(CROSSED)
    assert "N and S cross: their frame stands 180 deg from where they lead" in sentence
    assert "write 'heading: 270 deg'" in sentence
    assert told(CROSSED.replace("heading: 90 deg", "heading: 270 deg")) == []
    heavy = CROSSED.replace("mass: none", "mass: 5 kg/m").replace("rope: rope}", "rope: rope, NODES}")
    nodes = "rope_weight: distributed, rope_nodes: 3"
    assert told(heavy.replace("NODES", nodes)) == [sentence]


@pytest.mark.parametrize(("heading", "count"), [(350, 0), (30, 1), (150, 1), (200, 0)])
def test_slings_that_are_askew_and_do_not_cross_are_not_told(heading: int, count: int) -> None:
    """The paper's lift has them: they cross where the frame is more than 90 deg from 270 deg."""
    assert len(told(CROSSED.replace("heading: 90 deg", f"heading: {heading} deg"))) == count


def test_a_hinge_that_holds_the_frame_is_not_told() -> None:
    """20 t x 9.81 m/s² x 1.5 m = 294 kN m is more than slings can turn it with."""
    assert told(CROSSED.replace("friction: 0 kN m", "friction: 300 kN m")) == []
    assert len(told(CROSSED.replace("friction: 0 kN m", "friction: 2 kN m"))) == 1


def test_half_a_degree_beside_it_the_frame_turns_round() -> None:
    """Its stiffness is −(V/h) 6 m² there, which leads to 270 deg: it passes that, and swings about it."""
    run = gantline.simulate(parse_scenario(CROSSED.replace("heading: 90 deg", "heading: 90.5 deg")))
    heading = np.degrees(run.column("joint_position", "e"))
    assert math.isclose(heading[0], 90.5, abs_tol=1e-6)
    assert heading.max() > 270.0
