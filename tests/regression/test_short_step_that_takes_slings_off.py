"""A hold of 10 ms in which a sling is taken off was told that nobody sees anything in that.

A step that cuts, takes off or puts on, pulls pins or takes supports away does so as it begins; how long it
lasts is nothing that anybody looks at.
"""

from __future__ import annotations

import pytest

from four_slings import HANDED_OVER
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

LAST = "  - {step: let it hang, hold: until_end}\n"


@pytest.mark.parametrize(("does", "is_told"), [("", True), (", detach: [sling.A, sling.B]", False)])
def test_a_step_that_does_something_at_once(does: str, is_told: bool) -> None:
    assert LAST in HANDED_OVER
    text = HANDED_OVER.replace(LAST, f"  - {{step: off, hold: 10 ms{does}}}\n{LAST}")
    found = [one for one in assemble(parse_scenario(text)).doubts if "nobody sees" in one.sentence]
    assert bool(found) is is_told
