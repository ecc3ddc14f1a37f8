"""A carrier that lay across a river of 1 m/s felt nothing of it, beside two crane barges that did.

The lift file gave `current_areas` to the crane barges and forgot the carrier, broadside on; its mooring lines
came to 4.4 % of their breaking force, and no word said that the current passes it. A stream that pushes
nothing at all was told. So it was with a load without `wind_areas` beside a vessel that has some.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

BARGE = """
  {name}:
    position: [0 m, {y} m]
    draft: 2 m
    hull: {{box: [40 m, 12 m, 4 m]}}
    masses: {{all: {{mass: 984 t, at: [20 m, 0 m, 2 m]}}}}
    radii_of_gyration: [4 m, 11 m, 11 m]
"""
AREAS = "    current_areas: {side: {area: 80 m^2, coefficient: 1, along: y, at: [20 m, 0 m, 1 m]}}\n"
NONE = AREAS.replace("coefficient: 1", "coefficient: 0")
ACROSS = "current: {speed: 1 m/s, direction: 90 deg}\n"


def _warnings(first: str, second: str) -> list[str]:
    barges = BARGE.format(name="crane_barge", y=100) + first + BARGE.format(name="carrier", y=160) + second
    text = LIFT.replace("ground:", f"{ACROSS}vessels:{barges}ground:")
    return [one for one in assemble(parse_scenario(text)).warnings if "current" in one]


def test_a_vessel_that_the_current_passes_is_told() -> None:
    (told,) = _warnings(AREAS, "")
    assert told == (
        "the current of 1.0 m/s does not push carrier, without 'current_areas': give them, or one with a "
        "coefficient of 0 where that is meant"
    )


@pytest.mark.parametrize("second", [AREAS, NONE])
def test_one_with_areas_or_with_none_on_purpose_is_not(second: str) -> None:
    assert _warnings(AREAS, second) == []


def test_a_load_that_the_wind_passes_is_told() -> None:
    areas = AREAS.replace("current", "wind").replace("at: [20 m, 0 m, 1 m]", "at: [20 m, 0 m, 3 m]")
    wind = ACROSS.replace("current", "wind")
    text = LIFT.replace("ground:", f"{wind}vessels:{BARGE.format(name='barge', y=100)}{areas}ground:")
    told = [one for one in assemble(parse_scenario(text)).warnings if "wind" in one]
    assert [one.split(":")[0] for one in told] == [
        "the wind of 1.0 m/s does not push module, without 'wind_areas'"
    ]
