"""A load that was let down over a barge which nothing let it touch was in order to `gantline check`.

It went through her deck, and only the run said so, by `no_overlap`: after minutes, or never where the step
waited for slings to go slack. What lets them touch is a contact under `body_contacts`, which neither the load
nor the vessel asks for.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario, parse_scenario
from module_lift import BARGE, module_lift

#: Underside of the module, and the deck of a barge of 4 m that draws 2 m, over the water [m].
UNDERSIDE, DECK = 12.0, 2.0
CONTACT = """\
mechanics:
  body_contacts:
    on_deck: {between: [module, barge], stiffness: 100 MN/m, damping: 1 MN s/m}
"""
PLATFORM = "structures: {tower: {type: box, x: [15 m, 25 m], y: [-5 m, 5 m], z: [3 m, 8 m]}}\n"
NOT_TOLD = (
    "and nothing lets them touch: a load goes through hulls and decks; "
    "'on_deck: {between: [module, barge], …}' under 'body_contacts' of 'mechanics' does"
)


def told(by: float, *, x: float = 20.0, around: str = BARGE, until: str = "") -> list[str]:
    """What is said of a way down by a length [m], or until something, and of contacts."""
    text = module_lift(by, place=(x, UNDERSIDE), speed=30.0, duration=45.0, around=around)
    assert f"by: {by} m" in text
    given = text.replace(f"by: {by} m", f"until: {until}") if until else text
    doubts = assemble(parse_scenario(given)).doubts
    return [one.sentence for one in doubts if "lets them touch" in one.sentence]


@pytest.mark.parametrize("by", [11.0, 13.5])
def test_a_way_down_through_the_deck(by: float) -> None:
    """By what it goes down more than 12 m less 2 m."""
    deep = f"{by - (UNDERSIDE - DECK):.2f} m"
    assert told(by) == [
        f"step 'lower' lets module down over barge, to {deep} below her deck or deeper, {NOT_TOLD}"
    ]


@pytest.mark.parametrize("until", ["{slings: slack}", "{supports: touched}", "{load_transferred: 5 %}"])
def test_a_step_that_waits_for_it_to_stand_there(until: str) -> None:
    quay = "ground: {level: -9 m}\n"
    said = told(1.0, around=BARGE + quay, until=until)
    assert said == [f"step 'lower' waits for module to stand on barge, {NOT_TOLD}"]


@pytest.mark.parametrize(
    "around", [BARGE + CONTACT, BARGE + PLATFORM, ""], ids=["contact", "platform", "none"]
)
def test_what_may_touch_it_is_in_order(around: str) -> None:
    assert told(12.0, around=around) == []


@pytest.mark.parametrize(("by", "x"), [(9.0, 20.0), (10.4, 20.0), (12.0, 45.0)])
def test_over_the_deck_just_on_it_or_beside_her_nothing_is_said(by: float, x: float) -> None:
    """Slings stretch and decks yield by less than 0.5 m; her bow is at 40 m."""
    assert told(by, x=x) == []


def test_cranes_that_lead_it_over_her() -> None:
    """The hooks of `heavy_lift_ship` come from the quay, and lower until their slings are slack."""
    lift = load_scenario("heavy_lift_ship")
    begin = lift.text.index("  body_contacts:")
    without = lift.text[:begin] + lift.text[lift.text.index("plan:", begin) :]
    for text, said in ((lift.text, 0), (without, 1)):
        doubts = assemble(parse_scenario(text, lift.source)).doubts
        assert sum("waits for reactor to stand on ship" in one.sentence for one in doubts) == said
