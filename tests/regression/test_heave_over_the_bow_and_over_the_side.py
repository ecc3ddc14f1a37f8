"""A crane that slews while it compensates heave was told of the wrong end of its turn.

`gantline check` looks at the first and at the last step that keeps a hook still, and told only of the one
in which the hook has to be moved faster. A boom over the bow goes up and down with the pitch of the barge,
in short waves, and over the side with its roll, in long ones: more slowly and farther. So a hoist whose
stroke was enough over the bow, and too short by a tenth over the side, went without a warning.
"""

from __future__ import annotations

import pytest

from compensated import BARGE, compensated_text
from gantline.scenario import Scenario, parse_scenario
from gantline.study.heave_demand import doubts_of_demand, heave_demands
from lift_text import changed

SEA = "swell: {significant_height: 0.8 m, peak_period: 7 s, direction: 150 deg}"
#: Short waves from ahead, long ones from abeam.
SEAS = """\
wind_sea: {significant_height: 1.5 m, peak_period: 5 s, direction: 180 deg}
  swell: {significant_height: 0.4 m, peak_period: 15 s, direction: 90 deg}"""
SLEWS = """\
    slewing_axis: [80 m, 0 m]
    slewing: {speed: 30 deg/min, acceleration: 0.05 deg/s^2}
    luffing:
"""


def slewed(bow: str = "", side: str = "") -> Scenario:
    """The crane barge, whose boom slews from over the bow to over the side; with more words of both holds."""
    plan = (
        f"  - {{step: over the bow, hold: 20 s{bow}}}\n"
        "  - {step: slew, slew: sheerleg, speed: 20 deg/min, to: 90 deg}\n"
        f"  - {{step: over the side, hold: until_end{side}}}\n"
    )
    text = compensated_text(plan, can="speed: 1 m/s, acceleration: 1 m/s^2, stroke: 1.3 m", lasts="600 s")
    return parse_scenario(changed(text, (SEA, SEAS), ("    luffing:\n", SLEWS)), str(BARGE))


def test_both_ends_of_the_turn_are_told() -> None:
    """Each asks for what it asks for by itself: more speed over the bow, more stroke over the side."""
    still = ", compensate_heave: H1"
    (bow,) = heave_demands(slewed(bow=still))
    (side,) = heave_demands(slewed(side=still))
    assert bow.speed > side.speed
    assert bow.stroke < 1.3 < side.stroke
    both = heave_demands(slewed(bow=still, side=still))
    assert [one.step for one in both] == ["over the bow", "over the side"]
    assert [one.stroke for one in both] == pytest.approx([bow.stroke, side.stroke], rel=1e-6)
    assert [one.speed for one in both] == pytest.approx([bow.speed, side.speed], rel=1e-6)
    (doubt,) = doubts_of_demand(both)
    assert doubt.path == ("plan", 2, "compensate_heave")
    assert "'stroke' 1.44 m, and has 1.30 m" in doubt.sentence
