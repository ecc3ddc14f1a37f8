"""Tables of RAOs for tests."""

from __future__ import annotations

import numpy as np

from gantline.hydro.raos import DisplacementRaos

__all__ = ["ON_DECK", "goes_with_the_water"]

#: A deckhouse of the vessel `vessel`, on which the load `load` may be set down, as a section of a lift file.
ON_DECK = """\
mechanics:
  bodies:
    house:
      parent: vessel
      at: [50 m, 0 m, 8 m]
      joint: {type: fixed}
      mass: 1 t
      shape: {box: [12 m, 8 m, 1 m]}
  body_contacts:
    on_deck: {between: [load, house], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}
"""


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
