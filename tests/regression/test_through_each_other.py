"""A load that went into the boom, one that went through the deck of a barge, a boom through a tower.

No simulation holds these off each other, and distances were looked at only of pairs under `watch`: whoever
did not think of a pair had GO, with "no pair under 'watch'" far down among what was not checked.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import gantline
from crawler_lift import HEEL, crawler_lift
from gantline.checks import Check, Verdict
from gantline.results.loads.overlaps import overlaps
from gantline.results.recording import Recording
from gantline.results.solids import box_faces
from gantline.scenario import parse_scenario
from module_lift import module_lift
from of_recording import check_of, checks_of

DECK, UNDERSIDE = 2.0, 12.0
OVER_THE_DECK = (20.0, UNDERSIDE)
#: How far the hook goes down where each case says it anew [m].
LOWERED = 1.0


def told(recording: Recording) -> list[Check]:
    return checks_of(recording, "no_overlap")


def lowered(by: float, more: str = "") -> Recording:
    lift = module_lift(by, place=OVER_THE_DECK, speed=30.0, duration=45.0)
    return gantline.simulate(parse_scenario(lift + more))


@pytest.mark.parametrize(
    ("by", "verdict"), [(9.9, None), (10.5, Verdict.WARNING), (12.5, Verdict.FAILED)], ids=str
)
def test_a_load_through_a_deck(by: float, verdict: Verdict | None) -> None:
    """The deck is 2 m above the water, the underside 12 m; half of the module's height are 1.5 m."""
    found = told(lowered(by))
    assert [one.verdict for one in found] == ([] if verdict is None else [verdict])
    for one in found:
        assert one.element == "barge to module"
        deep = float(one.remark.split(" m deep")[0].split(", ")[-1])
        assert deep == pytest.approx(by - (UNDERSIDE - DECK), abs=0.03)


def test_a_hook_that_is_lowered_into_the_load() -> None:
    """A module on the ground, slings of 5 m from a hook that is drawn as 3 m, and 6 m of way down."""
    standing = module_lift(
        LOWERED, place=OVER_THE_DECK, speed=30.0, duration=45.0, ground="ground: {level: 12 m}\n", around=""
    )
    lift = standing.replace("  lugs:", "  stands_on: ground\n  lugs:")
    lower = lift.replace("[20.0 m, 0 m, 20.0 m]", "[20.0 m, 0 m, 19.9 m]")
    hook = lower.replace("type: fixed_hook", "type: fixed_hook\n    block: {mass: 2 t, height: 3 m}")
    reeving = hook.replace(
        "    hoist:",
        "    reeving: {parts_each: 4, rope: sling, sheave_diameter: 0.6 m, upper_sheaves_at: 40 m}\n"
        "    drum: {diameter: 0.8 m}\n    hoist:",
    )
    slings = reeving.replace("damping_time: 10 ms}", "damping_time: 10 ms, diameter: 30 mm}")

    def found(by: float) -> list[str]:
        text = slings.replace(f"by: {LOWERED} m", f"by: {by} m")
        return [one.element for one in told(gantline.simulate(parse_scenario(text)))]

    assert found(4.5) == []
    assert found(6.0) == ["hook to module"]


def test_a_pair_that_is_watched_is_judged_by_that() -> None:
    recording = lowered(10.5, "watch: [{between: [module, barge]}]\n")
    assert not told(recording)
    assert check_of(recording, "clearance_margin").verdict is Verdict.FAILED


def test_a_pair_that_touches_is_held_apart_by_that() -> None:
    """On a soft deck the module sinks in by 20 t g / (4 x 1 MN/m), 49 mm, and no further."""
    deck = "{between: [module, barge], stiffness: 1 MN/m, damping: 100 kN s/m}"
    recording = lowered(12.0, f"mechanics: {{body_contacts: {{deck: {deck}}}}}\n")
    assert recording.column("load_transferred", "module")[-1] < 0.05
    assert not told(recording)


def slewed(tower: str) -> Recording:
    """The boom of the crawler crane, whose slewing axis is at (3, -2) m, goes by 10 deg to the left."""
    box = f"structures: {{tower: {{type: box, x: [10 m, 12 m], {tower}}}}}\n"
    plan = "{step: slew, slew: c1, speed: 0.3 rev/min, by: 10 deg}"
    return gantline.simulate(parse_scenario(crawler_lift(60e3, plan, slew=0.0, duration=20.0, more=box)))


@pytest.mark.parametrize(
    ("tower", "is_told"),
    [
        ("y: [-0.5 m, 3 m], z: [0 m, 60 m]", True),
        ("y: [2.5 m, 5 m], z: [0 m, 60 m]", False),
        (f"y: [-0.5 m, 3 m], z: [0 m, {HEEL + 15} m]", False),
    ],
    ids=["in the way", "beside", "below"],
)
def test_a_boom_through_a_tower(tower: str, is_told: bool) -> None:
    """10 deg at 9 m from the slewing axis are 1.6 m; the boom is 1.9 m wide.

    Its middle is 23 m over its heel pins at 5.4 m ahead of them, its lower side 4 m below that.
    """
    found = told(slewed(tower))
    assert [one.element for one in found] == ["c1.boom to tower"] * is_told


def drawn_as(recording: Recording, vertices: Any, triangles: Any) -> Recording:
    """The same with another drawing of the load; vertices from its centre of gravity [m]."""
    scene = dict(recording.attributes["scene"])
    mesh = {
        "type": "mesh",
        "vertices": np.asarray(vertices).tolist(),
        "triangles": np.asarray(triangles).tolist(),
    }
    load = {"name": "module", "kind": "load", "shape": mesh, "centre_of_gravity": [0.0, 0.0, 0.0]}
    scene["bodies"] = [load if body["name"] == "module" else body for body in scene["bodies"]]
    return Recording(recording.variables, recording.coordinates, {**recording.attributes, "scene": scene})


def test_triangles_are_looked_at_as_they_are() -> None:
    """A module 0.5 m in the deck as a box of triangles, and as one that is pointed, beside the barge."""
    recording = lowered(10.5)
    corners = np.array([(x, y, z) for x in (-2, 2) for y in (-2, 2) for z in (-1.5, 1.5)], dtype=float)
    (found,) = overlaps(drawn_as(recording, corners, box_faces(1)))
    assert found.depth == pytest.approx(0.5, abs=0.03)
    # Its lowest point is 19 m to the side, so that it rises from there to where the deck is.
    pointed = [(-2.0, 0.0, 1.5), (2.0, 0.0, 1.5), (0.0, 1.0, 1.5), (0.0, 19.0, -1.5)]
    faces = [(0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)]
    assert overlaps(drawn_as(recording, pointed, faces)) == []


def test_a_vessel_that_a_load_is_to_stand_on_is_told_how() -> None:
    lift = module_lift(LOWERED, place=OVER_THE_DECK, speed=30.0, duration=45.0)
    text = lift.replace("  lugs:", "  stands_on: barge\n  lugs:")
    with pytest.raises(gantline.ScenarioError, match="let both touch by 'body_contacts' of 'mechanics'"):
        parse_scenario(text)
