"""A transformer that two tuggers drag over a deck without friction: "its friction … find no balance".

`gantline statics --steps` had no equilibrium at 50 % of a step that pumps, "its friction and what that
holds find no balance (on_grillage/8)", below the words that contacts are without friction there. What did
not settle were the tuggers that keep the pull of its tag lines; the contact was the first of those that
nobody had asked.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import load_scenario
from gantline.statics import NoEquilibriumError, Statics

LIFT = Path(__file__).with_name("tuggers_without_balance.yaml")


def test_the_drum_that_does_not_settle_is_named() -> None:
    """Without its tag lines, and with pulls of half as much, the lift has an equilibrium then."""
    with pytest.raises(NoEquilibriumError) as found:
        Statics(load_scenario(LIFT)).equilibrium(716.0)
    assert found.value.cause == "its motor or brake and what pulls at the drum find no balance"
    assert found.value.element in {"tag.one.tugger", "tag.two.tugger"}
