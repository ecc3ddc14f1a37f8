"""The table of events of a report ended before the load had lifted off.

It had the first 400 events. In `goliath` slings hang on the verge of slack while the rig equalises, 380
changes of them in 90 s: the table filled six pages of paper and left out lift-off and all steps but three.
"""

from __future__ import annotations

import numpy as np

from gantline.report.events import Events
from gantline.report.subject import Subject
from sample_lift import sample_recording

TIME = np.arange(0.0, 101.0)


def rows(events: list[tuple[float, str, str]]) -> tuple[list[tuple[str, str, str]], int]:
    content = Events().content(
        Subject(sample_recording(TIME, tension=np.full((len(TIME), 5), 600e3), events=events))
    )
    assert content is not None
    return content["rows"], content["left_out"]


def test_there_and_back_is_one_row() -> None:
    """Five or more changes of one rope, each soon after the last; what lies between stays in its place."""
    chatter: list[tuple[float, str, str]] = [
        (1.0 + 0.1 * n, ("taut", "slack")[n % 2], "sling.S1") for n in range(7)
    ]
    other: list[tuple[float, str, str]] = [
        (1.25, "taut", "sling.S2"),
        (50.0, "lift_off", "load"),
        (60.0, "slack", "sling.S1"),
    ]
    shown, left_out = rows(sorted([*chatter, *other]))
    assert left_out == 0
    assert shown == [
        ("1.000 – 1.600", "taut/slack, 7 changes", "sling.S1"),
        ("1.250", "taut", "sling.S2"),
        ("50.000", "lift off", "load"),
        ("60.000", "slack", "sling.S1"),
    ]


def test_few_changes_keep_their_rows() -> None:
    events: list[tuple[float, str, str]] = [(1.0 + n, ("taut", "slack")[n % 2], "sling.S1") for n in range(4)]
    assert [row[1] for row in rows(events)[0]] == ["taut", "slack", "taut", "slack"]


def test_what_matters_most_is_kept() -> None:
    """Of 1 + 500 + 1 rows 400 stay: the steps, and the first of the ropes."""
    ropes: list[tuple[float, str, str]] = [(1.0 + 0.01 * n, "taut", f"sling.S{n}") for n in range(500)]
    shown, left_out = rows([(0.0, "step_begin", "hoist"), *ropes, (50.0, "lift_off", "load")])
    assert len(shown) == 400 and left_out == 102
    assert shown[0][1] == "step begin" and shown[-1][1] == "lift off"
    assert shown[398][2] == "sling.S397"
