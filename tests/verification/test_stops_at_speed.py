"""Moving sheaves of an equalizer that run into their stops, one rope and one load over all of them.

Of three sheaves at xᵢ, down positive, the load at z below, slings k (z − xᵢ − L), the equalizing rope
K (2 Σ x − s) and stops N at both ends of the strokes, all with dampers:

    m ẍᵢ = fᵢ + m g − 2T − Nᵢ        M z̈ = M g − Σ fᵢ
"""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp

from mechanics import Floats, G, adaptive, body, document, end, half_turn, rope, slider

RADIUS, SHEAVE, LOAD = 0.2, 300.0, 40e3
#: Length [m], EA [N] of the slings, of the equalizing rope; damping time of all ropes [s].
SLING, EA, DAMPED = 10.0, 4e7, 0.002
FREE, STIFF = 30.0 + 5 * math.pi * RADIUS + 0.002, 2e8
#: Ends of the strokes [m], stiffness [N/m] and damping time [s] of the stops.
ENDS, STOP, STOPPED = (-0.005, 0.006), 1e8, 0.0005
#: Speeds at the start [m/s], of the load too; its depth below the sheaves [m].
SPEEDS, SINKS, DEPTH = (1.5, -0.5, -1.0), 0.8, 10.02


def rates(_: float, state: Floats) -> Floats:
    """Of travels, the load's depth, and their speeds."""
    x, z, v, w = state[:3], state[3], state[4:7], state[7]
    slings = np.maximum(0.0, EA / SLING * (z - x - SLING + DAMPED * (w - v)))
    tension = max(0.0, STIFF / FREE * (2 * x.sum() - 0.002 + DAMPED * 2 * v.sum()))
    below = np.maximum(0.0, STOP * (x - ENDS[1] + STOPPED * v))
    above = np.maximum(0.0, STOP * (ENDS[0] - x - STOPPED * v))
    turned = (SHEAVE * G + slings - 2 * tension - below + above) / SHEAVE
    return np.concatenate([v, [w], turned, [G - slings.sum() / LOAD]])


def test_sheaves_run_into_their_stops() -> None:
    """Travels and depth over half a second; scipy's steps are short, for each of these forces has a corner.

    Positions may be wrong by 1e-8 m in a step; bouncing amplifies what a step leaves, here to 8e-8 m.
    """
    duration = 0.5
    times = np.linspace(0, duration, 51)
    start = [0.0, 0.0, 0.0, DEPTH, *SPEEDS, SINKS]
    own = solve_ivp(rates, (0, duration), start, "LSODA", times, rtol=1e-10, atol=1e-11, max_step=2e-4).y.T
    stops = {"lower": ENDS[0], "upper": ENDS[1], "stiffness": STOP, "damping_time": STOPPED}
    route, bodies, ropes = [end(None, (-RADIUS, 0, 0))], [], []
    for i, speed in enumerate(SPEEDS):
        x = 4 * RADIUS * i
        guide = slider((0, 0, -1), velocity=speed, stops=stops)
        bodies.append(body(f"m{i}", guide, SHEAVE, position=(x, 0, -5)))
        ropes.append(rope(f"s{i}", SLING, [end(f"m{i}"), end("load", (x, 0, 0))], EA, DAMPED))
        route.append(half_turn(f"m{i}", (0, 0, 0), RADIUS, False))
        if i < 2:
            route.append(half_turn(None, (x + 2 * RADIUS, 0, 0), RADIUS, True))
    route.append(end(None, (9 * RADIUS, 0, 0)))
    bodies.append(body("load", slider((0, 0, -1), velocity=SINKS), LOAD, position=(0, 0, -5 - DEPTH)))
    system = document(bodies, ropes=[rope("equalizing", FREE, route, STIFF, DAMPED), *ropes])
    run = adaptive(
        system, duration, tension_tolerance=10.0, position_tolerance=1e-8, sample_interval=duration / 50
    )
    found = np.stack([run.joint(f"m{i}") for i in range(3)], axis=1)
    assert np.abs(found - own[:, :3]).max() < 5e-7
    assert np.abs(run.joint("load") + DEPTH - own[:, 3]).max() < 5e-7
    assert len(run.events("stop_hit")) >= 3, "sheaves must run into their stops"
    assert run.energy_remainder < 1e-11
