"""A load that the lift file has in the air, and that a run begins with on the ground.

`start: rest` finds where everything rests. A load whose height had a wrong digit, 13.5 m for 3.5 m, hung in
slack slings; rest let it down by 10 m onto what was below, and the run began there without a word. Of vessels
that start more than 1 m from where the lift file has them a run has always said so.
"""

from __future__ import annotations

import pytest

from gantline import simulate
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift

GROUND = "ground: {level: 0 m, friction: 0.4}\n"


def warnings(height: float, length: float) -> list[str]:
    """Of a load of 4 m height with its bottom there, whose lug is 3 m below its hook at the start."""
    hook = {"hook": (0.0, 0.0, height + 7.0)}
    text = hooked_lift(hook, {"A": (0.0, 0.0, 4.0)}, {"S": ("hook", "A", length)},
                       position=(0.0, 0.0, height), more=GROUND)  # fmt: skip
    text = text.replace("start: as_given", "start: rest")
    recording = simulate(parse_scenario(text), duration=0.1)
    return [one for one in recording.attributes["warnings"] if "where the lift file has it" in one]


def test_let_down() -> None:
    """On a sling of 20 m the load comes down to the ground, by 10 m; on one of 3 m it hangs where it is."""
    (told,) = warnings(10.0, 20.0)
    assert told.startswith(
        "load starts 10.0 m from where the lift file has it, 10.0 m of that lower: there it rests;"
    )
    assert warnings(10.0, 3.0) == []


@pytest.mark.parametrize(("length", "is_told"), [(3.9, False), (4.2, True)])
def test_a_metre(length: float, is_told: bool) -> None:
    """Slack of less than a metre is usual."""
    assert bool(warnings(10.0, length)) is is_told
