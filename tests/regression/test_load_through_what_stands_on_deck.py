"""A module that swung through a deckhouse was GO, with no warning.

What stands on a deck can be said as a body of `mechanics` alone, which has a shape to draw. Such bodies were
held against nothing: neither the load nor hooks, slings and falls that went through them were told.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from module_lift import BARGE, module_lift
from of_recording import checks_of

#: The house stands on a deck 2 m above the water, 3 m high; underside of the module at the start [m].
TOP, UNDERSIDE = 5.0, 12.0


def lowered(by: float, underside: float = UNDERSIDE, more: str = "") -> Recording:
    """A module over a house of 10 t, by which the barge goes down and trims by no more than 2 cm there."""
    deckhouse = f"""\
mechanics:
  bodies:
    house: {{parent: barge, at: [20 m, 0 m, 4 m], joint: {{type: fixed}}, mass: 10 t,
      shape: {{box: [6 m, 6 m, 3 m], centre: [0 m, 0 m, 1.5 m]}}}}
{more}"""
    lift = module_lift(by, place=(20.0, underside), speed=30.0, duration=45.0, around=BARGE + deckhouse)
    return gantline.simulate(parse_scenario(lift))


@pytest.mark.parametrize(
    ("by", "verdict"), [(6.9, None), (8.0, Verdict.WARNING), (9.0, Verdict.FAILED)], ids=str
)
def test_a_load_in_a_house_on_deck(by: float, verdict: Verdict | None) -> None:
    """From where it is past the middle of what is thinner, both 3 m, no drawing makes that good."""
    found = checks_of(lowered(by), "no_overlap")
    assert [(one.element, one.verdict) for one in found] == (
        [] if verdict is None else [("module to house", verdict)]
    )
    for one in found:
        deep = float(one.remark.split(" m deep")[0].split(", ")[-1])
        assert deep == pytest.approx(by - (UNDERSIDE - TOP), abs=0.03)
        assert ("'body_contacts' of 'mechanics' let them touch" in one.remark) is (verdict is Verdict.FAILED)


def test_its_sling_too() -> None:
    """Its lug, 3 m over the underside, is 2 m below the top of the house then, and 1 m above the deck."""
    found = checks_of(lowered(12.0), "sling_outside_structures")
    assert [one.verdict for one in found] == [Verdict.WARNING]
    assert "through 'house'" in found[0].remark


def test_a_load_that_begins_in_it_is_drawn_so() -> None:
    """As a foot in its bucket: nothing is said until it has been out."""
    assert checks_of(lowered(0.1, TOP - 0.5), "no_overlap") == []


def test_what_touches_it_in_the_simulation_is_held_off() -> None:
    touches = "  body_contacts:\n    on: {between: [module, house], stiffness: 100 MN/m, damping: 1 MN s/m}\n"
    recording = lowered(9.0, more=touches)
    assert checks_of(recording, "no_overlap") == []


def test_what_is_moved_about_stands_nowhere() -> None:
    """A body on a slider, which a plan or forces move, is no fixture."""
    recording = lowered(9.0)
    assert list(recording.rig.fixtures) == ["house"]
    text = module_lift(9.0, place=(20.0, UNDERSIDE), speed=30.0, duration=1.0)
    bodies = """\
mechanics:
  bodies:
    cart: {parent: barge, at: [5 m, 0 m, 4 m], joint: {type: slider, axis: [0, 1, 0]}, mass: 1 t,
      shape: {box: [1 m, 1 m, 1 m]}}
    crate: {parent: cart, at: [0 m, 0 m, 1 m], joint: {type: fixed}, mass: 1 t, shape: {box: [1 m, 1 m, 1 m]}}
"""
    assert list(gantline.simulate(parse_scenario(text + bodies)).rig.fixtures) == []
