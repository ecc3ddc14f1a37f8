"""The same lift in other units, at a quarter of its size, and of twice the weight: nothing in it may know a
unit, a size or a weight.

By Froude's law, gravity and densities as they are, a lift λ times as large goes its way in √λ of the time:

    length λ, time √λ, speed √λ, mass and force λ³, stiffness λ², damping λ^2.5, moment λ⁴, inertia λ⁵, …

so that tensions come to λ³ times, events to √λ times, and shares, angles and factors stay. A constant of the
program that should be a share of something, or a formula with a factor that is not there in one of its terms,
shows at once. Both are also read as checks: what is used of each capacity is the same.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import gantline
from gantline.checks import check_recording
from gantline.results.recording import Recording
from rescaled import POWERS, at_scale, at_weight, in_other_units

#: A module that four slings take off the ground one after another; gear, rules and limits of every kind.
PICKED_UP = """
format: 1
lift: {title: Picked up}
duration: 24 s
ground: {level: 0 m, friction: 0.4, stiffness: 300 MN/m, damping: 3 MN s/m}
ropes:
  s52: {axial_stiffness: 150 MN, damping_time: 15 ms, mass: 11.2 kg/m, minimum_breaking_force: 1890 kN,
    diameter: 52 mm}
shackles:
  top: {working_load_limit: 55 t, mass: 27 kg, bow_diameter: 95 mm,
    minimum_breaking_force: 2700 kN, proof_load: 1000 kN}
  low: {working_load_limit: 35 t, mass: 17 kg, bow_diameter: 84 mm,
    minimum_breaking_force: 1750 kN, proof_load: 690 kN}
load:
  name: module
  shape: {box: [12 m, 6 m, 5 m]}
  position: [1 m, 2 m, 0 m]
  heading: 30 deg
  weight: {calculated: 88 t, contingency: 1.07}
  centre_of_gravity: {at: [0.4 m, -0.25 m, 2.1 m]}
  stands_on: ground
  lugs:
    A: {at: [5 m, 2.5 m, 5 m], main_plate: xz, capacity: 40 t}
    B: {at: [5 m, -2.5 m, 5 m], main_plate: yz, capacity: 40 t}
    C: {at: [-5 m, -2.5 m, 5 m], main_plate: {turned: 27 deg}, capacity: 40 t}
    D: {at: [-5 m, 2.5 m, 5 m], main_plate: {normal: [0.5, 0.5, 0.3]}, capacity: 40 t}
cranes:
  hook:
    type: fixed_hook
    at: [1.3 m, 2 m, 13.8 m]
    rated_capacity: 120 t
    rating_includes_hook_block: true
    hook_block_mass: 4.2 t
    hoist: {speed: 6 m/min, acceleration: 0.15 m/s^2}
sling_defaults: {rope: s52, shackles: {top: top, bottom: low}}
slings:
  A: {from: hook, to: module.A, length: 10.62 m}
  B: {from: hook, to: module.B, length: 10.625 m}
  C: {from: hook, to: module.C, length: 10.62 m}
  D: {from: hook, to: module.D, length: 10.635 m}
plan:
  - {step: hoist, hoist: hook, speed: 5 m/min, by: 1 m}
  - {step: hold, hold: until_end}
rules: {dynamic_amplification_factor: 1.1, skew_load_factor: 1.25, load_factor: 1.3, consequence_factor: 1.3,
  material_factor: 1.5, termination_factor: 1.12, shackle_breaking_factor: 3}
limits: {rule: a yard, load_tilt: 3 deg, static_hook_load: 1200 kN, smallest_sling_tension_when_clear: 10 kN}
simulation: {sample_interval: 0.03125 s, tension_tolerance: 16 N, position_tolerance: 0.03125 mm}
"""

#: A barge that is let go with heel and trim: slack tank, mooring lines on the sea bed, current, and a module
#: that hangs from it in the wind.
AFLOAT = """
format: 1
lift: {title: Let go}
duration: 24 s
start: as_given
water: {density: 1025 kg/m^3, level: 0 m}
current: {speed: 0.8 m/s, direction: 160 deg}
wind: {speed: 14 m/s, direction: 70 deg}
ropes:
  fall: {axial_stiffness: 60 MN, damping_time: 20 ms, mass: none}
  chain: {axial_stiffness: 90 MN, damping_time: 50 ms, mass: 40 kg/m, minimum_breaking_force: 2400 kN}
vessels:
  barge:
    position: [-40 m, 0 m]
    draft: 3 m
    heel: 2 deg
    trim: 0.5 deg
    hull: {box: [80 m, 24 m, 7 m]}
    masses: {own: {mass: 5500 t, at: [39 m, 0.2 m, 4 m]}}
    radii_of_gyration: [8 m, 22 m, 23 m]
    tanks: {bow: {box: [16 m, 10 m, 4 m], bottom: [62 m, 3 m, 0.5 m], content: 320 t}}
    added_mass: {at: [40 m, 0 m, 3 m], surge: 300 t, sway: 1800 t, heave: 5000 t,
      roll: 90000 t m^2, pitch: 2000000 t m^2}
    water_damping: {at: [40 m, 0 m, 3 m], heave: 1.5 MN s/m, roll: 15 MN m s, pitch: 600 MN m s}
    current_areas: {side: {area: 240 m^2, coefficient: 0.8, along: y, at: [42 m, 0 m, 1.5 m]}}
mooring_lines:
  ps: {vessel: barge, fairlead: [78 m, 12 m, 7 m], to: [190 m, 150 m, -25 m], rope: chain,
    pretension: 150 kN, sea_bed: -25 m}
  sb: {vessel: barge, fairlead: [2 m, -12 m, 7 m], to: [-190 m, -150 m, -25 m], rope: chain,
    pretension: 150 kN, sea_bed: -25 m}
