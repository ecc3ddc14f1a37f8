"""The warning that a hoist's motor or brake pulled all it could and its drum did not follow."""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario
from of_recording import checks_of
from weak_hoist import standing

HOIST = "{step: hoist, hoist: crane, speed: 1 m/min, by: 0.5 m}"


@pytest.mark.parametrize(("mass", "is_too_weak"), [(2.0, False), (3.0, True)])
def test_a_motor_that_cannot_lift_is_told(mass: float, is_too_weak: bool) -> None:
    """Two parts of 12 kN hold 2.45 t, hook block and load together."""
    text = standing(HOIST, mass, "capacity: 12 kN", 60.0)
    recording = gantline.simulate(parse_scenario(text))
    found = checks_of(recording, "hoist_follows")
    assert bool(found) is is_too_weak, found
    for check in found:
        assert check.verdict is Verdict.WARNING
        assert "motor or brake pull all they can, while the hook goes up by 0.0" in check.remark


def test_a_hook_that_runs_away_before_the_lift_begins_fails() -> None:
    """A brake in N for kN: the hook block of 100 kg pulls 490 N, and goes down until its sling holds it."""
    weak = standing(HOIST, 2.0, "capacity: 12 N, brake: 12 N", 60.0)
    checks = check_recording(gantline.simulate(parse_scenario(weak)))
    found = next(check for check in checks if check.name == "hoist_follows")
    assert found.verdict is Verdict.FAILED
    assert "and the hook runs away: it begins" in found.remark
    # The sling of 6 m hangs down past the top of the load until it is taut.
    below = float(found.remark.split("begins ")[-1].split(" m below")[0])
    assert below > 5.9
