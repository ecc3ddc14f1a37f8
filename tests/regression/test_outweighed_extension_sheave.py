"""A start with two extension sheaves of unequal mass asked for a lower hook, which helps nothing.

The heavier sheave runs down until the sling over the lighter one is taut between its lugs and that sheave.
Such a start is refused, and was with "the sling is 18 m, but from 'block.L3' over 'X3' to 'block.L4' it is
18.000092 m at the start; lower the hook or make the sling longer": it was the same 0.092 mm with the hook
lower by a metre, or with a longer sling.
"""

from __future__ import annotations

import pytest

import gantline
from extension_lifts import DEEP

HEAVIER = DEEP.replace("X2: {mass: 150 kg}", "X2: {mass: 250 kg}")


@pytest.mark.parametrize("height", ["26.1 m", "25.1 m"])
def test_two_extension_sheaves_of_unequal_mass_on_a_slack_sling(height: str) -> None:
    """Whatever the hook's height, what is right is equal masses, or a start at which slings pull."""
    lift = HEAVIER.replace("26.1 m", height)
    with pytest.raises(gantline.ScenarioError) as refused:
        gantline.Simulation(gantline.parse_scenario(lift))
    message = str(refused.value)
    assert "'X2' is 100 kg heavier, with what is lumped on it, and draws 'X3' up; two extension" in message
    assert "lower the hook" not in message
    gantline.Simulation(gantline.parse_scenario(lift.replace("start: rest", "start: as_given")))


def test_a_hook_too_high_is_still_told_as_that() -> None:
    """Sheaves alike, and a hook a metre too high for their slings."""
    with pytest.raises(gantline.ScenarioError, match="lower the hook or make the sling longer"):
        gantline.Simulation(gantline.parse_scenario(DEEP.replace("26.1 m", "27.3 m")))
