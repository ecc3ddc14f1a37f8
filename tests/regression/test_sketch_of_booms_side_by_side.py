"""The side view of two cranes side by side looked along the line of their hooks: one boom lay over the other.

It went by the direction of the first boom alone. Both booms, both falls and both hooks stood in one place,
with the names `cc.H, mc.H` beside one dot. Of several cranes it now has that axis to the right along which
their hooks are farther apart; of one crane it has its boom, as before.
"""

from __future__ import annotations

import gantline
from gantline.report.sketch import sketches
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from led_pair import led_text


def side_title(recording: Recording) -> str:
    side, _ = sketches(Subject(recording))
    return side.title


def test_hooks_of_two_cranes_are_seen_apart() -> None:
    """Booms over y, hooks 24 m apart along x."""
    recording = gantline.Simulation(gantline.parse_scenario(led_text())).run(until=0.1)
    assert side_title(recording).endswith("x to the right")
    side, _ = sketches(Subject(recording))
    names = {mark.text for mark in side.marks if mark.style == "sk-name"}
    assert {"a.H", "b.H"} <= names


def test_one_crane_is_seen_across_its_boom() -> None:
    """Over the starboard side of its barge at the start."""
    recording = gantline.Simulation("revolving_crane").run(until=0.1)
    assert side_title(recording).endswith("y to the right")
