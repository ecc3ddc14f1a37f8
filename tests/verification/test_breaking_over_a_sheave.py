"""A rope that breaks while it runs over a sheave with losses and inertia, against equations of its own.

With s what has passed the sheave, L₁ = L₀ − s and L₂ = L₀ + s unstretched on either side, ε the strain there,
w = √(L₀/L) and g = w (ℓ − L) of each side (docs: flows, (F3) to (F6)),

    T = w EA/L₀ (g + τ ġ)        I s̈ = T₂ (1 + ε₂/2) − T₁ (1 + ε₁/2) − σ (T₁ + T₂) sign ṡ

until the larger T is the breaking force. Then both loads fall freely and the sheave turns on as it does.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import Floats, G, adaptive, body, document, end, flow, half_turn, rope, slider

RADIUS, DEPTH, SLACK = 0.2, 5.0, 0.3
LENGTH = 2 * DEPTH + math.pi * RADIUS + SLACK
LIGHT, HEAVY, TURNING, RATIO = 400.0, 700.0, 40.0, 1.08
EA, BREAKS, THROWN = 2e6, 30e3, -3.0
#: Speed at which the friction of the other solution has 76 % of its size [m/s].
STEEP = 1e-6


def sides(state: Floats, damped: float) -> tuple[Floats, Floats]:
    """Tensions [N] and strains of both sides, of heights, rope passed, and their speeds."""
    unstretched = np.array([LENGTH / 2 - state[2], LENGTH / 2 + state[2]])
    fed = np.array([-state[5], state[5]])
    length = math.pi * RADIUS / 2 - state[:2]
    strain, scale = length / unstretched - 1.0, np.sqrt(LENGTH / 2 / unstretched)
    value, rate = (length - unstretched) * scale, scale * (-state[3:5] - (1 + strain / 2) * fed)
    return scale * np.maximum(0.0, 2 * EA / LENGTH * (value + damped * rate)), strain


@pytest.mark.parametrize("damped", [0.0, 0.002])
def test_a_rope_breaks_as_it_slips_over_a_sheave(damped: float) -> None:
    """When it breaks, and how fast both loads and the sheave go then.

    LSODA steps over corners to 1e-8 s; 1e-8 s of 3 km/s², and friction that creeps, are 3e-5 m/s.
    """

    def rates(_: float, state: Floats) -> Floats:
        tension, strain = sides(state, damped)
        pulls = tension * (1 + strain / 2)
        lost = (RATIO - 1) / (RATIO + 1) * tension.sum() * math.tanh(state[5] / STEEP)
        turned = (pulls[1] - pulls[0] - lost) / TURNING
        return np.concatenate([state[3:], tension / [LIGHT, HEAVY] - G, [turned]])

    def spare(_: float, state: Floats) -> float:
        return float(sides(state, damped)[0].max() - BREAKS)

    spare.terminal = True  # type: ignore[attr-defined]
    start = np.array([-DEPTH, -DEPTH, 0, 0, THROWN, 0])
    own = solve_ivp(rates, (0, 1), start, "LSODA", rtol=1e-9, atol=1e-11, max_step=1e-4, events=spare)
    fall = rope(
        "fall",
        LENGTH,
        [end("light"), half_turn(None, (0, 0, 0), RADIUS, True, flow="sheave", ratio=RATIO), end("heavy")],
        EA,
        damped,
    )
    bodies = [
        flow("sheave", TURNING),
        body("light", slider(), LIGHT, position=(-RADIUS, 0, -DEPTH)),
        body("heavy", slider(velocity=THROWN), HEAVY, position=(RADIUS, 0, -DEPTH)),
    ]
    run = adaptive(
        document(bodies, ropes=[{**fall, "breaking_force": BREAKS}]),
        1.0,
        tension_tolerance=1e-2,
        position_tolerance=1e-9,
        sample_interval=0.5,
    )
    broken = run.events("broken")[0][0]
    assert broken == pytest.approx(own.t[-1], abs=2e-8)
    final, rest = own.y[:, -1], 1.0 - broken
    speeds = [run.body(name, "body_velocity")[-1, 2] + G * rest for name in ("light", "heavy")]
    speeds.append((run.joint("sheave")[-1] - run.joint("sheave")[-2]) / 0.5)
    assert speeds == pytest.approx(final[3:], abs=3e-5)
    assert run.energy("friction")[-1] > 50.0
    assert run.energy_remainder < 1e-11
