"""A fixed hook had no `wind_limit`: the crane behind it has one, and its lift was held against none.

Who knows of a crane but where its hook is, and the wind in which it may lift, wrote `type: fixed_hook` and
was told that cranes of other types have a limit. `wind: 12 m/s` then was a warning, that it pushes nothing.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.checks import Verdict
from gantline.checks.limits import LIMITS
from gantline.report.first_page import stop_if
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from gantline.results.variable import Variable
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import simulate
from hinged_mast import mast
from of_recording import checks_of

PLAN = "  - {step: hold, hold: until_end}\n"


def lift(limit: str = ", wind_limit: 12 m/s", wind: str = "13 m/s", more: str = "") -> str:
    text = mast(PLAN, hook=(19.0, 0.0, 60.0), more=f"wind: {wind}\n{more}").replace("900 s", "10 s")
    return text.replace("type: fixed_hook", f"type: fixed_hook{limit}")


@pytest.mark.parametrize(
    ("wind", "speed", "verdict"),
    [
        ("13 m/s", 13.0, Verdict.FAILED),
        ("11.9 m/s", 11.9, Verdict.OK),
        ("{speed: 9 m/s, direction: 0 deg, gusts: {speed: 12.5 m/s}}", 12.5, Verdict.FAILED),
    ],
)
def test_wind_or_its_gusts_are_held_against_it(wind: str, speed: float, verdict: Verdict) -> None:
    scenario = parse_scenario(lift(wind=wind))
    recording = simulate(scenario)
    (check,) = checks_of(recording, "wind_of_limit")
    assert check.verdict is verdict and check.value == pytest.approx(speed / 12.0)
    assert check.element == "main"
    assert not [one for one in assemble(scenario).warnings if "'wind_limit'" in one]
    said = [one for one in stop_if(Subject(recording)) if "the limit of main" in one]
    assert said == ["wind is over 12 m/s, the limit of main"]


def test_without_one_nothing_is_said() -> None:
    """Where the lift asks either: that limit is about nothing then, which the verdict says."""
    assert checks_of(simulate(parse_scenario(lift(limit=""))), "wind_of_limit") == []
    rig = {"hooks": [{"name": "main", "crane": "main", "wind": 13.0}], "limits": {"wind_of_limit": 1.0}}
    recording = Recording({"time": Variable(("time",), np.arange(2.0), "s", "")}, {}, {"rig": rig})
    found = list(LIMITS["wind_of_limit"].findings(recording, np.ones(2, dtype=np.bool_)))
    assert found == []


def test_a_limit_of_no_wind_is_refused() -> None:
    with pytest.raises(ScenarioError, match="wind_limit"):
        parse_scenario(lift(limit=", wind_limit: 0 m/s"))
