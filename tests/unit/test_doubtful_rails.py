"""Goliath cranes on one rail: the lift file starts, or takes, them into each other, and check says so."""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from goliath_lift import goliath_lift
from lift_text import changed

#: Half of the bases of both, 32 m each, from middle to middle [m].
REACH = 32.0
HOLD = "{step: end, hold: until_end}"
TRAVEL = "travel: {speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-100 m, 100 m]}"


def two_cranes(east: float, west: float, *plan: str, base: bool = True, span: str = "148 m") -> str:
    """A lift by `east` and a second crane, `west`, at two places along the rails [m]."""
    text = goliath_lift("\n".join([*plan, HOLD]))
    start, end = text.index("  gol:\n"), text.index("mechanics:\n")
    crane = text[start:end]
    if not base:
        crane = changed(crane, (", base: 32 m", ""))
    cranes = [
        changed(crane, ("  gol:\n", f"  {name}:\n"), ("span: 148 m", f"span: {wide}\n    position: {at} m"))
        for name, at, wide in (("east", east, "148 m"), ("west", west, span))
    ]
    return text[:start] + "".join(cranes) + text[end:].replace("gol.", "east.")


def told(text: str) -> list[tuple[str, str]]:
    """Places and sentences of what is said of rails."""
    doubts = assemble(parse_scenario(text)).doubts
    return [(one.path, one.sentence) for one in doubts if "same rails" in one.sentence]


def travel(crane: str, way: str, name: str = "meet", more: str = "") -> str:
    return f"{{step: {name}, travel: {crane}, speed: 30 m/min, {way}{more}}}"


def meets(where: str, east: str, west: str) -> str:
    need = f"their legs need more than {REACH:.2f} m by their 'base' alone"
    return f"{where} east is at {east}, and west on the same rails at {west}: {need}"


@pytest.mark.parametrize(("west", "is_told"), [(10.0, True), (32.0, True), (32.1, False), (80.0, False)])
def test_where_they_start(west: float, is_told: bool) -> None:
    """Corners of legs meet at half of both bases, 16 m + 16 m."""
    found = told(two_cranes(0.0, west))
    where = meets("at the start", "0.00 m", f"{west:.2f} m")
    assert found == ([("cranes.west.position", where)] if is_told else [])


def test_without_a_base_their_order_is_known() -> None:
    """Two cranes in one place are one too many, and what is beside is not known."""
    both = "at the start east is at 5.00 m, and west on the same rails at 5.00 m: both are in one place"
    assert told(two_cranes(5.0, 5.0, base=False)) == [("cranes.west.position", both)]
    assert told(two_cranes(5.0, 6.0, base=False)) == []
    passed = told(two_cranes(5.0, 6.0, travel("east", "to: 7 m"), base=False))
    assert passed == [
        (
            "plan[1]",
            "where step 'meet' ends east is at 7.00 m, and west on the same rails at 6.00 m: they cannot "
            "pass each other",
        )
    ]


def test_cranes_of_another_span_run_on_other_rails() -> None:
    assert told(two_cranes(0.0, 0.0, span="150 m")) == []
    assert len(told(two_cranes(0.0, 0.0, span="148.00001 m"))) == 1


def test_where_a_step_ends() -> None:
    """30 m on from 0 m there are 15 m to the other, at 45 m; back again it is told once."""
    steps = (
        travel("east", "by: 30 m"),
        travel("east", "by: -30 m", "back"),
        travel("east", "to: 29 m", "again"),
    )
    assert told(two_cranes(0.0, 45.0, *steps)) == [
        ("plan[1]", meets("where step 'meet' ends", "30.00 m", "45.00 m"))
    ]
    assert told(two_cranes(0.0, 45.0, travel("east", "by: 12.9 m"))) == []


def test_steps_beside_each_other_count_together() -> None:
    """Both go on by 30 m at once: they stay 45 m apart. By 10 m the other is 25 m in front of the first."""
    first, beside = travel("east", "by: 30 m"), ", starts: with_previous"
    assert told(two_cranes(0.0, 45.0, first, travel("west", "by: 30 m", "too", beside))) == []
    assert told(two_cranes(0.0, 45.0, first, travel("west", "by: 10 m", "too", beside))) == [
        ("plan[2]", meets("where step 'too' ends", "30.00 m", "55.00 m"))
    ]


def test_what_only_may_be_is_left_to_the_run() -> None:
    """A step that ends at a time leaves a crane anywhere on its way from where it was."""
    timed = travel("east", "towards: plus, brake_from: 20 s", "timed")
    assert told(two_cranes(0.0, 45.0, timed)) == []
    # Where the other comes as near as 20 m to where the first at least is, they meet for sure.
    assert told(two_cranes(0.0, 45.0, timed, travel("west", "to: 20 m"))) == [
        ("plan[2]", meets("where step 'meet' ends", "0.00 m or more", "20.00 m"))
    ]
    away = travel("east", "towards: minus, brake_from: 20 s", "timed")
    assert told(two_cranes(0.0, 45.0, away, travel("west", "to: 20 m"))) == []
