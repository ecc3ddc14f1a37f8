"""How a vessel lies in the water, from the orientation and height of its axes.

n = Rᵀ ẑ is the upward direction in its axes. Trim and heel are those of `gantline.hydro.Attitude`, asin n_x
and atan2(n_y, n_z); the draft at a station is the z of the water in the centre plane there,
(VE2) of docs/concepts/vessels.md.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gantline.results.variable import FloatArray

__all__ = ["Lie"]

#: Least cosine by which drafts are divided: close to 90 deg of heel or trim no draft means anything.
_UPRIGHT = 1e-6


class Lie(NamedTuple):
    """Of one vessel, at one time or at many.

    Attributes:
        turn: World from vessel, shape (..., 3, 3).
        height: Of its origin above the water, shape (...) [m].
    """

    turn: FloatArray
    height: FloatArray

    @property
    def up(self) -> FloatArray:
        """Upwards, vessel axes, shape (..., 3)."""
        return self.turn[..., 2, :]

    @property
    def heel(self) -> FloatArray:
        """To starboard positive, shape (...) [rad]."""
        angle: FloatArray = np.arctan2(self.up[..., 1], self.up[..., 2])
        return angle

    @property
    def trim(self) -> FloatArray:
        """By the stern positive, shape (...) [rad]."""
        angle: FloatArray = np.arcsin(np.clip(self.up[..., 0], -1.0, 1.0))
        return angle

    def at_lean(self, heel: FloatArray, trim: FloatArray) -> FloatArray:
        """Upwards where it lies with another heel and trim, vessel axes, shape (..., 3).

        Args:
            heel: Change of its heel, shape (...) [rad].
            trim: Change of its trim, shape (...) [rad].
        """
        heel, trim = self.heel + heel, self.trim + trim
        return np.stack((np.sin(trim), np.cos(trim) * np.sin(heel), np.cos(trim) * np.cos(heel)), axis=-1)

    def draft(self, station: float) -> FloatArray:
        """At `station` [m] along it, along its own z in the centre plane, shape (...) [m]."""
        steep = np.where(
            np.abs(self.up[..., 2]) < _UPRIGHT, np.copysign(_UPRIGHT, self.up[..., 2]), self.up[..., 2]
        )
        found: FloatArray = -(self.height + self.up[..., 0] * station) / steep
        return found

    def leans(self, rotation: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Change of heel and trim by a small turn, each of shape (...) [rad].

        Args:
            rotation: The turn, world axes, shape (..., 3) [rad].
        """
        # Ẑ-parts of ω × x, ω × y, ω × z: what n changes by.
        change = np.einsum("...i,...ij->...j", np.cross((0.0, 0.0, 1.0), rotation), self.turn)
        up = self.up
        heel = (up[..., 2] * change[..., 1] - up[..., 1] * change[..., 2]) / (
            up[..., 1] ** 2 + up[..., 2] ** 2
        )
        return heel, change[..., 0] / np.cos(self.trim)
