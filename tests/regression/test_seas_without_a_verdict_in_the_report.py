"""Seas of which nothing is known read in a report like seas that are allowed.

`gantline seas --duration` ended every run before its plan did: the program told "82 % no verdict" and
"allowed none", the section of the report "82 %", in another colour, and the reason twice without the sea that
each was of. It called the runs "the whole plan", too.
"""

from __future__ import annotations

from dataclasses import replace
from math import radians
from typing import Any

from gantline.report.page import render_report
from gantline.report.seas import Seas
from gantline.report.subject import Subject
from gantline.results.file.saved import Beside
from gantline.results.file.saved_seas import SavedSea, SavedSeas
from sample_lift import ringing_lift, sample_rig

_WHY = "NO VERDICT: the run ends at 130 s; not begun: swing free"
#: A sea of 0.4 m and 7 s towards 165 degrees in which 82 % of a limit is used, and no more is known.
_SEA = SavedSea(
    0.4, 7.0, radians(165.0), False, False, False, 1, 0.82, "lug_load_of_capacity", "", "", True, _WHY
)


def _seas(*seas: SavedSea) -> SavedSeas:
    none = {(one.direction, one.period): None for one in seas}
    return SavedSeas("", "A lift", "swell", False, 1, 130.0, seas, none, (), len(seas))


def _content(*seas: SavedSea) -> dict[str, Any]:
    content = Seas().content(Subject(ringing_lift(rig=sample_rig()), Beside(seas=_seas(*seas))))
    assert content is not None
    return content


def test_a_share_of_a_sea_without_a_verdict_says_so() -> None:
    """As the table of the program does; one in which a check failed has its share alone, in red."""
    failed = replace(_SEA, height=0.8, used=1.03, is_refused=True, verdict="")
    rows = _content(_SEA, failed)["fields"][0]["rows"]
    assert [row["cells"][0]["text"] for row in rows] == ["103 %", "82 % no verdict"]
    assert [row["cells"][0]["tone"] for row in rows] == ["bad", "warn"]


def test_a_sea_that_came_to_no_share_has_the_words_alone() -> None:
    """Without a blank before them."""
    (row,) = _content(replace(_SEA, used=None))["fields"][0]["rows"]
    assert row["cells"][0]["text"] == "no verdict"


def test_a_reason_names_its_seas() -> None:
    """One that is true of two stands once, behind both."""
    seas = (_SEA, replace(_SEA, period=9.0), replace(_SEA, period=11.0, verdict="NO VERDICT: another"))
    assert _content(*seas)["reasons"] == [
        f"0.4 m, 7 s, 165 deg; 0.4 m, 9 s, 165 deg: {_WHY}",
        "0.4 m, 11 s, 165 deg: NO VERDICT: another",
    ]


def test_runs_that_end_before_the_plan_are_not_all_of_it() -> None:
    """The sentence stands above runs of any duration."""
    page = render_report(ringing_lift(rig=sample_rig()), beside=Beside(seas=_seas(_SEA)))
    assert "whole plan in other seas" not in page
    assert "The lift, simulated in other seas than that of this recording" in page
