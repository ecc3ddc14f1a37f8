"""A drum that paid out more rope than lies on it was a warning among others, and the lift a GO.

250 t were lowered by 12.5 m on 8 parts from a drum with 3.5 turns: at the end it had -14.6, that is 73 m of
rope more than there was, and the hook would have gone down with its rope. The verdict was GO WITH WARNINGS,
and the table named the first warning of five. Fewer turns than the lift file's own `spare_turns` were no
failure either, and where nothing says how many there are at the start, `spare_turns` asked in vain.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results.recording import Recording
from gantline.scenario import ScenarioError, parse_scenario
from gantline.statics import Statics
from of_recording import checks_of

PARTS, DIAMETER, DOWN = 4, 1.0, 3.0
#: Turns that leave the drum on the way down: rope over its circumference.
OFF = PARTS * DOWN / (math.pi * DIAMETER)


def lift(drum: str) -> str:
    """5 t that hang in four parts go down by 3 m, which are 12 m of rope, or 3.82 turns."""
    return f"""\
format: 1
lift: {{title: A load goes down}}
duration: 40 s
ropes: {{r: {{axial_stiffness: 100 MN, damping_time: 20 ms, mass: none, diameter: 20 mm}}}}
load:
  name: load
  shape: {{box: [2 m, 2 m, 1 m]}}
  position: [0 m, 0 m, 10 m]
  weight: {{calculated: 5 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 0.5 m]}}
  lugs: {{A: {{at: [0 m, 0 m, 1 m]}}}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 16 m]
    block: {{mass: 0.5 t, height: 1 m}}
    reeving: {{ropes: 1, parts_each: {PARTS}, rope: r, sheave_diameter: 0.5 m, upper_sheaves_at: 30 m}}
    drum: {{diameter: {DIAMETER} m{drum}}}
    hoist: {{speed: 12 m/min, acceleration: 0.1 m/s^2}}
slings: {{S: {{from: hook, to: load.A, length: 5 m, rope: r}}}}
plan:
  - {{step: down, lower: hook, speed: 12 m/min, by: {DOWN} m}}
  - {{step: hold, hold: until_end}}
"""


def checked(recording: Recording) -> list[Check]:
    return checks_of(recording, "turns_on_drum")


def run(drum: str) -> Recording:
    return gantline.simulate(parse_scenario(lift(drum)))


def test_rope_that_runs_off_fails() -> None:
    found = run(", wraps_at_start: 3.5")
    [check] = checked(found)
    assert check.verdict is Verdict.FAILED
    assert check.element == "hook.drum"
    assert f"{OFF - 3.5:.1f} turns more than lie on it" in check.remark
    assert verdict_of(check_recording(found)).startswith("NO-GO")


def test_an_equilibrium_fails_too() -> None:
    rest = Statics(parse_scenario(lift(", wraps_at_start: 3.5"))).equilibrium().recording
    assert [check.verdict for check in checked(rest)] == [Verdict.FAILED]


def test_fewer_than_the_lift_file_asks_for_fail() -> None:
    [check] = checked(run(", wraps_at_start: 6, spare_turns: 3"))
    assert check.verdict is Verdict.FAILED
    assert f"{6 - OFF:.1f} turns are left, and 3 have to stay" in check.remark


def test_fewer_than_two_where_nothing_is_asked_for_are_a_warning() -> None:
    [check] = checked(run(", wraps_at_start: 5"))
    assert check.verdict is Verdict.WARNING
    assert f"{5 - OFF:.1f} turns are left, and 2 have to stay" in check.remark


@pytest.mark.parametrize("drum", [", wraps_at_start: 7, spare_turns: 3", ", wraps_at_start: 6", ""])
def test_nothing_is_said_of_enough(drum: str) -> None:
    assert not checked(run(drum))


def test_turns_that_nothing_says_are_a_warning() -> None:
    """The lift file asks for some, and nobody knows whether they stay; that was `not checked`, and a GO."""
    [check] = checked(run(", spare_turns: 3"))
    assert check.verdict is Verdict.WARNING
    assert "wraps_at_start" in check.remark


def test_fewer_at_the_start_than_have_to_stay_are_refused() -> None:
    """No plan makes that right: it was in order, and failed at 0 s of the run."""
    with pytest.raises(ScenarioError, match=r"2 turns are on it at the start, and 3 have to stay") as problem:
        parse_scenario(lift(", wraps_at_start: 2, spare_turns: 3"))
    assert "cranes.hook.drum.wraps_at_start" in str(problem.value)


def test_as_many_at_the_start_as_have_to_stay_are_enough() -> None:
    """Just as many are in order, and are what the drum has at the start."""
    question = Statics(parse_scenario(lift(", wraps_at_start: 3, spare_turns: 3")))
    assert question.equilibrium(0.0).recording.column("drum_wraps", "hook.drum")[-1] == pytest.approx(3.0)
