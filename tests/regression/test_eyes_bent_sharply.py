"""What eyes of slings bend about: `{}` said nothing, 30 mm of a rope of 44 mm were in order.

`gantline check` had no word about either. And `rope_load_of_breaking_force` of four slings that bend about
4 mm said four times that no strength is left, once for each.
"""

from __future__ import annotations

import math

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.checks import Verdict, check_recording
from gantline.scenario import ScenarioError, parse_scenario, resolve
from gantline.statics import Statics
from lift_text import changed

FACTORS = "load_factor: 1.3, consequence_factor: 1.3, material_factor: 1.5, termination_factor: 1.25"


def _with(ends: str, defaults: str = "") -> str:
    """The four slings with this of sling A, and this of all of them."""
    own = f"to: module.A, length: 8.6 m, {ends}rope: sling"
    text = changed(LIFT, ("to: module.A, length: 8.6 m, rope: sling", own))
    return changed(text, ("\nslings:", f"\n{defaults}slings:")) if defaults else text


def _told(text: str) -> list[str]:
    doubts = assemble(parse_scenario(text)).doubts
    return [one.sentence for one in doubts if "bends about" in one.sentence]


def test_an_eye_about_less_than_its_rope_is_told() -> None:
    """0027/ND rev 11, 7.8.1: 1 - 0.5/sqrt(D/d) of 30 mm over 44 mm are left."""
    left = 1.0 - 0.5 / math.sqrt(30.0 / 44.0)
    [told] = _told(_with("bends_about: {top: 30 mm}, "))
    assert told == (
        f"the top eye of A bends about 30 mm, less than the 44 mm of its rope: {100 * left:.1f} % of what it "
        "breaks at is left; rules ask for the diameter of the rope at least"
    )
    assert not _told(_with("bends_about: {top: 44 mm}, "))


def test_a_bow_thinner_than_the_rope_is_told() -> None:
    kind = "shackles: {thin: {working_load_limit: 20 t, bow_diameter: 40 mm}}\n"
    [told] = _told(_with("shackles: {bottom: thin}, ", kind))
    assert told.startswith(
        "the bottom eye of A bends about 40 mm, less than the 44 mm of its rope: 47.6 % of"
    )


def test_eyes_alike_are_told_once() -> None:
    [told] = _told(_with("", "sling_defaults: {bends_about: {top: 10 mm}}\n"))
    assert told.startswith("the top eye of A (and 3 more) bends about 10 mm")
    assert "no strength is left" in told


def test_the_check_names_them_in_one_sentence() -> None:
    text = _with("", "sling_defaults: {bends_about: {top: 10 mm}}\n")
    text = changed(text, ("rules: {", f"rules: {{{FACTORS}, "))
    rest = Statics(parse_scenario(text)).equilibrium().recording
    [check] = [one for one in check_recording(rest) if one.name == "rope_load_of_breaking_force"]
    assert check.verdict is Verdict.FAILED
    assert check.remark == ("bent so sharply that no strength is left: sling.A, sling.B, sling.C and 1 more")


@pytest.mark.parametrize("key", ["bends_about", "shackles"])
@pytest.mark.parametrize("of_all", [False, True])
def test_ends_that_say_nothing_are_refused(key: str, of_all: bool) -> None:
    text = _with("", f"sling_defaults: {{{key}: {{}}}}\n") if of_all else _with(f"{key}: {{}}, ")
    with pytest.raises(ScenarioError) as error:
        assemble(parse_scenario(text))
    [problem] = error.value.problems
    assert f"'{key}' has neither 'top' nor 'bottom' and says nothing" in problem.message


def test_a_sling_may_be_without_what_all_have() -> None:
    text = _with("bends_about: {}, ", "sling_defaults: {bends_about: {top: 300 mm}}\n")
    slings = resolve(parse_scenario(text)).slings
    assert slings["A"].bends_about == {}
    assert slings["B"].bends_about == {"top": 0.3}
