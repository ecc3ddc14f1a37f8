"""A load that swings, is hoisted and snatches on extension sheaves two and three deep, against equations of
their own.

Sheaves are points with mass; over each runs a sling of one tension T = max(0, EA/L (e + τ ė)), e the length
of both its legs over L. The load is a rigid body: M p̈ = F + M g, I ω̇ = m − ω × I ω in its axes. scipy's
DOP853 solves that from where the lift file has the load, and the sheaves where they hang at the start.
"""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from mechanics import Floats, G, adaptive
from rigid import across, axes, cross, moments, turning

LOAD, TOP = 60e3, 4.0
SIZE, CENTRE = np.array([8.0, 6.0, 3.0]), np.array([0.25, -0.2, 1.5])
INERTIA = LOAD / 12 * ((SIZE**2).sum() - SIZE**2)
EA, TAU = 4e6, 0.01
SPEED, SPIN = np.array([0.5, -0.6, 0.4]), np.array([0.1, 0.12, -0.08])
#: Speed of the hoist [m/s], and how it comes to that [m/s²], [s].
HOIST, ACCELERATION, RAMP = 0.5, 0.5, 1.0


def slings(depth: int) -> dict[str, tuple[float, list[str]]]:
    """Length [m] and both ends of the sling over each sheave; lugs from the deepest."""
    over: dict[str, tuple[float, list[str]]] = {}
    level, count = ["X1"], 1
    for _ in range(1, depth):
        below = [f"X{count + 1 + place}" for place in range(2 * len(level))]
        over |= {one: (9.0, below[2 * place : 2 * place + 2]) for place, one in enumerate(level)}
        level, count = below, count + len(below)
    return over | {one: (18.0, [f"L{2 * k + 1}", f"L{2 * k + 2}"]) for k, one in enumerate(level)}


def lift(depth: int, lugs: dict[str, Floats], masses: dict[str, float], height: float) -> str:
    """The lift file, the hook at a height [m]."""
    at = [f"    {name}: {{at: [{x} m, {y} m, {z} m]}}" for name, (x, y, z) in lugs.items()]
    hung = [
        f"  S{one}: {{over: {one}, to: [{', '.join(e if e[0] == 'X' else f'load.{e}' for e in ends)}], "
        f"length: {length} m}}"
        for one, (length, ends) in slings(depth).items()
    ]
    sheaves = [f"  {name}: {{mass: {mass} kg}}" for name, mass in masses.items()]
    x, y, z = CENTRE
    return "\n".join(
        [
            "format: 1",
            "lift: {title: Extension sheaves}",
            "duration: 4 s",
            "start: as_given",
            f"ropes: {{sling: {{axial_stiffness: {EA} N, damping_time: {TAU} s, mass: none}}}}",
            "load:",
            "  name: load",
            f"  shape: {{box: [{SIZE[0]} m, {SIZE[1]} m, {SIZE[2]} m]}}",
            "  position: [0 m, 0 m, 10 m]",
            "  weight: {calculated: 60 t, contingency: 1.00}",
            f"  centre_of_gravity: {{at: [{x} m, {y} m, {z} m]}}",
            "  lugs:",
            *at,
            "cranes:",
            f"  hook: {{type: fixed_hook, at: [0 m, 0 m, {height} m], rated_capacity: 100 t,",
            "         hoist: {speed: 60 m/min, acceleration: 0.5 m/s^2}}",
            "sling_defaults: {rope: sling}",
            "plan: [{step: hoist, hoist: hook, speed: 30 m/min, by: 5 m}]",
            "extension_sheaves:",
            *sheaves,
            f"slings:\n  S0: {{from: hook, to: X1, length: {TOP} m}}",
            *hung,
        ]
    )


