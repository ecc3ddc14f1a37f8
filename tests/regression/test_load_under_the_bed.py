"""A load with `in_water` that was lowered through the bed of the water without a word.

`water.depth` shaped the waves and nothing else: in water of 12 m the manifold of `splash_zone` hung 18 m
under the surface with its weight in water in the hook. Vessels and anchors were told.
"""

from __future__ import annotations

from typing import Any

import pytest

import gantline
from gantline.scenario import load_scenario

#: Underside at the end: 6 m over still water, lowered by 14 m and 10 m, and what ropes stretch, 0.11 m.
DEEP = 14.0 + 10.0 - 6.0 + 0.11


def told(changes: dict[str, Any]) -> list[str]:
    """In waves of 1 mm: still water for what is asked here."""
    lift = load_scenario("splash_zone").changed(
        {"waves": {"ripple": {"height": "1 mm", "period": "6 s", "direction": "0 deg"}}, **changes}
    )
    recording = gantline.simulate(lift)
    return [one for one in recording.attributes["warnings"] if "bed of the water" in one]


def test_it_is_told_where_nothing_holds_it() -> None:
    (found,) = told({"water.depth": "12 m"})
    assert "nothing holds it there; 'ground: {level: -12 m}' would" in found
    # Stretch as above, to the last digit that is printed of it.
    assert float(found.split("up to ")[1].split(" m")[0]) == pytest.approx(DEEP - 12.0, abs=0.01)


def test_statics_tells_it_too() -> None:
    """At rest at the end of the plan."""
    statics = gantline.Statics(load_scenario("splash_zone").changed({"water.depth": "12 m"}))
    warnings = statics.equilibrium().recording.attributes["warnings"]
    assert any("manifold goes into the bed of the water" in one for one in warnings)


@pytest.mark.parametrize("changes", [{}, {"water.depth": "12 m", "ground": {"level": "-12 m"}}])
def test_nothing_is_told_where_the_water_is_deep_or_ground_holds_it(changes: dict[str, Any]) -> None:
    """40 m of water, and ground at the bed on which it is set down."""
    assert told(changes) == []
