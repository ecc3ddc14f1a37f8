"""A hook block that swung into another crane's boom, or was lowered into a wall or deck: nothing was said.

Hook blocks were held against the load and each other alone. That the falls above went through the boom was a
warning, and where they did not, as where the hook block only just comes below the boom, not even that.
"""

from __future__ import annotations

import pytest

import gantline
from crawler_lift import crawler_lift
from gantline.checks import Verdict
from gantline.scenario import parse_scenario
from module_lift import module_lift
from of_recording import checks_of
from swung_crane import BOOM_HEIGHT, swung


@pytest.mark.parametrize(("below", "is_hit"), [(0.0, True), (12.0, False)], ids=str)
def test_a_hook_block_in_the_boom_of_another_crane(below: float, is_hit: bool) -> None:
    """In the middle of it, and 12 m below.

    Upright the boom goes 3 % of 63 m/2 over cos θ, 0.2286, to each side of its middle, 4.1 m, which 0.35 m of
    half a hook block times tan θ raise to 5.6 m; the hook block is 2 m high.
    """
    found = checks_of(gantline.simulate(parse_scenario(swung(100.0, BOOM_HEIGHT - below))), "no_overlap")
    hits = [one.verdict for one in found if one.element == "c1.boom to c2.H"]
    assert hits == ([Verdict.FAILED] if is_hit else [])


@pytest.mark.parametrize(("top", "is_hit"), [(14.0, True), (6.0, False)], ids=str)
def test_a_hook_block_in_a_wall(top: float, is_hit: bool) -> None:
    """From 30 m down by 20 m, over a wall 16 m to port of the crane at (3, -2) m: the hook comes to 10 m."""
    wall = f"structures:\n  wall: {{type: box, x: [0 m, 6 m], y: [12 m, 16 m], z: [0 m, {top} m]}}\n"
    plan = "{step: down, lower: c1.H, speed: 6 m/min, by: 20 m}\n{step: rest, hold: until_end}"
    lift = crawler_lift(60e3, plan, duration=230.0, more=wall, sample=0.2)
    found = checks_of(gantline.simulate(parse_scenario(lift)), "no_overlap")
    told = [(one.element, one.verdict) for one in found]
    assert told == ([("c1.H to wall", Verdict.FAILED)] if is_hit else [])


@pytest.mark.parametrize(("by", "is_hit"), [(18.5, True), (17.5, False)], ids=str)
def test_a_hook_in_a_deck(by: float, is_hit: bool) -> None:
    """From 20 m over the water down to half a metre below the deck, which is 2 m up, or as much above it."""
    lift = module_lift(by, place=(20.0, 12.0), speed=30.0, duration=45.0)
    found = checks_of(gantline.simulate(parse_scenario(lift)), "no_overlap")
    hits = [one.verdict for one in found if one.element == "barge to hook"]
    assert hits == ([Verdict.FAILED] if is_hit else [])
