"""Statics did not know which pins the plan had pulled by then, or put in.

An equilibrium was found with the pins as the plan has them at that time, but its recording had no event of
it, so checks took them as they are at the start. A lift whose plan pulls its pins was held against the
rule's skew load factor of 1.25, and nobody told that its slings give it no tilt stiffness: shackles used 87
% in `gantline statics` and 70 % in a run that ends in the same place. One whose plan puts pins in was held
against no factor at all.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.results.loads.skew import skew_loads
from gantline.results.loads.tilting import loose_tilt

#: What the plan does, whether pins hold at the start, at its end.
PLANS = {
    "pulled": ({"pull_pins": "e1"}, True, False),
    "pulled one": ({"pull_pins": "e1.2"}, [2], False),
    "put in": ({"put_in_pins": "e1.2"}, False, True),
    "left in": ({}, [2], True),
    "pulled and put in again": ({"pull_pins": "e1", "then": {"put_in_pins": "e1"}}, True, True),
}


def lift(does: dict[str, object], locked: object) -> gantline.Scenario:
    """The reference lift on slings alike, with a step that acts on pins before the load is clear."""
    does = dict(does)
    then = does.pop("then", {})
    assert isinstance(then, dict)
    plan = [
        {"step": "take up", "hoist": "test_hook", "speed": "0.1 m/s", "by": "1 m"},
        {"step": "pins", "hold": "1 s", **does},
        {"step": "look", "hold": "1 s", **then},
        {"step": "hoist", "hoist": "test_hook", "speed": "0.1 m/s", "by": "3 m"},
        {"step": "hold", "hold": "until_end"},
    ]
    slings = {f"slings.S{number}.length": "26.5 m" for number in (1, 2, 3, 4, 5)}
    changes = {"duration": "80 s", "plan": plan, "equalizers.e1.travel.locked": locked, **slings}
    return gantline.load_scenario("equalizer").changed(
        {**changes, "cranes.test_hook.at.z": "39.6 m", "rules": {"skew_load_factor": 1.25}}
    )


@pytest.mark.parametrize(("does", "locked", "is_in"), PLANS.values(), ids=PLANS)
def test_pins_at_rest_are_as_the_plan_has_them(does: dict[str, object], locked: object, is_in: bool) -> None:
    """Lengths decide where a pin is in, and the load is loose where none is: at rest as in a run."""
    rest = gantline.Statics(lift(does, locked)).equilibrium().recording
    assert {one.lengths_decide for one in skew_loads(rest)} == {is_in}
    assert (loose_tilt(rest, rest.rig.loads[0]) is None) == is_in


def test_before_the_step_pins_are_as_at_the_start() -> None:
    """No event of a pin that the plan pulls later."""
    rest = gantline.Statics(lift({"pull_pins": "e1"}, True)).equilibrium(time=5.0).recording
    assert rest.events("pin_pulled") == []
    assert {one.lengths_decide for one in skew_loads(rest)} == {True}
