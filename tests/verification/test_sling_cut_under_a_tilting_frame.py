"""A sling of an equalizer is cut as its load bounces; its frame tilts, sheaves run into stops, other slings
break: against own equations.

About the bearing of the hook, which stands, frame and sheaves have p = (a, 0, −h − x), d = (0, 0, −1) in the
frame's axes, spin ω, pulls f of the slings, T of the equalizing rope, N of the stops; the load is rigid:

    (J + Σ m [p]ᵀ[p]) α + Σ m p × d ẍ = Σ p × F + c × M g − ω × J ω
    m d·(α × p) + m ẍ = d·F − 2 T − N         F = f + m (g − ω × (ω × p) − 2 ω × d ẋ)
    W r̈ = W g − Σ f         I ω̇ = −Σ b × f − ω × I ω         in the load's axes, b the arms of its lugs
    T = EA/L max(0, 2 Σ x + 2 τ Σ ẋ)         f = EA/L max(0, e + τ ė)

Half turns stay under their fixed sheaves, so all parts of the rope are along the guides. scipy's LSODA
solves it, from the start to the cut, and on from where a tension comes to the breaking force.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from mechanics import Floats, G
from rigid import about, across, axes, moments, turning

DURATION, CUT = 1.2, 0.4
#: The sling that is cut, and what the others bear [N].
FIRST, STRENGTH = 0, np.array([np.inf, 1.3e6, 1.6e6])
#: Of the frame: places of sheaves along it, their depth and that of the fixed ones, radius [m].
ALONG, DEPTH, ABOVE, RADIUS, HOOK = np.array([-1.6, 0.0, 1.6]), 7.0, 5.0, 0.4, 30.0
SHEAVE, FRAME, CENTRE, SPINS = 300.0, 10e3, 4.0, np.diag([8e3, 25e3, 24e3])
UP, DOWN, STOP, STOPPED = -1.2, 1.5, 5e7, 0.004
EA, EQUALIZING, TAU = 120e6, 100e6, 0.005
ROPE = 6 * (DEPTH - ABOVE) + 5 * math.pi * RADIUS
LOAD, INERTIA = 90e3, np.array([[300e3, 15e3, -20e3], [15e3, 420e3, 10e3], [-20e3, 10e3, 500e3]])
LUGS = np.array([(-2.0, 0.3, 2.0), (0.2, -0.4, 2.2), (2.3, 0.2, 2.1)])
PLACE = np.array([0.1, 0.05, 8.7])
LENGTHS = np.array(
    [
        round(math.dist((a, 0, HOOK - DEPTH), PLACE + lug) + 0.002, 3)
        for a, lug in zip(ALONG, LUGS, strict=True)
    ]
)
DOWNWARDS = np.array([0.0, 0.0, -1.0])
ACROSS_DOWN = across(DOWNWARDS)
BODY = SPINS + about(FRAME, CENTRE * DOWNWARDS)


@dataclass
class Rig:
    """What of the slings is left."""

    whole: Floats = field(default_factory=lambda: np.ones(3))

    def pulls(self, y: Floats) -> tuple[Floats, Floats, Floats, Floats]:
        """Sheaves in the frame; pulls on them and arms of the lugs, world's axes; tensions of slings [N]."""
        frame, spin, x, speed = y[:4], y[4:7], y[7:10], y[10:13]
        place, attitude, velocity, rolls = y[13:16], y[16:20], y[20:23], y[23:26]
        turned, load = axes(frame), axes(attitude)
        p = np.column_stack([ALONG, np.zeros(3), -DEPTH - x])
        arms = LUGS @ load.T
        way = place + arms - (0.0, 0.0, HOOK) - p @ turned.T
        sheaves = (p @ across(spin).T + np.outer(speed, DOWNWARDS)) @ turned.T
        rate = velocity + arms @ across(load @ rolls).T - sheaves
        long = np.sqrt((way * way).sum(axis=1))
        pulls = EA / LENGTHS * (long - LENGTHS + TAU * (way * rate).sum(axis=1) / long)
        tension = self.whole * np.maximum(0.0, pulls)
        return p, tension[:, None] * way / long[:, None], arms, tension

    def rates(self, _: float, y: Floats) -> Floats:
        """Of the whole state."""
        frame, spin, x, speed, attitude, rolls = y[:4], y[4:7], y[7:10], y[10:13], y[16:20], y[23:26]
        p, pulls, arms = self.pulls(y)[:3]
        turned, whirl = axes(frame), across(spin)
        weight = G * DOWNWARDS @ turned
        rope = EQUALIZING / ROPE * max(0.0, float(2 * x.sum() + TAU * 2 * speed.sum()))
        stops = np.maximum(0.0, STOP * (x - DOWN + STOPPED * speed))
        stops -= np.maximum(0.0, STOP * (UP - x - STOPPED * speed))
        turns = p @ (whirl @ whirl).T + 2 * np.outer(speed, whirl @ DOWNWARDS)
        forces = pulls @ turned + SHEAVE * (weight - turns)
        mass, right = SHEAVE * np.eye(6), np.empty(6)
        mass[:3, :3] = BODY + SHEAVE * ((p * p).sum() * np.eye(3) - p.T @ p)
        mass[:3, 3:] = SHEAVE * (p @ ACROSS_DOWN).T
        mass[3:, :3] = mass[:3, 3:].T
        right[:3] = moments(p, forces) - whirl @ BODY @ spin
        right[:3] += CENTRE * FRAME * ACROSS_DOWN @ weight
        right[3:] = forces @ DOWNWARDS - 2 * rope - stops
        faster = np.linalg.solve(mass, right)
        moment = moments(arms, -pulls) @ axes(attitude) - across(rolls) @ INERTIA @ rolls
        falls = G * DOWNWARDS - pulls.sum(0) / LOAD
        rolls_faster = np.linalg.solve(INERTIA, moment)
        of_load = [y[20:23], turning(attitude, rolls), falls, rolls_faster]
        return np.concatenate([turning(frame, spin), faster[:3], speed, faster[3:], *of_load])


