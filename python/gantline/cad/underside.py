"""How low triangles come over a rectangle."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

__all__ = ["lowest_over"]

Array = npt.NDArray[np.float64]


def lowest_over(corners: Array, half: tuple[float, float]) -> float | None:
    """Lowest z of triangles over a rectangle about the origin [m]; None where none is over it.

    Args:
        corners: of each triangle (m, 3, 3), x and y along the sides of the rectangle [m].
        half: half of its two sides [m].
    """
    low, high = corners.min(axis=1), corners.max(axis=1)
    is_near = (np.abs(low + high)[:, :2] / 2 <= (high - low)[:, :2] / 2 + np.array(half)).all(axis=1)
    near = np.flatnonzero(is_near)
    lowest: float | None = None
    # From the lowest on: most are higher than what has been found by then.
    for place in near[np.argsort(low[near, 2], kind="stable")]:
        if lowest is not None and low[place, 2] >= lowest:
            break
        piece = list(corners[place])
        for axis in (0, 1):
            for side in (-1.0, 1.0):
                piece = _cut(piece, axis, side, half[axis])
        if piece:
            found = float(min(corner[2] for corner in piece))
            lowest = found if lowest is None else min(lowest, found)
    return lowest


def _cut(corners: list[Array], axis: int, side: float, most: float) -> list[Array]:
    """What of a convex outline has side times its coordinate not above `most` (Sutherland, Hodgman)."""
    out = [side * float(corner[axis]) - most for corner in corners]
    found = []
    for place, corner in enumerate(corners):
        before = place - 1
        if (out[place] > 0.0) != (out[before] > 0.0):
            share = out[before] / (out[before] - out[place])
            found.append(corners[before] + share * (corner - corners[before]))
        if out[place] <= 0.0:
            found.append(corner)
    return found
