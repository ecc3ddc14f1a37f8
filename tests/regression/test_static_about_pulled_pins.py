"""Locking pins that are pulled while the load hangs still.

Static forces were means over the whole time that it hung still, of slings as they share under pins and as
they do after: an outer sling that had carried half of the load showed 418 kN of its 589, the middle one 341
of its 392.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.results import series
from gantline.scenario import parse_scenario
from pinned_lift import LIFT, WEIGHT

#: What each sling carries while the load hangs still: half under pins, a third after.
LARGEST = {"S1": WEIGHT / 2, "S2": WEIGHT / 3, "S3": WEIGHT / 2}


def test_what_slings_carry_is_that_before_or_after() -> None:
    """W/2 under pins, W/3 without; what swings on after the pulling leaves less than 1e-3 in a mean."""
    recording = gantline.simulate(parse_scenario(LIFT))
    assert len(recording.events("pin_pulled")) == 3
    for sling in recording.rig.slings:
        static, window = series.greatest_static(recording, series.sling_tension(recording, sling))
        assert static == pytest.approx(LARGEST[sling.name], rel=1e-3)
        assert bool((recording.time[window] < 20.0).all()) is (sling.name != "S2")
