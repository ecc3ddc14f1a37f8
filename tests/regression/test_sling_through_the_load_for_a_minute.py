"""Slings that went through their load for a minute of two hours: GO, for what a short run told.

A box hangs by its ends from two hooks. One comes down by 3 m and goes up again, and its sling, upright as
before, then leads through the end of the box that leans over it. Slings and their own load were looked at
sixty times, evenly apart in time while the sling carries: two minutes apart in a run of two hours. So it hung
on how long the file let the load hang afterwards whether anything was told.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import Verdict
from gantline.results.loads.through import slings_over_edges
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import checks_of

#: From the middle to the ends of the box and to its lugs, and how far one hook goes down [m].
HALF, LUG, DOWN = 6.0, 6.05, 3.0
LIFT = """
format: 1
lift: {{title: one end down and up again}}
duration: {duration} s
ropes: {{sling: {{axial_stiffness: 100 MN, mass: none, damping_time: 0.1 s}}}}
load:
  name: box
  shape: {{box: [12 m, 2 m, 4 m]}}
  position: [0 m, 0 m, 10 m]
  weight: {{calculated: 40 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  lugs:
    A: {{at: [-6.05 m, 0 m, {height} m]}}
    B: {{at: [6.05 m, 0 m, {height} m]}}
cranes:
  a: {{type: fixed_hook, at: [-6.05 m, 0 m, {hook} m], hoist: {{speed: 9 m/min, acceleration: 0.05 m/s^2}}}}
  b: {{type: fixed_hook, at: [6.05 m, 0 m, {hook} m], hoist: {{speed: 9 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: sling, length: 20 m}}
slings:
  A: {{from: a, to: box.A}}
  B: {{from: b, to: box.B}}
plan:
  - {{step: wait, hold: 20 s}}
  - {{step: down, lower: a, speed: 9 m/min, by: 3 m}}
  - {{step: up, hoist: a, speed: 9 m/min, by: 3 m}}
  - {{step: hang, hold: until_end}}
"""


def run(duration: float, below: float) -> Recording:
    """The lift with its lugs so far below the top of the box [m]."""
    height = 4.0 - below
    return simulate(parse_scenario(LIFT.format(duration=duration, height=height, hook=10.0 + height + 20.0)))


@pytest.mark.parametrize("duration", [80.0, 7200.0], ids=str)
def test_through_the_load(duration: float) -> None:
    (check,) = checks_of(run(duration, 2.0), "sling_outside_load")
    assert (check.verdict, check.element) == (Verdict.WARNING, "A")


@pytest.mark.parametrize("duration", [80.0, 7200.0], ids=str)
def test_over_its_edge(duration: float) -> None:
    """As deep as it gets: where it is as far from the end of the box as from its top.

    With a = 6.05 m from the middle to lugs and hooks, sin φ = 3 m/2a. The lugs are 2a cos φ apart in plan, so
    both slings, 20 m long, lead outwards by δ, sin δ = a (1 − cos φ)/20 m, and the one of the lower end into
    the box by φ − δ in its axes: s of the way to the top, h over its lug, i s − 0.05 m in from its end with
    i = h tan(φ − δ), and h (1 − s) below its top.
    """
    below = 0.9
    recording = run(duration, below)
    (found,) = slings_over_edges(recording)
    leans = math.asin(DOWN / (2.0 * LUG))
    into = leans - math.asin(LUG * (1.0 - math.cos(leans)) / 20.0)
    inwards = below * math.tan(into)
    deep = below * (1.0 - (below + LUG - HALF) / (below + inwards))
    assert deep == pytest.approx(0.137, abs=1e-3)
    # Twenty places along 0.93 m are 49 mm apart; within half of that it gets less deep by tan(φ − δ) of it.
    assert found.deep == pytest.approx(deep, abs=0.0245 * math.tan(into))
    assert found.at == pytest.approx(below / math.cos(into), abs=2e-3)
    (check,) = checks_of(recording, "sling_over_edge")
    assert check.verdict is Verdict.WARNING