@pytest.fixture(scope="module")
def recording() -> Recording:
    x, y, z = PLACE
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = INERTIA
    lugs = [f"    L{k}: {{at: [{a} m, {b} m, {c + 2} m]}}" for k, (a, b, c) in enumerate(LUGS)]
    ends = [f"cut_at: {CUT} s" if k == FIRST else f"breaks_at: {STRENGTH[k]} N" for k in range(3)]
    slings = [
        f"  S{k}: {{from: e1.{k + 1}, to: load.L{k}, length: {long} m, rope: sling, {ends[k]}}}"
        for k, long in enumerate(LENGTHS)
    ]
    along = [f"[{', '.join(f'{at} m' for at in places)}]" for places in (ALONG, (-0.8, 0.8), (-2, 2))]
    text = f"""\
format: 1
lift: {{title: A sling is cut}}
duration: {DURATION} s
start: as_given
ropes:
  sling: {{axial_stiffness: {EA} N, damping_time: {TAU} s}}
  equalizing: {{axial_stiffness: {EQUALIZING} N, damping_time: {TAU} s}}
load:
  name: load
  shape: {{box: [6 m, 4 m, 4 m]}}
  position: [{x} m, {y} m, {z - 2} m]
  weight: {{calculated: {LOAD} kg}}
  inertia:
    {{xx: {xx} kg m^2, yy: {yy} kg m^2, zz: {zz} kg m^2,
     xy: {xy} kg m^2, xz: {xz} kg m^2, yz: {yz} kg m^2}}
  centre_of_gravity: {{at: [0 m, 0 m, 2 m]}}
  lugs:
{chr(10).join(lugs)}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, {HOOK} m], hoist: {{speed: 0.1 m/s, acceleration: 0.1 m/s^2}}}}
equalizers:
  e1:
    hangs_from: hook
    frame:
      {{mass: {FRAME} kg, length: 5 m, width: 1.6 m, height: 3 m, centre_of_gravity_below_hook: {CENTRE} m,
       inertia_about_length: {SPINS[0, 0]} kg m^2, inertia_about_width: {SPINS[1, 1]} kg m^2,
       inertia_about_vertical: {SPINS[2, 2]} kg m^2}}
    hinge: {{tilts: true}}
    rope: equalizing
    rope_ends: {{along: {along[2]}, below_hook: {ABOVE} m}}
    fixed_sheaves: {{along: {along[1]}, below_hook: {ABOVE} m, pitch_diameter: {2 * RADIUS} m}}
    moving_sheaves:
      {{along: {along[0]}, below_hook: {DEPTH} m, pitch_diameter: {2 * RADIUS} m, mass: {SHEAVE} kg}}
    travel:
      {{up: {-UP} m, down: {DOWN} m, stops: true, stop_stiffness: {STOP} N/m, stop_damping_time: {STOPPED} s}}
slings:
{chr(10).join(slings)}
simulation: {{tension_tolerance: 5 N, position_tolerance: 0.00001 mm, sample_interval: 5 ms}}
"""
    return simulate(parse_scenario(text))


