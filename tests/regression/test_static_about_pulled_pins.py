"""Locking pins that are pulled while the load hangs still.

Static forces were means over the whole time that it hung still, of slings as they share under pins and as
they do after: an outer sling that had carried half of the load showed 418 kN of its 589, the middle one 341
of its 392. And where the load never hung still under pins, a sling's 503.6 kN under them was
dynamics of its 392.4 kN without, 1.28.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks.measure import Found, Missing
from gantline.checks.slings import sling_dynamic_factor
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


def test_what_slings_carry_under_pins_alone_is_no_dynamics() -> None:
    """Pins that are pulled after 1 s, when nothing has hung still yet.

    The middle sling is 20 mm too long: the outer two have their peaks under pins, it has its own after that.
    """
    lift = LIFT.replace("hold: 20 s", "hold: 1 s").replace("length: 12.2 m", "length: 12.02 m")
    recording = gantline.simulate(parse_scenario(lift))
    peaks = {sling.name: series.rope_peak(recording, sling.rope) for sling in recording.rig.slings}
    assert [peaks[name][1] < 1.0 for name in LARGEST] == [True, False, True]
    every = recording.time >= 0.0
    found = [one for one in sling_dynamic_factor(recording, every) if isinstance(one, Found)]
    assert [one.element for one in found] == ["S2"]
    assert found[0].value == pytest.approx(peaks["S2"][0] / (WEIGHT / 3), rel=1e-3)
    assert recording.metrics()["dynamic_amplification_factor"] == found[0].value
    missing = [one for one in sling_dynamic_factor(recording, every) if isinstance(one, Missing)]
    assert [one.element for one in missing] == ["S1", "S3"]
    assert all("other sheaves were pinned than at the peak" in one.reason for one in missing)
