"""Trolleys, cranes and upper structures that a run takes past the end of their range.

Plans are refused where that is certain. A step that ends at a time or on a condition goes as far as that
takes: a crane went to 150 m on rails of 100 m, a trolley to 70 m of 60 m, an upper structure to 162 deg of
100 deg, and each was a GO, since booms alone had a check of where they are.
"""

from __future__ import annotations

import math

import pytest

from crawler_lift import crawler_lift
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from goliath_lift import goliath_lift
from of_recording import checks_of

END = "{step: end, hold: 1 s}"


def told(text: str) -> list[Check]:
    recording = Simulation(parse_scenario(text)).run()
    return checks_of(recording, "stays_in_range")


def goliath(step: str, end: str, most: float) -> str:
    """A lift with another end of a range; the crane begins at 0 m, its trolley at -20 m."""
    text = goliath_lift(f"{{step: move, {step}}}\n{END}", duration=60.0, tolerance=1e3)
    assert text.count(end) == 1
    return text.replace(end, f"{end.split(',')[0]}, {most} m]")


RAILS, GIRDER = "[-100 m, 100 m]", "[-60 m, 60 m]"
#: To 0.5 m/s with 0.03 m/s^2 and from 30 s on back to rest: 0.5 m/s x 30 s, 15 m.
_GOES = "speed: 30 m/min, brake_from: 30 s"


@pytest.mark.parametrize(("most", "is_told"), [(14.9, True), (15.1, False)])
def test_a_crane_on_its_rails(most: float, is_told: bool) -> None:
    found = told(goliath(f"travel: gol, {_GOES}", RAILS, most))
    assert [one.verdict for one in found] == [Verdict.FAILED] * is_told
    for one in found:
        assert one.element == "gol"
        assert one.remark.startswith("it comes to 15.00 m, and its range is -100.00 m to 14.90 m;")
        # 0.1 m short of where it stops, sqrt(2 x 0.1 m/0.03 m/s^2) before that; samples are 0.1 s apart.
        stops = 30.0 + 0.5 / 0.03
        assert one.time == pytest.approx(stops - math.sqrt(2 * 0.1 / 0.03), abs=0.1)


@pytest.mark.parametrize(("most", "is_told"), [(-5.1, True), (-4.9, False)])
def test_a_trolley_on_its_girder(most: float, is_told: bool) -> None:
    found = told(goliath(f"traverse: one, {_GOES}", GIRDER, most))
    assert [one.element for one in found] == ["gol.one"] * is_told


def slewed(until: str) -> str:
    plan = f"{{step: slew, slew: c1, speed: 0.3 rev/min, {until}}}\n{END}"
    whole = "slewing: {speed: 0.3 rev/min, acceleration: 0.1 deg/s^2"
    text = crawler_lift(60e3, plan, duration=60.0)
    assert whole in text
    return text.replace(whole, f"{whole}, range: [60 deg, 100 deg]")


def test_an_upper_structure() -> None:
    """From 90 deg with 0.1 deg/s^2 for t and back to rest: 0.1 t^2 deg, 12.1 deg and 9.8 deg."""
    (found,) = told(slewed("brake_from: 11 s"))
    assert found.remark.startswith("it comes to 102.1 deg, and its range is 60.0 deg to 100.0 deg;")
    assert told(slewed("brake_from: 9.9 s")) == []
    assert told(slewed("to: 100 deg")) == []


def test_a_crawler_crane_that_travels() -> None:
    """0.05 m/s^2 for 4 s and back: 0.8 m."""
    travel = "    travel: {speed: 1 km/h, acceleration: 0.05 m/s^2, range: [-1 m, 0.7 m]}\n"
    plan = f"{{step: go, travel: c1, speed: 1 km/h, brake_from: 4 s}}\n{END}"
    (found,) = told(crawler_lift(60e3, plan, duration=20.0, crane=travel))
    assert (found.element, found.verdict) == ("c1", Verdict.FAILED)
    assert found.remark.startswith("it comes to 0.80 m,")


def test_a_lift_at_rest() -> None:
    """At 40 s it stands past its end, at 0 s not yet."""
    question = Statics(parse_scenario(goliath(f"travel: gol, {_GOES}", RAILS, 14.0)))
    for time, count in ((0.0, 0), (55.0, 1)):
        checks = check_recording(question.equilibrium(time=time).recording)
        assert sum(one.name == "stays_in_range" for one in checks) == count
