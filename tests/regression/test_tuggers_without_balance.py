"""A transformer that two tuggers drag over a deck without friction: "its friction … find no balance".

`gantline statics --steps` had no equilibrium at 50 % of a step that pumps, "its friction and what that
holds find no balance (on_grillage/8)", below the words that contacts are without friction there. Then it
named a tugger, after 15 s and 100 000 steps. Neither was at fault: without friction the transformer slides
off the edge of its grillage, where the places at which it touches change to and fro from step to step, until
the 500 steps of a search are used up. That drums are out of balance where a search is stuck was taken for one
that stands at the joint of two pieces of its rope, and 200 such searches were made on end; the tuggers lay
within a piece each.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import load_scenario
from gantline.statics import NoEquilibriumError, Statics

LIFT = Path(__file__).with_name("tuggers_without_balance.yaml")


def test_what_slides_is_named() -> None:
    """Without its tag lines, and with pulls of half as much, the lift has an equilibrium then."""
    statics = Statics(load_scenario(LIFT))
    with pytest.raises(NoEquilibriumError) as found:
        statics.equilibrium(716.0)
    assert found.value.element == "transformer"
    assert found.value.cause == (
        "it slides over what it stands on, which without friction does not hold it, "
        "to where no step brings its forces closer to balance"
    )
