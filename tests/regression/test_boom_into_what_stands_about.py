"""A crane luffed its boom down into the ship before it, or into a tower of `mechanics`: nothing was said.

Cranes were held against no hull, since what stands on one is rough about where it stands, and against nothing
that `mechanics` draws.
"""

from __future__ import annotations

import pytest

import gantline
from crawler_lift import AHEAD, HEEL, LENGTH, crawler_lift
from gantline.checks import Verdict
from gantline.scenario import parse_scenario
from of_recording import checks_of

#: A ship of box shape, 20 m above the water at the level of the ground, from 18 m before the crane on.
SHIP = """\
vessels:
  ship:
    position: [-17 m, 28 m]
    draft: 4 m
    hull: {box: [40 m, 24 m, 24 m]}
    masses: {hull: {mass: 3936 t, at: [20 m, 0 m, 8 m]}}
    radii_of_gyration: [8 m, 12 m, 12 m]
"""
#: A tower of 20 m in the same place.
TOWER = "    tower: {at: [3 m, 18 m, 0 m], joint: {type: fixed}, shape: {box: [4 m, 4 m, 40 m]}}\n"
PLAN = "{step: down, luff: c1, speed: 30 deg/min, to: ANGLE deg}\n{step: rest, hold: until_end}"


def told(angle: float, more: str, body: str) -> dict[frozenset[str], Verdict]:
    """What is said of a crane that luffs to an angle [deg]; its axis is at (3, -2) m, its boom to port."""
    lift = crawler_lift(20e3, PLAN.replace("ANGLE", str(angle)), duration=150.0, more=more, sample=0.2)
    quick = lift.replace("speed: 3 deg/min, acceleration: 0.02", "speed: 30 deg/min, acceleration: 0.2")
    recording = gantline.simulate(parse_scenario(quick.replace("  bodies:\n", f"  bodies:\n{body}")))
    return {frozenset(one.element.split(" to ")): one.verdict for one in checks_of(recording, "no_overlap")}


@pytest.mark.parametrize(
    ("more", "body", "name"), [(SHIP, "", "ship"), ("", TOWER, "tower")], ids=["ship", "tower"]
)
@pytest.mark.parametrize(("angle", "verdict"), [(60.0, None), (40.0, Verdict.FAILED)], ids=str)
def test_a_boom_in_what_stands_before_the_crane(
    more: str, body: str, name: str, angle: float, verdict: Verdict | None
) -> None:
    """18 m before its axis its middle is 2.5 m + 16.4 m tan θ high: 30.9 m at 60 deg, 16.3 m at 40 deg."""
    assert (AHEAD, HEEL, LENGTH) == (1.6, 2.5, 63.0)
    found = told(angle, more, body)
    assert found.get(frozenset({"c1.boom", name})) is verdict
