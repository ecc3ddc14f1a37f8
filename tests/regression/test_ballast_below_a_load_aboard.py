"""`gantline ballast` found nothing for a barge on whose deck a load stands that a crane ashore has set down.

Its equilibria let the load slide: it went down the least heel until its slings held it, so that the barge lay
otherwise on either side of even keel and never on it. After 30 rounds and a minute it said "no answer in 30
rounds; the nearest that was found is heel -0.011 deg", or 0.9 deg with slack slings. Friction holds what
stands on a deck, here as in a run.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.study.ballast import solve_ballast
from module_on_a_barge import LIFT


@pytest.mark.parametrize(("step", "share"), [("half", 0.5), ("further", 1.0)])
def test_tanks_right_what_stands_aboard(step: str, share: float) -> None:
    """Upright, 60 t 1 m to port are balanced by 15 t 4 m to starboard; half of it by half of that."""
    text = LIFT.replace("PULL", "pretension: 20 kN, type: spring")
    found = solve_ballast(parse_scenario(text), step=step)
    aside = found.contents["sb"] - found.contents["ps"]
    assert aside == pytest.approx(share * 15e3, rel=0.01)
    assert found.attitude.heel == pytest.approx(0.0, abs=1e-5)
    assert found.attitude.trim == pytest.approx(0.0, abs=1e-5)
    assert found.moved == pytest.approx(share * 15e3, rel=0.02)
