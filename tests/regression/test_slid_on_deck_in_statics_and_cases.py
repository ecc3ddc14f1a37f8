"""A load set down on a deck: `statics` and `cases` were NO-GO for its sliding, without a word that it slides.

A transformer had been set down on a barge, its slings slack, and the run was in order there. Contacts are
without friction in statics unless they are asked for with it: it slid 5 m until its slings held it, with 44 %
of its weight in them and its falls 7 degrees out of plumb. `statics --steps` told of it; `statics` alone,
`cases` and the report with these cases had what failed, and no word on why.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from gantline import open_recording
from gantline.report.first_page import FirstPage
from gantline.report.rest import Rest
from gantline.report.subject import Subject
from gantline.results.file.saved import Beside, SavedCases
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study import run_cases
from lift_text import changed
from onto_a_deck import onto_a_deck
from sample_lift import ringing_lift, sample_rig
from verbs import gantline

_FAILS = "box stands where a check fails, free to slide"
_HOLDS = "has friction hold what it can"


def _lift(friction: str) -> str:
    """A box set down on a deck that leans by 3 degrees, less than friction of 0.3 holds, atan 0.3 = 16.7 deg.

    The hook ends 6.8 m up and lugs of the box 2 m, 4.8 m below it: a sling of 5 m is slack where it stands,
    and aslant by about acos(4.8/5) = 16 deg where it is taut.
    """
    return changed(
        onto_a_deck("  - {step: down, lower: hook, speed: 3 m/min, by: 0.5 m}", ""),
        ("{type: slider, axis: [0, 0, 1], motion: []}", "{type: fixed}"),
        ("at: [10 m, 0 m, 0 m]", "at: [0 m, 0 m, 0 m]\n      orientation: {about: [0, 1, 0], angle: 3 deg}"),
        (", friction: 0.3", friction),
        (
            "simulation:",
            "limits: {rule: yard, sling_angle_from_vertical: 10 deg}\n"
            "cases: {heavy: {set: {load.weight.simulate: design}}}\nsimulation:",
        ),
        ("calculated: 10 t", "calculated: 10 t, contingency: 1.05"),
    )


def _said(tmp_path: Path, friction: str, *verb: str) -> str:
    path = tmp_path / "scenario.yaml"
    path.write_text(_lift(friction), encoding="utf-8")
    return " ".join(gantline(verb[0], str(path), *verb[1:]).stdout.split())


def test_statics_say_what_holds_it(tmp_path: Path) -> None:
    """Which it does: with friction the check that failed has nothing to fail by."""
    said = _said(tmp_path, ", friction: 0.3", "statics")
    assert "FAILED sling_angle_from_vertical" in said
    assert f"{_FAILS}; --held {_HOLDS}" in said
    held = _said(tmp_path, ", friction: 0.3", "statics", "--held")
    assert "FAILED" not in held and _FAILS not in held


def test_statics_as_json_name_it(tmp_path: Path) -> None:
    """By the name that `cases --json` has for it; with friction nothing slides there."""
    path = tmp_path / "scenario.yaml"
    path.write_text(_lift(", friction: 0.3"), encoding="utf-8")
    for more, names in (([], ["box"]), (["--held"], [])):
        numbers = json.loads(gantline("statics", str(path), "--json", *more).stdout)
        assert numbers["fails_as_it_slides"] == names


def test_cases_say_what_holds_it(tmp_path: Path) -> None:
    """Of all cases in one sentence."""
    said = _said(tmp_path, ", friction: 0.3", "cases")
    assert said.count(f"{_FAILS}; 'gantline statics --held' {_HOLDS}") == 1


@pytest.mark.parametrize("verb", ["statics", "cases"])
def test_nothing_is_said_of_what_has_no_friction(tmp_path: Path, verb: str) -> None:
    """It slides in a run, too."""
    said = _said(tmp_path, "", verb)
    assert "FAILED" in said and _FAILS not in said


def test_the_first_page_says_it_beside_cases_that_are_not_sound() -> None:
    """And the section of cases beside each of them."""
    document = run_cases(parse_scenario(_lift(", friction: 0.3")), workers=1).to_json()
    saved = SavedCases.from_json(document)
    assert [one.slides for one in saved.cases] == [("box",), ("box",)]
    assert "box is free to slide there" in saved.cases[0].remarks
    page = FirstPage().content(Subject(ringing_lift(rig=sample_rig(load_tilt=1.0)), Beside(cases=saved)))
    assert page["what_if"]["sliding"] == "box"
    for case in document["cases"]:
        for state in case["states"]:
            # Files from before there was the word.
            del state["fails_as_it_slides"]
    assert [one.slides for one in SavedCases.from_json(document).cases] == [(), ()]


def test_at_rest_in_a_report_has_what_the_program_says_of_friction(tmp_path: Path) -> None:
    """The section had losses of sheaves alone, and of a lift without them nothing."""
    rest = Statics(parse_scenario(_lift(", friction: 0.3"))).equilibrium()
    equilibrium = open_recording(rest.with_modes([], {}).save(tmp_path / "equilibrium.nc"))
    subject = Subject(ringing_lift(rig=sample_rig()), Beside(equilibrium=equilibrium))
    content = Rest().content(subject)
    assert content is not None
    assert dict(content["facts"])["friction"] == "contacts without friction"
