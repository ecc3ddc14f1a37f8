"""The warning that a hoist's motor or brake pulled all it could and its drum did not follow."""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario
from weak_hoist import standing


@pytest.mark.parametrize(("mass", "is_too_weak"), [(2.0, False), (3.0, True)])
def test_a_motor_that_cannot_lift_is_told(mass: float, is_too_weak: bool) -> None:
    """Two parts of 12 kN hold 2.45 t, hook block and load together."""
    text = standing("{step: hoist, hoist: crane, speed: 1 m/min, by: 0.5 m}", mass, "capacity: 12 kN", 60.0)
    recording = gantline.simulate(parse_scenario(text))
    found = [check for check in check_recording(recording) if check.name == "hoist_follows"]
    assert bool(found) is is_too_weak, found
    for check in found:
        assert check.verdict is Verdict.WARNING
        assert check.remark.endswith("motor or brake pull all they can")
