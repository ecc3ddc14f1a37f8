"""An emergency stop of trolleys was as soft as any other stop, where nothing said otherwise, without a word.

Trolleys, cranes and booms without an `emergency_acceleration` stop with their usual one. A stop of the
trolleys of `goliath` in mid-traverse was simulated at 0.03 m/s^2, and falls swing by twice that over g,
0.35 deg: GO. Brakes that are thrown in stop several times as hard. Whoever said that theirs do not, with the
usual deceleration as that of an emergency, was then told to say it.
"""

from __future__ import annotations

from typing import Any

from gantline.assembly import assemble
from gantline.scenario import load_scenario

STOP = {"emergency_stop": {"in_step": "to the dock", "after": "30 s"}}
TRAVERSE = "cranes.goliath.trolleys.{}.traverse.emergency_acceleration"


def told(changed: dict[str, Any]) -> list[str]:
    lift = load_scenario("goliath")
    found = assemble(lift.changed(changed) if changed else lift).warnings
    return [one for one in found if "emergency" in one]


def test_usual_deceleration_is_told() -> None:
    """Both trolleys, by their names; hoists have a deceleration of their own."""
    [found] = told(STOP)
    assert "of goliath.upper, goliath.lower is as soft as any stop" in found
    assert "'emergency_acceleration'" in found


def test_one_of_its_own_is_in_order() -> None:
    own = {TRAVERSE.format(trolley): "0.2 m/s^2" for trolley in ("upper", "lower")}
    assert told(STOP | own) == []


def test_the_usual_one_may_be_said() -> None:
    """0.03 m/s^2, that of the trolleys of `goliath`, of both or of one."""
    usual = {TRAVERSE.format(trolley): "0.03 m/s^2" for trolley in ("upper", "lower")}
    assert told(STOP | usual) == []
    [found] = told(STOP | {TRAVERSE.format("upper"): "0.03 m/s^2"})
    assert "of goliath.lower is as soft as any stop" in found


def test_nothing_is_said_of_a_lift_without_a_stop() -> None:
    assert told({}) == []
