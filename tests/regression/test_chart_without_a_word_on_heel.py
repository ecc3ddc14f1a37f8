"""A crane afloat heeled under load by 3.4 deg across its boom, and nothing of its attitude was past anything.

A chart that says within what heel it holds is held against that. Of one that says nothing the attitude was
that of the falls alone, `ok` at 8 %: falls hang plumb, so a side-lead of 0.03 deg was all that the checks saw
of 5.9 % of the load that pulls across the boom. A crawler crane that leans by 0.57 deg is told since long.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from gantline.results.recording import Recording

#: Over the deck, with its boom along the barge [s].
OVER_THE_DECK = 560.0


def _lift(aside: float, chart: str) -> Recording:
    """`revolving_crane` with its ballast aside [m], at rest; its chart says `chart` of heel and trim."""
    given = gantline.load_scenario("revolving_crane")
    said = "      heel: 3 deg\n      trim: 3 deg\n"
    place = "ballast:       {mass: 4380 t, at: [46.6 m, 0 m, 1.4 m]}"
    assert given.text.count(said) == given.text.count(place) == 1
    text = given.text.replace(said, chart).replace(place, place.replace("46.6 m, 0 m", f"46.6 m, {aside} m"))
    lift = gantline.parse_scenario(text)
    return gantline.Statics(lift).equilibrium(OVER_THE_DECK).recording


@pytest.mark.parametrize(("aside", "is_told"), [(1.6, True), (0.6, False)])
def test_what_pulls_across_a_boom_is_told(aside: float, is_told: bool) -> None:
    """A heel of 1.15 deg is 2 %; tan of the heel, for the falls hang plumb."""
    rest = _lift(aside, "")
    found = [one for one in check_recording(rest) if one.name == "stands_level"]
    heel = abs(float(rest.column("vessel_heel", "barge")[-1]))
    assert (heel > 0.02) is is_told
    assert [one.verdict for one in found] == [Verdict.WARNING] * is_told
    for one in found:
        assert one.element == "rc"
        assert f"across its boom by {heel * 57.29578:.2f} deg" in one.remark


def test_a_chart_that_says_so_is_held_against_that() -> None:
    rest = _lift(1.6, "      heel: 2 deg\n      trim: 3 deg\n")
    found = {one.name: one for one in check_recording(rest)}
    assert "stands_level" not in found
    assert found["attitude_of_rating"].verdict is Verdict.FAILED
