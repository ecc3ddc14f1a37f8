"""Charts and booms of which a digit had slipped, so that more seemed allowed, were in order.

The last row of a chart at 4.5° for 45° put what may hang at 45° on a line from 55° to 4.5°: 206 t in place
of 150 t. A row at 280 m for 28 m did the same for a boom of 62 m. A crawler crane of 1900 t for 190 t never
came near to tipping, and a luffing range up to 820° let a boom be luffed over. Tackles from a top at 620 m
for 62 m pulled with less.
"""

from __future__ import annotations

import math

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, load_scenario
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.cranes.rating import Rating


def told(lift: str, **changes: object) -> list[str]:
    scenario = load_scenario(lift).changed({key.replace("__", "."): one for key, one in changes.items()})
    return [f"{one.path}: {one.sentence}" for one in assemble(scenario).doubts]


def crawler(mass: str = "190 t") -> Crawler:
    crane = (load_scenario("upending").changed({"cranes.main.base_mass": mass}).cranes or {})["main"]
    assert isinstance(crane, Crawler)
    return crane


def test_a_chart_with_a_gap() -> None:
    """Between 55 deg, 220 t, and 4.5 deg, 150 t, a line has 220 - 70 · 10 / 50.5 = 206 t at 45 deg."""
    at_45 = 220 - 70 * (55 - 45) / (55 - 4.5)
    assert at_45 == pytest.approx(206.1, abs=0.05)  # as it is rounded
    chart = "cranes__sheerleg__rating__angle"
    assert told("crane_barge_in_swell", **{chart: ["75 deg", "65 deg", "55 deg", "4.5 deg"]}) == [
        "cranes.sheerleg.rating.angle: the rating chart of sheerleg has nothing between 4.5 deg and 55.0 "
        "deg; what may hang there is taken from a line between both, and a digit may have slipped"
    ]
    assert told("crane_barge_in_swell", **{chart: ["75 deg", "65 deg", "55 deg", "25 deg"]}) == []


def test_a_row_farther_than_the_boom() -> None:
    """A level boom reaches from the slewing axis over its heel pins, 1.2 m ahead, to its length."""
    crane = crawler()
    reach = crane.boom.heel_pins.ahead + crane.boom.length
    radius = ["12 m", "14 m", "16 m", "18 m", "20 m", "24 m", "280 m"]
    assert told("upending", cranes__main__rating__radius=radius) == [
        "cranes.main.rating.radius: the rating chart of main has a row at 280.0 m, and its boom reaches no "
        f"farther than {reach:.1f} m; a digit has slipped, or it is of another boom"
    ]
    radius[-1] = f"{reach:.1f} m"
    said = told("upending", cranes__main__rating__radius=radius)
    assert not any("reaches no farther" in one for one in said)  # what tips the crane there is another matter


@pytest.mark.parametrize(("mass", "is_told"), [("190 t", False), ("400 t", False), ("1900 t", True)])
def test_a_crane_too_heavy_for_its_chart(mass: str, is_told: bool) -> None:
    """What tips it at 28 m, equation (CR4): moments of its parts about the middle of a track."""
    crane = crawler(mass)
    assert crane.rating is not None
    half = min(crane.tracks.gauge, crane.tracks.length) / 2
    boom, weight, radius = crane.boom, crane.counterweight, 28.0
    pins = boom.heel_pins.ahead
    moment = (crane.base_mass + crane.central_ballast) * half + weight.mass * (half + weight.behind)
    moment -= boom.mass * (pins + boom.centre_of_gravity * (radius - pins) - half)
    moment -= boom.head_gear * (radius - half)
    share = crane.rating.rated[-1] / (moment / (radius - half))
    assert (share < 0.25) is is_told
    doubts = told("upending", cranes__main__base_mass=mass)
    if is_told:
        rated = f"{crane.rating.rated[-1] / 1e3:.1f} t at 28.0 m"
        assert doubts == [
            f"cranes.main: the rating chart of main has {rated}, {100 * share:.3g} % of what tips the crane "
            "by its masses, where 75 % is usual; a mass of the crane is too large, or the chart too small"
        ]
    else:
        assert doubts == []


def test_a_top_far_away() -> None:
    """From heel pins at 98 m, 9 m to a top at 70 m, 620 m."""
    away = math.hypot(98 - 70, 620 - 9)
    assert told("floating_crane", cranes__fc__luffing__tackles__from=["70 m", "8 m", "620 m"]) == [
        f"cranes.fc.luffing.tackles.from: the top of the luffing tackles of fc is {away:.1f} m from its heel "
        "pins, and its boom is 110.0 m long; they seem to pull with far less than they do"
    ]


@pytest.mark.parametrize(("share", "is_told"), [("4.5 %", True), ("30 %", False), ("45 %", False)])
def test_a_boom_that_weighs_at_its_foot(share: str, is_told: bool) -> None:
    """Its moment is a tenth of what it is, and the crane tips later."""
    said = (
        "cranes.main.boom.centre_of_gravity: the centre of gravity of main.boom is at 4.5 % of its length; "
        "35 % to 55 % is usual, and a digit has slipped"
    )
    assert told("upending", cranes__main__boom__centre_of_gravity=share) == ([said] if is_told else [])


def test_a_range_past_plumb() -> None:
    with pytest.raises(ScenarioError, match=r"luffing\.range: 820 deg is past plumb.*90 deg at the most"):
        load_scenario("upending").changed({"cranes.main.luffing.range": ["30 deg", "820 deg"]})


def test_an_angle_of_a_chart_past_plumb() -> None:
    with pytest.raises(ValueError, match="750 deg is past plumb, where no boom stands"):
        Rating.model_validate({"angle": ["750 deg", "65 deg"], "rated": ["300 t", "280 t"]})
