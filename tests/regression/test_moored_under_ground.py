"""Mooring lines made fast under the ground or the bottom of the water, and fibre ropes that weigh as steel.

A bollard at 0.39 m in place of 3.9 m, under a quay of 3.5 m, and an anchor at −60 m in water 10 m deep were
taken as they were, GO with 0 warnings; of tag lines the first has always been told. A line under water loses
what steel of its mass displaces: of a polyester rope, 1.2 kg/m of 44 mm, 10.2 N/m were left where it weighs
3.0 N/m, and one of polypropylene floats.
"""

from __future__ import annotations

from json import dumps
from typing import Any

import pytest

from afloat import barge, lift_of
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

STEEL = {"construction": "6x36 IWRC", "grade": "1960", "diameter": "44 mm"}
BASIN = {"type": "dock", "x": ["-400 m", "150 m"], "y": ["-300 m", "300 m"], "floor": "-30 m"}
QUAY: dict[str, Any] = {
    "ground": {"level": "3.5 m"},
    "structures": {
        "basin": {"type": "dock", "x": ["-400 m", "150 m"], "y": ["-300 m", "300 m"], "floor": "-30 m"}
    },
}


def told(to: tuple[float, float, float], rope: dict[str, Any] = STEEL, **given: Any) -> list[str]:
    line = {"vessel": "barge", "fairlead": ["98 m", "14 m", "6.5 m"], "rope": "moor", "pretension": "200 kN"}
    line |= {"to": [f"{part} m" for part in to], **given.pop("line", {})}
    whole = lift_of(barge(), ropes={"moor": rope}, mooring_lines={"bow": line}, **given)
    return [one for one in assemble(parse_scenario(dumps(whole))).warnings if "mooring line" in one]


@pytest.mark.parametrize(
    ("to", "said"),
    [
        ((170.0, 60.0, 3.9), None),
        ((170.0, 60.0, 0.39), "3.11 m under the ground"),
        ((140.0, 60.0, 0.39), None),
        ((140.0, 60.0, -30.0), None),
        ((140.0, 60.0, -33.0), "3 m under the floor of the dock"),
    ],
)
def test_under_ground(to: tuple[float, float, float], said: str | None) -> None:
    """A quay of 3.5 m beside a basin that ends at 150 m."""
    whole = f"mooring line bow is made fast {said}: 'to' is a place in the world"
    assert told(to, **QUAY) == ([] if said is None else [whole])


@pytest.mark.parametrize(("height", "is_told"), [(-10.0, False), (-10.9, False), (-60.0, True), (5.0, False)])
def test_under_the_bottom_of_the_water(height: float, is_told: bool) -> None:
    """A tenth of the depth is left to beds that slope."""
    found = told((340.0, 200.0, height), water={"depth": "10 m"})
    said = (
        "mooring line bow is made fast 50 m under the bottom of water 10 m deep: 'to' is a place in the world"
    )
    assert found == ([said] if is_told else [])


@pytest.mark.parametrize(
    ("mass", "is_wet", "is_told"), [(1.2, True, True), (1.2, False, False), (7.9, True, False)]
)
def test_ropes_of_no_steel(mass: float, is_wet: bool, is_told: bool) -> None:
    rope = {"axial_stiffness": "10 MN", "mass": f"{mass} kg/m", "diameter": "44 mm"}
    found = told((340.0, 200.0, -30.0), rope, line={"under_water": is_wet})
    said = (
        "mooring line bow weighs under water what is left of as much steel; 1.2 kg/m of 44 mm are no steel, "
        "and weigh less there, if they do not float"
    )
    assert found == ([said] if is_told else [])
