"""The first page had the yard pull locking pins of moving sheaves that hang free, which have none.

"any out before the first step" stood beside an equalizer with `guided: none`: a pin sits in a guide, and a
lift file that locks such sheaves is refused.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.report.page import render_report
from gantline.scenario import parse_scenario
from lift_text import spoiled


@pytest.mark.parametrize(("guided", "is_said"), [("vertical", True), ("none", False)])
def test_pins_are_said_of_sheaves_in_guides(guided: str, is_said: bool) -> None:
    text = spoiled("moving_sheaves: {", f"moving_sheaves: {{guided: {guided}, ")
    page = render_report(gantline.simulate(parse_scenario(text), duration=0.1))
    assert ("any out before the first step" in page) is is_said
