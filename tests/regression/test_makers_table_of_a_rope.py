"""A curve of a rope as its maker's table has it.

Such a table begins with 0 % over 0 %, and has forces in % of what breaks the rope. The first point was
refused by "this share has to be above zero", from which nobody learns that a curve begins at nothing by
itself, and 3 % by "needed is a force", which does not say of what it is a share.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from gantline.scenario.curve import RopeCurve

LIFT = """
format: 1
lift: {{title: A line}}
duration: 1 s
ropes:
  nylon: {{curve: {curve}, minimum_breaking_force: 640 kN}}
mechanics:
  bodies: {{one: {{joint: {{type: free}}, mass: 1 t, inertia: {{xx: 1 t m^2, yy: 1 t m^2, zz: 1 t m^2}}}}}}
"""


@pytest.mark.parametrize(
    ("curve", "said"),
    [
        (
            "{strain: [0 %, 5 %, 10 %], tension: [0 kN, 19 kN, 58 kN]}",
            "curve.strain: item 1: '0 %' is zero; a curve begins there by itself: leave this point out",
        ),
        (
            "{strain: [5 %, 10 %], tension: [0 kN, 58 kN]}",
            "curve.tension: item 1: '0 kN' is zero; a curve begins there by itself: leave this point out",
        ),
        (
            "{strain: [5 %, 10 %], tension: [3 %, 9 %]}",
            "curve.tension: '3 %' is a share; a force is needed, such as '10 kN': multiply by",
        ),
        ("{strain: 0 %, tension: [3 kN]}", "curve.strain: found '0 %'; a list is needed, such as [5 %]"),
        ("{strain: [], tension: [3 kN]}", "curve.strain: found a list of 0; at least 1 are needed"),
        ("{strain: 0.05, tension: [3 kN]}", "curve.strain: found '0.05'; a list is needed"),
    ],
)
def test_what_is_right_is_said(curve: str, said: str) -> None:
    with pytest.raises(ScenarioError) as problem:
        parse_scenario(LIFT.format(curve=curve))
    assert said in str(problem.value)


def test_what_begins_with_a_nought_is_no_zero() -> None:
    found = RopeCurve.model_validate({"strain": ["0.5 %", "0.02"], "tension": ["0.5 kN", "2 kN"]})
    assert found.points == [(0.005, 500.0), (0.02, 2000.0)]
