"""A report on a screen sent its reader to "sheet 2", and a screen has no sheets.

On paper an equalizer was parted from the table of its sheaves by the end of a page, all checks began on a new
page however much of the one before was free, and the third column of events broke `support.keel_blocks.1.4`
between its letters while the two beside it had room.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import gantline.report
from gantline.report import render_report
from sample_lift import ringing_lift, sample_rig

TEMPLATES = Path(gantline.report.__file__).parent / "templates"


def rules(sheet: str) -> dict[str, str]:
    """What a style sheet says outside of media or within the only one, by selector."""
    text = re.sub(
        r"/\*.*?\*/|^@media[^{]*\{", "", (TEMPLATES / sheet).read_text(encoding="utf-8"), flags=re.M | re.S
    )
    found = re.findall(r"([^{}]+)\{([^{}]*)\}", text)
    return {
        selector: " ".join(body.split())
        for group, body in found
        for selector in map(str.strip, group.split(","))
    }


@pytest.fixture(scope="module")
def html() -> str:
    rig = sample_rig()
    rig["plan"] = [{"step": f"step {one}", "kind": "hoist"} for one in range(1, 21)]
    return render_report(ringing_lift(rig=rig))


def test_a_screen_links_to_further_steps_and_paper_names_the_sheet(html: str) -> None:
    told = '<span class="on-paper">see sheet 2</span><a class="no-print" href="#steps">see below</a>.'
    assert f"<strong>Steps 17 to 20: {told}</strong>" in html
    assert html.count("see sheet 2") == 1
    assert rules("report.css")[".on-paper"] == "display: none;"
    assert rules("print.css")[".on-paper"] == "display: inline;"
    assert rules("print.css")[".no-print"] == "display: none;"


def test_what_belongs_together_stays_on_a_page(html: str) -> None:
    assert rules("print.css")[".together"] == "break-inside: avoid;"
    equalizers = (TEMPLATES / "equalizers.html").read_text(encoding="utf-8")
    assert '<div class="together">\n<h3>' in equalizers


def test_checks_begin_where_the_page_has_room(html: str) -> None:
    assert '<div class="scroll long"><table class="checks">' in html


def test_names_of_events_have_the_room_that_is_left() -> None:
    assert rules("print.css")[".events th:not(:last-child)"] == "width: 1%;"
