"""What lies beside a recording: read where it belongs to it, and refused where it is anything else."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline.replacing import replace_text
from gantline.report import render_report, write_report
from gantline.report.first_page import FirstPage
from gantline.report.rest import Cases, Modes, Rest
from gantline.report.subject import Subject
from gantline.results import Recording
from gantline.results.file.saved import CASES, EQUILIBRIUM, LOST_LOAD, SavedCases, digest_of, read_beside
from hostile import EVIL
from sample_lift import ringing_lift

pytestmark = pytest.mark.usefixtures("player")

SCENARIO = "format: 1\n"


def lift(text: str = SCENARIO) -> Recording:
    one = ringing_lift()
    return Recording(one.variables, one.coordinates, {**one.attributes, "scenario": text})


def cases(**changed: Any) -> dict[str, Any]:
    """Two cases, one without equilibrium; the numbers are made up."""
    fine = {"variant": "", "losses": "none", "equilibrium": True, "cause": "", "stable": True, "failed": []}
    bad = {**fine, "equilibrium": False, "cause": "nothing holds it", "stable": None}
    worst = {
        "quantity": "sling_tension",
        "element": "S1",
        "given": 500e3,
        "value": 612.34e3,
        "case": "heavy",
        "variant": "+x",
        "losses": "forward",
    }
    small = {**worst, "quantity": "smallest_sling_tension", "element": "S2", "value": 100e3, "losses": "none"}
    less = {**worst, "element": "S3", "value": 1.0}
    hoist = {**worst, "quantity": "hoist_load", "element": "crane", "value": 1702.4e3}
    document = {
        "scenario_sha256": digest_of(SCENARIO),
        "sound": False,
        "cases": [{"case": "", "states": [fine]}, {"case": "cut", "states": [bad, bad]}],
        "worst": [less, worst, small, hoist],
    }
    return {**document, **changed}


def equilibrium(**changed: Any) -> Recording:
    one = ringing_lift()
    said = {"time": 1.0, "stable": True, "unstable_motions": 0, "neutral_motions": 1, "residual": 1e-12}
    mode = {
        "number": 1,
        "period": 14.026,
        "growth_time": None,
        "damping_ratio": 0.02,
        "motion": "load turns",
    }
    away = {"number": 2, "period": None, "growth_time": 3.0, "damping_ratio": None, "motion": "hook moves"}
    attributes = {**one.attributes, "scenario": SCENARIO, "statics": said, "modes": [mode, away]}
    return Recording(one.variables, one.coordinates, {**attributes, **changed})


def lost_load(**changed: Any) -> dict[str, Any]:
    """A barge that comes back; the numbers are made up."""
    swing = {"vessel": "barge", "towards": "stern", "farthest": 0.05, "freeboard": 0.8, "ratio": 20.0}
    document = {"load": "module", "scenario_sha256": digest_of(SCENARIO), "sound": True, "time": 40.0}
    return {**document, "swings": [swing], **changed}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    replace_text(tmp_path / CASES, json.dumps(cases()))
    equilibrium().save(tmp_path / EQUILIBRIUM)
    return tmp_path


def test_a_report_shows_what_lies_beside_it(folder: Path) -> None:
    html = write_report(lift(), folder / "report.html").read_text(encoding="utf-8")
    for anchor in ("statics", "modes", "cases"):
        assert f'<section id="{anchor}"' in html
    assert "14.026 s" in html and "LEADS AWAY, e-fold in 3.00 s" in html
    assert "no equilibrium: nothing holds it" in html
    assert "heavy, +x, slip along" in html
    # The first page has the worst of all slings, and its case in words.
    first = html.split('<section id="lift"')[1].split("<section")[0]
    assert "most in sling S1" in first and "612.3\u00a0kN, heavy" in first
    assert "least in sling S2" in first and "100.0\u00a0kN, heavy" in first
    assert "<strong>cut is not sound</strong>: no equilibrium: nothing holds it" in first
    # Not the hook load, which the table of cases has: hook block and falls are in it.
    assert "most on hook" not in first and "most hoist load at crane" in first
    # Readings of hooks are in t: 1702.4 kN/9.81 m/s^2.
    assert "173.5\u00a0t, heavy" in first
    assert "hoist load <i>t</i>" in html and "hoist load <i>kN</i>" not in html
    assert "gantline cases LIFT" not in first


def test_nothing_beside_is_no_section(tmp_path: Path) -> None:
    html = write_report(lift(), tmp_path / "report.html").read_text(encoding="utf-8")
    for anchor in ("statics", "modes", "cases"):
        assert f'<section id="{anchor}"' not in html
    assert "gantline cases LIFT" in html


def test_what_is_of_another_lift_file_is_left_out(folder: Path) -> None:
    beside = read_beside(folder, lift("format: 1 # changed\n"))
    assert (beside.cases, beside.equilibrium) == (None, None)
    assert [one.split(":")[0] for one in beside.left_out] == [CASES, EQUILIBRIUM]
    assert all("of another lift file" in one for one in beside.left_out)
    # Which of the two is the older one nobody knows: a file may have been edited after its run.
    assert all("'gantline run' the recording" in one for one in beside.left_out)


@pytest.mark.parametrize(
    "document",
    [
        [],
        {},
        cases(cases={}),
        cases(worst=[{}]),
        cases(worst=[{**cases()["worst"][0], "value": "1"}]),
        cases(worst=[{**cases()["worst"][0], "value": True}]),
        cases(worst=[{**cases()["worst"][0], "quantity": "__class__"}]),
        cases(worst=[{**cases()["worst"][0], "given": float("nan")}]),
        cases(cases=[{"case": "", "states": [1]}]),
    ],
)
def test_what_is_no_file_of_cases_is_refused(document: Any, tmp_path: Path) -> None:
    with pytest.raises(ValueError):
        SavedCases.from_json(document)
    (tmp_path / CASES).write_text(json.dumps(document), encoding="utf-8")
    beside = read_beside(tmp_path, lift())
    assert beside.cases is None
    assert beside.left_out[0].startswith(f"{CASES}: is not what 'gantline cases' writes")


def test_deep_nesting_is_refused(tmp_path: Path) -> None:
    (tmp_path / CASES).write_text("[" * 200_000, encoding="utf-8")
    assert "is not what 'gantline cases' writes" in read_beside(tmp_path, lift()).left_out[0]


def test_an_equilibrium_without_its_attributes_is_left_out(tmp_path: Path) -> None:
    lift().save(tmp_path / EQUILIBRIUM)
    beside = read_beside(tmp_path, lift())
    assert beside.equilibrium is None
    assert list(beside.left_out) == [f"{EQUILIBRIUM}: holds no equilibrium of 'gantline statics'"]


def test_hostile_texts_beside_are_texts(folder: Path) -> None:
    worst = {**cases()["worst"][1], "element": EVIL, "case": EVIL, "variant": EVIL}
    bad = {**cases()["cases"][1]["states"][0], "cause": EVIL}
    document = cases(worst=[worst], cases=[{"case": EVIL, "states": [bad]}])
    replace_text(folder / CASES, json.dumps(document))
    mode = {"number": EVIL, "period": EVIL, "growth_time": True, "damping_ratio": [], "motion": EVIL}
    equilibrium(modes=[mode], statics={"stable": EVIL, "residual": EVIL, "lossy_sheaves": EVIL}).save(
        folder / EQUILIBRIUM
    )
    beside = read_beside(folder, lift())
    assert beside.left_out == [] and beside.cases is not None and beside.equilibrium is not None
    html = render_report(lift(), beside=beside)
    assert "<img" not in html and html.count("<script") == 3
    assert html.count("&lt;img") >= 5


def test_sections_of_statics_give_the_numbers_of_the_last_sample(folder: Path) -> None:
    subject = Subject(lift(), read_beside(folder, lift()))
    rest = subject.beside.equilibrium
    assert rest is not None
    content = Rest().content(subject)
    assert content is not None
    last = np.array([rest.column("rope_tension", sling.rope)[-1] for sling in rest.rig.slings])
    assert [row[1] for row in content["slings"]] == [f"{one / 1e3:.1f}" for one in last]
    assert [row[2] for row in content["slings"]] == [f"{one / last.mean():.3f}" for one in last]
    modes = Modes().content(subject)
    assert modes is not None and [row["damping"] for row in modes["rows"]] == ["2.00 %", "–"]
    assert Cases().content(Subject(lift())) is None
    what_if = FirstPage().content(subject)["what_if"]
    assert what_if["sound"] is False and what_if["more"] == 0


def test_a_lost_load_beside_its_recording(tmp_path: Path) -> None:
    replace_text(tmp_path / LOST_LOAD, json.dumps(lost_load()))
    found = read_beside(tmp_path, lift()).lost_load
    assert found is not None and found.is_sound and found.load == "module" and found.time == 40.0
    assert [(one.vessel, one.towards, one.ratio) for one in found.swings] == [("barge", "stern", 20.0)]


@pytest.mark.parametrize(
    ("written", "said"),
    [
        (lost_load(scenario_sha256="0"), "is of another lift file than the recording"),
        (lost_load(time="now"), "is not what 'gantline statics --lost' writes ('time' is no number)"),
        (lost_load(swings=[{}]), "is not what 'gantline statics --lost' writes"),
        ([], "is not what 'gantline statics --lost' writes (an object was expected)"),
    ],
)
def test_a_lost_load_that_is_anything_else_is_left_out(tmp_path: Path, written: Any, said: str) -> None:
    replace_text(tmp_path / LOST_LOAD, json.dumps(written))
    found = read_beside(tmp_path, lift())
    assert found.lost_load is None
    (sentence,) = found.left_out
    assert sentence.startswith(f"{LOST_LOAD}: {said}")
