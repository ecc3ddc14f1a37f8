"""A load that tilts fast beside many slow motions.

`gantline statics` says in which period a load tilts to and fro: that of the natural motion that has most
part in the tilt that a moment makes. It looked among the slowest motions alone, six unless more were asked
for. Under cranes with falls, and afloat, these are swings of hooks and motions of vessels in which the load
hardly tilts: a module on one equalizer off a barge was said to tilt in 26.8 s, the surge of the crane barge
on its moorings, where it does in 4.1 s; `goliath` in 14.2 s instead of 1.1 s, `floating_crane` in 15.9 s
instead of 7.0 s. And of two motions of one period only the later one counted: a load that is alike both
ways seemed to tilt as it turns about plumb.
"""

from __future__ import annotations

import math

import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study import tilting_of
from mechanics import G
from plumb_lift import AXIAL_STIFFNESS, LENGTH, MASS, plumb_lift

SLOWEST = 3  # two swings, and turning about plumb


@pytest.mark.parametrize("known", [0, SLOWEST, None])
def test_period_does_not_depend_on_how_many_motions_are_known(known: int | None) -> None:
    """Four plumb slings of stiffness k at ±y, level with the centre of gravity: T = 2π √(I/(4 k y²))."""
    question = Statics(parse_scenario(plumb_lift("").replace("cases:\n", "")))
    rest = question.equilibrium()
    swing = 2 * math.pi * math.sqrt(LENGTH / G)  # m on slings of 10 m: slower than any tilting
    assert all(mode.period is None or mode.period > 0.5 * swing for mode in question.modes(SLOWEST))
    inertia = MASS / 12 * (10.0**2 + 5.0**2)  # box of 10 m x 10 m x 5 m [kg m²]
    stiffness = 4 * AXIAL_STIFFNESS / LENGTH * 2.5**2  # [N m/rad]
    (found,) = tilting_of(question, rest, question.modes(known))
    # Stretch by 0.37 % makes slings softer by half of that.
    assert found.period == pytest.approx(2 * math.pi * math.sqrt(inertia / stiffness), rel=2e-3)
