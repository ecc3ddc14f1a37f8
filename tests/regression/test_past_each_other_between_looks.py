"""A crane that swung through another within two hours was not told: GO for what failed in a short run.

Drawn bodies were held against each other at 600 moments that were evenly apart in time, ropes and what they
go through at 60. In a run of two hours these are 12 s and two minutes apart, while a boom that slews is
through another in 8 s and its falls in 4 s. So it hung on how long the file let the load hang afterwards
whether two booms in the same place were a failure, or nothing.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import checks_of
from swung_crane import MIDDLE, swung


@pytest.mark.parametrize("duration", [100.0, 7200.0], ids=str)
def test_what_goes_through_is_told_however_long_the_run_goes_on(duration: float) -> None:
    """Looks that are evenly apart are at 36 s and 48 s of two hours, and booms, 1.9 m wide, meet at 42 s.

    The head goes 16 m from its axis with 1.8 deg/s, 0.5 m/s: from the one side of the other boom to the other
    in 3.8 m/0.5 m/s = 7.6 s.
    """
    assert pytest.approx(42.0) == MIDDLE
    recording = simulate(parse_scenario(swung(duration, 28.0)))
    deep = {one.element: one.verdict for one in checks_of(recording, "no_overlap")}
    assert deep["c1.boom to c2.boom"] is Verdict.FAILED
    ropes = {one.element: one.remark for one in checks_of(recording, "falls_and_lines_outside")}
    assert "through 'c1.boom'" in ropes["hoist.c2.H.1"]
