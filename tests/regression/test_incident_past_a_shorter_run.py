"""A sling that is to be cut at 30 s: with `--duration 20 s` the lift was GO, and nothing was said of the cut.

So it was with a cut at the very end of a lift, after which nothing comes; a state at rest has it. Supports
that are removed and emergency stops past the end were passed over still when cuts were told already.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.scenario import parse_scenario

ON_TIMBER = LIFT.replace("stands_on: ground", "stands_on: timber\n  position: [0 m, 0 m, 0.1 m]")
TIMBER = "timber: {under: module, grid: {x: [-1 m, 1 m], y: [-1 m, 1 m]}, height: 0.1 m, removed_at: 30 s}"
SOFT = LIFT.replace("acceleration: 0.05 m/s^2", "acceleration: 0.05 m/s^2, emergency_acceleration: 1 m/s^2")


@pytest.mark.parametrize(
    ("duration", "is_told"),
    [(20.0, True), (30.0, True), (31.0, False)],
    ids=["before", "at the end", "after"],
)
def test_a_cut_that_a_run_does_not_reach_is_told(duration: float, is_told: bool) -> None:
    lift = parse_scenario(LIFT.replace("A: {from: crane,", "A: {cut_at: 30 s, from: crane,"))
    said = [one for one in gantline.simulate(lift, duration=duration).attributes["warnings"] if "cut" in one]
    late = f"the run ends at {duration:g} s, and what is cut then or later is not seen: sling.A at 30 s"
    assert said == [late] * is_told


@pytest.mark.parametrize(
    ("lift", "done", "name"),
    [
        (SOFT + "emergency_stop: {at: 30 s}\n", "stopped", "emergency stop"),
        (ON_TIMBER + f"supports:\n  {TIMBER}\n", "removed", "timber"),
    ],
    ids=["emergency stop", "support"],
)
@pytest.mark.parametrize(("duration", "is_told"), [(20.0, True), (31.0, False)], ids=["before", "after"])
def test_a_stop_or_a_removal_that_a_run_does_not_reach_is_told(
    lift: str, done: str, name: str, duration: float, is_told: bool
) -> None:
    recording = gantline.simulate(parse_scenario(lift), duration=duration)
    late = f"the run ends at {duration:g} s, and what is {done} then or later is not seen: {name} at 30 s"
    assert [one for one in recording.attributes["warnings"] if done in one] == [late] * is_told
