"""A box in wind from abeam had a margin of 45 mm for its centre of gravity, "unstable", of 1.5 m or more.

Below one hook nothing holds a heading, and wind turns the box about plumb, slowly, once its centre of gravity
is aside of where the wind pushes: it stays level as it is. That was told in the words for a load that tips.
The wind from abeam held the heading by next to nothing, so that the box was told to tilt "as if hung at
0.00 m", by 87.91 degrees per 100 mm.
"""

from __future__ import annotations

from math import sqrt

import pytest

from four_slings import LIFT
from gantline.scenario import Scenario, parse_scenario
from gantline.statics import Statics
from gantline.study import margins_of
from gantline.study.tilting import tilting_of, untold
from lift_text import changed
from mechanics import G

#: Lugs across the load and above its centre of gravity; length and stiffness of the slings [m, N].
ACROSS, ABOVE, LENGTH, STIFFNESS = 1.5, 1.5, 8.6, 89.06e6
MASS, SPEED, AREA, COEFFICIENT = 40e3, 12.0, 12.0, 1.2
WIND = f"wind: {{speed: {SPEED} m/s, direction: 90 deg}}\n"


def lift(more: str = "") -> Scenario:
    """The module as it hangs from the start on, the middles of its wind areas in that of the box."""
    ends = f"ends: {{area: 9 m^2, along: x, coefficient: {COEFFICIENT}}}"
    areas = f"wind_areas: {{sides: {{area: {AREA} m^2, along: y, coefficient: {COEFFICIENT}}}, {ends}}}\n"
    stands = ("ground: {friction: 0.5}\n", ""), ("  stands_on: ground\n", "")
    hanging = changed(LIFT, ("  lugs:\n", f"  {areas}  lugs:\n"), *stands)
    # Lugs that bear what two of them have to, and a tilt that may be, at the end of a margin that is to be
    # one of slack slings.
    hanging = hanging.replace("capacity: 13.2 t", "capacity: 30 t")
    rest = "plan: [{step: hold, hold: until_end}]\nlimits: {rule: own, load_tilt: 30 deg}\n"
    return parse_scenario(f"{hanging[: hanging.index('plan:')]}{rest}{more}")


def by_hand() -> float:
    """How far aside the two slings of the other side have nothing to carry [m].

    Plumb through the hook the centre of gravity lies in the plane of the two that carry, W/2 each over the
    cosine of their angle. They are longer by that, and the hook stands L ΔL/2b aside in the load's axes.
    """
    high = sqrt(LENGTH**2 - 2.5**2 - ACROSS**2)
    longer = MASS * G / 2 * LENGTH / high / STIFFNESS * LENGTH
    aside = LENGTH * longer / (2 * ACROSS)
    return ACROSS + (ACROSS + aside) * ABOVE / high


def test_in_wind_as_in_calm_air() -> None:
    """The wind leans the load by its force over the weight, 9.6 m below the hook."""
    assert by_hand() == pytest.approx(1.79, abs=5e-3)
    leans = 0.5 * 1.225 * COEFFICIENT * AREA * SPEED**2 / (MASS * G) * 9.6
    for more, off in (("", 0.01), (WIND, leans)):
        scenario = lift(more)
        margins = {one.direction: one for one in margins_of(scenario, Statics(scenario).equilibrium())}
        assert margins["+y"].cause in ("C, D slack", "D, C slack")
        assert margins["−y"].cause in ("A, B slack", "B, A slack")
        for way in ("+y", "−y"):
            assert margins[way].distance == pytest.approx(by_hand(), abs=off)
        assert margins["up"].cause == "nothing; further on it is outside the load"


def test_its_tilt_is_not_told() -> None:
    question = Statics(lift(WIND))
    rest = question.equilibrium()
    found = tilting_of(question, rest, question.modes())
    assert (found, untold(rest, found)) == ([], ["module"])
