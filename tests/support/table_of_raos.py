"""Tables of RAOs for tests."""

from __future__ import annotations

import numpy as np

from gantline.hydro.raos import DisplacementRaos

__all__ = ["goes_with_the_water"]


def goes_with_the_water(*, pitch: float = 1.0, heave: float = 1.0) -> DisplacementRaos:
    """A vessel that goes with the water, in waves of 60 s and shorter ones, from following to head seas.

    Args:
        pitch: over the slope of the water, X₅ = -iκ cos β.
        heave: over that of the water.
    """
    frequencies = 2 * np.pi / np.array([60.0, 20.0, 10.0, 5.0])
    directions = np.radians([0.0, 60.0, 120.0, 180.0])
    motion = np.zeros((4, 4, 6), dtype=complex)
    motion[:, :, 2] = heave
    motion[:, :, 4] = -1j * pitch * np.outer(frequencies**2 / 9.81, np.cos(directions))
    return DisplacementRaos("any", frequencies, directions, motion)
