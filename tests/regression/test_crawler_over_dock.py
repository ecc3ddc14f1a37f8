"""A crawler crane whose tracks reached 4.5 m over the edge of a quay.

Its position was 12 m for 20 m, the edge itself. Ground was simulated under all of its tracks, and the
pressure under those over the water passed as 45 % of what the ground bears.
"""

from __future__ import annotations

import pytest

import gantline
from crawler_lift import GAUGE, TRACK, crawler_lift
from gantline.scenario import parse_scenario
from gantline.scenario.crawler import Crawler

#: Of the crane of `crawler_lift`: its slewing axis [m].
X, Y = 3.0, -2.0


def lift(edge: float, *, heading: float = 0.0, tracks: str = "") -> str:
    """A crane beside a dock that begins `edge` m along x."""
    text = crawler_lift(300e3, heading=heading, tracks=tracks)
    dock = f"structures: {{basin: {{type: dock, x: [{edge} m, 90 m], y: [-50 m, 50 m], floor: -9 m}}}}\n"
    return text.replace("ropes:\n", f"{dock}ropes:\n", 1)


@pytest.mark.parametrize(("heading", "reach"), [(0.0, TRACK / 2), (90.0, GAUGE / 2)])
def test_ends_of_tracks_over_a_dock_are_refused(heading: float, reach: float) -> None:
    """They reach half a track along the heading from the slewing axis, and half a gauge across it."""
    parse_scenario(lift(X + reach + 0.01, heading=heading))
    with pytest.raises(gantline.ScenarioError) as caught:
        parse_scenario(lift(X + reach - 0.01, heading=heading))
    said = str(caught.value)
    assert f"cranes.c1.position: the end of a track of 'c1' at ({X + reach:.2f}, " in said
    where = f"x {X + reach - 0.01:g} to 90 m, y -50 to 50 m"
    assert said.endswith(f"is over the dock, {where}; put the crane onto the ground beside it")


def test_what_is_under_them_may_be_said() -> None:
    """All four on the floor of a dry dock."""
    corners = ("left.front", "left.back", "right.front", "right.back")
    levels = ", ".join(f"{corner}: -9 m" for corner in corners)
    cranes = parse_scenario(lift(-90.0, tracks=f", levels: {{{levels}}}")).cranes or {}
    crane = cranes["c1"]
    assert isinstance(crane, Crawler)
    assert crane.tracks.levels == dict.fromkeys(corners, -9.0)
