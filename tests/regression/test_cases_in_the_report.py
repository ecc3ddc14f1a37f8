"""The report and the table of `gantline cases` said different things of the same cases.

A tilt of 0.01 deg that became 1.03 deg had a share of 68.967, a sheave that came to the other side of its
start one of -5.609; the table has no share for either. What reads the same as the lift as it is given had a
case for its cause. And a GO was green, without a word, above cases in which a lug was at 108 %.
"""

from __future__ import annotations

import math

from gantline.report.first_page import FirstPage
from gantline.report.rest import Cases
from gantline.report.subject import Subject
from gantline.results.file.saved import Beside, SavedCase, SavedCases, SavedWorst
from sample_lift import ringing_lift, sample_rig


def subject(*worst: SavedWorst, troubles: tuple[str, ...] = ()) -> Subject:
    cases = [SavedCase("", 1, ()), SavedCase("lengths", 2, troubles)]
    saved = SavedCases("", not troubles, cases, worst)
    return Subject(ringing_lift(rig=sample_rig(load_tilt=1.0)), Beside(cases=saved))


def rows_of(one: Subject) -> list[dict[str, str]]:
    content = Cases().content(one)
    assert content is not None
    return list(content["worst"])


def test_forces_have_a_share_of_one_another_and_nothing_else() -> None:
    force = SavedWorst("sling_tension", "S1", 500e3, 612e3, "lengths", "+x")
    tilt = SavedWorst("load_tilt", "block", math.radians(0.015), math.radians(1.034), "lengths", "+x")
    travel = SavedWorst("sheave_travel", "e1.1", 0.250, -1.403, "lengths", "")
    rows = rows_of(subject(force, tilt, travel))
    assert [row["ratio"] for row in rows] == ["1.224", "–", "–"]
    assert [row["value"] for row in rows] == ["612.0 kN", "1.03 deg", "−1.403 m"]


def test_what_reads_the_same_has_no_case() -> None:
    one = subject(SavedWorst("sheave_travel", "e1.1", -0.40500, -0.40502, "lengths", "+x"))
    assert rows_of(one)[0]["case"] == "as given"
    page = FirstPage().content(one)
    assert page["what_if"]["rows"] == [("travel of e1.1", "−0.405 m, as given")]


def test_the_verdict_says_which_cases_are_not_sound() -> None:
    sound, unsound = (
        FirstPage().content(subject(troubles=troubles))["verdict"]
        for troubles in ((), ("lug_load_of_capacity failed",))
    )
    assert sound["head"].startswith("GO") and sound["unsound"] == ""
    # The verdict itself is that of the run, as in the terminal; it is no clear one any more.
    assert unsound["head"] == sound["head"]
    assert (unsound["tone"], unsound["unsound"]) == ("warn", "lengths")