def solved(times: Floats) -> tuple[Floats, Floats, list[tuple[float, int]]]:
    """States and tensions [N], shapes (time, state) and (time, 3); when [s] which sling broke."""
    rig, broken = Rig(), []
    states: list[Floats] = []
    tensions: list[Floats] = []
    at, y = 0.0, np.concatenate([[1.0], np.zeros(12), PLACE, [1.0], np.zeros(9)])

    def strength(_: float, state: Floats) -> float:
        return float((rig.pulls(state)[3] - STRENGTH).max())

    strength.terminal, strength.direction = True, 1  # type: ignore[attr-defined]
    while at < DURATION:
        part = solve_ivp(
            rig.rates,
            (at, CUT if at < CUT else DURATION),
            y,
            "LSODA",
            events=strength,
            rtol=1e-10,
            atol=1e-12,
            max_step=0.02,
            dense_output=True,
        )
        at, y = float(part.t[-1]), part.y[:, -1]
        states += [part.sol(t) for t in times[len(states) : np.searchsorted(times, at, side="right")]]
        tensions += [rig.pulls(state)[3] for state in states[len(tensions) :]]
        parts = int((rig.pulls(y)[3] - STRENGTH).argmax()) if part.status == 1 else FIRST
        if part.status == 1:
            broken.append((at, parts))
        rig.whole[parts] = 0.0
    return np.array(states), np.array(tensions), broken


def test_the_others_catch_it_and_break_one_after_the_other(recording: Recording) -> None:
    """Travels, places, attitudes and tensions through cut, six stops and two breaks; when slings break.

    Ten times these tolerances leave a hundred times as much: 5e-6 m of travel, 10 N, 2e-8 s.
    """
    states, tensions, broken = solved(recording.time)
    for k in range(3):
        assert np.abs(recording.column("sheave_travel", f"e1.{k + 1}") - states[:, 7 + k]).max() < 2e-7
        assert np.abs(recording.column("rope_tension", f"sling.S{k}") - tensions[:, k]).max() < 0.5
    assert np.abs(recording.column("body_position", "load") - states[:, 13:16]).max() < 5e-9
    assert np.abs(recording.column("body_orientation", "e1") - states[:, :4]).max() < 2e-9
    assert np.rad2deg(2 * np.arccos(states[:, 0].min())) > 8.0, "the frame must tilt"
    events = recording.events("broken")
    assert [name for _, _, name in events] == [f"sling.S{k}" for _, k in broken] == ["sling.S1", "sling.S2"]
    assert [at for at, _, _ in events] == pytest.approx([at for at, _ in broken], abs=2e-9)
    assert len(recording.events("stop_hit")) == 6
    assert recording.metrics()["energy_remainder"] < 1e-12
