"""A guide that the load missed was one warning among ten, without how far it was missed.

The table of a run tells the first of its warnings and how many more there are. So it is a check of its own,
with the distance by which the lip of a face is on the wrong side of the tip."""

from __future__ import annotations

import math

import pytest

from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from guided_lift import guided_lift

DOWN = "  - {step: lower, lower: crane, speed: 6 m/min, by: 1.0 m}\n  - {step: rest, hold: until_end}\n"
#: How far the flare opens each side [m].
RUN = 0.4 * math.sin(math.radians(30.0))


def checks(post: float) -> list[Check]:
    """Of a load that comes down with the middle of its frame at x = 3.5 m, beside a post at x [m]."""
    guide = (
        f"  g: {{post: {{at: [{post} m, 0 m, 0 m], diameter: 0.4 m, height: 1 m}}, "
        "frame: {at: [3.5 m, 0 m, 0 m], clearance: 30 mm, height: 0.6 m, "
        "flare: {length: 0.4 m, angle: 30 deg}}, friction: 0.2}\n"
    )
    recording = simulate(parse_scenario(guided_lift(guide, height=1.6, plan=DOWN, duration=14.0)))
    return [one for one in check_recording(recording) if one.name == "comes_to_guides"]


def test_it_warns_with_how_far_it_is_missed() -> None:
    """A lip is outside of the tip, 0.2 m in radius, up to clearance and run of the flare: 0.23 m."""
    [check] = checks(4.9)
    assert (check.verdict, check.element) == (Verdict.WARNING, "g")
    assert "the fore side of its frame is on the wrong side of the post at" in check.remark
    assert f"it misses by {1.4 - 0.03 - RUN:.2f} m: see its place" in check.remark


@pytest.mark.parametrize("post", [3.5, 3.7])
def test_one_that_is_met_is_not_told(post: float) -> None:
    assert checks(post) == []
