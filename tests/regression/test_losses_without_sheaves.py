"""Losses of sheaves in an equalizer that is approximated were left out without a word.

The lift `mechanisms` with `efficiency: 0.98` came to the same tensions to the last bit as without losses, in
order. The page on older mechanisms says that they are left out; whoever compares mechanisms looks at a lift
file with losses, and finds a spread in one of them alone.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario
from gantline.scenario.errors import Problem

FIXED, MOVING = "equalizers.e1.fixed_sheaves", "equalizers.e1.moving_sheaves"


def told(lift: str, changed: Mapping[str, object]) -> list[Problem]:
    scenario = load_scenario(lift)
    doubts = assemble(scenario.changed(changed) if changed else scenario).doubts
    return [one for one in doubts if "approximated" in one.sentence]


def test_losses_are_told_with_their_place_and_how_large_they_are() -> None:
    """An efficiency of 0.98 loses 2 %; the line is that of the fixed sheaves."""
    [found] = told("mechanisms", {f"{FIXED}.efficiency": 0.98})
    lines = load_scenario("mechanisms").text.splitlines()
    assert (found.path, lines[(found.line or 0) - 1].split()[0]) == (FIXED, "fixed_sheaves:")
    assert "what its fixed sheaves lose, 2 % of the tension at each, is left out" in found.sentence


def test_each_place_is_told_once() -> None:
    both = {f"{FIXED}.efficiency": 0.98, f"{MOVING}.efficiency": 0.96}
    assert [one.path for one in told("mechanisms", both)] == [FIXED, MOVING]


def test_a_groove_loses_as_much_as_its_rope_holds_about_half_a_turn() -> None:
    """1 - exp(-mu pi) with mu = 0.1, 27.0 %, where the bearing would hold 40 %."""
    losses = {
        "ropes.equalizing.mass": "9 kg/m",
        f"{FIXED}.groove_friction": 0.1,
        f"{FIXED}.efficiency": 0.6,
        f"{FIXED}.rotating_mass": "150 kg",
    }
    [found] = told("mechanisms", losses)
    assert f"{100 * (1 - math.exp(-0.1 * math.pi)):.3g} %" in found.sentence


@pytest.mark.parametrize("lift", ["mechanisms", "equalizer"])
def test_nothing_is_said_without_losses(lift: str) -> None:
    assert told(lift, {}) == []


def test_nothing_is_said_of_sheaves_that_have_them() -> None:
    assert told("equalizer", {f"{FIXED}.efficiency": 0.98}) == []
