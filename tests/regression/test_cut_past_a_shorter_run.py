"""A sling that is to be cut at 30 s: with `--duration 20 s` the lift was GO, and nothing was said of the cut.

So it was with a cut at the very end of a lift, after which nothing comes; a state at rest has it.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.scenario import parse_scenario


@pytest.mark.parametrize(
    ("duration", "is_told"),
    [(20.0, True), (30.0, True), (31.0, False)],
    ids=["before", "at the end", "after"],
)
def test_a_cut_that_a_run_does_not_reach_is_told(duration: float, is_told: bool) -> None:
    lift = parse_scenario(LIFT.replace("A: {from: crane,", "A: {cut_at: 30 s, from: crane,"))
    said = [one for one in gantline.simulate(lift, duration=duration).attributes["warnings"] if "cut" in one]
    late = f"the run ends at {duration:g} s, and what is cut then or later is not seen: sling.A at 30 s"
    assert said == [late] * is_told
