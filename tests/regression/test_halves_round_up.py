"""Figures that end on a half are rounded away from zero, as people do and as the player does.

The first page of `spreader_bar` had a design weight of 47.2 t, of 45 t x 1.05 = 47.25 t, and the sum below
it, with 3.11 t of rigging, was 50.4 t: whoever added up what stood there had 50.3 t.
"""

from __future__ import annotations

import math

import pytest

from gantline.units import format_quantity


@pytest.mark.parametrize(
    ("value", "unit", "digits", "shown"),
    [
        (1.05 * 45e3, "t", 1, "47.3 t"),
        (-1.05 * 45e3, "t", 1, "-47.3 t"),
        (2.5, "s", 0, "3 s"),
        (0.125, "m", 2, "0.13 m"),
        # What is less than a half by as little as a float can tell is less: 0.285 is 0.28499999999999998.
        (0.285, "m", 2, "0.28 m"),
        (-0.004, "m", 2, "0.00 m"),
        (1e15, "m", 1, "1000000000000000.0 m"),
        (math.nan, "m", 1, "nan m"),
        (math.inf, "m", 1, "inf m"),
    ],
)
def test_halves_go_away_from_zero(value: float, unit: str, digits: int, shown: str) -> None:
    assert format_quantity(value, unit, digits) == shown
