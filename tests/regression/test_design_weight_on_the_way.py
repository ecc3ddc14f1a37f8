"""The design weight against a rating chart at the largest radius that the load passes.

What a rule asks, the static load with contingency and dynamic amplification factor, was held against the
chart where the load hung still alone. A crawler crane took 100 t up at 14 m, held it, luffed out to 20 m and
came back: there the simulated weight was looked at, 64 % with the hook block, and not that of the rule, 73 %.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.results.recording import Recording
from of_recording import check_of

LIFT = """
format: 1
lift: {title: Out and back}
duration: 400 s
ground: {level: 0 m, friction: 0.5}
ropes:
  sling: {axial_stiffness: 300 MN, damping_time: 20 ms, mass: none}
  hoist: {axial_stiffness: 36 MN, damping_time: 20 ms, mass: none, diameter: 28 mm}
hook_types:
  H:
    rated_capacity: 400 t
    block: {mass: 7 t, height: 2 m}
    reeving: {parts_each: 14, rope: hoist, sheave_diameter: 0.7 m, below_head: 1 m, sheave_block_mass: 1 kg}
    drum: {diameter: 0.8 m}
    hoist: {speed: 6 m/min, acceleration: 0.02 m/s^2}
cranes:
  c1:
    type: crawler
    position: [0 m, 0 m]
    rating_includes_hook_block: true
    tracks: {length: 9 m, width: 1.5 m, gauge: 8.4 m, stiffness: 2000 MN/m}
    base_mass: 190 t
    central_ballast: 95 t
    counterweight: {mass: 250 t, behind: 6.5 m}
    boom: {heel_pins: {ahead: 1.6 m, height: 2.5 m}, length: 63 m, radius: 14 m, mass: 60 t}
    luffing: {speed: 3 deg/min, acceleration: 0.005 deg/s^2, range: [30 deg, 82 deg]}
    rating: {radius: [12 m, 14 m, 16 m, 18 m, 20 m, 24 m], rated: [360 t, 283 t, 231 t, 195 t, 168 t, 130 t]}
    hooks: {H: {type: H, height: 15.9 m}}
load:
  name: module
  shape: {box: [6 m, 6 m, 4 m]}
  position: [14 m, 0 m, 0 m]
  weight: {calculated: 100 t, contingency: 1.05}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  stands_on: ground
  lugs:
    A: {at: [2 m, 2 m, 4 m]}
    B: {at: [2 m, -2 m, 4 m]}
    C: {at: [-2 m, -2 m, 4 m]}
    D: {at: [-2 m, 2 m, 4 m]}
sling_defaults: {rope: sling, length: 12.3 m}
slings:
  A: {from: c1.H, to: module.A}
  B: {from: c1.H, to: module.B}
  C: {from: c1.H, to: module.C}
  D: {from: c1.H, to: module.D}
plan:
  - {step: lift off, hoist: c1.H, speed: 1 m/min, until: {supports: clear}}
  - {step: clear, hoist: c1.H, speed: 4 m/min, by: 4 m}
  - {step: hold, hold: 40 s}
  - {step: out, luff: c1, speed: 3 deg/min, by: -5.6 deg}
  - {step: in, luff: c1, speed: 3 deg/min, by: 5.6 deg}
  - {step: hold again, hold: until_end}
rules: {dynamic_amplification_factor: 1.1}
simulation: {sample_interval: 0.1 s}
"""


@pytest.fixture(scope="module")
def run() -> Recording:
    return gantline.simulate(gantline.parse_scenario(LIFT))


def test_the_rule_counts_at_the_largest_radius(run: Recording) -> None:
    """(100 t x 1.05 x 1.1 + 7 t) g over what the chart allows farthest out."""
    check = check_of(run, "hoist_load_of_rating")
    radius = run.column("crane_radius", "c1.H")
    farthest = float(radius.max())
    assert 19.0 < farthest < 20.5
    chart = run.rig.rating_charts[0]
    rated = float(chart.rated_at(radius).min())
    assert check.value == pytest.approx((100e3 * 1.05 * 1.1 + 7e3) * 9.81 / rated, rel=1e-3)
    assert check.formula.endswith(f"kN at {farthest:.2f} m")
    # At the hold points, at 14 m, it is less than what the simulated weight uses on the way.
    assert check.value is not None
    assert check.value > float((run.column("hoist_load", "c1.H") / chart.rated_at(radius)).max())
