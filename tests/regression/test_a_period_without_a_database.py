"""`added_mass: {period: 6 s}` of a vessel was told that a period is for a database, and nothing to do."""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, load_scenario


def test_it_is_said_what_there_is_without_one() -> None:
    with pytest.raises(ScenarioError) as caught:
        load_scenario("revolving_crane").changed({"vessels.barge.added_mass": {"period": "6 s"}})
    said = (
        "'period' is for a 'database'; without one each motion has its own number, surge, sway, heave, roll"
    )
    assert said in str(caught.value)
