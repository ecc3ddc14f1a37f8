"""A reactor set down on the deck of its ship: `statics --steps` FAILED and did not say why.

Contacts are without friction unless they are asked for with it, the deck leans by half a degree, and the
reactor slid until its slings pulled at it, which took their hooks out of plumb. `--held` all was in order.
"""

from __future__ import annotations

from gantline.cli.friction import fails_as_it_slides
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study.steps import run_steps
from lift_text import changed
from onto_a_deck import onto_a_deck

_TOLD = "  box stands where a check fails, free to slide; --held has friction hold what it can"


def _told(friction: str) -> list[str]:
    """A box on a deck that leans by 3 degrees, where it slides until its sling of 5 m holds it."""
    text = changed(
        onto_a_deck("  - {step: down, lower: hook, speed: 3 m/min, by: 0.5 m}", ""),
        ("{type: slider, axis: [0, 0, 1], motion: []}", "{type: fixed}"),
        ("at: [10 m, 0 m, 0 m]", "at: [0 m, 0 m, 0 m]\n      orientation: {about: [0, 1, 0], angle: 3 deg}"),
        (", friction: 0.3", friction),
        ("simulation:", "limits: {rule: yard, load_tilt: 2 deg}\nsimulation:"),
    )
    question = Statics(parse_scenario(text, "x.yaml"))
    return fails_as_it_slides([one.state for one in run_steps(question, "none")])


def test_it_is_told_what_holds_it() -> None:
    assert _told(", friction: 0.3") == [_TOLD]


def test_nothing_holds_it_where_there_is_no_friction() -> None:
    assert _told("") == []
