"""A crane with a boom whose rating chart was left out of the lift file.

The chart of one of two crawler cranes was gone, and so was the check of that crane: the other one passed, and
the lift was GO, without a word of the crane of which nothing said what it may lift at its radius.
"""

from __future__ import annotations

from typing import Any

import pytest

from gantline.checks import Check, Verdict
from gantline.results.recording import Recording
from of_recording import check_of
from rated_lift import RATED, recording

#: 100 t in each hook at 16 m, where the chart has 231 t, and two cranes keep back 1.2.
LOAD, ROW, KEPT = 100.0, 231.0, 1.2
FACTORS = {"several_cranes_factor": {"value": KEPT, "source": "example"}}
#: A boom that luffs [rad].
LUFFS = (0.5, 1.4)


def checked(charts: list[str], booms: list[dict[str, Any]], **rig: Any) -> Check:
    """`hoist_load_of_rating` of cranes c1 and c2 with one hook each, of which only some have a chart."""
    both = recording([[16.0, 16.0]] * 2, [[LOAD, LOAD]] * 2, cranes=("c1", "c2"), factors=FACTORS)
    given = both.attributes["rig"]
    kept = [chart for chart in given["rating_charts"] if chart["crane"] in charts]
    changed = {**given, "rating_charts": kept, "booms": booms, **rig}
    of = Recording(both.variables, both.coordinates, {**both.attributes, "rig": changed})
    return check_of(of, "hoist_load_of_rating")


def test_one_of_two_cranes_has_none() -> None:
    """The other uses 1.2 x 100 / 231 of its own, which is no more than a warning now."""
    found = checked(["c1"], [{"name": "c1"}, {"name": "c2", "range": LUFFS}])
    assert found.value == pytest.approx(KEPT * LOAD / ROW)
    assert found.verdict is Verdict.WARNING
    assert found.remark == "not checked, no rating chart: c2"


def test_none_has_one() -> None:
    found = checked([], [{"name": "c1"}, {"name": "c2"}])
    assert found.verdict is Verdict.NOT_CHECKED
    assert found.remark == "no rating chart: c1, c2"


@pytest.mark.parametrize(("luffs", "verdict"), [(None, Verdict.OK), (LUFFS, Verdict.WARNING)])
def test_one_number_is_enough_for_a_boom_that_keeps_its_angle(luffs: Any, verdict: Verdict) -> None:
    """Where it luffs, what is rated goes with the radius, and one number does not say it."""
    rating = {"name": "c2", "level": "crane", "hooks": ["H1"], "rated_capacity": RATED[2]}
    booms = [{"name": "c1"}, {"name": "c2", "range": luffs}]
    assert checked(["c1"], booms, ratings=[rating]).verdict is verdict
    unsaid = checked(["c1"], booms, ratings=[{**rating, "rated_capacity": None}])
    assert unsaid.remark == "not checked, no rating chart: c2"


def test_a_crane_from_which_nothing_hangs_needs_none() -> None:
    assert checked(["c1", "c2"], [{"name": "c1"}, {"name": "c2"}, {"name": "c3"}]).verdict is Verdict.OK