@pytest.mark.parametrize(("depth", "height"), [(2, 29.2), (3, 33.25)])
def test_a_load_on_sheaves_under_sheaves(depth: int, height: float) -> None:
    """Places of load and sheaves, and its attitude, over 4 s in which slings go slack and snatch."""
    angles = 2 * np.pi * (np.arange(2**depth) + 0.5) / 2**depth
    lugs = {f"L{k + 1}": np.array([3 * np.cos(a), 2 * np.sin(a), 3.0]) for k, a in enumerate(angles)}
    over = slings(depth)
    masses = {name: 200.0 + 90.0 * k for k, name in enumerate(over)}
    system = assemble(parse_scenario(lift(depth, lugs, masses, height))).document
    joints = {one["name"]: one["joint"] for one in system["bodies"]}
    joints["load"] |= {"velocity": SPEED.tolist(), "angular_velocity": SPIN.tolist()}
    names, weights = list(over), np.array(list(masses.values()))
    arms = np.array(list(lugs.values())) - CENTRE
    routes = [["hook", "X1"], *([a, one, b] for one, (_, (a, b)) in over.items())]
    lengths = np.array([TOP, *(length for length, _ in over.values())])
    legs = [(k, a, b) for k, route in enumerate(routes) for a, b in itertools.pairwise(route)]
    # Of each leg its sling, and the points that it pulls ahead, 1, and back, -1.
    sling_of = np.array([[k == sling for sling, _, _ in legs] for k in range(len(routes))], dtype=float)
    ends = np.array(
        [[float(name == a) - float(name == b) for _, a, b in legs] for name in ("hook", *names, *lugs)]
    )

    def tensions(time: float, state: Floats) -> tuple[Floats, Floats, Floats]:
        """Of all slings, forces on hook, sheaves and lugs, rotation of the load."""
        place, q, speed, spin = np.split(state[:13], [3, 7, 10])
        rotation, moved = axes(q), state[13:].reshape(2, -1, 3)
        risen = ACCELERATION * min(time, RAMP) ** 2 / 2 + HOIST * max(0.0, time - RAMP)
        hook = np.array([[[0, 0, height + risen]], [[0, 0, ACCELERATION * min(time, RAMP)]]])
        on_load = np.stack([place + arms @ rotation.T, speed + arms @ across(spin).T @ rotation.T])
        places, speeds = np.concatenate([hook, moved, on_load], axis=1)
        ways = -ends.T @ places
        spans = np.sqrt((ways * ways).sum(axis=1))
        along = ways / spans[:, None]
        rate = -(along * (ends.T @ speeds)).sum(axis=1)
        stretch = sling_of @ (spans + TAU * rate) - lengths
        found = np.maximum(0.0, EA / lengths * stretch)
        return found, ends @ ((found @ sling_of)[:, None] * along), rotation

    def rates(time: float, state: Floats) -> Floats:
        _, pulls, rotation = tensions(time, state)
        spin, on_lugs = state[10:13], pulls[1 + len(names) :]
        force = on_lugs.sum(axis=0) - (0, 0, LOAD * G)
        spun = (moments(arms, on_lugs @ rotation) - cross(spin, INERTIA * spin)) / INERTIA
        sheaves = pulls[1 : 1 + len(names)] / weights[:, None] - [0, 0, G]
        half = state[13:].reshape(2, -1)
        return np.concatenate(
            [state[7:10], turning(state[3:7], spin), force / LOAD, spun, half[1], sheaves.ravel()]
        )

    hung = np.concatenate([joints[name]["position"] for name in names])
    start = np.concatenate([np.array([0, 0, 10]) + CENTRE, [1, 0, 0, 0], SPEED, SPIN, hung, 0 * hung])
    times = np.linspace(0, 4, 21)
    own = solve_ivp(rates, (0, 4), start, "DOP853", times, rtol=1e-8, atol=1e-8, max_step=0.02).y.T
    run = adaptive(system, 4.0, tension_tolerance=10.0, position_tolerance=1e-8, sample_interval=0.2)
    # 10 N in a step; a light sheave between slack slings goes through many snatches. Of random lifts 4e-5 m
    # were found at sheaves, 1e-6 m at the load.
    assert np.abs(run.body("load") - own[:, :3]).max() < 5e-6
    alike = (run.body("load", "body_orientation") * own[:, 3:7]).sum(axis=1)
    assert np.abs(np.abs(alike / np.linalg.norm(own[:, 3:7], axis=1)) - 1.0).max() < 1e-12
    for k, name in enumerate(names):
        assert np.abs(run.body(name) - own[:, 13 + 3 * k : 16 + 3 * k]).max() < 1e-4
    pulled = np.array([tensions(time, state)[0] for time, state in zip(times, own, strict=True)])
    assert (pulled == 0).any() and pulled.max() > 1.5 * LOAD * G, "slings must go slack and snatch"
    assert run.energy_remainder < 1e-11
