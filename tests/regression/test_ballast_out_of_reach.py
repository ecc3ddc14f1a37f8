"""Tanks amidships that were to take a trim away were said to give "no answer in 30 rounds".

More water in both of two tanks at half length makes a barge displace more, so that it trims a little less,
but no content of theirs takes the trim away. The search went from contents to others that were hardly nearer
until its rounds were over, and said that, as if more rounds would do.
"""

from __future__ import annotations

import pytest

from ballasted import barge, lift, tank
from gantline.study.ballast import solve_ballast
from gantline.study.newton import CannotBeError

SIDES = {
    "P": tank((50.0, 10.0, 1.0), 900.0, (20.0, 8.0, 6.0)),
    "S": tank((50.0, -10.0, 1.0), 600.0, (20.0, 8.0, 6.0)),
}


def test_is_told_as_such() -> None:
    aft = {"aft": tank((10.0, 0.0, 1.0), 400.0, (10.0, 20.0, 6.0))}
    scenario = lift(barge({**SIDES, **aft}))
    with pytest.raises(CannotBeError, match=r"^the tanks cannot do it; the nearest that was found is heel "):
        solve_ballast(scenario, tanks=["P", "S"])
