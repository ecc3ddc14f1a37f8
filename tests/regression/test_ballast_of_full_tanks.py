"""Contents of full tanks, which `gantline ballast --write` rounded to a lift file that is refused.

Contents are written to the kilogram. A tank of 8202.87 kg that has to be full was written with 8.203 t, and
the new lift file refused: "8.203 t do not go into it; it holds 8.20287 t". A tank that has to keep what the
plan pumps out of it was written with up to half a kilogram less, and refused as running empty.
"""

from __future__ import annotations

import math

import pytest

from ballasted import barge, lift, pump, tank
from floating import SEA
from gantline.scenario import parse_scenario
from gantline.scenario.afloat.tanks import tanks_of
from gantline.study import solve_ballast

BOX = (2.0, 2.0, 2.0007)
CAPACITY = SEA * math.prod(BOX)


def test_a_tank_that_has_to_be_full_is_written_with_what_goes_into_it() -> None:
    """The outer tank heels most for its water: it is filled before the inner one gets any."""
    tanks = {"outer": tank((50, 10, 0.5), 1.0, BOX), "inner": tank((50, 5, 0.5), 100.0)}
    assert round(CAPACITY) > CAPACITY, "to the nearest kilogram it would run over"
    answer = solve_ballast(lift(barge(tanks)), heel=math.radians(-0.3))
    assert answer.contents["outer"] == pytest.approx(CAPACITY, rel=1e-12)
    written = parse_scenario(answer.text)
    assert tanks_of(written)["barge.outer"].content == 8202.0
    again = solve_ballast(written, heel=math.radians(-0.3))
    assert again.moved < 3.0


def test_a_tank_keeps_what_the_plan_pumps_out_of_it() -> None:
    """Of the outer tank all is taken but 500.4 kg, which the plan pumps away later."""
    tanks = {"outer": tank((50, -10, 0.5), 5.0, BOX), "inner": tank((50, -5, 0.5), 100.0)}
    plan = [pump("outer", "sea", "100 t/h", by="500.4 kg"), {"step": "wait", "hold": "until_end"}]
    given = lift(barge(tanks), plan)
    answer = solve_ballast(given, heel=math.radians(0.05), time=0.0)
    assert answer.contents["outer"] == pytest.approx(500.4, rel=1e-9)
    assert tanks_of(parse_scenario(answer.text))["barge.outer"].content == 501.0
