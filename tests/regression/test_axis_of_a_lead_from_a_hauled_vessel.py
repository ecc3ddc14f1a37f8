"""A load was turned about an axis beside the one that its lift file gave, without a word.

Cranes lead as if their vessel lay where the lift file has her. One that mooring lines have hauled by 20 m
before took the axis `about`, in x and y of the world, along with her.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario

SHIP = Path(__file__).parents[2] / "scenarios" / "heavy_lift_ship" / "scenario.yaml"
_OVER = "{step: over the deck, lead: [fore.H, aft.H], by: [0 m, -20.85 m, 0 m], speed: 1.2 m/min"
_HAUL = "{step: along the quay, haul: aft.spring, speed: 0.5 m/min, by: 1 m}"

#: Where the ship has her stern and keel as the lift begins: a crane that stands there has its places hers.
_FIXED = "[0 m, 0 m, -6.1 m]"


def doubts(*, haul: bool, about: bool, fixed: bool = False) -> list[str]:
    """What is told of lines that move in a lift whose reactor is turned by one degree as it comes over.

    With `fixed` the aft crane stands on the ground in its place.
    """
    text = SHIP.read_text(encoding="utf-8")
    turned = _OVER.replace("speed: 1.2 m/min", "turn: 1 deg, speed: 1 m/min")
    axis = "turn: 1 deg, about: [80 m, 0 m]" if about else "turn: 1 deg"
    text = text.replace(_OVER, turned.replace("turn: 1 deg", axis))
    line = "  aft.spring:  {type: to_the_quay, "
    assert line in text
    text = text.replace(line, f"{line}winch: {{speed: 1 m/min, acceleration: 0.01 m/s^2}}, ")
    if haul:
        step = "  - {step: up, lead"
        assert step in text
        text = text.replace(step, f"  - {_HAUL}\n{step}")
    if fixed:
        fore, aft = text.split("  aft:\n    type: floating_crane\n", 1)
        aft = aft.replace("    vessel: ship\n", f"    position: {_FIXED}\n", 1)
        text = f"{fore}  aft:\n    type: floating_crane\n{aft}"
    found = assemble(parse_scenario(text)).doubts
    return [str(one.sentence) for one in found if "moves lines of ship" in one.sentence]


def test_an_axis_of_the_world_is_told_once_the_vessel_is_hauled() -> None:
    (told,) = doubts(haul=True, about=True)
    assert told.startswith("step 'along the quay' moves lines of ship")
    assert "this axis is off by as far as she has gone" in told


@pytest.mark.parametrize(("haul", "about"), [(False, True), (True, False)])
def test_a_way_that_goes_with_the_vessel_is_not(haul: bool, about: bool) -> None:
    assert doubts(haul=haul, about=about) == []


@pytest.mark.parametrize("about", [False, True])
def test_hooks_on_two_bases_come_apart_once_one_is_hauled(about: bool) -> None:
    """Of both steps that lead, with or without an axis: hooks are not as far apart as their way has them."""
    found = doubts(haul=True, about=about, fixed=True)
    assert len(found) == 2
    for told in found:
        assert told.startswith("step 'along the quay' moves lines of ship")
        assert told.endswith("hooks come apart from those on another base")


def test_hooks_on_two_bases_that_stay_do_not() -> None:
    assert doubts(haul=False, about=True, fixed=True) == []
