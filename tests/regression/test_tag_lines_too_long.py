"""Tag lines that were made fast with more than twice the length of their way held nothing, without a word.

The module of `off_a_barge` turned by 70° between two lines of 30 m, where the ways are 12 m: its turning was
told where it passed 45°, that the lines were slack from beginning to end was not.
"""

from __future__ import annotations

from gantline.checks import Check
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from lift_text import changed
from of_recording import checks_of
from tugged_load import LIFT

#: From 5 m along the load to 60 m, 4 m up: hypot(55, 4) = 55.15 m; the load rises by 3 m or so.
WAY = 55.15
#: A second one pulls across, at its end, and turns the load towards itself: by atan(60/5) at most.
ACROSS = "tag_lines:\n  across: {at: [-5 m, 0 m, 2 m], to: [-5 m, 60 m, 6 m], rope: tag, pull: 1 kN}\n"


def told(held: str, across: str = ACROSS) -> list[Check]:
    text = changed(
        LIFT,
        ("pull: 3 kN", held),
        ("speed: 5 m/min, by: 5 m", "speed: 10 m/min, by: 3 m"),
        ("duration: 300 s", "duration: 90 s"),
        ("tag_lines:\n", across),
    )
    recording = Simulation(parse_scenario(text)).run()
    found = checks_of(recording, "tag_lines_pull")
    return [one for one in found if one.element == "line"]


def test_a_line_that_is_slack_all_the_time() -> None:
    (check,) = told(f"length: {2 * WAY} m")
    assert check.remark.startswith("slack all the time that the load hangs clear, and turns by ")
    assert check.remark.endswith(" deg: made fast too long to hold it")


def test_one_that_pulls_at_some_time() -> None:
    """It is just taut at the start; as the load turns away its end goes away too."""
    assert told("length: as_routed") == []


def test_a_load_that_does_not_turn() -> None:
    """Nothing pulls at it: a line with slack has nothing to hold."""
    assert told(f"length: {2 * WAY} m", "tag_lines:\n") == []
