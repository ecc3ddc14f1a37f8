"""Modes of a lift whose motor pulls all it can, after the plan has asked it for the last time.

Its motor is too weak to come where the plan had it, and stands with all its force in the rope. As long as
the plan asked for more it gave way in modes, sensitivities and matrices; from the end of that on rounding
decided whether it did or held like a brake, since it stood at its bound exactly. What one can just hold
drags it along.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mechanics import G, body, document, drum, end, flow, rope, slider
from resting import at_rest

MASS, INERTIA, FALL, STAY = 4000.0, 600.0, 6.0, 4.0
WEIGHT = MASS * G
STRAIN = 1e-5
EA, STIFFNESS, CAPACITY = WEIGHT / STRAIN, 0.4 * WEIGHT, 1.08 * WEIGHT


def winch() -> dict[str, Any]:
    """A load between a winch that hauls for 10 s and a stay below, which is just taut."""
    bodies = [
        body("load", slider((0, 0, -1)), MASS, position=(0, 0, -FALL)),
        flow("drum", INERTIA, drive="motor", capacity=CAPACITY),
    ]
    ropes = [
        rope("fall", FALL / (1 + STRAIN), [drum(None, (0, 0, 0), "drum"), end("load")], EA),
        rope("stay", STAY, [end(None, (0, 0, -FALL - STAY)), end("load")], STIFFNESS * STAY),
    ]
    ramps = [
        {"at": 0.0, "duration": 0.5, "velocity": -0.2},
        {"at": 10.0, "duration": 0.5, "velocity": 0.0},
    ]
    return document(bodies, ropes=ropes, drives=[{"name": "motor", "ramps": ramps}])


@pytest.mark.parametrize("time", [5.0, 9.0, 10.4, 10.5, 12.0, 20.0, 60.0])
def test_the_motor_gives_way_in_modes(time: float) -> None:
    """Drum I and load m on the rope k and the stay: K = [[k, −k], [−k, k + k_s]], M = [I, m]."""
    rest = at_rest(winch(), time)
    assert rest.tensions[0] == pytest.approx(CAPACITY, rel=1e-9)
    up = (CAPACITY - WEIGHT) / STIFFNESS
    stiffness = EA / (FALL - up)
    matrix = np.array([[stiffness, -stiffness], [-stiffness, stiffness + STIFFNESS]])
    squares = np.sort(np.linalg.eigvals(np.diag([1 / INERTIA, 1 / MASS]) @ matrix))
    # Strains of 1e-5 are left out of these equations.
    assert rest.squares == pytest.approx(squares, rel=5e-5)
