"""Limits of slings in a lift that hangs on ropes of `mechanics`.

A module on a spreader of `mechanics` with `sling_factor_on_breaking_force: 8` was a GO without a warning,
where its ropes have a factor of 5.3: no sling, nothing to check.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from hung_by_mechanics import LIFT
from lift_text import spoiled

LIMITS = {
    "sling_factor_on_breaking_force": "8",
    "sling_angle_from_vertical": "20 deg",
    "sling_angle_from_horizontal": "70 deg",
    "smallest_sling_tension_when_clear": "1 kN",
}
REMARK = "carries module as a rope of 'mechanics', which is no sling: down_1, down_2"


@pytest.mark.parametrize("key", LIMITS)
def test_what_bears_the_load_and_is_no_sling_is_named(key: str) -> None:
    text = spoiled("limits: {rule: yard}", f"limits: {{rule: yard, {key}: {LIMITS[key]}}}", LIFT)
    checks = check_recording(Simulation(parse_scenario(text)).run())
    [found] = [one for one in checks if one.name == key]
    assert (found.verdict, found.value, found.remark) == (Verdict.WARNING, None, REMARK)


def test_without_such_a_limit_it_is_no_warning() -> None:
    checks = check_recording(Simulation(parse_scenario(LIFT)).run())
    assert not [one for one in checks if one.name in LIMITS and one.verdict is not Verdict.NOT_CHECKED]
