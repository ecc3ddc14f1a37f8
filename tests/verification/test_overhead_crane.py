"""An overhead crane: what its wheels bear on the runway, and what it is drawn with."""

from __future__ import annotations

import numpy as np
import pytest

from gantline.checks import check_recording
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from shown import ROOT, lift_on

LIFT = lift_on(ROOT / "docs" / "concepts" / "goliath.md", "An overhead crane carries a machine")
G = 9.81
#: Of the page: span and wheelbase, height of the rails [m]; masses of girder, both carriages, a trolley [kg].
SPAN, BASE, RAILS = 28.0, 5.6, 14.0
GIRDER, CARRIAGES, TROLLEY = 38e3, 12e3, 8e3
#: How far sheaves of a hook block are above its bearing [m].
TO_SHEAVES = 1.2
#: Places of the trolleys, which the plan does not move [m].
ALONG = {"hall.A": -3.0, "hall.B": -9.0}
CORNERS = ("left.front", "left.back", "right.front", "right.back")


def at_rest(text: str) -> Recording:
    """The lift as it hangs, with its load clear of the floor and the crane where it began."""
    return Statics(parse_scenario(text)).equilibrium(time=22.0).recording


def corners(recording: Recording) -> np.ndarray:
    return np.array([recording.column("corner_load", f"hall.{one}")[-1] for one in CORNERS])


def test_corners_bear_what_stands_and_hangs_by_moments_about_the_rails() -> None:
    """Each side its share (14 m - x)/28 m of what is at x; with plumb falls both corners of a side alike."""
    plumb = at_rest(LIFT)
    at = [(TROLLEY * G + plumb.column("hoist_load", hook)[-1], x) for hook, x in ALONG.items()]
    own = (GIRDER + CARRIAGES) / 2 * G
    left = own + sum(weight * (0.5 - x / SPAN) for weight, x in at)
    right = own + sum(weight * (0.5 + x / SPAN) for weight, x in at)
    assert corners(plumb) == pytest.approx(np.array([left, left, right, right]) / 2, rel=1e-9)


def test_the_lever_of_falls_out_of_plumb_is_their_height_over_the_rails() -> None:
    """Ropes haul the hook blocks along the rails, which are at 14 m: all that hangs and pulls, by moments.

    They pull level with the sheaves, so that no moment comes onto hook blocks, which are kept upright.
    """
    text = LIFT.replace("damping_time: 10 ms}", "damping_time: 10 ms, mass: none}") + "mechanics:\n  ropes:\n"
    for hook, along in ALONG.items():
        ends = f"{{type: end, body: {hook}, at: [0 m, 0 m, {TO_SHEAVES} m]}}"
        ends += f", {{type: end, body: world, at: [{along} m, 26 m, 9 m]}}"
        text += f"    {hook}: {{rope: sling, length: 24.5 m, stretched: true, route: [{ends}]}}\n"
    held = at_rest(text)
    across, total = 0.0, (GIRDER + CARRIAGES + 2 * TROLLEY) * G
    hung = [("machine", 90e3), *((hook, 1.2e3) for hook in ALONG)]
    for name, mass in hung:
        across += mass * G * held.column("body_position", name)[-1, 1]
        total += mass * G
    for hook, along in ALONG.items():
        end = held.column("body_position", hook)[-1] + (0.0, 0.0, TO_SHEAVES)
        assert end[1] > 1.0  # m: otherwise nothing is tested
        way = np.array([along, 26.0, 9.0]) - end
        force = held.column("rope_tension", hook)[-1] * way / np.linalg.norm(way)
        across += force[1] * (end[2] - RAILS) - force[2] * end[1]
        total -= force[2]
    front, back = corners(held)[[0, 2]].sum(), corners(held)[[1, 3]].sum()
    assert (front - back) * BASE / 2 == pytest.approx(across, rel=1e-7)
    assert front + back == pytest.approx(total, rel=1e-9)


def test_it_is_drawn_up_on_its_rails_and_stands_in_no_floor() -> None:
    """Floors of the hall under its rails are beside no legs; its carriages are watched by their name."""
    floor = "structures: {floor: {type: box, x: [-20 m, 20 m], y: [-30 m, 30 m], z: [-1 m, 0 m]}}\n"
    watch = "watch: [{between: [machine, hall.end_carriages], smallest: 2 m}]\n"
    rest = at_rest(LIFT + floor + watch)
    checks = {check.name: check for check in check_recording(rest)}
    assert "no_overlap" not in checks and "wind_of_limit" not in checks
    # The left carriage, 0.84 m wide, is 14 - 0.42 - (6 + 3.5) m beside the machine, which is 9.5 m below it.
    machine = rest.column("body_position", "machine")[-1]
    level = RAILS - (machine[2] + 1.8)
    beside = SPAN / 2 - 0.42 - (6.0 + 3.5)
    assert checks["clearance_margin"].value == pytest.approx(np.hypot(level, beside) - 2.0, abs=1e-3)
