"""A pin that is pulled in the middle of a swing, against Lagrange's equations of a chain of three rods.

Until then the second joint is told to keep still, after that it is free; a damped rope at the chain's end
goes slack meanwhile. `lagrange` knows where points of the rods are and how long the rope's way is.
"""

from __future__ import annotations

import numpy as np

from lagrange import Batch, Lagrange, derivative, distance
from mechanics import Floats, Json, adaptive, body, document, end, hinge, rope

MASSES, LENGTHS = np.array([20.0, 30.0, 25.0]), np.array([1.0, 1.2, 0.8])
INERTIAS = MASSES * LENGTHS**2 / 12
ANGLES, RATES = np.array([0.5, -0.6, 0.9]), np.array([0.3, 0.0, -1.0])
#: Where the rope is held [m], EA [N], τ [s]; when the pin is pulled [s].
HELD, EA, TAU = np.array([1.6, 0.0, -2.2]), 8e4, 0.003
PULLED, DURATION = 0.7, 1.3


def rods(q: Batch) -> tuple[list[Batch], Batch]:
    """Two points of half its mass of each rod, which have its inertia, and the chain's end (k, 3) [m]."""
    turned, origin, points = np.cumsum(q, axis=1), np.zeros((len(q), 3), dtype=q.dtype), []
    for k in range(3):
        angle = turned[:, k]
        down = np.stack([-np.sin(angle), np.zeros_like(angle), -np.cos(angle)], axis=1)
        arm = np.sqrt(INERTIAS[k] / MASSES[k])
        points += [origin + down * (LENGTHS[k] / 2 + side * arm) for side in (1, -1)]
        origin = origin + down * LENGTHS[k]
    return points, origin


def points(q: Batch) -> Batch:
    return np.stack(rods(q)[0], axis=1)


def way(q: Batch) -> Batch:
    return distance(rods(q)[1], np.broadcast_to(HELD, (len(q), 3)))[:, None]


LENGTH = float(way(ANGLES[None])[0, 0]) * 0.99


def pull(_: float, q: Floats, v: Floats) -> Floats:
    """T = max(0, k (e + τ ė))."""
    length, gradient = derivative(way, q)
    return np.asarray(-np.maximum(0.0, EA / LENGTH * (length - LENGTH + TAU * (gradient @ v))) @ gradient)


def test_a_pin_is_pulled_in_a_swing() -> None:
    """Angles of all joints before and after, to 1e-7 rad: both are right to some 1e-8."""
    masses = np.repeat(MASSES / 2, 2)
    before, after = np.linspace(0, PULLED, 8), np.linspace(0, DURATION - PULLED, 7)
    held = Lagrange(masses, points, pull, {1: lambda _: 0.0}).run(ANGLES, RATES, before)
    let_go = Lagrange(masses, points, pull).run(held[-1, :3], held[-1, 3:], after)
    own = np.concatenate([held[:-1], let_go])
    bodies = []
    for k in range(3):
        joint = hinge((0, 1, 0), position=ANGLES[k], velocity=RATES[k])
        rod = body(
            f"rod{k}",
            joint | ({"pin": True} if k == 1 else {}),
            MASSES[k],
            parent=f"rod{k - 1}" if k else None,
            position=(0, 0, -LENGTHS[k - 1] if k else 0),
            centre_of_gravity=(0, 0, -LENGTHS[k] / 2),
            inertia=(INERTIAS[k], INERTIAS[k], 0),
        )
        bodies.append(rod)
    plan: list[Json] = [
        {"name": "pinned", "until": {"type": "duration", "duration": PULLED}},
        {"name": "free", "until": {"type": "end_of_run"}, "pulls": ["rod1"]},
    ]
    ropes = [rope("r", LENGTH, [end("rod2", (0, 0, -LENGTHS[2])), end(None, HELD.tolist())], EA, TAU)]
    run = adaptive(
        document(bodies, ropes=ropes, plan=plan),
        DURATION,
        tension_tolerance=1e-3,
        position_tolerance=1e-9,
        sample_interval=0.1,
    )
    found = np.stack([run.joint(f"rod{k}") for k in range(3)], axis=1)
    assert np.abs(found - own[:, :3]).max() < 1e-7
    assert np.abs(found[8:, 1] - ANGLES[1]).max() > 0.5, "what the pin held must move then"
    assert run.events("slack"), "the rope must go slack"
    assert run.energy_remainder < 1e-11
