"""Sixteen slings of a gate were `too short: lower the hook`, and the crane stood 17 m beside it.

Slings that do not reach at the start were told by their lengths alone. Where the hook stands beside the
middle of the lugs that it bears by more than they lack, that is told with the way: a heading, a sign or an
outreach is wrong, and no hook has to come lower."""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from spreader_lifts import one_bar


def refused(text: str) -> str:
    with pytest.raises(gantline.ScenarioError) as caught:
        assemble(parse_scenario(text))
    return str(caught.value)


def test_the_way_to_the_lugs_is_told() -> None:
    """Lugs lie around x = 0, y = 0: with the hook at (3, -2) m they are 3.61 m away."""
    said = refused(LIFT.replace("at: [0 m, 0 m, 11 m]", "at: [3 m, -2 m, 11 m]"))
    beside = "crane stands 3.61 m beside the middle of its lugs"
    way = f"{beside}: from it they are 3.00 m along −x and 2.00 m along +y"
    assert f"{way}; lower the hook or make the sling longer" in said


def test_a_hook_that_is_too_high_is_told_as_that() -> None:
    said = refused(LIFT.replace("at: [0 m, 0 m, 11 m]", "at: [0.2 m, 0 m, 14 m]"))
    assert "lower the hook or make the sling longer" in said
    assert "beside" not in said


def test_a_hook_above_a_bar_is_told_by_the_lugs_of_the_load() -> None:
    """Between hook and lugs hangs a bar, whose place follows from its slings."""
    text = one_bar()
    at = "at: [0 m, 0 m, "
    assert at in text
    said = refused(text.replace(at, "at: [9 m, 0 m, ", 1))
    assert "hook stands 9.00 m beside the middle of its lugs: from it they are 9.00 m along −x" in said


def test_where_no_height_helps_the_way_stands_last() -> None:
    said = refused(LIFT.replace("at: [0 m, 0 m, 11 m]", "at: [0 m, 20 m, 11 m]"))
    way = "crane stands 20.00 m beside the middle of its lugs: from it they are 20.00 m along −y"
    assert f"which no height of the hook makes up; put crane, boom or load elsewhere: {way}" in said
