"""A sheave with inertia went on turning after its rope had parted, and the run ended there.

What passes a sheave changes the unstretched lengths beside it, (F1), of a rope that nothing holds any more
too. When nothing was left of one the run stopped: "the step fell below 0.0000000001 s: forces change faster
than any step can follow (f4)", by `del` "the equations are singular here". The equalizing rope of a
snatched equalizer with losses and inertia broke, and 0.4 s later the run could not go on.
"""

from __future__ import annotations

import math

import pytest

from mechanics import Json, adaptive, body, document, end, flow, half_turn, rope, simulate, slider

CUT, LASTS = 0.5, 6.0
HIGH, RADIUS, EA = 3.0, 0.4, 5e6


def atwood(ratio: float) -> Json:
    """Unlike weights over a sheave of 50 kg, the rope of which is cut as they go."""
    bodies = [
        body("heavy", slider(), 1200.0, position=(-RADIUS, 0, 0)),
        body("light", slider(), 800.0, position=(RADIUS, 0, 0)),
        flow("sheave", 50.0),
    ]
    over = half_turn(None, (0, 0, HIGH), RADIUS, over=True, flow="sheave", ratio=ratio)
    line = rope("r", None, [end("heavy"), over, end("light")], EA)
    return document(bodies, ropes=[line | {"cut_at": CUT}])


@pytest.mark.parametrize("ratio", [1.0, 1.05])
@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_a_sheave_turns_on_evenly(method: str, ratio: float) -> None:
    """F ≤ σ (T₁ + T₂) = 0 in (F6): ṡ stays as it is, past what there was of the rope on either side."""
    system = atwood(ratio)
    run = (
        adaptive(system, LASTS)
        if method == "adaptive"
        else simulate(system, LASTS, step=1e-3, sample_interval=0.01)
    )
    assert [at for at, _ in run.events("cut")] == [pytest.approx(CUT)]
    after = run.time >= CUT + 0.01
    time, passed = run.time[after], run.joint("sheave")[after]
    speed = (passed[-1] - passed[0]) / (time[-1] - time[0])
    assert passed == pytest.approx(passed[0] + speed * (time - time[0]), abs=1e-9)
    # More than there was on either side.
    assert abs(passed[-1]) > HIGH + math.pi * RADIUS / 2 + 1.0
    assert run.energy_remainder < 1e-6
