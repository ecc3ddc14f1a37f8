"""A boom that went down, and with it the load onto the ground.

Nothing in the plan lowered it. The crane slewed on with 150 t half on the ground and its falls 11 deg out of
plumb; where neither chart nor limits speak of that, the lift was GO without a word.

A load that was slewed into a house was told in the same words, "comes down on what is below it": a warning.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gantline.checks import Check, Verdict
from gantline.checks.plan import came_down
from gantline.results.recording import Recording
from gantline.results.variable import Variable

#: Steps follow each other every 10 s; the load comes down 5 s into the second.
DOWN = 15.0


def checked(*kinds: str, load: str = "module") -> list[Check]:
    """Warnings of a plan of steps of these kinds, one after another from 0 s on; `+` goes side by side."""
    plan: list[dict[str, Any]] = []
    events: list[tuple[float, str, str]] = [(DOWN, "set_down", load)]
    for place, kind in enumerate(kinds):
        for one in kind.split("+"):
            name = f"{one} {place}"
            plan.append({"step": name, "kind": one})
            events += [(10.0 * place, "step_begin", name), (10.0 * place + 10.0, "step_end", name)]
    events.sort(key=lambda event: event[0])
    variables = {
        "time": Variable(("time",), np.arange(0.0, 31.0), "s", ""),
        "event_time": Variable(("event",), np.array([event[0] for event in events]), "s", ""),
        "event_kind": Variable(("event",), np.array([event[1] for event in events]), "1", ""),
        "event_name": Variable(("event",), np.array([event[2] for event in events]), "1", ""),
    }
    rig = {"plan": plan, "loads": [{"name": "module", "body": "module", "weight": 1.5e6}]}
    return came_down(Recording(variables, {}, {"rig": rig}))


@pytest.mark.parametrize(
    ("kind", "verdict", "words"),
    [
        ("luff", Verdict.WARNING, "it comes down on what is below it"),
        ("luff+slew", Verdict.WARNING, "it comes down on what is below it"),
        ("slew", Verdict.FAILED, "it runs into what is in its way"),
        ("traverse", Verdict.FAILED, "it runs into what is in its way"),
        ("travel", Verdict.FAILED, "it runs into what is in its way"),
    ],
)
def test_a_load_that_meets_something_while_it_is_taken_along_is_told(
    kind: str, verdict: Verdict, words: str
) -> None:
    (found,) = checked("hoist", kind, "hold")
    assert (found.verdict, found.element, found.time) == (verdict, "module", DOWN)
    assert found.remark.startswith(words) and "which does not lower it" in found.remark


@pytest.mark.parametrize("kind", ["lower", "luff+lower", "hoist", "hold"])
def test_one_that_is_lowered_is_not(kind: str) -> None:
    assert checked("hoist", kind, "hold") == []


def test_what_is_no_load_is_not() -> None:
    assert checked("hoist", "luff", "hold", load="box of mechanics") == []
