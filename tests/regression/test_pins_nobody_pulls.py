"""Locking pins that no step pulled: the equalizer lifted as a rigid beam, GO, and nothing said so.

The step `equalise` of a lift with three equalizers named two of them. What came of it was told, forces on
pins, slack slings and a step that waits for ever, and not why; where pins and slings bear it nothing was.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from lift_text import changed
from pinned_lift import LIFT

HOIST = "{step: hoist, hoist: hook, speed: 0.05 m/s, by: 0.5 m}"
#: The lift with slings of one length, hoisted by the plan.
LEVEL = changed(
    LIFT,
    ("length: 12.2 m", "length: 12 m"),
    ("{step: end, hold: until_end}", HOIST),
)
FORGOTTEN = changed(LEVEL, (", pull_pins: e1", ""))
TOLD = (
    "the pins of e1 hold all its sheaves, and no step of the plan pulls them: it shares as a rigid beam does;"
    " 'pull_pins: e1' in a step lets it equalise"
)


def told(text: str) -> list[str]:
    return [sentence for sentence in assemble(parse_scenario(text)).warnings if "the pins of" in sentence]


def test_a_hoist_under_pins_that_are_never_pulled_is_told() -> None:
    (sentence,) = told(FORGOTTEN)
    assert sentence == TOLD


@pytest.mark.parametrize(
    "meant",
    [
        LEVEL,
        changed(LEVEL, ("pull_pins: e1}", "pull_pins: e1.2}")),
        changed(FORGOTTEN, ("locked: true", "locked: [1, 3]")),
        changed(FORGOTTEN, ("locked: true", "locked: false")),
        changed(FORGOTTEN, (HOIST, "{step: end, hold: 1 s}")),
    ],
    ids=["pulled", "one of them pulled", "some locked", "none locked", "nothing hoisted"],
)
def test_what_is_meant_so_is_not(meant: str) -> None:
    assert told(meant) == []
