"""Gravity with a digit or a unit that had slipped: all forces a tenth, and GO without a word.

With `gravity: 0.981 m/s^2` the slings of the module had a factor on their breaking force of 96 in place of
11. Capacities in tonnes follow gravity, so hooks and lugs were used as before, and nothing looked odd.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario


def told(gravity: str) -> list[str]:
    """Warnings of the module's lift file that name gravity."""
    text = f"{LIFT}simulation: {{gravity: {gravity}}}\n"
    return [one for one in assemble(parse_scenario(text, "x.yaml")).warnings if "gravity" in one]


@pytest.mark.parametrize("gravity", ["0.981 m/s^2", "32.2 m/s^2"])
def test_gravity_that_is_nowhere_on_earth_is_told(gravity: str) -> None:
    (told_of,) = told(gravity)
    assert told_of.startswith("a load weighs ")
    assert told_of.endswith("where gravity is 9.76 to 9.84 m/s^2; a unit or digit has slipped")


@pytest.mark.parametrize("gravity", ["9.764 m/s^2", "9.80665 m/s^2", "9.834 m/s^2", "10 m/s^2"])
def test_gravity_between_equator_and_poles_is_not(gravity: str) -> None:
    """9.780 m/s^2 at the equator and 9.832 m/s^2 at the poles, at sea level: GRS 80."""
    assert told(gravity) == []
