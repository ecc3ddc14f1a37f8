"""A sling that is cut while the load hangs at a hold point.

Static forces were means over the whole hold point: of the sling that took over half of what it carried before
and half of what it did after, 29.6 % of its shackle's working load limit in place of 59.6 %.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.results import series
from gantline.scenario import parse_scenario

CUT = LIFT.replace("hold: 20 s", "hold: until_end").replace(
    "  A: {from: crane, to: module.A, length: 8.6 m,",
    "  A: {from: crane, to: module.A, cut_at: 50 s, length: 8.6 m,",
)


def test_what_the_others_carry_is_that_before_or_after() -> None:
    """Two slings across the load carry it all once one of the others is gone, twice what they did."""
    recording = gantline.simulate(parse_scenario(CUT.replace("duration: 70 s", "duration: 120 s")))
    for sling in recording.rig.slings:
        tension = series.sling_tension(recording, sling)
        before, after = (float(tension[recording.time <= 49.9][-1]), float(tension[-1]))
        static, window = series.greatest_static(recording, tension)
        # After the cut the load swings on until the end, by 5e-5 of the forces.
        assert static == pytest.approx(max(before, after), rel=1e-4)
        assert bool((recording.time[window] < 50.0).all()) is (before > after)
