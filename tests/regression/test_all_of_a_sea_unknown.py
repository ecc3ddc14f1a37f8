"""A sea all of whose waves are shorter than a database knows had "1e+02 % of the energy" in them."""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, load_scenario


def test_the_whole_is_a_hundred_per_cent() -> None:
    short = {"waves.swell.peak_period": "2 s", "waves.swell.significant_height": "0.1 m"}
    with pytest.raises(
        ScenarioError, match=r"crane_barge\.nc: 100 % of the energy of swell is in waves shorter"
    ):
        assemble(load_scenario("crane_barge_in_swell").changed(short))
