"""The first page told of a step its verb and speed alone: not what moves, not how far nor which way.

Who has only the report read `travel 8.33 m/min` where the tail crane goes 15 m back, `slew 20 deg/min`
without where to, and `haul 0.42 m/min` without which lines. `travel 16.7 m/min` of a crane that keeps falls
plumb is the most that it may do, and stood there as its speed. A hook that is kept still against heave was
not named at all. What the rails of a Goliath crane bear at most stood among the checks alone.
"""

from __future__ import annotations

from typing import Any

import pytest

import gantline
from gantline.report.first_page import FirstPage
from gantline.report.steps import first_steps, step_rows
from gantline.report.subject import Subject
from sample_lift import ringing_lift, sample_rig


def does(step: dict[str, Any]) -> str:
    rig = sample_rig()
    rig["plan"] = [{"step": "one", "speed": 0.25, **step}]
    return str(step_rows(Subject(ringing_lift(rig=rig)))[0]["does"])


@pytest.mark.parametrize(
    ("step", "shown"),
    [
        ({"kind": "travel", "moves": ["tail"], "by": -15.0}, "travel tail 15 m/min by −15 m"),
        (
            {"kind": "traverse", "moves": ["upper", "lower"], "to": 75.0},
            "traverse upper, lower 15 m/min to 75 m",
        ),
        (
            {"kind": "traverse", "moves": ["upper"], "towards": "minus"},
            "traverse upper 15 m/min towards minus",
        ),
        ({"kind": "slew", "speed": 0.0, "moves": ["rc"], "to": 0.0}, "slew rc 0 deg/min to 0 deg"),
        (
            {"kind": "luff", "speed": 0.0, "moves": ["fc"], "by": -0.0349065850398866},
            "luff fc 0 deg/min by −2 deg",
        ),
        ({"kind": "haul", "moves": ["stern.ps", "stern.sb"]}, "haul stern.ps, stern.sb 15 m/min"),
        (
            {"kind": "travel", "moves": ["tail"], "keep_plumb": ["tail.H"]},
            "travel tail up to 15 m/min, keeps tail.H plumb",
        ),
        (
            {"kind": "lower", "moves": ["H1"], "compensate_heave": ["H1"], "relative_to": "barge"},
            "lower H1 15 m/min; H1 kept still over barge",
        ),
        (
            {"kind": "hold", "speed": None, "compensate_heave": ["H1"]},
            "H1 kept still over the ground",
        ),
    ],
)
def test_a_step_says_what_moves_and_how_far(step: dict[str, Any], shown: str) -> None:
    assert does(step) == shown


def test_every_hook_of_a_lift_needs_no_names() -> None:
    hooks = [hook["name"] for hook in sample_rig()["hooks"]]
    every = {"kind": "hoist", "moves": hooks, "drives": [f"{name}.hoist" for name in hooks], "by": 0.3}
    assert does(every) == "hoist 15 m/min by 0.3 m"
    # The same words in a lift with a hook more are some of the hooks, and named.
    assert does({**every, "drives": ["other.hoist"]}) == f"hoist {', '.join(hooks)} 15 m/min by 0.3 m"


def test_the_plan_of_a_lift_file_arrives() -> None:
    upending = gantline.Statics("upending").rig.plan
    away = next(step for step in upending if step.step == "tail away")
    assert (away.moves, away.by, away.to) == (["tail"], -15.0, None)
    slewed = next(step for step in gantline.Statics("revolving_crane").rig.plan if step.kind == "slew")
    assert (slewed.moves, slewed.by, slewed.to) == (["rc"], None, 0.0)
    held = next(step for step in gantline.Statics("onto_a_platform").rig.plan if step.step == "steady")
    assert (held.compensate_heave, held.relative_to) == (["H1"], "")


def test_corner_loads_of_a_goliath_crane_stand_on_the_first_page() -> None:
    # Without a contingency, so that they are those of the recording.
    plain = gantline.load_scenario("goliath").changed({"load.weight.contingency": 1.0})
    lift = gantline.simulate(plain, duration=10.0)
    most = max(
        (float(lift.column("corner_load", corner).max()), corner) for corner in lift.coordinates["corner"]
    )
    content = FirstPage().content(Subject(lift))
    assert content is not None
    assert (f"largest corner load, {most[1]}", f"{most[0] / 1e3:.0f} kN") in content["weights"]


def test_when_to_stop_stands_above_a_few_steps() -> None:
    # Below the attitude it pushed the signatures of `off_a_barge`, with two vessels, off the sheet of A4.
    rig = sample_rig()
    for count, has_room in ((0, False), (4, True), (6, True), (7, False)):
        rig["plan"] = [{"step": f"step {number}", "kind": "hold"} for number in range(count)]
        assert first_steps(Subject(ringing_lift(rig=rig)))["has_room"] is has_room
