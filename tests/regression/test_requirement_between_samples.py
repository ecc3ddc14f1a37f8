"""A step that ends between two samples: what it requires was read at the one before, up to an interval early.

Samples 1 s apart, of which the last before the end has 40 % of the load transferred and the next 60 %:
`load_transferred: below 50 %` was held against 40 %, ok, whatever the step ended with. Of the two samples
about the end the unfavourable one counts, unless something parts, comes or goes as the next step begins, and
that is none of this step.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from gantline.checks import Check, Verdict, check_recording
from sample_lift import WEIGHT, sample_recording, sample_rig

#: Samples 1 s apart; the load comes off its supports by 20 % a second, at 2 s all of it stands.
TIME = np.linspace(0.0, 10.0, 11)
HUNG = np.clip((TIME - 2.0) / 5.0, 0.0, 1.0)


def required(
    side: str, limit: float, *, end: float = 4.6, then: dict[str, Any] | None = None, events: Any = ()
) -> Check:
    """`load_transferred` at the end of 'hoist'; `then` are keys of the step that begins there."""
    rig: dict[str, Any] = sample_rig()
    rig["plan"] = [
        {"step": "hoist", "kind": "hoist", "require": {"load_transferred": {side: limit}}},
        {"step": "next", "kind": "hold", "hold_until": "end", **(then or {})},
    ]
    recording = sample_recording(
        TIME,
        rig=rig,
        tension=np.outer(HUNG, np.full(5, WEIGHT / 5)),
        contact=np.repeat((1.0 - HUNG)[:, None] * WEIGHT / 4, 4, axis=1),
        events=[
            (0.0, "step_begin", "hoist"),
            (end, "step_end", "hoist"),
            (end, "step_begin", "next"),
            *events,
        ],
    )
    return next(one for one in check_recording(recording) if one.step == "hoist")


@pytest.mark.parametrize(
    ("side", "limit", "value", "time", "verdict"),
    [
        ("below", 0.5, 0.6, 5.0, Verdict.FAILED),
        ("below", 0.61, 0.6, 5.0, Verdict.OK),
        ("above", 0.5, 0.4, 4.0, Verdict.FAILED),
        ("above", 0.39, 0.4, 4.0, Verdict.OK),
    ],
)
def test_of_two_samples_the_unfavourable_one_counts(
    side: str, limit: float, value: float, time: float, verdict: Verdict
) -> None:
    """The end is at 4.6 s: (4 - 2)/5 hang at the sample before it, (5 - 2)/5 at the one after."""
    found = required(side, limit)
    assert found.verdict is verdict
    assert found.value == pytest.approx(value, rel=1e-12)
    assert found.time == time


@pytest.mark.parametrize("end", [4.0, math.nextafter(4.0, 0.0), math.nextafter(4.0, 5.0)])
def test_a_sample_at_the_end_is_the_only_one(end: float) -> None:
    """Rounding of the time of an event is no other sample."""
    for side, limit in (("below", 0.5), ("above", 0.3)):
        found = required(side, limit, end=end)
        assert (found.verdict, found.time) == (Verdict.OK, 4.0)


@pytest.mark.parametrize(
    "then",
    [{"cut": ["sling.S1"]}, {"detach": ["sling.S1"]}, {"remove_supports": ["keel"]}, {"pull_pins": ["e1"]}],
)
def test_what_the_next_step_changes_at_once_is_not_of_this_one(then: dict[str, Any]) -> None:
    found = required("below", 0.5, then=then)
    assert (found.verdict, found.time) == (Verdict.OK, 4.0)


def test_nor_is_what_parts_by_itself_in_between() -> None:
    found = required("below", 0.5, events=[(4.8, "broken", "sling.S1")])
    assert (found.verdict, found.time) == (Verdict.OK, 4.0)
