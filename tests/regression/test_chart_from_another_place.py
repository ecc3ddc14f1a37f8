"""Charts by the radius of a floating crane, which has no slewing axis, and by the outreach of a crawler.

Such a chart was read at the outreach from the bow, whatever its maker counts from. A sheerleg whose heel
pins are 7.6 m behind its bow, 55.0 m from them to its hook, was rated for 1404 t, where its chart from the
heel pins has 1100 t: 1250 t were a GO at 89 %, and are 114 %. The lift file is refused, and says the word
that is right; `outreach_from` at the heel pins reads the chart where its maker does.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from crawler_lift import crawler_lift
from gantline.scenario import ScenarioError, parse_scenario
from gantline.statics import Statics
from harbour_lift import HARBOUR_LIFT

#: Of the floating crane of that lift: heel pins, bow, length of the boom [m]; its angle [deg].
PINS, BOW, BOOM, ANGLE = 98.0, 105.6, 110.0, 60.0
_OUTREACH = "rating: {outreach: ["
#: Two rows of its chart: places [m] and rated loads [t].
PLACES, RATED = (45.0, 60.0), (1500.0, 900.0)


def test_a_radius_of_a_floating_crane_is_refused() -> None:
    assert HARBOUR_LIFT.count(_OUTREACH) == 1
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(HARBOUR_LIFT.replace(_OUTREACH, "rating: {radius: ["))
    assert "cranes.fc.rating.radius: this crane has no 'slewing_axis' from which a radius counts" in str(
        refused.value
    )
    assert "'outreach' is right, which counts from the bow" in str(refused.value)


def test_an_outreach_of_a_crawler_crane_is_refused() -> None:
    text = crawler_lift(150e3).replace("rating: {radius: [", "rating: {outreach: [")
    with pytest.raises(ScenarioError, match=r"cranes\.c1\.rating\.outreach: a crane that slews has no bow"):
        parse_scenario(text)


def outreach_from(place: float) -> float:
    """Outreach of the hook at the start that counts from this x of the vessel [m]."""
    scenario = parse_scenario(HARBOUR_LIFT.replace("outreach_from: 105.6 m", f"outreach_from: {place} m"))
    recording = Statics(scenario).equilibrium(time=0.0).recording
    return float(recording.column("crane_radius", "fc.H1")[-1])


def test_an_outreach_counts_from_where_the_file_says() -> None:
    """From heel pins 7.6 m behind the bow it is 7.6 m more, times cos of the trim before it lifts.

    That is 2 deg: cos is 6e-4 below 1, of 7.6 m 5 mm.
    """
    assert outreach_from(PINS) - outreach_from(BOW) == pytest.approx(BOW - PINS, abs=0.01)


def test_the_figures_of_the_story() -> None:
    """On even keel: 98 m + 110 m cos 60 deg is 47.4 m from the bow, 55 m from the heel pins."""
    head = PINS + BOOM * math.cos(math.radians(ANGLE))
    rated = [float(np.interp(head - place, PLACES, RATED)) for place in (BOW, PINS)]
    assert rated == pytest.approx([1404.0, 1100.0])
    assert [1250.0 / one for one in rated] == pytest.approx([0.89, 1.136], abs=1e-3)
