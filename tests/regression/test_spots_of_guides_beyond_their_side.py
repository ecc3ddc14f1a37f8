"""A frame that slid past the shoulder of its post pressed on a cone that went on below it, by `adaptive`.

Steps ended as much as 1 mm beyond the end of a side. On a cone that narrows by 11 degrees a spot is 0.2 mm
deeper there than on the cylinder, 4 kN of 20 MN/m: the largest force of the guide was 5.40 kN where `del`
with steps of 0.2 ms has 3.19 kN.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from guided_lift import guided_lift

GUIDE = (
    "  g: {post: {at: [3.5 m, 0 m, 0 m], diameter: 0.4 m, height: 1 m, cone: {length: 0.5 m, "
    "tip_diameter: 0.2 m}}, frame: {at: [3.5 m, 0 m, 0 m], clearance: 30 mm, height: 0.6 m, "
    "flare: {length: 0.4 m, angle: 30 deg}}, friction: 0.2}\n"
)
PLAN = "  - {step: lower, lower: crane, speed: 3 m/min, by: 1.1 m}\n  - {step: rest, hold: until_end}\n"


def test_both_methods_have_the_force_as_the_upper_end_comes_over_the_shoulder() -> None:
    """Within the steps of `del`: 1 ms of 0.05 m/s and 11 degrees are 10 um, 0.2 kN of 20 MN/m."""
    peaks = []
    for more in ("", "simulation: {integrator: del, step: 1 ms}"):
        text = guided_lift(GUIDE, at=(0.1, 0.05), plan=PLAN, duration=13.0, more=more)
        recording = simulate(parse_scenario(text, "x.yaml"))
        # By then the frame has come to rest against the post, and its upper end comes to the shoulder.
        late = recording.time > 11.0
        peaks.append(recording.column("guide_force", "g")[late].max())
    assert peaks[0] == pytest.approx(peaks[1], abs=0.2e3)
