"""A crawler crane that does everything at once: momentum of all bodies against what the ground pushes.

It travels over uneven ground, slews back, luffs in tackles and hoists a load under a spreader bar in wind. No
equation of motion of the crane is needed: of the recording alone, dp/dt and dL/dt by differences, weights,
the wind by its formula and the forces under four corners have to balance.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.assembly.assemble import assemble
from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.results.variable import FloatArray
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation

G = 9.81
#: Half length and half gauge of the tracks [m]; order of `gantline.results.cranes.track_pressure.CORNERS`.
ENDS = np.array([(4.5, 4.2, 0.0), (-4.5, 4.2, 0.0), (4.5, -4.2, 0.0), (-4.5, -4.2, 0.0)])
#: Speed of the wind [m/s], ½ ρ C A of the load's end and side [kg/m], their height over its base [m].
WIND = 8.0 * np.array([math.cos(math.radians(70.0)), math.sin(math.radians(70.0)), 0.0])
DRAG, AREAS_AT = 0.5 * 1.225 * 1.2 * np.array([12.0, 30.0, 0.0]), 1.5
#: Its centre of gravity from its datum, height of the hook block [m].
CENTRE, HOOK_BLOCK = np.array([0.5, -0.2, 1.4]), 2.0
#: Time between samples [s]. Ramps of drives begin and end between two of them, where differences cut corners.
SAMPLE = 0.01

LIFT = """\
format: 1
lift: {title: Everything at once}
duration: 16 s
start: rest
ground: {level: 2 m}
wind: {speed: 8 m/s, direction: 70 deg}
ropes:
  hoist: {axial_stiffness: 36 MN, damping_time: 20 ms, mass: 3.2 kg/m, diameter: 28 mm}
  luff: {axial_stiffness: 60 MN, damping_time: 20 ms, mass: 5 kg/m, diameter: 36 mm}
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, mass: none, diameter: 44 mm}
load:
  name: box
  shape: {box: [10 m, 4 m, 3 m]}
  position: [6.217 m, 13.528 m, 14.03 m]
  heading: 25 deg
  weight: {calculated: 100 t}
  centre_of_gravity: {at: [0.5 m, -0.2 m, 1.4 m]}
  wind_areas:
    end: {area: 12 m^2, coefficient: 1.2, along: x, at: [0 m, 0 m, 1.5 m]}
    side: {area: 30 m^2, coefficient: 1.2, along: y, at: [0 m, 0 m, 1.5 m]}
  lugs:
    A: {at: [-4 m, 1.5 m, 3 m]}
    B: {at: [-4 m, -1.5 m, 3 m]}
    C: {at: [4 m, 1.5 m, 3 m]}
    D: {at: [4 m, -1.5 m, 3 m]}
spreaders:
  bar:
    mass: 3 t
    size: [9 m, 0.4 m, 0.4 m]
    lugs:
      T1: {at: [-4 m, 0 m, 0.3 m]}
      T2: {at: [4 m, 0 m, 0.3 m]}
      B1: {at: [-4 m, 0 m, -0.3 m]}
      B2: {at: [4 m, 0 m, -0.3 m]}
sling_defaults: {rope: sling}
slings:
  T1: {from: c1.H, to: bar.T1, length: 8 m}
  T2: {from: c1.H, to: bar.T2, length: 8 m}
  A: {from: bar.B1, to: box.A, length: 6 m}
  B: {from: bar.B1, to: box.B, length: 6 m}
  C: {from: bar.B2, to: box.C, length: 6 m}
  D: {from: bar.B2, to: box.D, length: 6 m}
cranes:
  c1:
    type: crawler
    position: [3 m, -2 m]
    heading: 40 deg
    slew: 35 deg
    tracks: {length: 9 m, width: 1.5 m, gauge: 8.4 m, stiffness: 150 MN/m,
      levels: {left.front: 10 mm, right.back: 5 mm}}
    base_mass: 190 t
    upper_mass: 60 t
    central_ballast: 95 t
    counterweight: {mass: 250 t, behind: 6.5 m, height: 4 m}
    boom: {heel_pins: {ahead: 1.6 m, height: 2.5 m}, length: 63 m, radius: 16 m, mass: 60 t,
      centre_of_gravity: 45 %, head_gear: 3 t}
    luffing: {speed: 3 deg/min, acceleration: 0.05 deg/s^2, range: [30 deg, 82 deg],
      tackles: {count: 2, parts: 12, rope: luff, from: [-4 m, 1.2 m, 14 m]}}
    slewing: {speed: 0.3 rev/min, acceleration: 0.1 deg/s^2}
    travel: {speed: 1 km/h, acceleration: 0.03 m/s^2, range: [-5 m, 50 m]}
    hooks:
      H:
        across: 0.4 m
        height: 30.36 m
        rated_capacity: 400 t
        block: {mass: 7 t, height: 2 m}
        reeving:
          {parts_each: 10, rope: hoist, sheave_diameter: 0.7 m, below_head: 1 m, sheave_block_mass: 2 t}
        drum: {diameter: 0.8 m}
        hoist: {speed: 6 m/min, acceleration: 0.02 m/s^2}
