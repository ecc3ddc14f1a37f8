"""Righting arms over heel, free to trim, at constant displacement."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.arguments import number
from gantline.hydro.attitude import Attitude
from gantline.hydro.floating import CannotFloatError, energy_at, point, settle
from gantline.hydro.hull import Hull, hull_of
from gantline.hydro.hydrostatics import SEA_WATER

__all__ = ["Heeled", "Righting", "RightingArms", "righting_arms"]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Heeled:
    """A hull at an angle of heel.

    Attributes:
        heel: The angle [rad].
        trim: that it takes then, by the stern [rad].
        height: of its origin above the water [m].
        arm: horizontal distance of the centre of buoyancy from that of gravity, positive where it rights [m].
        work: energy of weight and water over the weight, up to a constant: what heeling takes [m].
        across: metacentric height for trim there, above zero where it rests and does not lie over [m].
    """

    heel: float
    trim: float
    height: float
    arm: float
    work: float
    across: float

    @property
    def normal(self) -> Array:
        """Upwards, vessel axes (3,)."""
        return Attitude(0.0, self.heel, self.trim).normal


class Righting:
    """A hull that something heels, free to trim, at constant displacement.

    Args:
        hull: The hull.
        mass: of everything [kg].
        centre_of_gravity: of everything, vessel axes (3,) [m].
        density: of the water [kg/m^3].

    Raises:
        CannotFloatError: if it weighs more than all its volume displaces.
    """

    def __init__(
        self, hull: Hull, mass: float, centre_of_gravity: npt.ArrayLike, *, density: float = SEA_WATER
    ) -> None:
        whole = hull.closure.volume
        self._hull, self._volume = hull, mass / density
        if not 0 < self._volume < whole:
            raise CannotFloatError(f"{hull.name}: {mass / 1e3:g} t do not float on {whole:.6g} m³")
        self._centre = np.asarray(centre_of_gravity, dtype=float)
        low, high = hull.box
        middle = float(low[0] + high[0]) / 2
        draft = float(low[2] + (high[2] - low[2]) * self._volume / whole)
        # Height and trim by heel: each search begins where its neighbour towards upright ended. One beyond
        # may have turned over, where the trim that upright leads to has an end.
        self._known = {0.0: (Attitude(draft, 0.0, 0.0, middle).height, 0.0)}

    def at(self, heel: float) -> Heeled:
        """Where it is at an angle of heel, positive to starboard [rad].

        Raises:
            CannotFloatError: if no trim was found in which it rests.
        """
        nearer = (known for known in self._known if 0.0 <= known / heel <= 1.0) if heel else iter((0.0,))
        height, trim = self._known[max(nearer, key=abs)]
        state, _ = settle(self._hull, self._volume, self._centre, (height, heel, trim), heel=heel)
        self._known[heel] = (float(state[0]), float(state[2]))
        attitude = Attitude(0.0, heel, float(state[2]))
        below = self._hull.below(attitude.normal, float(state[0]))
        arm = (self._centre - below["moment"] / below["volume"]) @ attitude.port
        energy = energy_at(self._hull, self._volume, self._centre, state)
        (heave, both), (_, trims) = energy.curvature[np.ix_([0, 2], [0, 2])]
        across = float(trims - both * both / heave) / self._volume
        return Heeled(heel, attitude.trim, float(state[0]), float(arm), energy.value / self._volume, across)


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
        heel: angles, one or several, positive to starboard [rad].
        density: of the water [kg/m^3].
        correction: of free surfaces, which raises the centre of gravity [m].

    Raises:
        CannotFloatError: if it weighs more than all its volume displaces.
        TypeError: if the mass, an angle, the density or the correction is no number, or the hull none.
        ValueError: if the centre of gravity is no point, or an angle more than half a turn.
    """
    hull_of(hull)
    number(mass, "mass", "kilograms")
    number(density, "density", "kilograms per cubic metre")
    number(correction, "correction", "metres")
    angles = _angles(heel)
    centre = point(centre_of_gravity) + np.array([0.0, 0.0, correction])
    righting = Righting(hull, mass, centre, density=density)
    arm, trim = np.zeros_like(angles), np.zeros_like(angles)
    for index in np.argsort(np.abs(angles), kind="stable"):
        there = righting.at(float(angles[index]))
        arm[index], trim[index] = there.arm, there.trim
    return RightingArms(angles, arm, trim)


def _angles(heel: object) -> Array:
    """Angles of heel, one or several, (n,) [rad].

    Raises:
        TypeError: If one is no number.
        ValueError: If one is more than half a turn, as those in degrees are.
    """
    several = heel if isinstance(heel, Iterable) and not isinstance(heel, str) else [heel]
    angles = np.array([number(one, "heel", "radians") for one in several])
    for angle in angles[np.abs(angles) > np.pi]:
        degrees = f"{angle:g} degrees are {np.radians(angle):.4g}"
        raise ValueError(f"heel: {angle:g} rad is more than half a turn; angles are in radians, {degrees}")
    return angles
