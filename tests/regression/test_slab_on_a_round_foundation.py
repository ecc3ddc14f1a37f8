"""A slab of `mechanics` that came to stand on a round foundation by `body_contacts`.

A pair of shapes had eight places at which it touched, sixteen where the load was from CAD or round. The
top of a foundation has sixteen corners that count: the slab stood on eight of them, and others took over
whenever it leaned. One let go of leaning by 0.1 rad still rocked after eight seconds, with 0.73 of its
weight on the foundation. Now a pair has as many places as both faces have corners.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import gantline
from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from mechanics import G

MASS, STIFFNESS, TOP, RADIUS, HALF = 50e3, 100e6, 4.0, 3.0, 1.0
LIFT = """\
format: 1
lift: {{title: A slab on a round foundation}}
duration: 6 s
start: as_given
structures:
  foundation: {{type: cylinder, at: [0 m, 0 m], diameter: 6 m, z: [0 m, 4 m]}}
  plinth: {{type: box, x: [20 m, 28 m], y: [-4 m, 4 m], z: [0 m, 4 m]}}
mechanics:
  bodies:
    slab:
      at: [0 m, 0 m, {height} m]
      joint: {{type: free, orientation: {{about: [1, 0.37, 0], angle: {lean} rad}}}}
      mass: 50 t
      inertia: {{xx: 100 t m^2, yy: 100 t m^2, zz: 150 t m^2}}
      shape: {{box: [8 m, 8 m, 2 m]}}
  body_contacts:
    on: {{between: [slab, foundation], stiffness: 100 MN/m, damping: 200 kN s/m, friction: 0.4}}
    beside: {{between: [slab, plinth], stiffness: 100 MN/m, damping: 200 kN s/m, friction: 0.4}}
plan: [{{step: hold, hold: until_end}}]
simulation: {{sample_interval: 50 ms}}
"""


def test_a_slab_stands_on_all_corners_of_a_round_top() -> None:
    """Put down level, sixteen springs share its weight: it sinks by W/16 k, 0.3 mm."""
    recording = gantline.simulate(parse_scenario(LIFT.format(height=TOP + HALF, lean=0.0)), duration=1.0)
    forces = recording["contact_force"].values[-1]
    assert np.sort(forces)[-16:] == pytest.approx(np.full(16, MASS * G / 16), rel=1e-3)
    sunk = TOP + HALF - recording["body_position"].values[-1, 0, 2]
    assert sunk == pytest.approx(MASS * G / (16 * STIFFNESS), rel=1e-3)


def test_a_slab_that_leans_comes_to_rest() -> None:
    """Let go of leaning by 0.1 rad it rocks, and stands still after six seconds with its weight below it.

    Corners on which it leaned last, of those that a level top does not keep, bear on beside the sixteen.
    """
    lean = 0.1
    height = TOP + HALF * math.cos(lean) + RADIUS * math.sin(lean)
    recording = gantline.simulate(parse_scenario(LIFT.format(height=height, lean=lean)))
    forces = recording["contact_force"].values[-1]
    assert forces.sum() == pytest.approx(MASS * G, rel=1e-6)
    assert 16 <= int((forces > 0.0).sum()) <= 20
    assert np.ptp(recording["body_position"].values[-20:, 0], axis=0).max() < 1e-6


def test_places_are_the_corners_of_both_faces() -> None:
    """Where two convex faces meet has no more corners than both: 4 of a box, 16 that count of another."""
    document = assemble(parse_scenario(LIFT.format(height=5.0, lean=0.0))).document
    assert {pair["name"]: pair["places"] for pair in document["pairs"]} == {"on": 4 + 16, "beside": 4 + 4}
