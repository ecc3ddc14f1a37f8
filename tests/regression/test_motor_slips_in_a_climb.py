"""Statics of a winch whose motor can just hold its rope while that climbs to the next layer.

What a rope turns its drum by grows within a climb with what the drum has wound, ρT, so a motor that is too
weak above the climb and strong enough below stands within it. The matrix of statics had no ∂ρ/∂s: steps
went too far, over the joints of pieces of wound rope, and what the motor may hold of the rows, which jumps
there, was set to one value and the other in turn: "lengths that cannot change contradict one another" or
"its friction and what that holds find no balance". 126 of 2592 such winches had no equilibrium. Modes had no
∂ρ/∂s either: what swings about a place within a climb was told neutral.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from mechanics import G, body, document, drum, end, flow, rope, slider
from resting import at_rest

MASS, INERTIA, FALL = 4000.0, 600.0, 6.0
WEIGHT = MASS * G
#: Layers: radius, growth from one to the next as a share of it, turns of a layer; a climb takes half a turn.
RADIUS, GROWTH, TURNS = 0.3, 1 / 6, 1.5
TURN = 2 * math.pi * RADIUS
#: Unstretched length of the stay [m].
STAY = 4.0


def winch(
    start: float, capacity: float, *, strain: float = 1 / 80, laid: float | None = None, stay: float = 0.0
) -> dict[str, Any]:
    """A load on a rope of this `strain` under it, which a drum with `start` turns is to haul in by 2 m.

    Its motor holds `capacity`, the rope on it was wound under `laid`, as shares of the weight; a stay below
    the load, just taut, has the stiffness `stay` [N/m].
    """
    coil = drum(None, (0, 0, 0), "drum")
    coil["drum"]["layers"] = {"radius": RADIUS, "step": GROWTH * RADIUS, "turns": TURNS, "start": start}
    if laid is not None:
        coil["drum"]["laid_under"] = laid * WEIGHT
    ropes = [rope("fall", FALL / (1 + strain), [coil, end("load")], WEIGHT / strain)]
    if stay > 0:
        ropes.append(rope("stay", STAY, [end(None, (0, 0, -FALL - STAY)), end("load")], stay * STAY))
    bodies = [
        body("load", slider((0, 0, -1)), MASS, position=(0, 0, -FALL)),
        flow("drum", INERTIA, drive="motor", capacity=capacity * WEIGHT),
    ]
    ramps = [
        {"at": 0.0, "duration": 0.5, "velocity": -0.2},
        {"at": 10.0, "duration": 0.5, "velocity": 0.0},
    ]
    return document(bodies, ropes=ropes, drives=[{"name": "motor", "ramps": ramps}])


def turns_at(ratio: float) -> float:
    """Turns where ρ is this within the first climb, which begins a quarter of a turn before a full layer."""
    return TURNS - 0.25 + 0.5 * (ratio - 1) / GROWTH


@pytest.mark.parametrize("time", [2.0, 20.0])
@pytest.mark.parametrize("laid", [None, 0.4, 1.1])
def test_the_drum_stands_where_the_motor_can_hold(time: float, laid: float | None) -> None:
    """T = mg; from ρ = 1.05 it is dragged, however the rope was wound, to ρ = 1.03 = F̂/mg."""
    rest = at_rest(winch(1.4, 1.03, laid=laid), time)
    assert rest.tensions[0] == pytest.approx(WEIGHT, rel=1e-8)
    # By the radius grows with the turns, 1e-9 of the force is 1e-9/0.18 m on the first layer.
    assert rest.joint("drum") == pytest.approx((1.4 - turns_at(1.03)) * TURN, abs=1e-7)


@pytest.mark.parametrize("capacity", [1.08, 1.1, 1.14, 1.16])
@pytest.mark.parametrize("laid", [None, 0.0, 0.9, 2.0])
def test_a_load_that_is_stayed_is_hauled_up_as_far_as_the_motor_can(
    capacity: float, laid: float | None
) -> None:
    """F̂ = ρT, T = mg + k u, the load u up, and what is wound at each strain on the way.

    With ε = T/EA and the length ℓ − u outside dL = −dw/(1 + ε) of L = (ℓ − u)/(1 + ε), so that

        w = u + ∫ (ℓ − u) ε'/(1 + ε) du      and      w = ∫ ρ ds = s + c² GROWTH TURN/4,

    s on the first layer, c the part of the climb that is done, which is half a turn long.
    """
    stiffness, strain = 0.4 * WEIGHT, 1 / 80
    slope = stiffness * strain / WEIGHT

    def wound(up: float) -> float:
        return float(up + quad(lambda u: (FALL - u) * slope / (1 + strain + slope * u), 0, up)[0])

    def climbed(up: float) -> float:
        ratio = capacity * WEIGHT / (WEIGHT + stiffness * up)
        return (turns_at(ratio) - 1.2) * TURN + (ratio - 1) ** 2 / GROWTH * TURN / 4

    up = brentq(lambda up: wound(up) - climbed(up), 0.0, (capacity - 1) * WEIGHT / stiffness, xtol=1e-14)
    tension = WEIGHT + stiffness * up
    rest = at_rest(winch(1.2, capacity, laid=laid, stay=stiffness), 20.0)
    # Parts of the way are so short that they leave 1e-9 m each of what is wound, some hundred of them.
    assert -rest.joint("load") == pytest.approx(up, abs=1e-7)
    assert rest.tensions[0] == pytest.approx(tension, abs=1e-7 * stiffness)
    assert -rest.joint("drum") == pytest.approx(
        (turns_at(capacity * WEIGHT / tension) - 1.2) * TURN, abs=1e-6
    )


def test_it_swings_about_that_place() -> None:
    """Drum I and load m on the rope k, and T ∂ρ/∂s at the drum: K = [[k ρ² + mg ρ', −k ρ], [−k ρ, k]].

    Without ρ' the slower motion is none, and was told neutral.
    """
    strain = 1e-5
    rest = at_rest(winch(1.4, 1.03, strain=strain), 20.0)
    assert (rest.found["unstable"], rest.found["neutral"]) == (0, 0)
    ratio, slope = 1.03, 2 * GROWTH / TURN
    stiffness = WEIGHT / strain / (FALL + (1.4 - turns_at(1.03)) * TURN * 1.04)
    matrix = stiffness * np.array([[ratio**2, -ratio], [-ratio, 1]])
    matrix[0, 0] += WEIGHT * slope
    squares = np.sort(np.linalg.eigvals(np.diag([1 / INERTIA, 1 / MASS]) @ matrix))
    # Strains of 1e-5 are left out of these equations; what swings slowly takes m g ρ'/(I + ρ² m).
    assert rest.squares == pytest.approx(squares, rel=5e-5)
    assert squares[0] == pytest.approx(WEIGHT * slope / (INERTIA + ratio**2 * MASS), rel=1e-4)
