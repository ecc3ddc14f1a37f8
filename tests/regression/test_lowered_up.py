"""A step that lowered a hook by hoisting its load 0.9 m: GO, and not a word of it.

`lower: crane, to: 12 m` after a step that hoisted until the load was clear: nobody knows before the run
where that leaves the hook, 11.1 m here, so `gantline check` has nothing to say, and the drive went up. A
plan that was to set a load down had it higher in the end.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.checks import Verdict, check_recording, verdict_of
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import checks_of

STEP = "{step: hoist, hoist: crane, speed: 3 m/min, by: 0.2 m}"
WAYS = (("hoist", 12.5), ("lower", 12))


def lift(*steps: str) -> str:
    """The module, lifted off until it is clear, and then these steps; its lugs and hook hold it."""
    text = LIFT.replace("13.2 t", "40 t").replace("46 t", "90 t")
    return text.replace(STEP, "\n  - ".join(steps))


def test_a_hook_that_is_lowered_upwards_is_told() -> None:
    recording = simulate(parse_scenario(lift("{step: down, lower: crane, speed: 3 m/min, to: 12 m}")))
    (begin,) = (time for time, _, name in recording.events("step_begin") if name == "down")
    height = recording.column("body_position", "crane")[:, 2]
    at = float(height[recording.time.searchsorted(begin)])
    # Slack of 8.6 m − √(2.5² + 1.5² + 8²) m = 0.087 m, then what slings stretch and the hook takes to brake.
    assert 11.087 < at < 11.15
    assert height[-1] == pytest.approx(12.0, abs=1e-9)
    (check,) = checks_of(recording, "plan_moves")
    assert check.verdict is Verdict.WARNING
    assert check.remark == f"'down' is to lower crane, which goes up from {at:.2f} m to 12.00 m"
    assert verdict_of(check_recording(recording)).startswith("GO WITH WARNINGS")


def test_a_hook_that_is_hoisted_downwards_is_told() -> None:
    """Set down after a step up, the hook is about where the load came clear; 10.5 m is 0.6 m below."""
    up = "{step: up, hoist: crane, speed: 3 m/min, by: 1 m}"
    touch = "{step: touch, lower: crane, speed: 3 m/min, until: {supports: touched}}"
    recording = simulate(
        parse_scenario(lift(up, touch, "{step: on, hoist: crane, speed: 3 m/min, to: 10.5 m}"))
    )
    (check,) = checks_of(recording, "plan_moves")
    assert check.remark.startswith("'on' is to hoist crane, which goes down from 11.")
    assert check.remark.endswith("to 10.50 m")


def test_steps_that_go_where_they_say_are_not() -> None:
    up, down = ("{{step: {0}, {0}: crane, speed: 3 m/min, to: {1} m}}".format(*one) for one in WAYS)
    assert checks_of(simulate(parse_scenario(lift(up, down))), "plan_moves") == []
