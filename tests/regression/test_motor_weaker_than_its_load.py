"""`gantline check` found a lift in order whose motor cannot hoist what hangs on it.

A motor of 12 kN a rope holds 2.45 t on two parts: 24 kN/g, hook block included. It was told of brakes weaker
than their motors alone; of the motor only a run told, by `hoist_follows`, after the lift had stood still.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import parse_scenario
from gantline.study.weak_motors import weak_motors
from mechanics import G
from verbs import gantline
from weak_hoist import HOOK_BLOCK, PARTS, hanging, standing
from winch_lift import winch_lift

UP = "{step: up, hoist: crane, speed: 6 m/min, by: 1 m}"


def motors(text: str) -> list[str]:
    return [doubt.sentence for doubt in weak_motors(parse_scenario(text))]


def pull(mass: float) -> float:
    """Of each rope at rest, of a load of a mass [t] that hangs clear on ropes without weight [kN]."""
    return (mass * 1e3 + HOOK_BLOCK) * G / PARTS / 1e3


@pytest.mark.parametrize("lift", [standing, hanging])
def test_it_is_held_against_the_load_at_rest(lift) -> None:  # type: ignore[no-untyped-def]
    where = "at the end of 'up'" if lift is standing else "at the start"
    [found] = motors(lift(UP, 8.0, f"capacity: {pull(8.0) - 0.01!r} kN", 30.0))
    pulls = f"the motor of crane pulls at most {pull(8.0) - 0.01:.2f} kN of each rope"
    assert f"{pulls}, and at rest {where} it pulls all of that" in found
    assert motors(lift(UP, 8.0, f"capacity: {pull(8.0) + 0.01!r} kN", 30.0)) == []


def test_on_a_higher_layer_it_holds_less() -> None:
    """On the third, 30 mm each, a drum of 0.4 m has 1.3 times its first diameter: more than the quarter of
    what hangs by which a motor has to be stronger not to be looked at, with its load at the first layer.
    """
    layers = "layers: 3, layer_step: 30 mm, wraps_per_layer: 10, wraps_at_start: 25"
    lift = hanging("{step: wait, hold: 1 s}", 8.0, f"capacity: {1.29 * pull(8.0)!r} kN", 1.0)
    assert len(motors(lift.replace("layers: 1", layers))) == 1
    lift = hanging("{step: wait, hold: 1 s}", 8.0, f"capacity: {1.31 * pull(8.0)!r} kN", 1.0)
    assert motors(lift.replace("layers: 1", layers)) == []


def test_one_that_could_lift_it_all_asks_for_no_statics(monkeypatch: pytest.MonkeyPatch) -> None:
    """`check` of a usual lift takes no longer than before."""
    monkeypatch.delattr("gantline.study.weak_motors.Statics")
    assert motors(standing(UP, 8.0, "capacity: 60 kN", 30.0)) == []


def test_check_tells_of_it_with_its_place(tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(standing(UP, 8.0, "capacity: 12 kN", 30.0), encoding="utf-8")
    found = gantline("check", str(path))
    assert found.exit_code == 0
    assert "cranes.crane.hoist.capacity: the motor of crane pulls at most 12 kN of each rope" in found.stderr


def test_a_drum_of_mechanics_counts() -> None:
    """10 t on one part of rope: 98.1 kN. Below it is a stop, without which it would rest nowhere."""
    stops = "stops: {lower: -1 m, upper: 9 m, stiffness: 100 MN/m}"
    text = winch_lift("90 kN").replace(", brake: 90 kN", "").replace("0, 1]}", f"0, 1], {stops}}}")
    weak, strong = (text.replace("capacity: 150 kN", f"capacity: {force} kN") for force in (98.0, 98.2))
    [found] = motors(weak)
    assert "the motor of winch pulls at most 98 kN, and at rest at the start" in found
    assert motors(strong) == []
