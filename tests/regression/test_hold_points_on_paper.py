"""On paper the table of hold points left its heading behind, and numbers their units.

The report of `monopile` had "Hooks at hold points" with the heads of the columns at the foot of one sheet,
and the first row on the next. "hold point 4 1555.0" ended a line, "s" was the next; so was that of "bucket,
at 185.00 s" among the checks.
"""

from __future__ import annotations

import re
from pathlib import Path

import gantline
from gantline.report import render_report
from hooked_lift import turned_by_two_hooks

PRINT = Path(gantline.__file__).parent / "report" / "templates" / "print.css"


def test_a_table_takes_its_heading_along() -> None:
    rules = {
        selector.strip(): body
        for selectors, body in re.findall(r"([^{}]+)\{([^{}]*)\}", PRINT.read_text(encoding="utf-8"))
        for selector in re.sub(r"/\*.*?\*/", "", selectors, flags=re.DOTALL).split(",")
        if "break-" in body
    }
    assert "break-after: avoid" in rules["caption"]
    assert "break-after: avoid" in rules["thead"]
    assert "break-before: avoid" in rules[".together:first-of-type"]


def test_no_line_ends_between_a_time_and_its_unit() -> None:
    held = turned_by_two_hooks("  - {step: look, hold: 2 s}\n")
    page = render_report(gantline.simulate(gantline.parse_scenario(held)))
    assert re.search(r"<th>look <span class=\"quiet\">[0-9.]+\u00a0s</span></th>", page)
    places = re.findall(r'</strong> <span class="quiet">([^<]*)</span>', page)
    timed = [place for place in places if " at " in place]
    assert timed
    assert all(re.search(r"[0-9]\u00a0s", place) for place in timed)
