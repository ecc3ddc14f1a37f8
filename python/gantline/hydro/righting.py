"""Righting arms over heel, free to trim, at constant displacement."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.hydro.attitude import Attitude
from gantline.hydro.floating import CannotFloatError, settle
from gantline.hydro.hull import Hull
from gantline.hydro.hydrostatics import SEA_WATER

__all__ = ["RightingArms", "righting_arms"]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class RightingArms:
    """Righting arms over heel.

    Attributes:
        heel: angles [rad].
        arm: horizontal distance of the centre of buoyancy from that of gravity, positive where it rights [m].
        trim: that the vessel takes then, by the stern [rad].
    """

    heel: Array
    arm: Array
    trim: Array

    @property
    def area(self) -> float:
        """Area below the curve [m rad], to small trim the work of heeling over the weight."""
        return float(np.trapezoid(self.arm, self.heel))


def righting_arms(
    hull: Hull,
    mass: float,
    centre_of_gravity: npt.ArrayLike,
    heel: Sequence[float] | Array,
    *,
    density: float = SEA_WATER,
    correction: float = 0.0,
) -> RightingArms:
    """Righting arms of a hull at angles of heel, free to trim.

    Args:
        hull: The hull.
        mass: of everything [kg].
        centre_of_gravity: of everything, vessel axes (3,) [m].
        heel: angles, positive to starboard [rad].
        density: of the water [kg/m^3].
        correction: of free surfaces, which raises the centre of gravity [m].

    Raises:
        CannotFloatError: if it weighs more than all its volume displaces.
    """
    volume, whole = mass / density, hull.closure.volume
    if not 0 < volume < whole:
        raise CannotFloatError(f"{hull.name}: {mass / 1e3:g} t do not float on {whole:.6g} m³")
    centre = np.asarray(centre_of_gravity, dtype=float) + np.array([0.0, 0.0, correction])
    low, high = hull.box
    middle = float(low[0] + high[0]) / 2
    start = Attitude(float(low[2] + (high[2] - low[2]) * volume / whole), 0.0, 0.0, middle).height
    angles = np.asarray(heel, dtype=float)
    order = np.argsort(np.abs(angles), kind="stable")
    arm, trim = np.zeros_like(angles), np.zeros_like(angles)
    last = {True: (start, 0.0), False: (start, 0.0)}  # from the neighbour on the same side
    for index in order:
        angle = float(angles[index])
        height, tilt = last[angle >= 0]
        state, _ = settle(hull, volume, centre, (height, angle, tilt), heel=angle)
        last[angle >= 0] = (float(state[0]), float(state[2]))
        attitude = Attitude(0.0, angle, float(state[2]))
        below = hull.below(attitude.normal, float(state[0]))
        arm[index] = (centre - below["moment"] / below["volume"]) @ attitude.port
        trim[index] = attitude.trim
    return RightingArms(angles, arm, trim)
