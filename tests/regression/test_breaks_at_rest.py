"""GO at rest for a sling that breaks at what it carries there.

An equilibrium keeps ropes that `breaks_at` lets break in a run. Nothing said so: `gantline statics` and
`gantline cases` passed a sling that carried 589 kN and breaks at 420 kN, far below its minimum breaking
force; in a run it breaks before the load is clear.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from pinned_lift import LIFT

FIRST = "to: block.L1, length: 12 m"


@pytest.mark.parametrize(("breaks_at", "breaks"), [("420 kN", True), ("600 kN", False)])
def test_a_rope_that_carries_what_breaks_it_fails(breaks_at: str, breaks: bool) -> None:
    """Half of 120 t, 588.6 kN, hangs on it."""
    text = LIFT.replace(FIRST, f"{FIRST}, breaks_at: {breaks_at}")
    found = check_recording(Statics(parse_scenario(text)).equilibrium(10.0).recording)
    parted = [one for one in found if one.name == "rope_parted"]
    assert [(one.element, one.verdict) for one in parted] == [("sling.S1", Verdict.FAILED)] * breaks
    assert all("carries 588.6 kN and breaks at 420.0 kN" in one.remark for one in parted)
