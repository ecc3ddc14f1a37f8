"""A drum under its brake crept by rounding, 1e-19 m a step, which decided which rope it paid out first.

What a brake holds was solved for like all else, so it moved by rounding. A drum that let go later had then
wound up or paid out a last 1e-16 m, and whether that lay over the rope that it took up at the start, with a
strain of its own, was settled by it: of 118 random rigs the masses of which were changed by 2e-15 of
themselves 12 came to other places by `del`, by up to 1e-6 m, and 15 by `adaptive` by more, up to 6e-5 m.
"""

from __future__ import annotations

import numpy as np
import pytest

from mechanics import Json, adaptive, body, document, drum, end, flow, half_turn, rope, simulate, slider

HIGH, RADIUS, EA, MASS = 10.0, 0.4, 3e6, 700.0


def hoist(brake: float) -> Json:
    """A load that starts on slack rope and bounces, over two sheaves with losses, on a drum under a brake."""
    top = half_turn(None, (RADIUS, 0, HIGH), RADIUS, over=True, flow="top", ratio=1.06)
    foot = half_turn(None, (3 * RADIUS, 0, 1.0), RADIUS, over=False, flow="foot", ratio=1.02)
    route = [end("load"), top, foot, drum(None, (4 * RADIUS, 0, HIGH), "winch")]
    bodies = [
        body("load", slider(position=0.02), MASS, position=(0, 0, 2.0)),
        flow("winch", 60.0, brake=brake),
        flow("top", 20.0),
        flow("foot", 0.0),
    ]
    return document(bodies, ropes=[rope("r", None, route, EA, 0.002)])


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_a_held_drum_does_not_move_at_all(method: str) -> None:
    """|F| ≤ F₀ in (F6): ṡ = 0 exactly, so that s is 0 for as long as the brake holds; by 60 kN it does."""
    system = hoist(60e3)
    run = adaptive(system, 2.0) if method == "adaptive" else simulate(system, 2.0, step=1e-3)
    assert float(np.ptp(run.joint("load"))) > 0.01
    assert not run.joint("winch").any()


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_it_slips_where_the_brake_is_too_weak(method: str) -> None:
    """The load alone pulls with m g (1.06 · 1.02)⁻¹ = 6.35 kN at least: 5 kN do not hold it."""
    system = hoist(5e3)
    run = adaptive(system, 2.0) if method == "adaptive" else simulate(system, 2.0, step=1e-3)
    assert run.joint("winch")[-1] > 0.1
