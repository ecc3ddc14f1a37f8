"""Curves of tension over strain: what they give, and lifts that begin on slings of one."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gantline import Simulation
from gantline.scenario import parse_scenario
from gantline.scenario.curve import RopeCurve

CURVE = RopeCurve.model_construct(strain=(0.01, 0.02, 0.03), tension=(1e5, 3e5, 7e5))


@pytest.mark.parametrize(
    ("strain", "tension", "slope", "energy"),
    [
        (0.0, 0.0, 1e7, 0.0),
        (0.005, 0.5e5, 1e7, 125.0),
        (0.015, 2e5, 2e7, 500.0 + 750.0),
        (0.025, 5e5, 4e7, 500.0 + 2000.0 + 2000.0),
        (0.04, 1.1e6, 4e7, 500.0 + 2000.0 + 5000.0 + 9000.0),  # beyond the last point, along its line
    ],
)
def test_tension_slope_and_energy_by_hand(strain: float, tension: float, slope: float, energy: float) -> None:
    assert CURVE.pull(strain) == pytest.approx((tension, slope, energy), rel=1e-12)
    assert CURVE.strain_under(tension) == pytest.approx(strain, rel=1e-12)


def test_the_stiffness_that_stands_for_it_has_its_energy() -> None:
    """T²/2EA = u at the last point: (7e5)²/2/7500."""
    assert CURVE.axial_stiffness == pytest.approx(7e5**2 / 2 / 7500, rel=1e-12)


@given(st.floats(0.0, 0.05), st.floats(0.0, 0.05))
def test_tension_rises_and_is_the_slope_of_the_energy(one: float, other: float) -> None:
    low, high = sorted((one, other))
    (pulled, _, stored), (more, _, in_all) = CURVE.pull(low), CURVE.pull(high)
    assert pulled <= more
    assert pulled * (high - low) - 1e-6 <= in_all - stored <= more * (high - low) + 1e-6


SPREADER = """\
format: 1
lift: {title: A spreader on slings of fibre}
duration: 2 s
start: as_given
ropes:
  fibre: {curve: {strain: [1 %, 2 %, 4 %], tension: [4 kN, 12 kN, 60 kN]}, mass: none}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 20 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
ground: {level: 0 m}
load:
  name: box
  shape: {box: [8 m, 3 m, 2 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 2 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  stands_on: ground
  lugs:
    A: {at: [-3 m, 0 m, 2 m]}
    B: {at: [3 m, 0 m, 2 m]}
spreaders:
  bar:
    mass: 1 t
    size: [6.4 m, 0.4 m, 0.4 m]
    lugs:
      top.A: {at: [-3 m, 0 m, 0.2 m]}
      top.B: {at: [3 m, 0 m, 0.2 m]}
      A: {at: [-3 m, 0 m, -0.2 m]}
      B: {at: [3 m, 0 m, -0.2 m]}
slings:
  u.A: {from: hook, to: bar.top.A, length: 6 m, rope: fibre}
  u.B: {from: hook, to: bar.top.B, length: 6 m, rope: fibre}
  l.A: {from: bar.A, to: box.A, length: 13 m, rope: fibre}
  l.B: {from: bar.B, to: box.B, length: 13 m, rope: fibre}
simulation: {tension_tolerance: 1 N}
"""


def test_a_spreader_begins_at_rest_on_slings_with_a_curve() -> None:
    """Its slings of 6 m bear it at 30 deg: 1 t under each of two, 5.67 kN each, on the second line."""
    recording = Simulation(parse_scenario(SPREADER)).run()
    bar = recording.column("body_position", "bar")
    assert np.abs(bar - bar[0]).max() < 1e-6
    rise = 20.0 - bar[0, 2] - 0.2
    length = float(np.hypot(3.0, rise))
    tension = 0.5 * 1e3 * 9.81 * length / rise
    assert recording.column("rope_tension", "sling.u.A")[-1] == pytest.approx(tension, rel=1e-6)
    # 4 kN at 1 %, from there 8 kN for each further per cent.
    assert length / 6.0 - 1.0 == pytest.approx(0.01 + (tension - 4e3) / 8e5, rel=1e-6)
