"""A drum that hauled in on after its rope had been cut used up what was left of it.

The unstretched length of the piece between the ends went on to shrink with every turn of the drum. When
nothing was left of it the run stopped ("there is no rope left between two of the places that it passes") and
equilibria had NaN for its tension, though nothing hung on the rope any more. What is left lies where it fell,
and the drum turns empty.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.scenario import parse_scenario
from gantline.statics import Statics

LIFT = """
format: 1
lift: {title: A weight on a drum and a stay}
duration: 30 s
start: as_given
ropes:
  stay: {axial_stiffness: 1 MN, damping_time: 0.1 s, mass: none}
mechanics:
  bodies:
    weight: {joint: {type: slider, axis: [0, 0, 1]}, mass: 1 t, at: [0 m, 0 m, 0 m]}
  drums:
    drum:
      diameter: 0.5 m
      rotating_mass: 100 kg
      drive: {speed: 0.6 m/s, acceleration: 1 m/s^2, capacity: 50 kN}
  ropes:
    stay:
      rope: stay
      length: as_routed
      route: [{type: end, body: weight}, {type: end, body: world, at: [0 m, 0 m, 5 m]}]
    hauled:
      rope: stay
      length: 5 m
      cut_at: 2 s
      route: [{type: end, body: weight}, {type: end, body: world, at: [0 m, 0 m, 5 m], drum: drum}]
plan:
  - {step: wait, hold: 3 s}
  - {step: haul in, haul_in: drum, speed: 0.5 m/s, by: 12 m}
"""


def test_run_goes_on() -> None:
    """12 m are hauled in where 5 m were left; the stay bears the weight."""
    run = gantline.simulate(parse_scenario(LIFT))
    assert run.attributes["status"] == "done"
    assert run.column("rope_paid_out", "drum")[-1] == pytest.approx(-12.0, abs=1e-9)
    after = run.time > 2.0
    assert np.all(run.column("rope_tension", "hauled")[after] == 0.0)
    assert run.column("rope_tension", "stay")[-1] == pytest.approx(1000.0 * 9.81, rel=1e-6)


def test_equilibrium_has_a_tension() -> None:
    """At rest at the end too."""
    rest = Statics(parse_scenario(LIFT)).equilibrium(30.0)
    assert rest.tension("hauled") == 0.0
    assert rest.tension("stay") == pytest.approx(1000.0 * 9.81, rel=1e-9)
