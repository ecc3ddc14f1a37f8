"""The column of `scenarios/upending` against the lever of its lugs, its tail crane against their geometry."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.checks import check_recording, has_failed, hold_points, hook_readings
from gantline.plot.moments import stages
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from promises import PROMISES, Promise
from shown import ROOT

SCENARIO = Path(__file__).parents[2] / "scenarios" / "upending"
#: Slings C and D lean by 1.2 m over their 13 m, at any tilt, while falls are plumb.
UPRIGHT = math.sqrt(1.0 - (1.2 / 13.0) ** 2)


@pytest.fixture(scope="module")
def upended() -> Recording:
    return gantline.simulate(SCENARIO)


@pytest.mark.parametrize("promise", PROMISES)
def test_what_every_scenario_promises(promise: Promise, upended: Recording, tmp_path: Path) -> None:
    """Metrics within the tolerance of their source; its balance closes; and saved, it says the same."""
    promise(ROOT / "scenarios" / "upending", upended, tmp_path)


def _during(recording: Recording, first: str, last: str) -> tuple[float, float]:
    """From the beginning of one step to the end of another [s]."""
    begins = {name: time for time, _, name in recording.events("step_begin")}
    ends = {name: time for time, _, name in recording.events("step_end")}
    return begins[first], ends[last]


def test_the_tail_crane_carries_by_the_lever_of_the_lugs(upended: Recording) -> None:
    """T = W (a cos t + b sin t)/(c cos t + d sin t) of plumb falls at the tilt t, lengths from the trunnions.

    a, b lead along and across the column to its centre of gravity, c, d to the brackets at the foot.
    """
    (load,) = upended.rig.loads
    trunnion, bracket = np.array(load.lugs["A"].at), np.array(load.lugs["C"].at)
    tilt = upended.column("load_tilt", "column")

    def ahead(along: float, across: float) -> np.ndarray:
        place: np.ndarray = along * np.cos(tilt) + across * np.sin(tilt)
        return place

    (a, _, b), (c, _, d) = -trunnion, bracket - trunnion
    expected = load.weight * ahead(a, b) / ahead(c, d)
    pulls = [upended.column("rope_tension", f"sling.{name}") for name in "CD"]
    carried = UPRIGHT * np.sum(pulls, axis=0)
    begin, end = _during(upended, "upend", "upend")
    # What rings as the hoist starts has gone after 20 s; near the end the column sways a little.
    steady = (upended.time > begin + 20.0) & (upended.time < end)
    off = np.abs(carried - expected) / load.weight
    assert np.median(off[steady]) < 1e-4
    assert off[steady & (tilt < math.radians(60.0))].max() < 1e-3
    assert off[steady].max() < 4e-3
    # From half of the weight to an eighth of it.
    assert carried[steady][0] / load.weight == pytest.approx(a / c, rel=5e-3)


def test_the_tail_crane_goes_with_its_lugs(upended: Recording) -> None:
    """It comes nearer by c - (c cos t + d sin t), its brackets c = 30 m and d = 2.7 m from the trunnions."""
    begin, end = _during(upended, "upend", "follow last")
    going = (upended.time > begin) & (upended.time < end)
    tilt = upended.column("load_tilt", "column")[going]
    way = upended.column("joint_position", "tail/along")[going]
    expected = 30.0 - (30.0 * np.cos(tilt) + 2.7 * np.sin(tilt))
    # Falls of 31 m that lean by 0.25 deg reach 0.14 m aside, at both ends.
    assert np.abs(way - way[0] - (expected - expected[0])).max() < 0.2
    for hook in ("main.H", "tail.H"):
        assert upended.column("falls_out_of_plumb", hook)[going].max() < math.radians(0.5)


#: Slings A and B lean by 2.6 m over their 14 m.
LEANING = math.sqrt(1.0 - (2.6 / 14.0) ** 2)


def test_it_hangs_upright_from_the_main_crane_alone(upended: Recording) -> None:
    """The centre of gravity is as far across as the trunnions are: upright but for what rigging weighs."""
    (load,) = upended.rig.loads
    begin, end = _during(upended, "tail off", "hold point 4")
    at = int(np.searchsorted(upended.time, end)) - 1
    hanging = {name: upended.column("rope_tension", f"sling.{name}")[at] for name in "ABCD"}
    assert hanging["C"] == hanging["D"] == 0.0
    assert LEANING * (hanging["A"] + hanging["B"]) == pytest.approx(load.weight, rel=1e-3)
    later = upended.time > begin
    assert np.abs(np.degrees(upended.column("load_tilt", "column")[later]) - 90.0).max() < 0.5


def test_it_is_set_on_its_foundation_by_its_foot(upended: Recording) -> None:
    """All but 5 % of the weight, or less as the hoist brakes, is on four packs of shims under its end."""
    (load,) = upended.rig.loads
    names = [f"support.foundation.{x}.{y}" for x in (1, 2) for y in (1, 2)]
    forces = np.array([upended.column("contact_force", name)[-1] for name in names])
    pulls = sum(upended.column("rope_tension", f"sling.{name}")[-1] for name in "AB")
    assert forces.sum() + LEANING * pulls == pytest.approx(load.weight, rel=1e-4)
    assert 0.95 * load.weight < forces.sum() < 0.97 * load.weight
    # N = ΣN/4 (1 + x/1.2 m + y/1.2 m) of the packs about their middle, x, y where what they carry acts:
    # weight and both slings, 14 m long, pulled unlike by falls that lean by 0.4°. Men pull with 0.1 kN each.
    middle, place = np.array([-15.0, 0.08, 0.9]), upended.column("body_position", "column")[-1]
    moment = np.cross(place - middle, (0.0, 0.0, -load.weight))
    turned = axes(upended.column("body_orientation", "column")[-1:])[0]
    for name, across in (("A", 2.6), ("B", -2.6)):
        tension = upended.column("rope_tension", f"sling.{name}")[-1]
        towards_hook = turned @ (-14.0 * LEANING, -across, 0.0) / 14.0
        moment += np.cross(place + turned @ load.lugs[name].at - middle, tension * towards_hook)
    corners = np.array([(x, y) for x in (-1, 1) for y in (-1, 1)])
    assert forces == pytest.approx(forces.mean() + corners @ (moment[1], -moment[0]) / 4.8, rel=5e-3)
    assert math.degrees(upended.column("load_tilt", "column")[-1]) == pytest.approx(90.0, abs=0.05)


def test_a_hook_that_has_let_go_uses_none_of_its_chart(upended: Recording) -> None:
    """At the end of the lift it was 4.9 %, and nothing at the hold point before, with the same slings."""
    points = {point.step.step: point.at for point in hold_points(upended)}
    for step in ("tail off", "hold point 4"):
        used = {one.name: one.used for one in hook_readings(upended, points[step])}
        assert used["tail.H"] is None and used["main.H"] is not None, step


def test_nothing_of_it_fails(upended: Recording) -> None:
    """Checks against the limits of its lift file."""
    assert not has_failed(check_recording(upended))


def test_stages_show_it_on_the_way(upended: Recording) -> None:
    """At a third and two thirds of a right angle."""
    assert [name for name, *_ in stages(upended)] == [
        "start",
        "lift-off",
        "tilted by 30 deg",
        "tilted by 60 deg",
        "end of 'down'",
        "end of 'set'",
    ]
