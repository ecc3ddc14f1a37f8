"""A box on tops of supports, as documents of the core."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from mechanics import Floats, Run

SIZE, MASS = np.array([3.0, 3.4, 2.6]), 20e3
INERTIA = MASS / 12 * ((SIZE**2).sum() - SIZE**2)
STIFFNESS, DAMPED = 40e6, 0.02


def sides(size: Floats) -> list[list[list[float]]]:
    """Corners of the sides of a box about its middle, anticlockwise from outside."""
    found = []
    for axis in range(3):
        first, second = (axis + 1) % 3, (axis + 2) % 3
        for sign in (-1, 1):
            around = [(-1, -1), (1, -1), (1, 1), (-1, 1)][::sign]
            corners = np.zeros((4, 3))
            corners[:, axis] = sign
            corners[:, first], corners[:, second] = np.array(around).T
            found.append((corners * size / 2).tolist())
    return found


def support(name: str, x: float, y: float, **changes: Any) -> dict[str, Any]:
    law = {"stiffness": STIFFNESS, "damping_time": DAMPED, "friction": 0.5}
    top = {"at": [x, y, 0.0], "half": [0.3, 0.3], "along": [1.0, 0.0, 0.0]}
    return {"name": name, "group": "box", "body": "box", "sides": sides(SIZE), **top, **law, **changes}


def turn(axis: int, angle: float) -> list[float]:
    """Quaternion of a turn about an axis of the world."""
    found = [math.cos(angle / 2), 0.0, 0.0, 0.0]
    found[1 + axis] = math.sin(angle / 2)
    return found


def force(done: Run, name: str) -> Floats:
    return done.columns["contact_force"][:, done.names["contact"].index(name)]
