"""Pins of an equalizer are pulled as its load bounces, turns and swings, and its hook begins to hoist:
against own equations.

The load is rigid; moving sheaves go down along plumb guides by x from where they start, at a along a frame
that turns by ψ about the plumb, whose square way is t. Slings pull with f along n upwards, and the equalizing
rope, all of whose parts are plumb, with T:

    T = EA/L max(0, 2 Σ x + 2 τ Σ ẋ)              f = EA/L max(0, e + τ ė)
    m ẍ = f n_z + m (g + z̈) − 2 T                 (I + Σ m a²) ψ̈ = −Σ a f n·t

z is how far the hook has gone up; until the pins are pulled x = 0. scipy's LSODA solves that.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from mechanics import Floats, G
from rigid import axes, points_of, rates_of

MASS, INERTIA = 300e3, 1e3 * np.diag([3100.0, 3200.0, 5100.0])
CENTRE = np.array([0.2, 0.1, 2.4])
PLACE, HEADING = np.array([0.5, -0.3, 2.9]), math.radians(6.0)
LUGS = np.array([[-3.5, 1.5, 5], [-1.5, -1.5, 5], [0, 0, 5], [1.6, -1.6, 5], [3.5, 1.5, 5]])
LENGTHS = np.array([20.1, 20.2, 20.05, 20.3, 20.15])
ALONG = np.array([-3.2, -1.6, 0.0, 1.6, 3.2])
#: Mass of a moving sheave [kg], inertia of the frame [kg m²], EA [N], τ [s].
SHEAVE, FRAME, SLING, EQUALIZING, DAMPING = 300.0, 110933.0, 200e6, 100e6, 4e-3
#: Height of the hook, depth of moving sheaves below it, rope of ten parts and nine half turns [m].
HOOK, BELOW, ROUTE = 36.483, 8.65, 20.0 + 9 * math.pi * 0.4
#: When pins are pulled and the hook begins, is fast, brakes and stands [s]; its acceleration [m/s²].
KINKS, ACCELERATION, ENDS = (2.3, 5.3, 6.0, 9.0), 0.1, 8.0

LIFT = """\
format: 1
lift: {title: Pins are pulled in a bounce}
duration: 8 s
start: as_given
ropes:
  sling: {axial_stiffness: 200 MN, damping_time: 4 ms}
  equalizing: {axial_stiffness: 100 MN, damping_time: 4 ms}
load:
  name: module
  shape: {box: [10 m, 10 m, 5 m]}
  position: [0.5 m, -0.3 m, 2.9 m]
  heading: 6 deg
  weight: {calculated: 300 t}
  inertia: {xx: 3100 t m^2, yy: 3200 t m^2, zz: 5100 t m^2}
  centre_of_gravity: {at: [0.2 m, 0.1 m, 2.4 m]}
  lugs:
    L1: {at: [-3.5 m, 1.5 m, 5 m]}
    L2: {at: [-1.5 m, -1.5 m, 5 m]}
    L3: {at: [0 m, 0 m, 5 m]}
    L4: {at: [1.6 m, -1.6 m, 5 m]}
    L5: {at: [3.5 m, 1.5 m, 5 m]}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 36.483 m], hoist: {speed: 1 m/s, acceleration: 0.1 m/s^2}}
equalizers:
  e1:
    hangs_from: hook
    heading: 0 deg
    frame: {mass: 20 t, length: 8 m, width: 1.6 m, height: 3.3 m, centre_of_gravity_below_hook: 5.0 m,
      inertia_about_vertical: 110933 kg m^2}
    hinge: {axis: vertical, friction: 0 kN m, damping: 0 kN m s}
    rope: equalizing
    rope_ends: {along: [-3.6 m, 3.6 m], below_hook: 6.65 m}
    fixed_sheaves: {along: [-2.4 m, -0.8 m, 0.8 m, 2.4 m], below_hook: 6.65 m, pitch_diameter: 0.8 m,
      efficiency: 1.0, rotating_mass: 0 kg}
    moving_sheaves: {along: [-3.2 m, -1.6 m, 0 m, 1.6 m, 3.2 m], below_hook: 8.65 m, pitch_diameter: 0.8 m,
      efficiency: 1.0, rotating_mass: 0 kg, mass: 300 kg, guided: vertical}
    travel: {up: 1.4 m, down: 1.9 m, locked: true}
slings:
  S1: {from: e1.1, to: module.L1, length: 20.1 m, rope: sling}
  S2: {from: e1.2, to: module.L2, length: 20.2 m, rope: sling}
  S3: {from: e1.3, to: module.L3, length: 20.05 m, rope: sling}
  S4: {from: e1.4, to: module.L4, length: 20.3 m, rope: sling}
  S5: {from: e1.5, to: module.L5, length: 20.15 m, rope: sling}
