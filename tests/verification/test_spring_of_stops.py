"""A spring of a joint, of two stops with next to nothing between them."""

from __future__ import annotations

import numpy as np

import gantline
from gantline.scenario import parse_scenario

OMEGA, GAP, SPEED = 10.0, 1e-6, 1.0
LIFT = """\
format: 1
lift: {title: a mass between two stops}
duration: 2 s
simulation: {gravity: 0 m/s^2, tension_tolerance: 0.01 N, position_tolerance: 0.001 mm}
mechanics:
  bodies:
    mass:
      joint: {type: slider, axis: [1, 0, 0], velocity: 1 m/s,
              stops: {lower: -0.001 mm, upper: 0.001 mm, stiffness: 1 kN/m}}
      mass: 10 kg
"""


def test_two_stops_are_a_spring() -> None:
    """x = v/omega sin(omega t) with omega^2 = k/m, but for the gap d on either side of every zero.

    It adds itself to the swing and 2 d/v to each of its n half periods, in which the mass goes by 2 d n.
    """
    recording = gantline.simulate(parse_scenario(LIFT))
    time = recording.time
    swing = SPEED / OMEGA * np.sin(OMEGA * time)
    halves = 2.0 * OMEGA / np.pi
    error = np.abs(recording.column("joint_position", "mass") - swing).max()
    assert error < GAP * (1.0 + 2.0 * halves)
