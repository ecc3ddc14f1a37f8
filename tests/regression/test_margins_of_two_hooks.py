"""Margins of a load on two hooks went past the rated capacity of one of them.

42 t by design hang in hooks 5 m apart, of which one is rated for 25 t. `--margins` said that their centre of
gravity may be 2.5 m elsewhere, as far as the lugs, where the slings of the other hook go slack: the hook of
25 t bears all 42 t then.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study import Margin, margins_of
from lift_text import changed

_APART, _DESIGN, _RATED = 5.0, 40.0 * 1.05, 25.0
_HOIST = "{speed: 3 m/min, acceleration: 0.05 m/s^2}"
_LIFT = f"""\
format: 1
lift: {{title: A module on two hooks}}
duration: 10 s
ropes:
  thick: {{axial_stiffness: 100 MN, minimum_breaking_force: 4 MN, diameter: 60 mm, mass: none}}
load:
  name: module
  shape: {{box: [6 m, 4 m, 3 m]}}
  position: [0 m, 0 m, 1 m]
  weight: {{calculated: 40 t, contingency: 1.05}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  lugs:
    A: {{at: [-2.5 m,  1.5 m, 3 m]}}
    B: {{at: [ 2.5 m,  1.5 m, 3 m]}}
    C: {{at: [-2.5 m, -1.5 m, 3 m]}}
    D: {{at: [ 2.5 m, -1.5 m, 3 m]}}
cranes:
  west: {{type: fixed_hook, at: [-2.5 m, 0 m, 12 m], rated_capacity: 60 t, hoist: {_HOIST}}}
  east: {{type: fixed_hook, at: [ 2.5 m, 0 m, 12 m], rated_capacity: {_RATED} t, hoist: {_HOIST}}}
sling_defaults: {{rope: thick, length: 8.141 m}}
slings:
  A: {{from: west, to: module.A}}
  B: {{from: east, to: module.B}}
  C: {{from: west, to: module.C}}
  D: {{from: east, to: module.D}}
plan:
  - {{step: hold, hold: until_end}}
"""


def _margins(text: str) -> dict[str, Margin]:
    scenario = parse_scenario(text, "lift.yaml")
    return {one.direction: one for one in margins_of(scenario, Statics(scenario).equilibrium())}


def test_the_hook_that_bears_more_ends_them() -> None:
    """By moments about the west hook, east bears W (1/2 + x/a), and comes to its capacity R there:

    x = a (R/W - 1/2) = 5 m (25/42 - 1/2) = 0.476 m.
    """
    found = _margins(_LIFT)
    # To the millimetre to which margins are searched, and slings that stretch by 4 mm tilt the load.
    assert found["+x"].distance == pytest.approx(_APART * (_RATED / _DESIGN - 0.5), abs=2e-3)
    assert found["+x"].cause == "hoist_load_of_rated_capacity of east fails its limit of 100.0 %"
    assert found["−x"].distance == pytest.approx(_APART / 2, abs=0.1)  # the lugs
    assert found["−x"].cause == "B, D slack"


def test_what_fails_as_planned_ends_them_as_it_gets_worse() -> None:
    """A hook of 20 t that bears 21 t as planned: nothing towards it, until slings are slack away from it."""
    found = _margins(changed(_LIFT, (f"{_RATED} t", "20 t")))
    # A margin of 2 mm, to where it is a thousandth more, would read as if that much were in order.
    assert found["+x"].distance == 0.0
    failed = "hoist_load_of_rated_capacity of east fails its limit of 100.0 %"
    assert found["+x"].cause == f"{failed} as planned, and by more"
    assert found["−x"].cause == "B, D slack"
