"""A hoist whose `capacity` was that of the hook held sixteen times as much as was meant, and nobody was told.

`capacity` and `brake` of a hoist are pulls of each rope. 2943 kN, the 300 t of the hook, in 16 parts of line
would hold 4800 t: `hoist_load_of_drive_capacity` was 5.8 %, ok, and neither motor nor brake could slip. The
rope itself breaks at 1231 kN.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario

LIFT = (Path(__file__).parents[2] / "scenarios/reeved_hoist/scenario.yaml").read_text(encoding="utf-8")
PULLS = "capacity: 260 kN, brake: 320 kN"


def told(pulls: str, text: str = LIFT) -> list[str]:
    assert PULLS in text
    warnings = assemble(parse_scenario(text.replace(PULLS, pulls))).warnings
    return [one for one in warnings if "motor" in one or "brake" in one]


def test_motor_for_the_hook() -> None:
    """16 x 2943 kN are what 4800 t weigh."""
    [found] = told("capacity: 2943 kN, brake: 320 kN")
    assert found.startswith(
        "the motor of hook pulls 2.94 MN at each rope: 16 parts of line would hold 4,800 t"
    )
    assert "the rated capacity is 300 t" in found


def test_brake_for_the_hook() -> None:
    [found] = told("capacity: 260 kN, brake: 3500 kN")
    assert found.startswith("the brake of hook pulls 3.5 MN at each rope")


def test_stronger_than_its_rope() -> None:
    """Where no rated capacity tells: 42 mm of 6x36 IWRC, 1960, break at 0.356 x 1960 x 42^2 N = 1231 kN."""
    text = LIFT.replace("    rated_capacity: 300 t\n", "")
    [found] = told("capacity: 1300 kN, brake: 1300 kN", text)
    assert found.startswith("motor and brake of hook pull 1.3 MN at each rope, which breaks at 1.23 MN")


@pytest.mark.parametrize("pull", ["260 kN", "500 kN"])
def test_usual_motors_are_in_order(pull: str) -> None:
    """184 kN in each of 16 parts hold the rated capacity; up to three times that nothing is said."""
    assert told(f"capacity: {pull}, brake: {pull}") == []
