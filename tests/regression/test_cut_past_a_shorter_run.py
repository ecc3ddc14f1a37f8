"""A sling that is to be cut at 30 s: with `--duration 20 s` the lift was GO, and nothing was said of the cut.

In a file whose own duration ends before a cut, or with it, that is an error.
"""

from __future__ import annotations

import gantline
from four_slings import LIFT
from gantline.scenario import parse_scenario


def test_a_cut_that_a_shorter_run_does_not_reach_is_told() -> None:
    lift = parse_scenario(LIFT.replace("A: {from: crane,", "A: {cut_at: 30 s, from: crane,"))
    said = [one for one in gantline.simulate(lift, duration=20.0).attributes["warnings"] if "cut" in one]
    assert said == ["the run ends at 20 s, and what is cut after that is not seen: sling.A at 30 s"]
    assert not [one for one in gantline.simulate(lift, duration=31.0).attributes["warnings"] if "cut" in one]
