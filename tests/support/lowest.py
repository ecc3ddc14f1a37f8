"""A rigid load under one ideal equalizer, by the one number that it can lower: independent of gantline."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
import numpy.typing as npt

__all__ = ["tilt_under_an_equalizer"]

Floats = npt.NDArray[np.float64]
#: Step of differences [m or rad]: f of order 10 m leaves gradients to 1e-11, second derivatives to 1e-7.
_STEP = 1e-4


def tilt_under_an_equalizer(
    along: Sequence[float],
    lengths: Sequence[float],
    lugs: Sequence[Sequence[float]],
    centre: Sequence[float],
    yaw: float,
) -> float:
    """Tilt of a load whose slings hang from sheaves that move up and down in one frame [rad].

    The sum of the sheaves' heights cannot change, so their weights do no work, and the load hangs as low as
    it can: lowest is Σ z over its lugs' places, that is, highest f = Σ (√(L² - d²) + (R p)·z), d the way of
    a lug from below its sheave across, p from the centre of gravity to the lug.

    Args:
        along: Places of the sheaves along the frame, which stands still [m].
        lengths: Lengths of the slings, stretched [m].
        lugs: Places of the lugs on the load [m].
        centre: Its centre of gravity [m].
        yaw: About how the load is turned to the frame [rad].
    """
    arms = np.asarray(lugs, dtype=float) - np.asarray(centre, dtype=float)
    tops = np.array([(x, 0.0) for x in along])

    def reach(motion: Floats) -> float:
        turned = arms @ _rotation(motion[2:]).T
        across = turned[:, :2] + motion[:2] - tops
        upright = np.sqrt(np.square(lengths) - np.square(across).sum(axis=1))
        return float((upright + turned[:, 2]).sum())

    found = _stationary(reach, np.array([0.0, 0.0, 0.0, 0.0, yaw]))
    return math.acos(_rotation(found[2:])[2, 2])


def _rotation(angles: Floats) -> Floats:
    """Turned about z, then y, then x of the load."""
    (cx, cy, cz), (sx, sy, sz) = np.cos(angles), np.sin(angles)
    about_x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    about_y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    about_z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    rotation: Floats = about_z @ about_y @ about_x
    return rotation


def _stationary(value: Callable[[Floats], float], start: Floats) -> Floats:
    """Where all derivatives vanish, by Newton's method on differences."""
    point = start
    steps = _STEP * np.eye(len(start))
    for _ in range(20):
        gradient = np.array([value(point + a) - value(point - a) for a in steps]) / (2 * _STEP)
        curvature = np.array(
            [
                [
                    value(point + a + b) - value(point + a - b) - value(point - a + b) + value(point - a - b)
                    for b in steps
                ]
                for a in steps
            ]
        ) / (4 * _STEP**2)
        change = np.linalg.solve(curvature, gradient)
        point = point - change
        if np.abs(change).max() < 1e-10:
            return point
    raise AssertionError("Newton's method found no place where the load hangs")
