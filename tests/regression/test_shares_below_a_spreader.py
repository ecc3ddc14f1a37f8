"""Shares of slings above and below a spreader.

The column `of the mean` of `gantline statics` had one mean of all slings. Those above a spreader carry the
spreader too and lean inwards: of a frame in four slings, with a module in four more below it, they had 1.08
and 1.15 of that mean, and those below 0.85 and 0.91; it is 0.97 and 1.03 of each four.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.results import series


def test_shares_are_of_slings_that_hang_alike() -> None:
    """Two slings above the bar add up to 2, four below it to 4; each by its own tension."""
    rest = gantline.Statics(gantline.load_scenario("spreader_bar")).equilibrium()
    shares = series.of_the_mean(rest.recording)
    assert set(shares) == {"T1", "T2", "NW", "SW", "NE", "SE"}
    for names in (("T1", "T2"), ("NW", "SW", "NE", "SE")):
        tensions = {name: rest.tension(f"sling.{name}") for name in names}
        mean = sum(tensions.values()) / len(names)
        assert {name: shares[name] for name in names} == pytest.approx(
            {name: tension / mean for name, tension in tensions.items()}, rel=1e-12
        )


def test_slack_slings_below_do_not_lower_the_mean_above() -> None:
    """At the start the bar hangs in two slings, whose shares were 3 with four that are slack."""
    rest = gantline.Statics(gantline.load_scenario("spreader_bar")).equilibrium(0.0)
    shares = series.of_the_mean(rest.recording)
    assert [shares[name] for name in ("T1", "T2")] == pytest.approx([1.0, 1.0], rel=1e-3)
    assert [shares[name] for name in ("NW", "SW", "NE", "SE")] == [None] * 4
