"""Plans that let a load down where it was just lifted off, and plans that never hold it as it hangs.

`lower` in place of `hoist` by 4 m, right after lift-off, was in order; so was a plan without any hold, of
which the run said afterwards that nothing tells what of the forces is static; and so was one that begins
with `lower` while the load stands."""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

OFF = "{step: off, hoist: crane, speed: 1 m/min, until: {supports: clear}}"
PART = "{step: part, hoist: crane, speed: 1 m/min, until: {load_transferred: 50 %}}"
UP = "{step: up, hoist: crane, speed: 3 m/min, by: 4 m}"
DOWN = "{step: down, lower: crane, speed: 3 m/min, by: 4 m}"
TOUCH = "{step: touch, lower: crane, speed: 3 m/min, until: {supports: touched}}"
SLACK = "{step: slack, lower: crane, speed: 3 m/min, by: 1.5 m}"
HOLD = "{step: look, hold: 20 s}"
LOOSE = "{step: loose, hold: 20 s, detach: [sling.A, sling.B, sling.C, sling.D]}"
AWAY = "{step: away, hoist: crane, speed: 3 m/min, by: 3 m}"
END = "{step: end, hold: until_end}"


def told(*plan: str) -> list[tuple[str, str]]:
    head, rest = LIFT.split("plan:\n")
    text = head + "plan:\n" + "".join(f"  - {step}\n" for step in plan) + rest[rest.index("rules:") :]
    doubts = assemble(parse_scenario(text)).doubts
    return [(one.path, one.sentence) for one in doubts if one.path.startswith("plan")]


def lowered(by: str) -> str:
    below = f"step 'down' lowers module to {by} m below where it comes off what it stood on"
    return f"{below}: it stands there again, and its slings go slack; is 'hoist' meant, or another way?"


@pytest.mark.parametrize(
    ("before", "by"),
    [
        ((OFF,), "4.00"),
        ((OFF, HOLD), "4.00"),
        # 0.3 m of 4 m are over what it stood on.
        ((PART, OFF, UP.replace("by: 4 m", "by: 0.3 m"), HOLD), "3.70"),
        # From 11 m, where the hook is as the lift begins, to 11.5 m, and 4 m down from there.
        ((UP.replace("by: 4 m", "to: 11.5 m"),), "3.50"),
    ],
)
def test_a_load_let_down_where_it_was_lifted_off(before: tuple[str, ...], by: str) -> None:
    assert told(*before, DOWN, END) == [(f"plan[{len(before) + 1}].lower", lowered(by))]


@pytest.mark.parametrize(
    "plan",
    [
        (OFF, UP, HOLD, DOWN, SLACK, LOOSE),
        (OFF, HOLD, TOUCH, SLACK, LOOSE),
        (OFF, HOLD, SLACK.replace("1.5 m", "0.8 m"), LOOSE),
        (OFF, HOLD, UP, DOWN.replace("by: 4 m", "to: 11 m"), END),
    ],
)
def test_one_that_is_set_down_is_not_told(plan: tuple[str, ...]) -> None:
    assert told(*plan) == []


@pytest.mark.parametrize("last", [(TOUCH,), (TOUCH, END), (TOUCH, SLACK, LOOSE, AWAY), (DOWN, SLACK, END)])
def test_a_plan_that_never_holds_the_load(last: tuple[str, ...]) -> None:
    said = (
        "no step holds module while it hangs, so nothing tells what of its forces is static; a hold after it "
        "is lifted off does, 'hold: 60 s'"
    )
    assert told(PART, HOLD, OFF, UP, *last) == [("plan[3]", said)]


@pytest.mark.parametrize(
    "plan", [(OFF, UP), (OFF, UP, HOLD, TOUCH), (OFF, HOLD, TOUCH, END), (OFF, UP, DOWN), (HOLD,)]
)
def test_one_that_holds_it_or_leaves_it_hanging_is_not_told(plan: tuple[str, ...]) -> None:
    """After the last step drives stand, so that a load that then hangs does so at rest."""
    assert told(*plan) == []


@pytest.mark.parametrize("down", ["by: 4 m", "to: 7 m"])
def test_a_plan_that_begins_down(down: str) -> None:
    """From 11 m."""
    says = "step 'down' lowers crane by 4.00 m while module stands, and nothing was lifted before"
    found = told(DOWN.replace("by: 4 m", down), OFF, HOLD)
    assert found == [("plan[1].lower", f"{says}: its slings go slack; is 'hoist' meant?")]


@pytest.mark.parametrize(
    "plan", [(SLACK, LOOSE, AWAY), (SLACK.replace("1.5 m", "0.8 m"), OFF, HOLD), (OFF, HOLD)]
)
def test_slack_to_take_slings_off_and_a_little_of_it(plan: tuple[str, ...]) -> None:
    assert told(*plan) == []
