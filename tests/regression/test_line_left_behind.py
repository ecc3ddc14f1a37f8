"""A line of constant pull whose tugger does not follow its load.

A load that comes nearer faster than a tugger hauls in leaves its line slack, and turns as it likes. The line
was reported with its largest pull, and no check said a word on it.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.checks import Verdict
from gantline.checks.check import Check
from gantline.results import series
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from mechanics import G
from of_recording import checks_of, step_end

PULL, EA = 1500.0, 150e3
#: Where the line is made fast, from below the hook, and where the tugger stands [m].
AT, TO = (-5.5, -2.0, 12.0), (-5.5, -20.0, 0.0)
LIFT = f"""
format: 1
lift: {{title: A load comes down towards a tugger}}
duration: 60 s
ropes:
  steel: {{axial_stiffness: 600 MN, damping_time: 20 ms, mass: none}}
  tag: {{axial_stiffness: {EA} N, damping_time: 0.2 s, mass: none}}
load:
  name: module
  shape: {{box: [11 m, 4 m, 3.5 m]}}
  position: [0 m, 0 m, 12 m]
  weight: {{calculated: 45 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  lugs:
    NW: {{at: [-4.5 m,  1.5 m, 3.5 m]}}
    SW: {{at: [-4.5 m, -1.5 m, 3.5 m]}}
    NE: {{at: [ 4.5 m,  1.5 m, 3.5 m]}}
    SE: {{at: [ 4.5 m, -1.5 m, 3.5 m]}}
cranes:
  crane: {{type: fixed_hook, at: [0 m, 0 m, 26 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: steel, length: 11.6 m}}
slings:
  NW: {{from: crane, to: module.NW}}
  SW: {{from: crane, to: module.SW}}
  NE: {{from: crane, to: module.NE}}
  SE: {{from: crane, to: module.SE}}
tag_lines:
  west: {{at: [-5.5 m, -2 m, 0 m], to: [-5.5 m, -20 m, 0 m], rope: tag, pull: {PULL} N, speed: SPEED}}
plan:
  - {{step: look, hold: 5 s}}
  - {{step: down, lower: crane, speed: 6 m/min, by: 4 m}}
  - {{step: end, hold: until_end}}
"""


def run(speed: str, cut: str = "") -> Recording:
    lift = LIFT.replace("SPEED", speed).replace("step: down,", f"step: down, {cut}")
    return Simulation(parse_scenario(lift)).run()


def told(recording: Recording) -> list[Check]:
    return checks_of(recording, "tag_lines_pull")


def chord(down: float) -> float:
    return math.hypot(TO[1] - AT[1], AT[2] - down)


def test_a_tugger_that_is_too_slow_is_told() -> None:
    """4 m down make the way 1.94 m shorter; 0.3 m is hauled in 60 s at 0.3 m/min, 0.21 m is stretch."""
    stretch = chord(0.0) * PULL / (EA + PULL)
    assert chord(0.0) - chord(4.0) > stretch + 0.005 * 60.0
    recording = run("0.3 m/min")
    (check,) = told(recording)
    assert check.verdict is Verdict.WARNING and check.element == "west"
    tension = recording.column("rope_tension", "tag.west")
    assert tension[0] == pytest.approx(PULL, rel=1e-6) and tension[-1] == 0.0
    assert check.time == pytest.approx(recording.time[int(np.argmax(tension < PULL / 2))])
    assert check.remark.startswith(
        f"for {recording.time[-1] - check.time:.3g} s it pulls less than half of 1.50 kN"
    )
    assert "is slack at times: its tugger hauls in at 0.3 m/min at most" in check.remark


def test_a_load_whose_line_is_slack_hangs_still() -> None:
    """Static is what hangs once the hoist stands, m g: the tugger hauls at its speed, and does no work.

    As if its motor still worked the load never hung still, and static was the mean of the whole lift.
    """
    recording = run("0.3 m/min")
    window = recording.time[series.quiet_window(recording)]
    end = step_end(recording, "down")
    # To a sample, of 0.02 s.
    assert window[0] == pytest.approx(end, abs=0.021) and window[-1] == recording.time[-1]
    assert recording.metrics()["static_hook_load"] == pytest.approx(45e3 * G, rel=1e-5)


def test_one_that_follows_is_not() -> None:
    """30 m/min are five times the speed of the hoist."""
    recording = run("30 m/min")
    assert not told(recording)
    assert recording.column("rope_tension", "tag.west").min() > PULL / 2


def test_one_that_a_step_lets_go_of_is_not() -> None:
    """It hangs from nothing from then on, as the plan has it."""
    assert not told(run("0.3 m/min", "cut: tag.west, "))
