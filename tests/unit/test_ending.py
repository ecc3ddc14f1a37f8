"""How a run ended that did not get through its lift: where, why, what to do next, and never a go."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from gantline.checks import check_recording, outcome_of
from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.results import Recording
from gantline.results.ending import ADVICE, ending_of
from gantline.viewer.pack import pack
from sample_lift import ringing_lift, sample_rig

ROOT = Path(__file__).resolve().parents[2]
FAILURE = {"time": 8.25, "element": "sling.S1", "cause": "it is to be put on here, is 8.5 m long"}
#: Capacities far above what hangs, so that the lift would be a go.
GOOD = {"load_tilt": 0.5}


def ended(status: str, **more: Any) -> Recording:
    """A lift that rings and passes what it is held against, with the end that is given."""
    plain = ringing_lift(rig=sample_rig(**GOOD))
    return Recording(plain.variables, plain.coordinates, {**plain.attributes, "status": status, **more})


def content(recording: Recording) -> dict[str, Any]:
    return FirstPage().content(Subject(recording))


def test_a_run_that_got_through_has_no_such_ending() -> None:
    assert ending_of(ended("done")) is None
    assert ending_of(ended("at rest at 3 s")) is None
    assert content(ended("done"))["ending"] is None


def test_a_failure_says_time_element_cause_and_what_to_do_next() -> None:
    ending = ending_of(ended("failed", failure=FAILURE))
    assert ending is not None
    assert (ending.time, ending.element, ending.cause) == (8.25, "sling.S1", FAILURE["cause"])
    assert "could not go on at 8.250 s" in ending.happened and "at sling.S1" in ending.happened
    assert ending.advice == "lower the hook in a step before, or make the sling longer"


def test_in_few_words_it_says_in_which_step_or_before_which() -> None:
    plain = ringing_lift(events=[(0.0, "step_begin", "hoist")])
    within = ending_of(plain)
    assert within is not None and within.in_short == "the run ends in 'hoist'"
    between = ringing_lift(events=[(0.0, "step_begin", "hoist"), (9.0, "step_end", "hoist")])
    before = ending_of(between)
    assert before is not None and before.in_short == "the run ends before 'hold'"
    stopped = Recording(plain.variables, plain.coordinates, {**plain.attributes, "status": "stopped"})
    told = ending_of(stopped)
    assert told is not None and told.in_short == "the run was stopped in 'hoist'"
    assert told.cause == ""


def test_an_old_recording_without_its_cause_says_what_it_can() -> None:
    ending = ending_of(ended("failed"))
    assert ending is not None and ending.cause == "" and ending.advice
    assert ending.time == ending.recorded


@pytest.mark.parametrize("status", ["failed", "stopped", "paused", "running"])
def test_no_such_run_is_ever_a_go(status: str) -> None:
    """Not on its first page, not in its checks; the page says so at its top."""
    recording = ended(status)
    assert not outcome_of(check_recording(recording)).value.startswith("GO")
    page = content(recording)
    assert not page["verdict"]["head"].startswith("GO") and page["verdict"]["tone"] == "bad"
    assert page["ending"]["no_go"].startswith("nothing after ")
    assert page["verdict"]["up_to"]


def test_a_limit_that_was_passed_before_is_no_go_all_the_same() -> None:
    plain = ringing_lift(rig=sample_rig(hook_dynamic_factor=1.0))
    recording = Recording(
        plain.variables, plain.coordinates, {**plain.attributes, "status": "failed", "failure": FAILURE}
    )
    page = content(recording)
    assert page["verdict"]["head"] == "NO-GO"
    assert page["ending"]["no_go"].endswith("it is NO-GO all the same, by what failed before")


def test_the_player_is_told_where_it_failed() -> None:
    header = pack(ended("failed", failure=FAILURE)).header
    assert header["failed"] is True and "the run failed" in header["unfinished"]
    header = pack(ended("done")).header
    assert header["failed"] is False and header["unfinished"] is None
    # While a lift runs nothing says where it will end.
    assert pack(ended("running")).header["unfinished"] is None


def test_every_cause_that_has_advice_is_one_that_there_is() -> None:
    """The words by which advice is found stand in the core's sources, or in those of yard words."""
    told = [ROOT / "python/gantline/scenario/failed.py", ROOT / "python/gantline/scenario/loads/hinge.py"]
    sources = [*(ROOT / "crates/gantline-core/src").rglob("*.rs"), *told]
    text = " ".join(" ".join(one.read_text(encoding="utf-8").split()) for one in sources)
    assert [words for words, _ in ADVICE if words not in text] == []