plan:
  - {step: bounce, hold: 2.3 s}
  - {step: up, hoist: hook, speed: 0.3 m/s, acceleration: 0.1 m/s^2, pull_pins: e1, brake_from: 6 s}
simulation: {sample_interval: 20 ms, tension_tolerance: 0.1 N, position_tolerance: 0.00001 mm}
"""


def forces(time: float, state: Floats) -> tuple[Floats, Floats, Floats, float]:
    """Tensions of slings [N], their ways up, lower ends [m], tension of the equalizing rope [N]."""
    load, (turn, rate), (travel, speed) = state[:13], state[13:15], state[15:].reshape(2, 5)
    ages = np.array([max(0.0, time - kink) for kink in KINKS])
    signs = ACCELERATION * np.array([1, -1, -1, 1])
    height, rise = HOOK + float(signs @ ages**2) / 2, float(signs @ ages)
    ahead, aside = np.array([math.cos(turn), math.sin(turn)]), np.array([-math.sin(turn), math.cos(turn)])
    tops = np.column_stack([np.outer(ALONG, ahead), height - BELOW - travel])
    moves = np.column_stack([np.outer(ALONG, rate * aside), rise - speed])
    ends, lug_moves = points_of(load, LUGS - CENTRE)
    ways = tops - ends
    sizes = np.sqrt((ways * ways).sum(axis=1))
    ways /= sizes[:, None]
    stretches = sizes - LENGTHS + DAMPING * (ways * (moves - lug_moves)).sum(axis=1)
    tensions = SLING / LENGTHS * np.maximum(0.0, stretches)
    pull = EQUALIZING / ROUTE * max(0.0, 2 * float(travel.sum() + DAMPING * speed.sum()))
    return tensions, ways, ends, pull


def rates(time: float, state: Floats, is_free: bool, lifted: float) -> Floats:
    """Of the load, the frame's turn and the sheaves' travel; the hook's acceleration upwards is `lifted`."""
    tensions, ways, ends, pull = forces(time, state)
    load = rates_of(state[:13], MASS, INERTIA, tensions[:, None] * ways, ends)
    aside = np.array([-math.sin(state[13]), math.cos(state[13]), 0.0])
    turning = -float(ALONG * tensions @ (ways @ aside)) / (FRAME + SHEAVE * float(ALONG @ ALONG))
    down = (tensions * ways[:, 2] - 2 * pull) / SHEAVE + G + lifted
    sheaves = np.concatenate([state[20:], down]) if is_free else np.zeros(10)
    return np.concatenate([load, [state[14], turning], sheaves])


def test_sheaves_let_go_in_a_bounce_move_as_their_own_equations_say() -> None:
    """Load, frame, sheaves and all tensions, through forty times that slings go slack or taut."""
    recording = simulate(parse_scenario(LIFT))
    attitude = np.array([math.cos(HEADING / 2), 0.0, 0.0, math.sin(HEADING / 2)])
    state = np.concatenate([PLACE + axes(attitude) @ CENTRE, attitude, np.zeros(6), np.zeros(12)])
    states = [state]
    for (begin, end), lifted in zip(pairwise((0.0, *KINKS[:3], ENDS)), (0.0, 1.0, 0.0, -1.0), strict=True):
        asked = recording.time[(recording.time > begin + 1e-9) & (recording.time < end - 1e-9)]
        run = solve_ivp(
            rates, (begin, end), state, "LSODA", [*asked, end], rtol=1e-10, atol=1e-11, max_step=0.01,
            args=(begin >= KINKS[0], lifted * ACCELERATION),
        )  # fmt: skip
        states.extend(run.y.T)
        state = run.y[:, -1]
    own = np.array(states)
    pulls = [forces(time, one) for time, one in zip(recording.time, own, strict=True)]
    # Found: 1.8e-8 m and rad, and 4e-8 of the largest tensions.
    assert recording.column("body_position", "module") == pytest.approx(own[:, :3], abs=2e-7)
    assert recording.column("joint_position", "e1") == pytest.approx(own[:, 13], abs=2e-7)
    for k in range(5):
        assert recording.column("sheave_travel", f"e1.{k + 1}") == pytest.approx(own[:, 15 + k], abs=2e-7)
        tensions = np.array([one[0][k] for one in pulls])
        found = recording.column("rope_tension", f"sling.S{k + 1}")
        assert found == pytest.approx(tensions, abs=1e-6 * tensions.max())
    tensions = np.array([one[3] for one in pulls])
    found = recording.column("rope_tension", "e1.equalizing")
    assert found == pytest.approx(tensions, abs=1e-6 * tensions.max())
    # What that is worth: sheaves go up and down by 0.6 and 0.9 m, the frame turns by 36°.
    assert own[:, 15:20].min() < -0.5
    assert own[:, 15:20].max() > 0.8
    assert np.ptp(own[:, 13]) > 0.6
    assert list(recording["event_kind"].values).count("taut") > 15
