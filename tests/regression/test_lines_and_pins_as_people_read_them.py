"""What tables and the first page said in a way that nobody can read.

The verdict of `upending` ended a line of the terminal between `91` and `%`. The first page of `mechanisms`
told the yard that the locking pins of its equalizer are to be out before the first step: an approximated
equalizer has no sheaves that move, and no pins.
"""

from __future__ import annotations

from typing import Literal

import pytest

import gantline
from gantline.cli.table import wrapped
from gantline.report.page import render_report
from gantline.scenario import parse_scenario
from lift_text import BASE

VERDICT = "GO; nearest to their limits: hoist_load_of_rating 93 %, hook_dynamic_factor 91 %, and-more 90 %"


@pytest.mark.parametrize("width", range(60, 100))
def test_no_line_ends_before_a_per_cent_sign(width: int) -> None:
    """Nor within a name, and nothing is lost."""
    lines = wrapped(VERDICT, width)
    assert max(map(len, lines)) <= width
    assert not any(line.lstrip().startswith("%") for line in lines)
    assert " ".join(line.strip() for line in lines) == VERDICT


@pytest.mark.parametrize(("mechanism", "is_said"), [("sheaves", True), ("approximated", False)])
def test_pins_of_what_has_none(mechanism: Literal["sheaves", "approximated"], is_said: bool) -> None:
    """Pins that are out from the start are said of sheaves that have some."""
    own = f"mechanism: {mechanism}"
    own += "\n    adjusting_factor: 0.01" if mechanism == "approximated" else ""
    text = BASE.replace("hangs_from:", f"{own}\n    hangs_from:", 1)
    assert own in text
    page = render_report(gantline.simulate(parse_scenario(text)))
    assert ("any out before the first step" in page) is is_said
