"""How a vessel lies in the water: draft, heel and trim, and the water's plane in the vessel's axes.

The vessel is trimmed first and then heeled about its own long axis. With heel phi and trim tau the upward
direction is

    n = (sin tau, cos tau sin phi, cos tau cos phi)

in its axes, and h(x) = n . x + d the height of a point over the water.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.arguments import needed, number

__all__ = ["Attitude", "attitude_of"]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Attitude:
    """Draft, heel and trim.

    Attributes:
        draft: from z = 0 to the water, along the vessel's z at `middle` in the centre plane [m].
        heel: positive to starboard [rad].
        trim: positive by the stern [rad].
        middle: x where the draft is measured [m].
    """

    draft: float
    heel: float = 0.0
    trim: float = 0.0
    middle: float = 0.0

    @property
    def normal(self) -> Array:
        """Upwards, in the vessel's axes (3,)."""
        level = math.cos(self.trim)
        return np.array(
            [math.sin(self.trim), level * math.sin(self.heel), level * math.cos(self.heel)], dtype=float
        )

    @property
    def height(self) -> float:
        """Height d of the vessel's origin above the water [m]."""
        normal = self.normal
        return float(-normal[0] * self.middle - normal[2] * self.draft)

    @property
    def forward(self) -> Array:
        """Horizontally forward, in the vessel's axes (3,)."""
        tilted = math.sin(self.trim)
        return np.array(
            [math.cos(self.trim), -tilted * math.sin(self.heel), -tilted * math.cos(self.heel)], dtype=float
        )

    @property
    def port(self) -> Array:
        """Horizontally to port, in the vessel's axes (3,)."""
        return np.array([0.0, math.cos(self.heel), -math.sin(self.heel)])

    def draft_at(self, x: float) -> float:
        """Draft in the centre plane at a place along the vessel [m], along the vessel's z."""
        normal = self.normal
        return float(self.draft - normal[0] / normal[2] * (x - self.middle))

    @classmethod
    def of(cls, height: float, heel: float, trim: float, middle: float) -> Attitude:
        """The attitude in which the vessel's origin is `height` [m] above the water."""
        flat = cls(0.0, heel, trim, middle)
        normal = flat.normal
        return cls(float(-(height + normal[0] * middle) / normal[2]), heel, trim, middle)


def attitude_of(given: object) -> Attitude:
    """An attitude as it is.

    Raises:
        TypeError: If it is none, such as a draft alone, or a part of it is no number.
    """
    found = needed(given, Attitude, "an attitude", "gantline.hydro.Attitude(4.0) has a draft of 4 m")
    for name, unit in (("draft", "metres"), ("heel", "radians"), ("trim", "radians"), ("middle", "metres")):
        number(getattr(found, name), name, unit)
    return found
