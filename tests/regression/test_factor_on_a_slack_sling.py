"""A sling that hung slack after its neighbour was cut had a dynamic factor of 2798.

Of four slings one is cut while the load is hoisted: two across each other carry it from then on, and the
fourth, which had its share up to the cut, hangs with less than a thousandth of that. The load never hung
still before, so that the static value was what was left, and `sling_dynamic_factor` named it as the
governing one; the metric `dynamic_amplification_factor` was that number. And of what the others made of it
the check `rope_parted` told nothing: whether they would hold, and why they carried twice as much, had to be
read from tables.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.checks import Verdict
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import check_of

#: B is cut as the load goes up, a second after it came clear; A and D, across each other, are left with it.
CUT = LIFT.replace("to: module.B,", "to: module.B, cut_at: 15 s,").replace("by: 0.2 m", "by: 1.5 m")


def test_what_a_cut_leaves_to_the_others() -> None:
    """A and D bear what the load weighs, W/(2 cos) each at rest, and C nothing; no factor is one on that."""
    assert "cut_at" in CUT and "by: 1.5 m" in CUT
    recording = simulate(parse_scenario(CUT))
    factor = check_of(recording, "sling_dynamic_factor")
    assert factor.value is not None and factor.value < 2.0  # a load that is let go of at once has 2
    assert factor.element in ("A", "D") and "C" in factor.remark
    assert recording.metrics()["dynamic_amplification_factor"] == pytest.approx(factor.value)

    parted = check_of(recording, "rope_parted")
    peaks = {name: float(recording.column("rope_peak_tension", f"sling.{name}")) for name in "AD"}
    assert all(recording.column("rope_peak_time", f"sling.{name}") > 15.0 for name in "AD")
    most = max(peaks, key=lambda name: peaks[name])
    [rope] = [one for one in recording.rig.ropes if one.name == f"sling.{most}"]
    assert rope.minimum_breaking_force is not None
    said = f"after that sling.{most} has most, {peaks[most] / 1e3:.1f} kN, "
    assert parted.verdict is Verdict.FAILED and said in parted.remark
    assert f"{100 * peaks[most] / rope.minimum_breaking_force:.0f} % of its minimum" in parted.remark
    assert parted.remark.endswith("with sling.C slack")
    hung = recording.column("rope_tension", "sling.A")[-1]
    assert hung == pytest.approx(recording.column("hook_load", "crane")[-1] / 2 * 8.6 / 8.088, rel=0.02)
