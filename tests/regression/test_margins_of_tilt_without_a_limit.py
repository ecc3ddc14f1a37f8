"""Of a girder in two plumb slings, which 0.13 m of its centre of gravity tilt by 5°, margins said "nothing".

Its lift file had no limit for tilt, so that the search went on to the side of the load, where it hung at 45°:
`1.500 m  nothing; further on it is outside the load`. Checks warn past 5° without a limit, and so do margins.
"""

from __future__ import annotations

import math

import pytest

from gantline.scenario import Scenario, parse_scenario
from gantline.statics import Statics
from gantline.study.tilting import Margin, margins_of
from plumb_lift import plumb_lift

#: Two lugs in line along x, and how high they are over the centre of gravity [m].
LUGS, DEPTH = {"A": (2.5, 0.0), "B": (-2.5, 0.0)}, 1.5
#: From which tilt checks warn where no limit is set [rad].
BOUND = math.radians(5.0)


def _lift(more: str = "") -> Scenario:
    text = plumb_lift("none: {set: {duration: 10 s}}", lugs=LUGS, more=more)
    return parse_scenario(text.replace("at: [0 m, 0 m, 2.5 m], env", "at: [0 m, 0 m, 1 m], env"))


def _margins(lift: Scenario) -> dict[str, Margin]:
    return {one.direction: one for one in margins_of(lift, Statics(lift).equilibrium(10.0))}


@pytest.mark.parametrize("way", ["+y", "−y"])
def test_a_tilt_of_which_checks_warn_ends_a_margin(way: str) -> None:
    """tan 5° of the depth of the centre of gravity below the lugs, to the millimetre of the search."""
    margin = _margins(_lift())[way]
    assert margin.distance == pytest.approx(DEPTH * math.tan(BOUND), abs=1.5e-3)
    assert margin.cause == "tilt beyond 5.00 deg, of which checks warn"


def test_a_limit_of_the_lift_file_stands_before_it() -> None:
    """With 20° in the file, tan 20° of it."""
    margin = _margins(_lift("limits: {rule: own, load_tilt: 20 deg}\n"))["+y"]
    assert margin.distance == pytest.approx(DEPTH * math.tan(math.radians(20.0)), abs=1.5e-3)
    assert margin.cause == "tilt beyond its limit of 20.00 deg"