mechanics:
  bodies:
    module:
      at: [48 m, 0 m, 6 m]
      joint: {type: free}
      mass: 90 t
      inertia: {xx: 400 t m^2, yy: 700 t m^2, zz: 800 t m^2}
      wind_areas: {side: {area: 60 m^2, coefficient: 1.2, along: y, at: [0.5 m, 0 m, 0.3 m]}}
  ropes:
    fall:
      rope: fall
      length: 20.3 m
      route: [{type: end, body: barge, at: [88 m, 0 m, 31 m]}, {type: end, body: module, at: [0 m, 0 m, 2 m]}]
simulation: {sample_interval: 0.03125 s, tension_tolerance: 16 N, position_tolerance: 0.03125 mm}
"""
#: What of that is recorded is a force.
FORCES = ("rope_tension", "contact_force", "hook_load", "rope_peak_tension")
LIFTS = {"picked up": PICKED_UP, "afloat": AFLOAT}
#: Powers of the scale of what is recorded.
RECORDED = {
    "time": POWERS["time"],
    "rope_tension": POWERS["force"],
    "body_position": POWERS["length"],
    "body_orientation": POWERS["angle"],
    "body_velocity": POWERS["speed"],
    "contact_force": POWERS["force"],
    "hook_load": POWERS["force"],
    "load_tilt": POWERS["angle"],
    "mooring_tension": POWERS["force"],
    "vessel_draft": POWERS["length"],
    "vessel_heel": POWERS["angle"],
    "vessel_freeboard": POWERS["length"],
    "vessel_displacement": POWERS["mass"],
    "rope_peak_tension": POWERS["force"],
    "event_time": POWERS["time"],
}


@pytest.fixture(scope="module")
def runs() -> dict[str, Recording]:
    return {name: gantline.simulate(gantline.parse_scenario(text)) for name, text in LIFTS.items()}


def differences(found: Recording, wanted: Recording, scale: float = 1.0) -> dict[str, float]:
    """Largest difference of each variable, as a share of its largest value."""
    shares = {}
    for name, power in RECORDED.items():
        if name not in wanted or not wanted[name].values.size:
            continue
        values, others = wanted[name].values, found[name].values / scale ** float(power)
        shares[name] = float(np.abs(others - values).max() / np.abs(values).max())
    return shares


@pytest.mark.parametrize("name", LIFTS)
@pytest.mark.parametrize("seed", [1, 2])
def test_units_drawn_by_lot(name: str, seed: int, runs: dict[str, Recording]) -> None:
    """Each quantity in a unit of its dimension by lot. Rounding of one in another unit is 1e-16; what stiff
    ropes, slack and friction make of that in a run is measured as 1e-7.
    """
    other = in_other_units(LIFTS[name], seed)
    assert other != LIFTS[name]
    found = gantline.simulate(gantline.parse_scenario(other))
    assert max(differences(found, runs[name]).values()) < 1e-6
    for was, check in zip(check_recording(runs[name]), check_recording(found), strict=True):
        assert (check.name, check.verdict, check.element) == (was.name, was.verdict, was.element)
        assert (check.value or 0.0) == pytest.approx(was.value or 0.0, rel=1e-6)
        assert (check.limit or 0.0) == pytest.approx(was.limit or 0.0, rel=1e-12)


@pytest.mark.parametrize("name", LIFTS)
def test_a_quarter_of_the_size(name: str, runs: dict[str, Recording]) -> None:
    """λ = 1/4, so that √λ and all other powers are exact in binary, tolerances at scale too: what is left
    comes of bounds of the method that have a size, and is less than its tolerance, 16 N of 0.4 MN or 4e-5.
    Largest tensions of mooring lines are those at the ends of steps, of which there is one less.
    """
    scale = 0.25
    found = gantline.simulate(gantline.parse_scenario(at_scale(LIFTS[name], scale)))
    assert [kind for _, kind, _ in found.events()] == [kind for _, kind, _ in runs[name].events()]
    shares = differences(found, runs[name], scale)
    assert shares.pop("rope_peak_tension") < 1e-3
    assert max(shares.values()) < 4e-5
    for was, check in zip(check_recording(runs[name]), check_recording(found), strict=True):
        assert (check.name, check.verdict) == (was.name, was.verdict)
        if was.value and check.value:
            power = 2 * math.log(check.value / was.value, scale)
            assert power == pytest.approx(round(power), abs=1e-3)


@pytest.mark.parametrize("factor", [2.0, 0.5])
def test_twice_and_half_as_heavy(factor: float, runs: dict[str, Recording]) -> None:
    """Masses, forces, stiffness and damping times μ: M v̇ = f is then μ times itself, so that all goes the
    same way at the same times under μ times the forces. A power of two is exact in binary, and so is each sum
    and product of such numbers: not one digit may differ.
    """
    was = runs["picked up"]
    found = gantline.simulate(gantline.parse_scenario(at_weight(PICKED_UP, factor)))
    assert found.events() == was.events()
    for name in RECORDED:
        if name in was:
            share = factor if name in FORCES else 1.0
            np.testing.assert_array_equal(found[name].values, share * was[name].values, err_msg=name)
    for before, after in zip(check_recording(was), check_recording(found), strict=True):
        assert (after.name, after.element, after.verdict) == (before.name, before.element, before.verdict)
        assert (after.utilisation or 0.0) == pytest.approx(before.utilisation or 0.0, rel=1e-12)
