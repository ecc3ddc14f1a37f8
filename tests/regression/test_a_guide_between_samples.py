"""A load that comes down on a landing guide between samples.

Forces of landing guides were those of samples, though the peaks of their contacts over all steps were known.
A frame that comes down over its post at 6 m/min presses it with 3.9 kN at one contact, and with less than
2.7 kN by samples 0.5 s apart. What several contacts bear together is still that of samples; a bump of theirs
is told.
"""

from __future__ import annotations

import pytest

from gantline.report.attitude import attitude
from gantline.report.subject import Subject
from gantline.results.loads.contact_peaks import guide_peak
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from guided_lift import guided_lift
from of_recording import checks_of

GUIDE = (
    "  g: {post: {at: [3.6 m, 0 m, 0 m], diameter: 0.4 m, height: 1 m, "
    "cone: {length: 0.5 m, tip_diameter: 0.2 m}}, "
    "frame: {at: [3.5 m, 0 m, 0 m], clearance: 30 mm, height: 0.6 m, flare: {length: 0.4 m, angle: 30 deg}}, "
    "friction: 0.2, capacity: 50 kN}\n"
)
PLAN = "  - {step: lower, lower: crane, speed: 6 m/min, by: 0.8 m}\n  - {step: rest, hold: until_end}\n"


def run_of(apart: float) -> Recording:
    return simulate(parse_scenario(guided_lift(GUIDE, plan=PLAN, duration=3.0)), sample_interval=apart)


def test_the_peak_of_one_contact_counts() -> None:
    """By samples 2 ms apart one contact has as much, and both together more."""
    fine, coarse = run_of(0.002), run_of(0.5)
    (guide,) = coarse.rig.guides
    one = max(float(fine.column("contact_force", name).max()) for name in guide.contacts)
    force, time = guide_peak(coarse, guide)
    assert float(coarse.column("guide_force", "g").max()) < 0.7 * one
    assert force == pytest.approx(one, rel=1e-3)
    assert coarse.metrics()["peak_guide_force.g"] == force
    (check,) = checks_of(coarse, "guide_force_of_capacity")
    assert check.value == pytest.approx(force / 50e3) and check.time == time
    assert dict(attitude(Subject(coarse)))["largest force of a guide"].startswith("g 3.90 kN at 1.2 s")
    assert guide_peak(fine, guide)[0] == float(fine.column("guide_force", "g").max()) > 1.3 * one
