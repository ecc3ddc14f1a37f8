"""Moving sheaves of 0.8 mm for 0.8 m were in order, with a rope of 46 mm over them.

Of drums it was told; of an equalizer nothing but its own check of D/d said so, for which nobody sets a limit.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario


def told(lift: str, path: str, diameter: str) -> list[str]:
    doubts = assemble(load_scenario(lift).changed({path: diameter})).doubts
    return [f"{one.path}: {one.sentence}" for one in doubts]


@pytest.mark.parametrize(("diameter", "is_told"), [("0.8 mm", True), ("80 mm", True), ("100 mm", False)])
def test_a_groove_of_no_room(diameter: str, is_told: bool) -> None:
    """A pitch diameter of twice the rope's leaves a tread as thick as the rope."""
    path = "equalizers.e1.moving_sheaves.pitch_diameter"
    said = [
        f"{path}: the moving sheaves of e1 have a pitch diameter of {diameter}, their rope is 46 mm thick; "
        "11 to 25 times that is usual, and a unit has slipped"
    ]
    assert told("equalizer_yard", path, diameter) == (said if is_told else [])


def test_sheaves_of_a_type() -> None:
    """Each equalizer that has them is told where its type says so."""
    path = "equalizer_types.EQ5-300.fixed_sheaves.pitch_diameter"
    said = told("goliath", path, "0.8 mm")
    assert len(said) == 3
    assert all(one.startswith(f"{path}: the fixed sheaves of E") for one in said)
