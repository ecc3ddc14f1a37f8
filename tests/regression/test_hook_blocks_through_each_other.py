"""The hook block of an auxiliary hook went up through that of the main hook without a word.

What belongs to one crane was not held against itself, its hook blocks neither. Both hang at one boom here,
and the auxiliary is hoisted past the level of the main hook, which stays at 30 m, up to 34 m.
"""

from __future__ import annotations

import pytest

import gantline
from crawler_lift import crawler_lift
from gantline.checks import Check, Verdict
from gantline.scenario import parse_scenario
from of_recording import checks_of


def hoisted_past(along: float) -> list[Check]:
    """What is said of things in the same place, with an auxiliary hook so far out from the main hook [m]."""
    plan = "{step: up, hoist: c1.A, speed: 6 m/min, to: 34 m}\n{step: rest, hold: until_end}"
    hooks = f"      A: {{type: H, along: {along} m, height: 26 m}}\n"
    text = crawler_lift(60e3, plan, duration=100.0)
    main = "      H: {type: H, height: 30 m}\n"
    recording = gantline.simulate(parse_scenario(text.replace(main, main + hooks)))
    return checks_of(recording, "no_overlap")


def test_hook_blocks_of_one_crane_that_go_through_each_other_are_told() -> None:
    """A jib of 0.3 m is 0.07 m farther out at 76.8 deg; hook blocks are drawn 0.35 m wide, half a sheave."""
    found = hoisted_past(0.3)
    assert [one.verdict for one in found] == [Verdict.FAILED]
    assert "c1.H" in found[0].element + found[0].remark
    assert "c1.A" in found[0].element + found[0].remark


@pytest.mark.parametrize("along", [3.0, 6.0])
def test_nothing_is_said_of_hook_blocks_that_pass_each_other(along: float) -> None:
    """0.69 m and 1.37 m farther out."""
    assert hoisted_past(along) == []
