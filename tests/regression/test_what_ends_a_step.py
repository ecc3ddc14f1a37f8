"""The first page told of a step that waits for a condition what it moves and how fast, and not until when.

`lift off, hoist 0.15 m/min` stood there, without that it goes on until the supports are clear and when that
was; of a step that brakes at a time nothing at all said when.
"""

from __future__ import annotations

from typing import Any

import pytest

from gantline.assembly import assemble
from gantline.report.steps import StepsContinued, first_steps, step_rows
from gantline.report.subject import Subject
from gantline.scenario import load_scenario
from sample_lift import ringing_lift, sample_rig


@pytest.mark.parametrize(
    ("scenario", "step", "words"),
    [
        ("goliath", "take up slack", "load transferred 2 %"),
        ("goliath", "equalise", "tension spread below 5 %"),
        ("goliath", "lift off", "supports clear"),
        ("floating_crane", "astern at 25", "falls within 0.1 deg of plumb"),
        ("monopile", "take up slack", "ps, sb taut"),
        ("monopile", "to half", "hoist load of H1 above 350 t"),
        ("upending", "upend", "tilt above 70 deg"),
        ("upending", "let go", "C, D slack"),
        ("onto_a_platform", "set down", "supports touched"),
        ("goliath", "hoist", ""),
    ],
)
def test_conditions_in_words(scenario: str, step: str, words: str) -> None:
    plan = assemble(load_scenario(scenario)).rig["plan"]
    assert next(one for one in plan if one["step"] == step).get("until", "") == words


@pytest.mark.parametrize(
    ("until", "words"),
    [
        ({"heel": {"vessel": "barge", "below": "-0.25 deg"}}, "heel of barge below -0.25 deg"),
        ({"trim": {"vessel": "barge", "above": "0 deg"}}, "trim of barge above 0 deg"),
        (
            {"mooring_tension": {"line": "bow.ps", "above": "200 kN"}},
            "tension of bow.ps above 200 kN",
        ),
        ({"hoist_load": {"hook": "H1", "above": "1.25 MN"}}, "hoist load of H1 above 1250 kN"),
    ],
)
def test_further_conditions(until: dict[str, Any], words: str) -> None:
    lift = load_scenario("off_a_barge")
    waits = {"step": "wait", "hold": "until_met", "until": until}
    plan = assemble(lift.changed({"plan": [waits, {"step": "end", "hold": "until_end"}]})).rig["plan"]
    assert plan[0]["until"] == words


def sample(*plan: dict[str, Any]) -> Subject:
    """A lift with a plan of whose steps none has ended."""
    return Subject(ringing_lift(rig={**sample_rig(), "plan": list(plan)}))


def test_one_that_never_was() -> None:
    [row] = step_rows(sample({"step": "lift off", "kind": "hoist", "until": "supports clear"}))
    assert row["until"] == "until supports clear, not met"


def test_steps_that_take_many_lines_leave_others_to_the_second_sheet() -> None:
    """Sixteen short ones have room on the first; of such as take three lines each ten have."""
    short = [{"step": f"step {one}", "kind": "hoist"} for one in range(16)]
    assert len(first_steps(sample(*short))["rows"]) == 16
    words = "falls of H1, H2, H3, H4 within 0.1 deg of plumb, all of them and together"
    long = [{**one, "until": words} for one in short]
    first, rest = first_steps(sample(*long)), StepsContinued().content(sample(*long))
    assert rest is not None
    assert (len(first["rows"]), rest["first"], len(rest["rows"])) == (10, 11, 6)
    assert first["elsewhere"] == "Steps 11 to 16"
