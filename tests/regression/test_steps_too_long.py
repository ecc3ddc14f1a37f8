"""Fixed steps of seconds, for milliseconds.

`step: 10 s` damps all that rings away: a lift of four slings had a dynamic factor of 1.000, its energy
balance closed, and it was GO. Steps above 50 ms were told then; 40 ms took half of what a
load rang with, and nothing was said.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import DYNAMIC, LIFT
from gantline.scenario import parse_scenario


@pytest.mark.parametrize(("step", "is_told"), [(10.0, True), (0.006, True), (0.005, False)])
def test_steps_that_damp_everything_are_told(step: float, is_told: bool) -> None:
    recording = gantline.simulate(parse_scenario(LIFT), integrator="del", step=step)
    said = [one for one in recording.attributes["warnings"] if one.startswith(f"steps of {step:g} s: ")]
    assert len(said) == is_told


def test_steps_that_lower_a_dynamic_factor_are_told() -> None:
    """A hoist that starts in 50 ms sets its load ringing: a factor of 1.118, and of 1.053 with 40 ms."""
    lift = parse_scenario(LIFT.replace("acceleration: 0.05 m/s^2", "acceleration: 1 m/s^2"))
    exact, long = gantline.simulate(lift), gantline.simulate(lift, integrator="del", step=0.04)
    name = "dynamic_amplification_factor"
    assert long.metrics()[name] < DYNAMIC < exact.metrics()[name]
    assert any("at 4 Hz by 50 % of critical" in one for one in long.attributes["warnings"])
    assert not exact.attributes["warnings"]
