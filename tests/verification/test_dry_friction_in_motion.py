"""Dry friction in motion, against equations in which it is a steep function of speed.

F tanh(v/u) with u far below every speed is dry friction that creeps a little where it should hold: scipy's
LSODA solves that. What it creeps is u times the duration; an own solution with ten times the u tells the
rest.

Hinges of a chain with friction in each: which of them hold and which slip is one problem, for what one
does moves the others. A rope over a sheave that loses: F = σ (T₁ + T₂), σ = (ρ − 1)/(ρ + 1), on the rope's
way s over it, and with L₁ − s, L₂ + s unstretched on either side, ε the strain there,

    I s'' = T₂ (1 + ε₂/2) − T₁ (1 + ε₁/2) − F        T = EA ε
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import Floats, G, adaptive, body, document, end, flow, half_turn, hinge, rope, slider

#: Speed at which friction has 76 % of its size [m/s or rad/s].
STEEP = 1e-7


@pytest.mark.parametrize("seed", [2, 4, 14])
def test_hinges_of_a_chain_hold_and_slip(seed: int) -> None:
    """Angles of two to four links that swing, and whose hinges hold and let go again."""
    draws, duration = np.random.default_rng(seed), 2.0
    count = int(draws.integers(2, 5))
    lengths, masses = draws.uniform(0.5, 2, count), draws.uniform(5, 50, count)
    inertias = draws.uniform(0.5, 5, count)
    friction = draws.uniform(0, 1, count) * masses.sum() * G * lengths * draws.choice([0.02, 0.2, 0.6], count)
    angles = draws.uniform(-1.2, 1.2, count)
    speeds = draws.choice([0, 1], count) * draws.uniform(-2, 2, count)
    summed = np.tril(np.ones((count, count)))
    below = np.array([masses[k:].sum() for k in range(count)])
    coupled = np.outer(lengths, lengths) * np.minimum(below[:, None], below[None])

    def rates(_: float, state: Floats) -> Floats:
        """Of angles to the link above; Σ m l l (cos(φᵢ − φⱼ) φⱼ'' + sin(φᵢ − φⱼ) φⱼ'²) of those to plumb."""
        turned, turning = summed @ state[:count], summed @ state[count:]
        apart = turned[:, None] - turned[None]
        inertia = summed.T @ (coupled * np.cos(apart) + np.diag(inertias)) @ summed
        moments = (coupled * np.sin(apart)) @ turning**2 + G * lengths * np.sin(turned) * below
        braked = friction * np.tanh(state[count:] / STEEP)
        return np.concatenate([state[count:], np.linalg.solve(inertia, -summed.T @ moments - braked)])

    times = np.linspace(0, duration, 101)
    start = np.concatenate([angles, speeds])
    own = solve_ivp(rates, (0, duration), start, "LSODA", times, rtol=1e-8, atol=1e-10).y.T
    links = [
        body(
            f"link{k}",
            hinge(position=angles[k], velocity=speeds[k], friction=friction[k]),
            masses[k],
            parent=f"link{k - 1}" if k else None,
            position=(0, 0, -lengths[k - 1]) if k else (0, 0, 0),
            centre_of_gravity=(0, 0, -lengths[k]),
            inertia=(0.1, inertias[k], inertias[k]),
        )
        for k in range(count)
    ]
    run = adaptive(
        document(links),
        duration,
        tension_tolerance=1e-2,
        position_tolerance=1e-8,
        sample_interval=duration / 100,
    )
    found = np.stack([run.joint(f"link{k}") for k in range(count)], axis=1)
    held = np.diff(found, axis=0) == 0.0
    changes = np.diff(held.astype(int), axis=0) != 0
    assert (changes.any(axis=0)).sum() >= 2, "hinges must hold and let go, more than one"
    # A chain amplifies what creeps, by up to ten here.
    assert np.abs(found - own[:, :count]).max() < 20 * STEEP * duration
    assert run.energy_remainder < 1e-12


@pytest.mark.parametrize(("heavier", "speed"), [(560.0, -0.3), (900.0, 0.5)], ids=["sticks", "runs"])
def test_loads_bounce_over_a_sheave_that_loses(heavier: float, speed: float) -> None:
    """Two loads thrown at the start: the rope over the sheave goes to and fro and sticks, or runs away."""
    light, inertia, stiffness, ratio, radius, depth = 500.0, 40.0, 3e6, 1.15, 0.3, 10.0
    sigma, duration = (ratio - 1) / (ratio + 1), 1.6
    way = depth + math.pi * radius / 2
    slackened = way / (1 + 0.45 * (light + heavier) * G / stiffness)

    def rates(_: float, state: Floats) -> Floats:
        """Of heights of both loads, rope over the sheave, and their speeds."""
        heights, passed = state[:2], state[2]
        unstretched = np.array([slackened - passed, slackened + passed])
        strain = (way - heights) / unstretched - 1.0
        tension = stiffness * np.maximum(0.0, strain)
        pulling = tension * (1 + strain / 2)
        lost = sigma * tension.sum() * np.tanh(state[5] / STEEP)
        turning = (pulling[1] - pulling[0] - lost) / inertia
        return np.concatenate([state[3:], tension / [light, heavier] - G, [turning]])

    times = np.linspace(0, duration, 17)
    own = solve_ivp(rates, (0, duration), [0, 0, 0, speed, 0.3, 0], "LSODA", times, rtol=1e-8, atol=1e-10).y.T
    bodies = [
        body("light", slider(velocity=speed), light, position=(-radius, 0, -depth)),
        body("heavy", slider(velocity=0.3), heavier, position=(radius, 0, -depth)),
        flow("sheave", inertia),
    ]
    route = [end("light"), half_turn(None, (0, 0, 0), radius, True, flow="sheave", ratio=ratio), end("heavy")]
    run = adaptive(
        document(bodies, ropes=[rope("r", 2 * slackened, route, stiffness)]),
        duration,
        tension_tolerance=0.1,
        position_tolerance=1e-8,
        sample_interval=duration / 16,
    )
    found = np.stack([run.joint(name) for name in ("light", "heavy", "sheave")], axis=1)
    # Creep of 0.16 µm, amplified somewhat as it bounces.
    assert np.abs(found - own[:, :3]).max() < 2e-6
    assert (run.energy("friction")[-1] > 1000.0) == (heavier > 800.0)
    assert run.energy_remainder < 1e-11