plan:
  - {step: travel, travel: c1, speed: 0.8 km/h, by: -4 m}
  - {step: slew, slew: c1, speed: 0.2 rev/min, by: -40 deg, starts: with_previous, start_at: 1 s}
  - {step: luff, luff: c1, speed: 3 deg/min, to: 72 deg, starts: with_previous, start_at: 2 s}
  - {step: hoist, hoist: c1.H, speed: 5 m/min, by: 2 m, starts: with_previous, start_at: 4 s}
  - {step: end, hold: until_end}
simulation: {tension_tolerance: 1 N, position_tolerance: 0.01 mm, sample_interval: 0.01 s}
"""


def rate(values: FloatArray) -> FloatArray:
    """Central differences; the first and the last are cut off by whoever takes them."""
    found: FloatArray = (np.roll(values, -1, axis=0) - np.roll(values, 1, axis=0)) / (2 * SAMPLE)
    return found


def place(recording: Recording, body: str) -> tuple[FloatArray, FloatArray]:
    """Centre of gravity (time, 3) [m] and axes (time, 3, 3) of a body."""
    return recording.column("body_position", body), axes(recording.column("body_orientation", body))


def wind(recording: Recording) -> tuple[FloatArray, FloatArray]:
    """Where the wind pushes the load (time, 3) [m], and how (time, 3) [N]: both areas at one place."""
    centre, turn = place(recording, "box")
    arm = turn @ (np.array([0.0, 0.0, AREAS_AT]) - CENTRE)
    spin = recording.column("body_angular_velocity", "box")
    past = recording.column("body_velocity", "box") + np.cross(spin, arm) - WIND
    own = np.einsum("tji,tj->ti", turn, past)
    return centre + arm, np.einsum("tij,tj->ti", turn, -DRAG * np.linalg.norm(own, axis=1)[:, None] * own)


def held_upright(recording: Recording, mass: float) -> FloatArray:
    """Moment that holds the hook block upright (time, 3) [N m]: the world bears it, and not the crane.

    Slings pull at its bearing, falls at its sheaves; what these pull follows from its motion.
    """
    centre = recording.column("body_position", "c1.H")
    (boom,) = recording.rig.booms
    bearing = centre + np.asarray(boom.hooks[0].bearing)
    slings = -sum(
        series.sling_tension(recording, sling)[:, None] * series.sling_direction(recording, sling)
        for sling in recording.rig.slings
        if sling.from_body == "c1.H"
    )
    up = np.array([0.0, 0.0, 1.0])
    falls = mass * (rate(recording.column("body_velocity", "c1.H")) + G * up) - slings
    sheaves = bearing + HOOK_BLOCK * up
    moment: FloatArray = -np.cross(bearing - centre, slings) - np.cross(sheaves - centre, falls)
    return moment


def test_momentum_of_everything_changes_by_what_the_ground_pushes() -> None:
    """ΣN = m g + dp/dt − wind, and moments about the world's level axes, with four drives at once."""
    scenario = parse_scenario(LIFT)
    mass = {body["name"]: body["mass"] for body in assemble(scenario).document["bodies"]}
    recording = Simulation(scenario).run()
    momentum = rate(recording.variables["momentum"].values)
    turning = rate(recording.variables["angular_momentum"].values)
    weight = sum(
        np.cross(recording.column("body_position", body), (0.0, 0.0, -G * mass[body]))
        for body in recording.coordinates["body"]
    )
    corners = [recording.column("contact_force", corner) for corner in recording.rig.crawlers[0].corners]
    middle, turn = place(recording, "c1.tracks")
    foot = middle - 0.8 * turn[:, :, 2]
    pushed = sum(
        np.cross(foot + turn @ end, np.stack([0 * force, 0 * force, force], axis=1))
        for end, force in zip(ENDS, corners, strict=True)
    )
    at, push = wind(recording)
    level = (momentum - push) * (1.0, 1.0, 0.0)  # what the joints of the tracks hold on the ground
    upright = momentum[:, 2] + G * sum(mass.values()) - push[:, 2] - sum(corners)
    moments = turning - weight - pushed - np.cross(at, push) - np.cross(foot, level)
    moments -= held_upright(recording, mass["c1.H"])

    inside = slice(2, -2)
    changes = np.abs(momentum[inside, 2]).max(), np.abs(turning[inside, :2]).max()
    assert changes[0] > 3e3 and changes[1] > 2e5  # it is not a crane at rest
    # Differences over 20 ms cut the corners where ramps begin and end: of a jump of 100 t by 0.02 m/s^2, that
    # ropes soften, 1 kN at two samples of 1600 at most, 35 N in the root of the mean square, and so with
    # moments 16 m out. Without what holds the hook block upright 1e-2 of the moments would be left.
    assert np.sqrt(np.mean(upright[inside] ** 2)) < 3e-3 * changes[0]
    assert np.sqrt(np.mean(moments[inside, :2] ** 2)) < 3e-4 * changes[1]
    assert recording.column("contact_force", "c1.left.back").min() > 0.0
    assert recording.metrics()["energy_remainder"] == pytest.approx(0.0, abs=1e-9)
