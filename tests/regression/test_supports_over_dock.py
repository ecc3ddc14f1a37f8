"""Supports in a dock whose `foot` was forgotten.

They stood at the level of the ground, in the air over a floor 9 m below. A load was set down on them there,
they bore it, and the lift was GO.
"""

from __future__ import annotations

import math

import pytest

import gantline
from four_slings import LIFT
from gantline.scenario import parse_scenario


def lift(group: str, heading: float = 0.0, low: float = 40.0) -> str:
    """A module on the ground at (2, 1) m, supports in the yard, and a dock that begins `low` m along x."""
    dock = f"structures: {{dock: {{type: dock, x: [{low} m, 90 m], y: [-50 m, 50 m], floor: -9 m}}}}\n"
    supports = f"supports: {{stools: {{under: module, height: 50 mm, {group}}}}}\n"
    text = LIFT.replace("load:\n", f"{dock}{supports}load:\n", 1)
    stands = "  stands_on: ground\n"
    return text.replace(stands, f"{stands}  position: [2 m, 1 m, 0 m]\n  heading: {heading} deg\n")


WORLD = "measured_from: world, grid: {x: [41 m, 45 m], y: [-1 m, 1 m]}"


def test_supports_in_the_world_over_a_dock_are_refused() -> None:
    with pytest.raises(gantline.ScenarioError) as caught:
        parse_scenario(lift(WORLD))
    said = str(caught.value)
    assert "supports.stools: 'stools.1.1' at (41.00, -1.00) m is over the dock" in said
    assert "'foot: -9 m' puts it onto the floor" in said


def test_with_a_foot_they_stand_on_the_floor() -> None:
    supports = parse_scenario(lift(f"{WORLD}, foot: -9 m")).supports or {}
    assert supports["stools"].foot == -9.0


@pytest.mark.parametrize("heading", [0.0, 90.0])
def test_places_on_the_load_go_with_it(heading: float) -> None:
    """A place 1.5 m along x of the load is at x = 2 + 1.5 cos(heading) in the world."""
    x = 2.0 + 1.5 * math.cos(math.radians(heading))
    group = "places: {p: {at: [1.5 m, 0 m]}}"
    parse_scenario(lift(group, heading, low=x + 0.01))
    with pytest.raises(gantline.ScenarioError, match="is over the dock"):
        parse_scenario(lift(group, heading, low=x - 0.01))
