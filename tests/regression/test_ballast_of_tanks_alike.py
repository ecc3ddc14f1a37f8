"""Contents of tanks that do nearly alike, between which the search went to and fro until it gave up.

Four tanks stand in a row on either side. Water in one of a row, or shared by two of it, heels and trims
alike and is nearly as much, so what answers do not say to first order made now one and now the other the
least: "no answer in 30 rounds; the nearest that was found is heel 0.601 deg, 0.001 deg off".
"""

from __future__ import annotations

import math

import pytest

from ballasted import barge, lift, tank
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study import solve_ballast
from gantline.study.afloat import Afloat

#: Tanks along the barge [m], and what is in those to port and to starboard [t].
PLACES = (15.0, 38.0, 62.0, 85.0)
ROWS = ((300.0, 600.0, 300.0, 400.0), (700.0, 400.0, 600.0, 700.0))


def test_tanks_that_do_nearly_alike_do_not_take_turns_without_an_end() -> None:
    """Heel and trim as wanted, with the contents put back into the lift file to the kilogram too."""
    tanks = {
        f"{side}{place:g}": tank((place, y, 0.5), content, (18.0, 12.0, 5.0))
        for side, y, row in zip("ps", (7.0, -7.0), ROWS, strict=True)
        for place, content in zip(PLACES, row, strict=True)
    }
    heel, trim = math.radians(0.6), math.radians(-0.3)
    answer = solve_ballast(lift(barge(tanks)), heel=heel, trim=trim)
    assert (answer.attitude.heel, answer.attitude.trim) == pytest.approx((heel, trim), abs=1e-7)
    again = Afloat(Statics(parse_scenario(answer.text)), "barge", 0.0).attitude
    # Half a kilogram in each of eight tanks, 7 m aside, over a GM of some 10 m and 16 000 t: 2e-7 rad.
    assert (again.heel, again.trim) == pytest.approx((heel, trim), abs=5e-7)
