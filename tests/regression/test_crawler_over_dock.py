"""A crawler crane whose tracks reached 4.5 m over the edge of a quay.

Its position was 12 m for 20 m, the edge itself. Ground was simulated under all of its tracks, and the
pressure under those over the water passed as 45 % of what the ground bears.

One that began beside a dock and travelled 30 m over it was GO: only where it began was looked at.
"""

from __future__ import annotations

import pytest

import gantline
from crawler_lift import GAUGE, TRACK, crawler_lift
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.scenario.cranes.crawler import Crawler

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


def travelled(by: float, edge: float) -> list[Check]:
    """The crane travels along x, beside a dock that begins `edge` m along x."""
    drive = "    travel: {speed: 1 km/h, acceleration: 0.05 m/s^2, range: [-50 m, 50 m]}\n"
    plan = f"{{step: travel, travel: c1, speed: 1 km/h, by: {by} m}}"
    lift = crawler_lift(60e3, plan, crane=drive, duration=40.0)
    dock = f"structures: {{basin: {{type: dock, x: [{edge} m, 90 m], y: [-50 m, 50 m], floor: -9 m}}}}\n"
    text = lift.replace("ropes:\n", f"{dock}ropes:\n", 1)
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    return [one for one in checks if one.name == "tracks_on_ground"]


def test_where_it_travels_is_looked_at() -> None:
    """Its front ends begin at 7.5 m and come to 12.5 m; 1 km/h is reached after 5.6 s and 0.77 m."""
    assert travelled(5.0, X + TRACK / 2 + 5.01) == []
    (found,) = travelled(5.0, X + TRACK / 2 + 2.0)
    assert (found.verdict, found.element) == (Verdict.FAILED, "c1.left.front")
    speed, rise = 1 / 3.6, 1 / 3.6 / 0.05
    exact = rise + (2.0 - speed * rise / 2) / speed
    assert found.time is not None and exact <= found.time <= exact + 0.05  # the first sample past the edge
    assert "goes over an edge" in found.remark and "9.00 m lower" in found.remark
