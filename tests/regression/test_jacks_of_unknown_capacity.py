"""A section of 800 t in four strand jacks was held against nothing, without a word, where none had a rating.

And one that was forgotten beside three that were rated: 190 t on it were held against nothing either. A hook
of which nothing says what it is rated for is told since long.
"""

from __future__ import annotations

from gantline.checks import Verdict, check_recording
from gantline.checks.check import Check
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from shown import ROOT, lift_on

TEXT = lift_on(ROOT / "docs" / "guides" / "several_cranes.md", "A bridge section in four strand jacks")
RATED = "rated_capacity: 300 t, "


def _check(text: str) -> Check:
    rest = Statics(parse_scenario(text)).equilibrium().recording
    [check] = [one for one in check_recording(rest) if one.name == "drum_load_of_rated_capacity"]
    return check


def test_jacks_without_a_rating_are_told() -> None:
    assert TEXT.count(RATED) == 4
    check = _check(TEXT.replace(RATED, ""))
    assert (check.verdict, check.value) == (Verdict.WARNING, None)
    assert "rated capacity not known: j1, j2, j3 and 1 more" in check.remark


def test_one_that_was_forgotten_is_told() -> None:
    check = _check(TEXT.replace(RATED, "", 1))
    assert (check.verdict, check.element) == (Verdict.WARNING, "j3")
    assert "not checked, rated capacity not known: j1" in check.remark
