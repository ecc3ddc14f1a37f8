"""By what wind grows was told nowhere, and of the limit of a crane not where it is held against.

`gantline check` and the report said `Wind: 8.0 m/s at 10 m towards 30 deg` of a sea, a town and an exponent
alike. The first page stopped the lift at "wind is over 13 m/s, the limit of main", which is meant at its
top while the gusts in the line below are meant at 10 m; and the check had `11.4965 m/s / 13 m/s`. `gantline
statics` left the growth out of what it says of the wind, and of what it keeps, so that nothing told the
wind at the load there.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks.limits import LIMITS
from gantline.checks.measure import Found
from gantline.report.first_page import stop_if
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from hinged_mast import mast


def lift(profile: str) -> Recording:
    """A hook at 60 m, of a crane that may lift in 13 m/s, for 0.1 s."""
    wind = f"{{speed: 8 m/s, direction: 30 deg{profile}}}"
    text = mast("  - {step: hold, hold: until_end}\n", hook=(19.0, 0.0, 60.0), more=f"wind: {wind}\n")
    text = text.replace("900 s", "0.1 s").replace("type: fixed_hook", "type: fixed_hook, wind_limit: 13 m/s")
    return simulate(parse_scenario(text))


@pytest.mark.parametrize(
    ("profile", "words"),
    [
        ("", "8.0 m/s towards 30 deg"),
        (", profile: {terrain: sea}", "8.0 m/s at 10 m over a roughness of 3 mm towards 30 deg"),
        (", profile: {terrain: town}", "8.0 m/s at 10 m over a roughness of 1 m towards 30 deg"),
        (
            ", profile: {height: 20 m, exponent: 0.14}",
            "8.0 m/s at 20 m by the power 0.14 of height towards 30 deg",
        ),
    ],
)
def test_wind_says_by_what_it_grows(profile: str, words: str) -> None:
    wind = lift(profile).rig.wind
    assert wind is not None and wind.in_words == words


@pytest.mark.parametrize(
    ("profile", "where", "speed"),
    [("", "", 8.0), (", profile: {exponent: 0.14}", " at its top", 8.0 * 6.0**0.14)],  # 60 m / 10 m
)
def test_the_limit_of_a_crane_is_that_at_its_top(profile: str, where: str, speed: float) -> None:
    recording = lift(profile)
    said = [one for one in stop_if(Subject(recording)) if "limit" in one]
    assert said == [f"wind is over 13 m/s{where}, the limit of main"]
    (found,) = LIMITS["wind_of_limit"].findings(recording, recording.time >= 0.0)
    assert isinstance(found, Found) and math.isclose(found.value, speed / 13.0, rel_tol=1e-12)
    assert found.formula == f"{speed:.3g} m/s{where} / 13 m/s"


def test_an_equilibrium_has_it_too() -> None:
    """And by it the wind at the load, 11 m over the ground: 1.1 times the height of its speed."""
    gusty = "wind: {speed: 8 m/s, direction: 30 deg, gusts: {speed: 12 m/s}, profile: {exponent: 0.14}}\n"
    text = mast("  - {step: hold, hold: until_end}\n", hook=(19.0, 0.0, 60.0), more=gusty)
    rest = Statics(parse_scenario(text)).equilibrium(0.0)
    wind = rest.recording.rig.wind
    assert wind is not None and wind.in_words == "8.0 m/s at 10 m by the power 0.14 of height towards 30 deg"
    assert rest.recording["wind_at_load"].values == pytest.approx(
        8.0 * 1.1**0.14, rel=1e-3
    )  # it sags by 1 mm
