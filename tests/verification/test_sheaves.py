"""Ropes over real sheaves: true tangents, variable wrap, fleet angles; integrator `adaptive`."""

from __future__ import annotations

import math

import numpy as np
import pytest

from mechanics import G, Json, adaptive, body, document, end, free, half_turn, point, rope, sheave, slider


def atwood(guide: Json) -> Json:
    """10 and 12 kg over one held sheave of radius 0.5 m at z = 10 m."""
    bodies = [
        body("light", slider(), 10.0, position=(-0.5, 0, 5)),
        body("heavy", slider(), 12.0, position=(0.5, 0, 5)),
    ]
    return document(bodies, ropes=[rope("r", None, [end("light"), guide, end("heavy")], 1e7, 0.01)])


def test_atwood_machine() -> None:
    """T = 2 m₁ m₂ g/(m₁ + m₂) and a = (m₂ − m₁) g/(m₁ + m₂), once the rope has stopped ringing."""
    run = adaptive(atwood(sheave(None, (0, 0, 10), (0, 1, 0), 0.5)), 1.0, tension_tolerance=1e-4)
    assert run.tension("r")[-1] == pytest.approx(2 * 10 * 12 * G / 22, rel=1e-6)
    velocity = run.body("heavy", "body_velocity")[:, 2]
    # Parts of the ropes stretch by T L/EA: 0.1 mm of 9.81/44 m.
    assert velocity[-1] == pytest.approx(-2 * G / 22 * 1.0, rel=1e-3)


def test_half_turn_and_sheave_agree_between_vertical_parts() -> None:
    """With plumb parts the true tangents are the paper's fixed points: the same motion."""
    real = adaptive(atwood(sheave(None, (0, 0, 10), (0, 1, 0), 0.5)), 1.0)
    fixed = adaptive(atwood(half_turn(None, (0, 0, 10), 0.5, over=True)), 1.0)
    assert np.abs(real.joint("heavy") - fixed.joint("heavy")).max() < 1e-9
    assert np.abs(real.tension("r") - fixed.tension("r")).max() < 1e-3


def test_load_hung_from_two_sheaves_in_equilibrium() -> None:
    """A load in the bight between two sheaves with counterweights: sin α = m/(2 M) where ropes leave."""
    weight, load, distance, radius = 100.0, 120.0, 8.0, 0.6
    alpha = math.asin(load / (2 * weight))
    # Outer sides plumb, inner sides inclined by α below the horizontal, tangent to the sheaves.
    inner = (distance / 2 - radius * math.sin(alpha)) / math.cos(alpha)
    z_load = 20.0 + radius * math.cos(alpha) - inner * math.sin(alpha)
    bodies = [
        body("left", slider(damping=200.0), weight, position=(-distance / 2 - radius, 0, 12)),
        body("right", slider(damping=200.0), weight, position=(distance / 2 + radius, 0, 12)),
        body("load", slider(damping=200.0), load, position=(0, 0, z_load + 0.5)),
    ]
    ropes = [
        rope(
            side,
            None,
            [end(side), sheave(None, (x, 0, 20), (0, 1, 0) if x < 0 else (0, -1, 0), radius), end("load")],
            1e8,
            0.01,
        )
        for side, x in (("left", -distance / 2), ("right", distance / 2))
    ]
    run = adaptive(document(bodies, ropes=ropes), 200.0, tension_tolerance=1e-2, sample_interval=1.0)
    # EA = 1e8 N: ropes of 13 m stretch by 0.13 mm.
    assert run.body("load")[-1, 2] == pytest.approx(z_load, abs=1e-3)
    assert run.tension("left")[-1] == pytest.approx(weight * G, rel=1e-4)


def test_swing_under_a_sheave_keeps_its_energy() -> None:
    """A load swings in space under a sheave askew, on an undamped rope: nothing may be lost.

    Fleet angles, wrap and free length change; the gradient must be the derivative of the length.
    """
    bodies = [
        body("counterweight", slider(), 122.0, position=(-0.6, 0.1, 4)),
        body("load", point((2.0, 1.5, 3.0), (0.3, -0.4, 0.0)), 120.0),
    ]
    guide = sheave(None, (0, 0, 10), (0.3, 1.0, 0.2), 0.5)
    system = document(bodies, ropes=[rope("r", None, [end("counterweight"), guide, end("load")], 2e5)])
    run = adaptive(system, 3.0, tension_tolerance=1e-4, position_tolerance=1e-8)
    stored = run.energy("kinetic") + run.energy("gravity") + run.energy("elastic")
    assert np.ptp(run.body("load")[:, 1]) > 1.0, "it must swing across"
    assert np.abs(stored - stored[0]).max() < 1e-6 * run.energy("kinetic").max()
    assert run.energy_remainder < 1e-8


def test_free_sheave_block_in_the_bight_of_a_rope() -> None:
    """A free sheave block rolls down a slack rope and swings: one tension, the books close."""
    bodies = [body("block", free((0.1, 0.05, 4.0)), 500.0, inertia=(60, 60, 60))]
    guide = sheave("block", (0, 0, 0.5), (0, -1, 0), 0.4)
    ends = [end(None, (-1.0, 0, 12)), guide, end(None, (1.0, 0, 12))]
    system = document(bodies, ropes=[rope("r", 17.0, ends, 1e7, 0.2)])
    run = adaptive(system, 3.0, tension_tolerance=1.0)
    force = run.columns["segment_tension"]
    assert np.array_equal(force[:, 0], force[:, 1]), "an ideal sheave passes tension on"
    assert force.max() > 500.0 * G / 2, "it has come to hang"
    assert run.energy_remainder < 1e-6
