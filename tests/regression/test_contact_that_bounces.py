"""An edge that bounces as it is set down filled the table of events with lines of one contact."""

from __future__ import annotations

from gantline.report.events import _rows

BOUNCES = [
    (0.0, "step_begin", "down"),
    (10.000, "set_down", "box"),
    (10.120, "lift_off", "box"),
    (10.210, "set_down", "box"),
    (10.250, "lift_off", "box"),
    (10.290, "set_down", "box"),
]


def lines(events: list[tuple[float, str, str]]) -> list[tuple[str, str, str]]:
    return [row.cells() for row in _rows(events)]


def test_up_to_four_changes_within_a_second_are_one_contact() -> None:
    assert lines(BOUNCES[:4])[1:] == [("10.000 – 10.210", "set down, with 1 bounce", "box")]
    assert lines(BOUNCES[:3])[1:] == [("10.000 – 10.120", "lift off/set down, 2 changes", "box")]


def test_more_are_so_as_before() -> None:
    assert lines(BOUNCES)[1:] == [("10.000 – 10.290", "lift off/set down, 5 changes", "box")]


def test_contacts_apart_have_a_line_each() -> None:
    """A load that is set down, and lifted again after two seconds; and two loads."""
    apart = [(10.0, "set_down", "box"), (12.0, "lift_off", "box")]
    assert [one[1] for one in lines(apart)] == ["set down", "lift off"]
    two = [(10.0, "set_down", "box"), (10.1, "set_down", "other")]
    assert [one[2] for one in lines(two)] == ["box", "other"]


def test_slings_that_go_slack_keep_their_lines() -> None:
    slack = [(10.0, "slack", "S1"), (10.2, "taut", "S1")]
    assert [one[1] for one in lines(slack)] == ["slack", "taut"]
