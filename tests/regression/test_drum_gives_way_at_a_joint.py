"""Statics of a motor that slips where the rope on its drum was wound under quite another tension.

The rows of a rope turn a drum by ρT(1 + ε/2)/(1 + ε_d), its rim by ρT, so what a motor holds of the rows
jumps where a piece of wound rope with another ε_d begins. A search that began with what belongs to neither
stood between them, with more at one side and less at the other: "no step brings its forces closer to
balance". Of 2425 winches that hauled or lowered at the limit of their motors 58 ended so. And before the
tension is known all the motor's force was taken for what it holds of the rows, ε/2 too little where the rope
was wound slack: a load that it can hold by less than that fell without end.
"""

from __future__ import annotations

import math
from typing import Any

import pytest

from mechanics import G, body, document, drum, end, flow, rope, slider
from resting import at_rest

MASS, FALL, STAY = 4000.0, 6.0, 4.0
WEIGHT = MASS * G
STRAIN = 1 / 80
EA = WEIGHT / STRAIN


def winch(capacity: float, laid: float, stay: float, speed: float) -> dict[str, Any]:
    """A load on a rope from a drum whose motor holds `capacity`, wound under `laid`, shares of the weight.

    A stay below the load, just taut, has the stiffness `stay` [N/m].
    """
    coil = drum(None, (0, 0, 0), "drum")
    coil["drum"]["laid_under"] = laid * WEIGHT
    ropes = [rope("fall", FALL / (1 + STRAIN), [coil, end("load")], EA)]
    if stay > 0:
        ropes.append(rope("stay", STAY, [end(None, (0, 0, -FALL - STAY)), end("load")], stay * STAY))
    bodies = [
        body("load", slider((0, 0, -1)), MASS, position=(0, 0, -FALL)),
        flow("drum", 600.0, drive="motor", capacity=capacity * WEIGHT),
    ]
    ramps = [{"at": 0.0, "duration": 0.5, "velocity": speed}]
    return document(bodies, ropes=ropes, drives=[{"name": "motor", "ramps": ramps}])


@pytest.mark.parametrize("laid", [0.0, 1.0, 2.0, 3.0])
@pytest.mark.parametrize("time", [1.0, 5.0, 20.0])
def test_a_stayed_load_is_hauled_up_as_far_as_the_motor_can(laid: float, time: float) -> None:
    """T = mg + k u = F̂, the load u up, w wound: dL = −dw/(1 + ε) of L = (ℓ − u)/(1 + ε), so that

    w = u + ∫ (ℓ − u) ε'/(1 + ε) du = (ℓ + (1 + ε₀)/ε') ln(1 + ε' u/(1 + ε₀)).
    """
    stiffness, capacity = 0.4 * WEIGHT, 1.01
    up = (capacity - 1) * WEIGHT / stiffness
    slope = stiffness / EA
    wound = (FALL + (1 + STRAIN) / slope) * math.log1p(slope * up / (1 + STRAIN))
    rest = at_rest(winch(capacity, laid, stiffness, -0.2), time)
    assert rest.tensions[0] == pytest.approx(capacity * WEIGHT, rel=1e-8)
    assert -rest.joint("load") == pytest.approx(up, abs=1e-7)
    # Parts of the way are so short that they leave 1e-9 m each of what is wound.
    assert -rest.joint("drum") == pytest.approx(wound, abs=1e-7)


def test_what_the_motor_can_just_hold_does_not_fall() -> None:
    """mg = T < F̂ = 1.005 mg, ε/2 = 0.00625: it hangs where it starts."""
    rest = at_rest(winch(1.005, 0.0, 0.0, 0.0))
    assert rest.tensions[0] == pytest.approx(WEIGHT, rel=1e-9)
    assert rest.joint("drum") == pytest.approx(0.0, abs=1e-9)
