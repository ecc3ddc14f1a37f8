"""A zero too many in the breaking force of a rope.

`minimum_breaking_force: 4890 kN` of a rope of 28 mm, for 489 kN, was taken as it stood: ropes had ten times
their factor, and the lift was GO.
"""

from __future__ import annotations

import math

import pytest

from four_slings import LIFT
from gantline.scenario import ScenarioError, parse_scenario

OLD = "{construction: 6x36 IWRC, grade: 1960, diameter: 44 mm, damping_time: 10 ms}"
#: What a circle of 28 mm holds, all of it steel of the grade 2160 of EN 10264-2 [kN].
MOST = 2160e6 * math.pi / 4 * 0.028**2 / 1e3


def text(force: float, diameter: str = ", diameter: 28 mm") -> str:
    assert OLD in LIFT
    return LIFT.replace(OLD, f"{{axial_stiffness: 36 MN, minimum_breaking_force: {force} kN{diameter}}}")


def breaking_force(text: str) -> float | None:
    ropes = parse_scenario(text).ropes
    assert ropes is not None
    return ropes["sling"].minimum_breaking_force


@pytest.mark.parametrize("force", [4890.0, 1.001 * MOST])
def test_more_than_steel_holds_is_refused(force: float) -> None:
    with pytest.raises(ScenarioError, match=r"kN/mm\^2 of a rope of 28 mm, and solid steel holds 2.16"):
        parse_scenario(text(force))


@pytest.mark.parametrize("force", [489.0, 0.999 * MOST])
def test_what_a_rope_may_hold_is_taken(force: float) -> None:
    assert breaking_force(text(force)) == pytest.approx(force * 1e3, rel=1e-12)


def test_without_a_diameter_nothing_is_known() -> None:
    assert breaking_force(text(4890.0, "")) == 4890e3
