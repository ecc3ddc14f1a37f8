"""`direction: SW` of wind was `is not a number with a unit`, without a word of what would be right.

Directions are angles from world x towards y in which things go, and weather reports say from where wind and
waves come: so both answers are told, and that they are for axes with x to the east and y to the north."""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from gantline.units import UnitError, quantity
from guided_lift import guided_lift


def told(text: str) -> str:
    with pytest.raises(UnitError) as caught:
        quantity(text, "angle")
    return str(caught.value)


# From east towards north: 0 deg is E, 90 deg is N, and half a quadrant between them is 45 deg.
@pytest.mark.parametrize(
    ("point", "towards", "back"),
    [("E", 0, 180), ("N", 90, 270), ("SW", 225, 45), ("nw", 135, 315), ("SSE", 292.5, 112.5)],
)
def test_both_ways_are_told(point: str, towards: float, back: float) -> None:
    right = f"'{towards:g} deg' is towards {point}, and what comes from {point} has '{back:g} deg'"
    assert told(point).startswith(f"'{point}' is a point of the compass; angles count from world x towards y")
    assert told(point).endswith(f"with x to the east and y to the north {right}")


def test_other_words_are_no_points() -> None:
    assert told("SWW").startswith("'SWW' is not a number with a unit")
    with pytest.raises(UnitError, match="'SW' is not a number with a unit"):
        quantity("SW", "length")


def test_it_is_told_at_the_key() -> None:
    text = guided_lift("  {}", more="wind: {speed: 8 m/s, direction: SW}").replace("guides:\n  {}", "")
    with pytest.raises(ScenarioError, match=r"wind\.direction: 'SW' is a point of the compass"):
        parse_scenario(text)
