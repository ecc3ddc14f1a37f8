"""A lift has equilibria at its own times alone."""

from __future__ import annotations

import pytest

from gantline.statics import Statics


@pytest.mark.parametrize("beyond", [-1.0, 0.5, 1e9, float("nan")], ids=["before", "after", "far", "none"])
def test_a_time_outside_of_the_lift_is_refused(beyond: float) -> None:
    question = Statics("equalizer")
    moment = beyond if beyond < 0.0 else question.scenario.duration + beyond
    with pytest.raises(ValueError, match=r"is no time of the lift, which lasts from 0 s to \d+ s"):
        question.equilibrium(moment)
