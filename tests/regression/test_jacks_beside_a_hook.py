"""Two strand jacks under one end of a load, a hook under the other: "stop if" knew of the hook alone.

Whoever watched the gauges of the jacks had no reading to compare with, since the first page had a table for
rated ones alone, and its sentence named the table "Hooks". Nothing said what the jacks were held against: a
winch beside hooks was taken for a tugger, whatever it bore.
"""

from __future__ import annotations

import re

import pytest

from gantline.checks import Verdict, check_recording
from gantline.report.first_page import FirstPage, stop_if
from gantline.report.subject import Subject
from gantline.report.winches import winch_rows
from gantline.results import Recording
from gantline.scenario import ScenarioError, parse_scenario
from gantline.statics import Statics
from jacks_and_hook import BUNDLE, LIFT, LOAD
from lift_text import changed


def _at_rest(text: str) -> Recording:
    return Statics(parse_scenario(text)).equilibrium(time=0.0).recording


@pytest.fixture(scope="module")
def unrated() -> Recording:
    """The section in two jacks of which nothing says what they are rated for, and a hook."""
    return _at_rest(LIFT)


def test_stop_if_names_both_tables(unrated: Recording) -> None:
    assert stop_if(Subject(unrated))[0] == (
        "a load cell or gauge differs by more than 10 % from its reading in the table “Hooks” or “Winches "
        "and jacks”"
    )


def test_gauges_of_jacks_have_readings(unrated: Recording) -> None:
    """Hook and jacks are 18 m to either side of the weight: half of it, two bundles to that."""
    rows, left_out = winch_rows(Subject(unrated))
    assert [(row["name"], left_out) for row in rows] == [("j1", 0), ("j2", 0)]
    for row in rows:
        assert float(row["static"]) == pytest.approx(LOAD / 4 + BUNDLE, abs=0.051)


def test_weights_are_no_sum(unrated: Recording) -> None:
    """`= static hook load 200.0 t` stood below a design weight of 400 t."""
    rows = dict(FirstPage().content(Subject(unrated))["weights"])
    assert rows["static hook load"] == f"{LOAD / 2:.1f} t"
    assert "= static hook load" not in rows


def test_jacks_without_a_rating_are_told(unrated: Recording) -> None:
    [check] = [one for one in check_recording(unrated) if one.name == "drum_load_of_rated_capacity"]
    assert (check.verdict, check.remark) == (Verdict.WARNING, "rated capacity not known: j1, j2")


def _fall(y: float, bulge: int) -> str:
    """A half turn of a rope at the load, whose weight is 16 m off its middle, or at the world above it."""
    body, x, z = ("section", -18 - 16, 2) if bulge < 0 else ("world", -18, 40)
    return (
        f"{{type: half_turn, body: {body}, enter: [{x} m, {y} m, {z} m], leave: [{x} m, {y + 1} m, {z} m], "
        f"bulge: [0, 0, {bulge}]}}"
    )


@pytest.mark.parametrize("verb", ["haul_in", "pay_out", "haul"])
def test_a_hook_is_no_drum(verb: str) -> None:
    """`'H' is not a drum; known here: 'j1', 'j2'` had no word of what moves it."""
    step = f"  - {{step: up, {verb}: H, speed: 1 m/min, by: 0.1 m}}\n"
    with pytest.raises(ScenarioError) as error:
        parse_scenario(changed(LIFT, ("plan:\n", f"plan:\n{step}")))
    told = "'H' is a hook; 'hoist' raises it, and 'lower' lets it down"
    assert error.value.problems[0].message.endswith(told)


def test_parts_of_a_tackle_count_together() -> None:
    """The weight 16 m off the middle leaves 22 t, 5.6 %, to a tackle of four parts: 1.4 % in its line."""
    route = ", ".join(
        (
            "{type: end, body: world, at: [-18 m, -1.5 m, 40 m]}",
            _fall(-1.5, -1),
            _fall(-0.5, 1),
            _fall(0.5, -1),
            "{type: end, body: world, at: [-18 m, 1.5 m, 40 m], drum: j1}",
        )
    )
    text = changed(
        re.sub(r"(?s)    j2: .*?(?=  ropes:)|    b1: .*?(?=plan:)", "", LIFT),
        (
            "  ropes:\nplan:",
            f"  ropes:\n    b1: {{rope: bundle, length: as_routed, route: [{route}]}}\nplan:",
        ),
        ("centre_of_gravity: {at: [0 m,", "centre_of_gravity: {at: [16 m,"),
        ("mass: 22.4 kg/m", "mass: none"),
    )
    rest = _at_rest(text)
    [check] = [one for one in check_recording(rest) if one.name == "drum_load_of_rated_capacity"]
    assert check.remark == "rated capacity not known: j1"


def test_a_tugger_beside_a_hook_may_do_without() -> None:
    """A rope of 380 kg that hardly reaches from a winch 60 m away bears its own half and no more."""
    hung = changed(
        LIFT,
        ("at: [18 m, 0 m, 30 m]", "at: [0 m, 0 m, 30 m]"),
        ("at: [18 m, 0 m, 4 m]", "at: [0 m, 0 m, 4 m]"),
        ("at: [-18 m, -5 m, 40 m]", "at: [-60 m, -5 m, 4 m]"),
        ("at: [-18 m, 5 m, 40 m]", "at: [-60 m, 5 m, 4 m]"),
    )
    rest = _at_rest(hung)
    assert "drum_load_of_rated_capacity" not in {one.name for one in check_recording(rest)}
    assert winch_rows(Subject(rest)) == ([], 0)
