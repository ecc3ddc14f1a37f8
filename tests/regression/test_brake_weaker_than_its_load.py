"""`gantline check` found a lift in order whose brakes hold less than what hangs on them.

A motor of 60 kN a rope lifts 8 t on two parts, and its brake holds 20 kN of 39.7 kN: only a run with an
emergency stop showed that the load comes down, and only statics had `hoist_load_of_drive_capacity`. Nothing
but a run with a stop showed it of a drum of `mechanics`.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from gantline.scenario import parse_scenario
from gantline.study.weak_brakes import weak_brakes
from mechanics import G
from weak_hoist import HOOK_BLOCK, PARTS, hanging, standing
from winch_lift import winch_lift

UP = "{step: up, hoist: crane, speed: 6 m/min, by: 1 m}"
STOP = "emergency_stop: {in_step: up, after: 1 s}\n"
#: Pull of each part of line at rest, ropes without weight [kN].
PULL = (8e3 + HOOK_BLOCK) * G / PARTS / 1e3


def brakes(text: str) -> list[str]:
    return [doubt.sentence for doubt in weak_brakes(parse_scenario(text))]


@pytest.mark.parametrize("stop", ["", STOP], ids=["no stop", "a stop before it hangs"])
def test_a_brake_of_a_hoist_is_held_against_the_load_at_rest(stop: str) -> None:
    """(8 t + hook block) g/2 of each rope, 39.73 kN, where the load hangs clear at the end of the plan."""
    motor = f"capacity: 60 kN, brake: {PULL - 0.1!r} kN"
    [found] = brakes(standing(UP, 8.0, motor, 30.0) + stop)
    holds, hangs = f"holds a pull of {PULL - 0.1:.2f} kN of each rope", f"it has to hold {PULL:.2f} kN"
    assert holds in found and hangs in found


def test_a_brake_that_holds_a_little_more_is_in_order() -> None:
    assert brakes(standing(UP, 8.0, f"capacity: 60 kN, brake: {PULL + 0.1!r} kN", 30.0)) == []


def test_a_load_that_hangs_before_the_plan_begins_counts() -> None:
    [found] = brakes(hanging(UP, 8.0, "capacity: 60 kN, brake: 20 kN", 30.0))
    assert f"at rest at the start it has to hold {PULL:.2f} kN" in found


def test_on_a_higher_layer_it_holds_less() -> None:
    """On the third, 20 mm each, a drum of 0.4 m has 1.2 times its first diameter, and sees so much more."""
    layers = "layers: 3, layer_step: 20 mm, wraps_per_layer: 10, wraps_at_start: 25"
    lift = hanging("{step: wait, hold: 1 s}", 8.0, f"capacity: 60 kN, brake: {1.1 * PULL!r} kN", 1.0)
    [found] = brakes(lift.replace("layers: 1", layers))
    assert f"it has to hold {1.2 * PULL:.2f} kN" in found


def test_a_brake_as_strong_as_its_motor_asks_for_no_statics(monkeypatch: pytest.MonkeyPatch) -> None:
    """What the motor lifts such a brake holds: `check` of a usual lift takes no longer than before."""
    monkeypatch.delattr("gantline.study.weak_brakes.Statics")
    assert brakes(standing(UP, 8.0, "capacity: 60 kN, brake: 60 kN", 30.0)) == []


def test_check_tells_of_a_drum_of_mechanics_with_its_place(tmp_path: Path) -> None:
    """10 t x g = 98.1 kN on one part of rope."""
    path = tmp_path / "lift.yaml"
    path.write_text(winch_lift("50 kN"), encoding="utf-8")
    line = 1 + next(at for at, text in enumerate(winch_lift("").splitlines()) if "brake:" in text)
    result = CliRunner().invoke(app, ["check", str(path)])
    assert result.exit_code == 0
    assert f"{path}:{line}: mechanics.drums.winch.drive.brake: " in result.stderr
    assert "holds a pull of 50 kN, and at rest at the start it has to hold 98.1 kN" in result.stderr
