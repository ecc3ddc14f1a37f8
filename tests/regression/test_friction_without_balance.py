"""Loads that tuggers drag askew as they come off the ground, and statics that gave up there.

Each search lets contacts hold from where they stood before. While a load comes clear, what is left of its
corners slides, and there may be no force of friction against its way that is in balance with what then
presses: with it the corner comes off, without it presses again. "Its friction and what that holds find no
balance (load.corner_1)": nine of sixty lifts with slings of uneven length and one or two tuggers had no
answer, most of them about a load that had long been clear of the ground. A run has one: the load slides, and
swings until it rests.

Where friction finds no balance, a load slides to where nothing drives it, and that is told.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from tugged_load import LIFT

LINE = "line: {at: [5 m, 0 m, 2 m], to: [60 m, 0 m, 6 m], rope: tag, pull: 3 kN}"


def test_a_load_slides_where_its_friction_finds_no_balance() -> None:
    """There it is told; clear of the ground friction holds nothing: it hangs as without friction."""
    statics = Statics(parse_scenario(LIFT.replace("to: [60 m, 0 m, 6 m]", "to: [60 m, 100 m, 6 m]")))
    # From 4.43 s to 4.46 s there is none; a way in longer parts may pass by what slides within one of them.
    there = statics.equilibrium(4.45, losses="held")
    [(moment, name)] = there.slides
    assert name == "load" and 4.35 < moment <= 4.45
    assert there.to_json()["slides"] == [{"time": moment, "name": "load"}]
    held = statics.equilibrium(20.0, losses="held")
    assert held.contacts == ()
    free = statics.equilibrium(20.0)
    for rope in ("sling.A", "sling.B", "sling.C", "sling.D", "tag.line"):
        # Two searches, each within 1e-9 of the forces, of what four slings of 100 MN share.
        assert held.tension(rope) == pytest.approx(free.tension(rope), abs=1e-6 * 400e3), rope


def test_it_holds_as_long_as_there_is_a_balance() -> None:
    """Before that all four corners hold, with less than μN."""
    askew = LIFT.replace("to: [60 m, 0 m, 6 m]", "to: [60 m, 100 m, 6 m]")
    rest = Statics(parse_scenario(askew)).equilibrium(4.2, losses="held")
    assert rest.slides == () and len(rest.contacts) == 4
    assert all(contact.used is not None and contact.used < 1.0 for contact in rest.contacts)


def test_where_it_has_slid_friction_holds_again() -> None:
    """A corner still presses later, and holds no more than μN, with slings that carry one after the other."""
    lengths = {"A": 8.701, "B": 8.806, "C": 8.800, "D": 8.830}
    uneven = LIFT.replace("[0 m, 0 m, 2 m]}\n  stands", "[-0.12 m, 0.19 m, 2.46 m]}\n  stands")
    for name, length in lengths.items():
        uneven = uneven.replace(f"to: load.{name}}}", f"to: load.{name}, length: {length} m}}")
    pulled = "line: {at: [5 m, -0.02 m, 1.92 m], to: [-33 m, -10.5 m, 5.6 m], rope: tag, pull: 13.57 kN}"
    assert LINE in uneven
    scenario = parse_scenario(uneven.replace(LINE, pulled)).changed({"ground.friction": "0.5"})
    rest = Statics(scenario).equilibrium(7.59, losses="held")
    assert [name for _, name in rest.slides] == ["load"]
    [corner] = rest.contacts
    # Bounds are right to 1e-8 of the largest.
    assert corner.used is not None and 0.9 < corner.used <= 1.0 + 1e-8
    assert rest.residual < 1e-9
