"""Pins of a hinge that bore more than is rated by a moment that was in no force.

A mast was pulled by a hook 6 m beside it. The force between load and hinge was 60 % of what both pins are
rated for, and the check said so; the moment askew, which two pins 1.5 m apart bear as a pair of forces, had
the one of them at 387 % of its half. A page said that the capacity does not know the moment; the check did
not.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Verdict
from gantline.results.loads.hinges import hinge_force, hinge_moment
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from hinged_mast import FOOT, HEAD, WEIGHT, mast
from mechanics import G
from of_recording import check_of

HOLD = "  - {step: hold, hold: 5 s}\n"
#: How far aside the hook hangs, and over the mast [m]; distance of the pins [m]; rated capacity of both [kg].
ASIDE, ABOVE, APART, RATED = 6.0, 49.0, 1.5, 90e3


def rest(*, aside: float = ASIDE, pins: str = "") -> Recording:
    hinge = f", rated_capacity: {RATED} kg{pins}"
    text = mast(HOLD, hook=(19.0, aside, 11.0 + ABOVE), hinge=hinge).replace("900 s", "5 s")
    return Statics(parse_scenario(text)).equilibrium(0.0).recording


def told(recording: Recording) -> Check:
    return check_of(recording, "hinge_force_of_rated_capacity")


def by_hand(aside: float = ASIDE) -> tuple[float, float]:
    """Force [N] and moment askew [N m] of the foot.

    The sling pulls with W FOOT/HEAD upwards, and so with aside/ABOVE of that along the axis of the hinge,
    which has the lever HEAD about upright through its middle.
    """
    up = WEIGHT * FOOT / HEAD
    across = up * aside / ABOVE
    return ((WEIGHT - up) ** 2 + across**2) ** 0.5, across * HEAD


def test_two_pins_bear_the_moment_too() -> None:
    """F + 2 M/b over the capacity, 387 %."""
    force, moment = by_hand()
    recording = rest(pins=f", pins_apart: {APART} m")
    (hinge,) = recording.rig.hinges
    assert hinge_force(recording, hinge)[-1] == pytest.approx(force, rel=2e-3)
    assert hinge_moment(recording, hinge)[-1] == pytest.approx(moment, rel=2e-3)
    check = told(recording)
    assert check.verdict is Verdict.FAILED
    assert check.value == pytest.approx((force + 2 * moment / APART) / (RATED * G), rel=2e-3)


def test_without_their_distance_the_moment_is_told() -> None:
    """Pins less than b apart with F + 2 M/b = C."""
    force, moment = by_hand()
    check = told(rest())
    assert check.verdict is Verdict.WARNING
    assert check.value == pytest.approx(force / (RATED * G), rel=2e-3)
    nearest = 2 * moment / (RATED * G - force)
    apart = float(check.remark.partition("two pins less than ")[2].partition(" m")[0])
    assert apart == pytest.approx(nearest, rel=0.01)


def test_a_hook_above_the_mast_has_no_moment() -> None:
    assert told(rest(aside=0.0)).verdict is Verdict.OK
    check = told(rest(aside=0.0, pins=f", pins_apart: {APART} m"))
    assert check.value == pytest.approx(by_hand(0.0)[0] / (RATED * G), rel=2e-3)
