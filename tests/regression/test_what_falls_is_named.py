"""A deck that slides without end was told as the post on it.

Of all bodies that had gone equally far the last was named, which is what is fixed to the one that falls: what
is drawn of a guide, outfitting, a frame.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.statics import NoEquilibriumError, Statics
from guided_lift import guided_lift

_WALL = (
    "  g: {held_by: deck, wall: {at: [0 m, -9 m, 0 m], faces: 90 deg, breadth: 2 m, height: 2 m}, "
    "bumper: {at: [0 m, -1.5 m, 0 m], diameter: 0.4 m}, friction: 0}\n"
)
_DECK = """\
start: rest
mechanics:
  bodies:
    deck: {joint: {type: slider, axis: [0, 1, -0.1]}, mass: 20 t}
    rail: {parent: deck, joint: {type: fixed}, mass: 1 t}
"""


def test_it_is_the_deck() -> None:
    """The load hangs 20 m high, and nothing is in the way of the deck."""
    text = guided_lift(_WALL, height=20.0, more=_DECK)
    with pytest.raises(NoEquilibriumError, match=r"it falls without end \(deck\)"):
        Statics(parse_scenario(text, "x.yaml")).equilibrium()
