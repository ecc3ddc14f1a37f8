"""A crawler crane had no `wind_limit`: "is not a key of a crawler crane", though its chart has one.

Blades of wind turbines are lifted up to the wind that the chart allows. A lift file could say it of Goliath
cranes alone, and `wind_of_limit: 100 %` of a crawler crane was held against nothing.
"""

from __future__ import annotations

import numpy as np
import pytest

from crawler_lift import crawler_lift
from gantline.assembly import assemble
from gantline.checks import Verdict
from gantline.checks.limits import LIMITS
from gantline.checks.measure import Found, Missing
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.variable import Variable
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from of_recording import checks_of

#: A mean of 8 m/s with gusts of 11 m/s.
WIND = "wind: {speed: 8 m/s, direction: 90 deg, gusts: {speed: 11 m/s}}\n"
LIMIT = "    wind_limit: {} m/s\n"


@pytest.mark.parametrize(("limit", "verdict"), [("10", Verdict.FAILED), ("11.1", Verdict.OK)])
def test_gusts_are_held_against_the_chart(limit: str, verdict: Verdict) -> None:
    text = crawler_lift(60e3, crane=LIMIT.format(limit), more=WIND)
    recording = Simulation(parse_scenario(text)).run()
    (check,) = checks_of(recording, "wind_of_limit")
    assert check.verdict is verdict and check.value == pytest.approx(11.0 / float(limit))


def test_a_boom_without_one_is_told_where_the_lift_asks() -> None:
    """Where nobody asks there is no line of it, as before."""

    def found(**limits: float) -> list[Found | Missing]:
        rig = {"booms": [{"name": "c1", "wind": 11.0}], "limits": limits}
        recording = Recording({"time": Variable(("time",), np.arange(2.0), "s", "")}, {}, {"rig": rig})
        return list(LIMITS["wind_of_limit"].findings(recording, np.ones(2, dtype=np.bool_)))  # type: ignore[arg-type]

    assert found() == []
    assert found(wind_of_limit=1.0) == [Missing("c1", "wind limit not known")]


def test_a_speed_alone_is_held_against_it_too() -> None:
    """14.1 m/s are past what is usual for booms, and within what this chart allows."""
    text = crawler_lift(60e3, crane=LIMIT.format("15"), more="wind: 14.1 m/s\n")
    assembly = assemble(parse_scenario(text))
    assert not [one for one in assembly.warnings if "wind" in one]
    (boom,) = Rig.from_json(assembly.rig).booms
    assert (boom.wind, boom.wind_limit) == (14.1, 15.0)
