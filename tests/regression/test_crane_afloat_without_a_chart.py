"""A crane afloat with a rated capacity and no chart leaned across its boom by 2.1 deg, without a word.

`stands_level` went through charts, to tell of those that say nothing of heel or trim; a crane that has none
says nothing either. A crawler crane without a chart is told since long.
"""

from __future__ import annotations

import re

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from lift_text import changed


@pytest.mark.parametrize(("aside", "is_told"), [(1.6, True), (0.6, False)])
def test_what_pulls_across_a_boom_is_told(aside: float, is_told: bool) -> None:
    """`revolving_crane` without its chart and with its ballast aside [m]; a heel of 1.15 deg is 2 %."""
    text = re.sub(r"    rating:\n(      .*\n)+", "", gantline.load_scenario("revolving_crane").text)
    text = changed(text, ("4380 t, at: [46.6 m, 0 m", f"4380 t, at: [46.6 m, {aside} m"))
    rest = gantline.Statics(gantline.parse_scenario(text)).equilibrium(560.0).recording
    assert not rest.rig.rating_charts
    found = [one for one in check_recording(rest) if one.name == "stands_level"]
    heel = abs(float(rest.column("vessel_heel", "barge")[-1]))
    assert (heel > 0.02) is is_told
    assert [(one.element, one.verdict) for one in found] == [("rc", Verdict.WARNING)] * is_told
    for one in found:
        assert f"across its boom by {heel * 57.29578:.2f} deg" in one.remark
        assert "'heel' of a rating, which it has not, says what is allowed" in one.remark
