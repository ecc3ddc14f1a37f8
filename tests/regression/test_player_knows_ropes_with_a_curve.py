"""The player did not know how long a rope of `mechanics` with a curve is by itself.

It took the one stiffness that has the energy of the curve, by which a rope of 10 m seemed to be 10 m to
10.07 m long as its load went up and down, so that it was taken for one that runs onto a drum and drawn
straight while slack.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.scenario import parse_scenario
from gantline.viewer.turning import natural_lengths

LIFT = """\
format: 1
lift: {title: A mass on a rope with a curve}
duration: 4 s
ropes:
  soft: {curve: {strain: [1 %, 2 %, 3 %], tension: [90 kN, 250 kN, 480 kN]}, mass: none, damping_time: 1 ms}
mechanics:
  bodies:
    m: {joint: {type: slider, axis: [0, 0, 1]}, mass: 10 t}
  ropes:
    r:
      rope: soft
      length: 10 m
      route: [{type: end, body: world, at: [0 m, 0 m, 10 m]}, {type: end, body: m}]
plan:
  - {step: bounce, hold: until_end}
simulation: {sample_interval: 50 ms, tension_tolerance: 10 N, position_tolerance: 0.001 mm}
"""


def test_the_length_by_itself_follows_from_the_curve() -> None:
    """10 m, at whatever tension it is seen."""
    recording = gantline.simulate(parse_scenario(LIFT))
    tension = recording.column("rope_tension", "r")
    # Dropped from where it is taut it goes twice as deep as it rests, at 98 kN, past the first point.
    assert tension.max() > 150e3
    found = natural_lengths(recording, list(range(len(recording.time))))
    assert found == [pytest.approx(10.0, abs=1e-3)]
