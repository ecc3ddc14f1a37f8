"""A load that `stands_on` a deck, a body of `mechanics` aboard a vessel, was told of the ground alone.

Of a vessel it was told what is right, `body_contacts`; of the grillage on it, as a load off a barge has one,
"'deck' is not a group of 'supports' and not 'ground'; known here: 'ground'".
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from lift_text import BASE, spoiled

DECK = """\
mechanics:
  bodies:
    deck: {joint: {type: fixed}, shape: {box: [20 m, 20 m, 1 m]}}
cranes:
"""


def test_what_is_right_is_said_of_a_body_too() -> None:
    text = spoiled("stands_on: ground", "stands_on: deck", spoiled("cranes:\n", DECK, BASE))
    says = (
        r"load\.stands_on: 'deck' is a body of 'mechanics', which no load stands on by 'stands_on'; leave it "
        r"out and let both touch by 'body_contacts'"
    )
    with pytest.raises(ScenarioError, match=says):
        parse_scenario(text)
