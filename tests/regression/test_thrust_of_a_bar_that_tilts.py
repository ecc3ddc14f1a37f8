"""The thrust in a bar that tilts was that of its one half alone, 0 kN of a lift and 6.1 kN of its mirror.

Pulls were added up from the end that comes first along the bar. Those from the other end differ by what the
bar weighs along itself, and where the first half is the high one nothing was left: the limit held.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.results.loads.spreaders import thrust

BAR = 20e3  # kg
G = 9.81


def lift(*, left: float, right: float) -> gantline.Scenario:
    """40 t on two slings below a bar between two hooks at these heights [m], 10 m apart."""
    hoist = "rated_capacity: 100 t, hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}"
    return gantline.parse_scenario(f"""\
format: 1
lift: {{title: A bar between hooks of two heights}}
duration: 20 s
ground: {{level: 0 m}}
ropes:
  sling: {{axial_stiffness: 300 MN, damping_time: 50 ms, mass: none, diameter: 56 mm}}
load:
  name: m
  shape: {{box: [10 m, 2 m, 2 m]}}
  position: [0 m, 0 m, 3 m]
  weight: {{calculated: 40 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{A: {{at: [-5 m, 0 m, 2 m]}}, B: {{at: [5 m, 0 m, 2 m]}}}}
spreaders:
  bar:
    mass: 20 t
    size: [10.4 m, 0.6 m, 0.4 m]
    lugs:
      T1: {{at: [-5 m, 0 m, 0 m]}}
      T2: {{at: [5 m, 0 m, 0 m]}}
      B1: {{at: [-5 m, 0 m, 0 m]}}
      B2: {{at: [5 m, 0 m, 0 m]}}
cranes:
  h1: {{type: fixed_hook, at: [-5 m, 0 m, {left} m], {hoist}}}
  h2: {{type: fixed_hook, at: [5 m, 0 m, {right} m], {hoist}}}
slings:
  U1: {{from: h1, to: bar.T1, length: 5 m, rope: sling}}
  U2: {{from: h2, to: bar.T2, length: 5 m, rope: sling}}
  D1: {{from: bar.B1, to: m.A, length: 9 m, rope: sling}}
  D2: {{from: bar.B2, to: m.B, length: 9 m, rope: sling}}
plan:
  - {{step: end, hold: until_end}}
""")


def test_a_bar_and_its_mirror_image() -> None:
    """Half of the bar's weight pushes its low half together, B/2 sin θ, and slings nearly plumb little more.

    Upper ones hold 30 t each and are within 0.2° of plumb, 1 kN along the bar: so much may be the difference.
    """
    found = []
    for heights in ((18.9, 18.2), (18.2, 18.9)):
        rest = gantline.Statics(lift(left=heights[0], right=heights[1])).equilibrium().recording
        found.append(float(thrust(rest, rest.rig.spreaders[0])[-1]))
    assert found[0] == pytest.approx(found[1], rel=1e-6)
    tilt = math.asin(0.7 / 10.0)
    assert found[0] == pytest.approx(BAR * G / 2 * math.sin(tilt), abs=1e3)
