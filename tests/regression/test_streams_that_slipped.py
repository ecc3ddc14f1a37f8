"""Wind and current that pushed nothing, or pushed what is not there, and lifts that were GO with them.

Wind across a module whose only area is along it passed by and pushed nothing: a direction or an axis was 90°
off, and the lift came out as in a calm. An area of 6000 m² at a height of 300 m, on a load of 10 × 8 × 6 m,
and a current of 14.4 m/s, 4 m/s in km/h read as 14.4, were taken as they were. Lugs and tag lines off the
load's box have always been told.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario


def told(wind: str, areas: str, current: str = "") -> list[str]:
    """Of a module of 6 × 4 × 3 m."""
    text = LIFT.replace("ground:", f"{wind}{current}ground:")
    return list(assemble(parse_scenario(text.replace("  lugs:\n", f"  {areas}\n  lugs:\n"))).warnings)


def blowing(direction: float, speed: float = 10.0) -> str:
    return f"wind: {{speed: {speed} m/s, direction: {direction} deg}}\n"


def of_wind(along: str, size: float = 12.0, at: str = "[0 m, 0 m, 1.5 m]") -> str:
    return f"wind_areas: {{side: {{area: {size} m^2, coefficient: 1.2, along: {along}, at: {at}}}}}"


@pytest.mark.parametrize(
    ("direction", "along", "is_told"),
    [(0.0, "x", False), (90.0, "x", True), (-90.0, "x", True), (0.0, "y", True), (88.0, "x", False)],
)
def test_a_direction_along_the_areas(direction: float, along: str, is_told: bool) -> None:
    said = (
        f"the wind towards {direction:.0f} deg pushes module nowhere at the start: all of its 'wind_areas' "
        "lie along it; see 'direction' and 'along'"
    )
    assert told(blowing(direction), of_wind(along)) == ([said] if is_told else [])


def test_turned_with_its_load() -> None:
    """The axis of a load with a heading of 90° is world y."""
    areas = "heading: 90 deg\n  " + of_wind("x")
    assert not any("nowhere" in one for one in told(blowing(90.0), areas))
    assert any("nowhere" in one for one in told(blowing(0.0), areas))


@pytest.mark.parametrize(
    ("size", "at", "said"),
    [
        (12.0, "[0 m, 0 m, 3.9 m]", []),
        (12.0, "[0 m, 0 m, 15 m]", ["the wind area side of module pushes 12 m outside the load's box"]),
        (23.0, "[0 m, 0 m, 1.5 m]", []),
        (
            120.0,
            "[0 m, 0 m, 1.5 m]",
            ["module has 120 m^2 of wind areas along x, and its box 12 m^2; a number has slipped"],
        ),
    ],
)
def test_an_area_off_its_load(size: float, at: str, said: list[str]) -> None:
    """The side across x of a box of 6 × 4 × 3 m has 12 m²; twice that is taken."""
    assert told(blowing(0.0), of_wind("x", size, at)) == said


def test_speeds_of_another_unit() -> None:
    wet = "current_areas: {end: {area: 12 m^2, coefficient: 1.2, along: x, at: [0 m, 0 m, 1.5 m]}}"
    current = "current: {speed: 14.4 m/s, direction: 0 deg}\n"
    assert told("", wet, current) == [
        "the current of 14.4 m/s is faster than 5.0 m/s; a unit has slipped, m/s for km/h"
    ]
    assert told("", wet, current.replace("14.4", "4.0")) == []
    assert any("is faster than 60.0 m/s" in one for one in told(blowing(0.0, 61.0), of_wind("x")))
