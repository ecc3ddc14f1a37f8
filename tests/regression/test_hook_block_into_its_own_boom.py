"""A hook block that a tugger pulled into the boom of its own crane: nothing was said.

Hook blocks were held against the booms of other cranes alone.
"""

from __future__ import annotations

import pytest

import gantline
from crawler_lift import crawler_lift
from gantline.checks import Verdict
from gantline.scenario import parse_scenario
from of_recording import checks_of

#: A spring from 55.5 m behind the hook, 40 m long where it is slack.
_TUGGER = """\
  ropes:
    pull: {{rope: tug, length: 40 m, stretched: true,
      route: [{{type: end, body: world, at: [-40 m, -2 m, 30 m]}}, {{type: end, body: c1.H}}]}}
plan:
"""


@pytest.mark.parametrize(("stiffness", "is_hit"), [(150, True), (80, False)])
def test_a_hook_block_pulled_into_its_boom(stiffness: float, is_hit: bool) -> None:
    """20 t, 34 m below the head of a boom at 80°: 6 m before it, as far as 20 t g 6/34 = 35 kN pull it.

    150 kN (49.5 - 40)/40 are 36 kN, 80 kN (52.2 - 40)/40 are 24 kN, which pull it by 4.2 m.
    """
    lift = crawler_lift(20e3, boom="angle: 80 deg", slew=0.0, duration=0.2)
    lift = lift.replace("plan:\n", _TUGGER.format(), 1)
    lift = lift.replace("ropes:\n  hoist", f"ropes:\n  tug: {{axial_stiffness: {stiffness} kN}}\n  hoist", 1)
    found = checks_of(gantline.simulate(parse_scenario(lift)), "no_overlap")
    hits = [one.verdict for one in found if one.element == "c1.boom to c1.H"]
    assert hits == ([Verdict.FAILED] if is_hit else [])


@pytest.mark.parametrize(("angle", "height"), [(80, 58), (70, 56)])
def test_a_hook_block_close_below_its_head(angle: float, height: float) -> None:
    """Where hoists stop it, 3.5 m below the sheaves above, it is in what is drawn of the head."""
    lift = crawler_lift(20e3, boom=f"angle: {angle} deg", duration=0.2)
    lift = lift.replace("height: 30 m}", f"height: {height} m}}")
    assert all(
        one.verdict is Verdict.OK for one in checks_of(gantline.simulate(parse_scenario(lift)), "no_overlap")
    )
