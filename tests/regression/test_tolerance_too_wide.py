"""A `tension_tolerance` of 3 kN where slings bear 98 kN each: as the hook starts in 50 ms the dynamic
factor was 1.08 in place of 1.12, the energy balance closed, and nothing was said.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import DYNAMIC, LIFT
from gantline.scenario import parse_scenario

SHARP = LIFT.replace("acceleration: 0.05 m/s^2", "acceleration: 1 m/s^2")


@pytest.mark.parametrize(("tolerance", "is_told"), [(980.0, False), (1000.0, True)])
def test_a_wide_tolerance_is_told(tolerance: float, is_told: bool) -> None:
    """From a hundredth of what a sling bears on, 981 N."""
    run = gantline.simulate(parse_scenario(SHARP), tension_tolerance=tolerance, duration=30.0)
    assert any("is wide beside the 98.4 kN" in one for one in run.attributes["warnings"]) == is_told


def test_a_wide_tolerance_lowers_a_dynamic_factor() -> None:
    """To below the limit of the lift, which it is above; by default nothing is said."""
    lift = parse_scenario(SHARP)
    exact, wide = gantline.simulate(lift), gantline.simulate(lift, tension_tolerance=3000.0)
    name = "dynamic_amplification_factor"
    assert wide.metrics()[name] < DYNAMIC < exact.metrics()[name]
    assert any("is wide beside the 98." in one for one in wide.attributes["warnings"])
    assert not exact.attributes["warnings"]
