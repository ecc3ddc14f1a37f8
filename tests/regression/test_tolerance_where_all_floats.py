"""The default tolerance of tensions where water bears everything went by the weight of vessels.

A barge between a quay and an outer barge had an error of 905 N allowed in each step, beside lines of 40 kN;
one of them ended 3 % off, without a word. Lines that hold what floats pull with about a hundredth of its
weight. Those of this lift were wrong by 0.5 % with a hundred times their default, and are by 0.01 %.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.scenario import parse_scenario

HULL = """\
    draft: 3 m
    hull: {box: [60 m, 20 m, 5 m]}
    masses: {all: {mass: 3690 t, at: [30 m, 0 m, 3 m]}}
    radii_of_gyration: [7 m, 17 m, 17 m]
"""
LINE = "rope: nylon, type: spring, pretension: 40 kN"
FENDER = "facing: 90 deg, thickness: 1 m, stiffness: 2 MN/m, damping: 0.2 MN s/m"
BARGES = f"""\
format: 1
lift: {{title: A barge between a quay and another}}
duration: 60 s
start: as_given
water: {{density: 1025 kg/m^3, level: 0 m}}
wind: {{speed: 20 m/s, direction: 90 deg}}
ropes: {{nylon: {{axial_stiffness: 4 MN, damping_time: 0.1 s, mass: none}}}}
vessels:
  inner:
{HULL}  outer:
    position: [0 m, 21 m]
{HULL}    wind_areas: {{side: {{area: 300 m^2, coefficient: 1.2, along: y, at: [35 m, 0 m, 5 m]}}}}
mooring_lines:
  fore: {{vessel: inner, fairlead: [58 m, -9 m, 4 m], to: [70 m, -16 m, 3 m], {LINE}}}
  aft: {{vessel: inner, fairlead: [2 m, -9 m, 4 m], to: [-10 m, -16 m, 3 m], {LINE}}}
  out.fore: {{vessel: outer, fairlead: [58 m, -9 m, 4 m], to: [45 m, 9 m, 4 m], held_by: inner, {LINE}}}
  out.aft: {{vessel: outer, fairlead: [2 m, -9 m, 4 m], to: [15 m, 9 m, 4 m], held_by: inner, {LINE}}}
fenders:
  quay.1: {{vessel: inner, at: [45 m, -10 m, 3 m], wall: [0 m, -11 m], {FENDER}}}
  quay.2: {{vessel: inner, at: [15 m, -10 m, 3 m], wall: [0 m, -11 m], {FENDER}}}
  side.1: {{vessel: outer, at: [45 m, -10 m, 3 m], wall: [0 m, 10 m], wall_of: inner, {FENDER}}}
  side.2: {{vessel: outer, at: [15 m, -10 m, 3 m], wall: [0 m, 10 m], wall_of: inner, {FENDER}}}
plan: [{{step: end, hold: until_end}}]
"""


def test_lines_of_barges_are_right_by_default() -> None:
    """A ten-thousandth of a hundredth of 7380 t over four ropes; tensions as with less of it to 0.1 %."""
    lift = parse_scenario(BARGES)
    recording = gantline.simulate(lift)
    tolerance = recording.attributes["settings"]["integrator"]["tension_tolerance"]
    assert tolerance == pytest.approx(1e-4 * 1e-2 * 7380e3 * 9.80665 / 4, rel=1e-3)
    fine = gantline.simulate(lift, tension_tolerance=tolerance / 100)
    for line in ("fore", "aft", "out.fore", "out.aft"):
        found, exact = (one.column("mooring_tension", line) for one in (recording, fine))
        assert np.abs(found - exact).max() < 1e-3 * exact.max()
