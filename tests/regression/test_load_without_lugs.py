"""A load without lugs, in baskets or on ropes of `mechanics`.

Its file could not be written: `lugs: {}` was answered by `is empty; leave it out or fill it`, and a load that
left it out by `'lugs' is missing; the load needs it`.
"""

from __future__ import annotations

import math

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from gantline.statics import Statics
from mechanics import G
from pipe_in_baskets import pipe_in_baskets

LIFT = pipe_in_baskets(hooks=7.5)


def test_baskets_bear_it() -> None:
    """Both legs of both baskets carry W/(4 cos α), sin α = 0.5 m over the leg of 5 m and its stretch."""
    rest = Statics(parse_scenario(LIFT)).equilibrium()
    tension = rest.tension("west")
    stretched = 11.0 * (1 + tension / 20e6)
    leg = 0.5 * (stretched - 1.0)
    alpha = math.asin(0.5 / leg)
    assert tension == pytest.approx(10e3 * G / (4 * math.cos(alpha)), rel=1e-6)
    assert rest.tension("east") == pytest.approx(tension, rel=1e-6)


@pytest.mark.parametrize(("below", "is_stable"), [(0.052, True), (0.049, False)])
def test_it_rolls(below: float, is_stable: bool) -> None:
    """The hook is on an ellipse about the eyes: the load is lowest upright where c > a²/b, 0.25/4.975 m.

    The axes are l = 5 m and b = √(l² - a²); from a centre of gravity c below the middle the hook is at the
    distance squared l² sin² t + (b cos t + c)², which is largest at t = 0 while a² < b c.
    """
    text = pipe_in_baskets(hooks=7.5, eyes=below)
    assert Statics(parse_scenario(text)).equilibrium().is_stable is is_stable


def test_what_is_empty_may_be_left_out() -> None:
    """As the message says."""
    with pytest.raises(ScenarioError, match=r"load\.lugs: is empty; leave it out or fill it"):
        parse_scenario(LIFT.replace("cranes:", "  lugs: {}\ncranes:"))
