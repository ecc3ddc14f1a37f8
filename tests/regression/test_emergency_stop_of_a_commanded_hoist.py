"""An emergency stop of a hoist that a program commands and the plan does not move.

The plan only held; a program lowered 262 t at 80 mm/s, the lift file had an emergency stop at 6 s. The same
lowering by the plan slipped to rest under the brake within 0.5 mm. The commanded one went on for 160 mm: its
motor braked with its usual 0.02 m/s², and no brake came in.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.scenario import parse_scenario
from mechanics import Floats

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
STOP, SPEED = 6.0, 0.08


def lift(*plan: str) -> gantline.Scenario:
    """The lift of `reeved_hoist` from where its load hangs 3 m above the ground."""
    text = (SCENARIOS / "reeved_hoist" / "scenario.yaml").read_text(encoding="utf-8")
    for old, new in (
        ("position: [0 m, 0 m, 0 m]", "position: [0 m, 0 m, 3 m]"),
        ("at: [0 m, 0 m, 16.75 m]", "at: [0 m, 0 m, 19.75 m]"),
        ("  stands_on: ground\n", ""),
    ):
        assert old in text
        text = text.replace(old, new)
    before, after = text.split("plan:\n")[0], "limits:" + text.split("limits:")[1]
    steps = "".join(f"  - {step}\n" for step in plan)
    return parse_scenario(f"{before}emergency_stop: {{at: {STOP} s}}\nplan:\n{steps}{after}")


def stopped(recording: gantline.Recording) -> tuple[list[str], Floats]:
    """What the drum did, and the height of the load after the stop [m]."""
    kinds = [kind for _, kind, name in recording.events() if name == "hook.drum"]
    height: Floats = recording.column("body_position", "block")[recording.time >= STOP, 2]
    return kinds, height


def test_the_brake_stops_what_a_program_lowers() -> None:
    """As it stops what the plan lowers: every bit of the motion is the same."""
    lowering = f"{{step: lower, lower: hook, speed: {60 * SPEED} m/min, start_at: 2 s, by: 2 m}}"
    plan = gantline.Simulation(lift(lowering), duration=8.0)
    plan.advance_to(STOP)
    planned = plan.run()
    run = gantline.Simulation(lift("{step: hold, hold: until_end}"), duration=8.0)
    run.advance_to(2.0)
    run.command("hook", speed=-SPEED)
    run.advance_to(STOP)
    before, _ = run.drive_state("hook")
    commanded = run.run()
    (kinds, height), (expected, other) = stopped(commanded), stopped(planned)
    assert kinds == expected == ["drum_slips", "drum_holds"]
    assert before - run.drive_state("hook")[0] < 2e-3
    assert np.array_equal(height, other)


@pytest.mark.parametrize("at", [STOP + 0.005, STOP + 1.0])
def test_what_has_been_stopped_takes_no_command(at: float) -> None:
    """While the brake slips, and when it holds."""
    run = gantline.Simulation(lift("{step: hold, hold: until_end}"), duration=8.0)
    run.advance_to(2.0)
    run.command("hook", speed=-SPEED)
    run.advance_to(at)
    with pytest.raises(gantline.CommandError, match="an emergency stop has stopped everything"):
        run.command("hook", speed=0.0)
