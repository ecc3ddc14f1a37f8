"""Where a free hull floats: the lowest energy of weight and water, by steps on its exact derivatives.

With h(x) = n . x + d the height over the water, V the volume below, m = int x dV, A, s, Q the section's
area and first and second moment, and V0 = mass/density the volume to displace with the centre of gravity G,
the energy over rho g is

    E(n, d) = -int h dV + V0 (n . G + d)
    dE/dd = V0 - V            dE/dn = V0 G - m
    d2E/dd2 = A               d2E/dd dn = s            d2E/dn2 = Q

and n turns by heel and trim as `Attitude` says.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.arguments import number
from gantline.hydro.attitude import Attitude, attitude_of
from gantline.hydro.hull import Hull, hull_of
from gantline.hydro.hydrostatics import SEA_WATER, Hydrostatics, hydrostatics

__all__ = ["CannotFloatError", "Energy", "Floating", "energy_at", "float_free", "settle"]

Array = npt.NDArray[np.float64]

_STEPS = 200
#: Slope of the energy, over V0 times a metre, at which it rests.
_BALANCED = 1e-12
#: What a step may turn [rad].
_TURN = 0.3


class CannotFloatError(ValueError):
    """A hull that does not float with this weight; the message says why."""


@dataclass(frozen=True)
class Floating:
    """A hull at rest in the water.

    Attributes:
        hydrostatics: in the attitude that it takes.
        centre_of_gravity: of everything, in vessel axes (3,) [m].
        gm: metacentric heights for heel and trim there [m].
        is_stable: True where it comes back from small heel and trim.
    """

    hydrostatics: Hydrostatics
    centre_of_gravity: Array
    gm: tuple[float, float]
    is_stable: bool

    @property
    def attitude(self) -> Attitude:
        """Draft, heel and trim."""
        return self.hydrostatics.attitude


@dataclass(frozen=True)
class Energy:
    """Energy of weight and water over rho g, up to a constant, with derivatives over height, heel and trim.

    Attributes:
        value: E [m^4].
        slope: shape (3,).
        curvature: shape (3, 3).
    """

    value: float
    slope: Array
    curvature: Array


def energy_at(hull: Hull, volume: float, centre: Array, state: Array) -> Energy:
    """E of a hull and its derivatives.

    Args:
        hull: The hull.
        volume: to displace [m^3].
        centre: of gravity, vessel axes (3,) [m].
        state: height of the origin above the water [m], heel and trim [rad], shape (3,).
    """
    height, heel, trim = (float(part) for part in state)
    attitude = Attitude(0.0, heel, trim)
    normal, forward, port = attitude.normal, attitude.forward, attitude.port
    below = hull.below(normal, height)
    lever = volume * centre - below["moment"]
    level = math.cos(trim)
    up = np.array([0.0, math.sin(heel), math.cos(heel)])
    turned = [level * port, forward]
    curved = [[-level * up, -math.sin(trim) * port], [-math.sin(trim) * port, -normal]]
    slope = np.array([volume - below["volume"], *(lever @ turn for turn in turned)])
    curvature = np.zeros((3, 3))
    curvature[0, 0] = below["area"]
    for i in range(2):
        curvature[0, 1 + i] = curvature[1 + i, 0] = below["area_moment"] @ turned[i]
        for j in range(2):
            curvature[1 + i, 1 + j] = turned[i] @ below["area_second"] @ turned[j] + lever @ curved[i][j]
    value = below["depth_moment"] + volume * (normal @ centre + height)
    return Energy(float(value), slope, curvature)


def point(given: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """A centre of gravity (3,) [m].

    Raises:
        ValueError: if it is none.
    """
    try:
        centre = np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError):  # a text, say, or lists of several lengths
        centre = np.zeros(0)
    if centre.shape != (3,):
        raise ValueError(f"centre_of_gravity: {given!r} is no point; x, y and z [m] are needed")
    return centre


def settle(
    hull: Hull,
    volume: float,
    centre: npt.ArrayLike,
    start: tuple[float, float, float],
    *,
    heel: float | None = None,
) -> tuple[Array, bool]:
    """Height of the origin above the water [m], heel and trim [rad] of least energy downhill of `start`.

    Args:
        hull: The hull.
        volume: to displace [m^3].
        centre: of gravity, vessel axes (3,) [m].
        start: height, heel and trim to begin with.
        heel: kept at this angle [rad] where given.

    Returns:
        the state (3,), and whether the energy rises all around it.

    Raises:
        CannotFloatError: if no step leads on.
    """
    gravity = np.asarray(centre, dtype=float)
    free = [0, 2] if heel is not None else [0, 1, 2]
    state = np.array(start, dtype=float)
    if heel is not None:
        state[1] = heel
    size = float(np.linalg.norm(np.ptp(hull.box, axis=0)))
    scale = np.array([volume, volume * size, volume * size])[free]
    here = energy_at(hull, volume, gravity, state)
    damping = 0.0
    for _ in range(_STEPS):
        slope, curvature = here.slope[free], here.curvature[np.ix_(free, free)]
        stiff = np.abs(np.diag(curvature)) + scale / size
        least = float(np.linalg.eigvalsh(curvature / np.sqrt(np.outer(stiff, stiff))).min())
        if np.abs(slope / scale).max() < _BALANCED:
            return state, least > 0
        shift = max(damping, 0.0 if least > 1e-9 else 1e-3 - least)
        step = np.zeros(3)
        step[free] = -np.linalg.solve(curvature + shift * np.diag(stiff), slope)
        step *= min(1.0, _TURN / max(np.abs(step[1:]).max(), 1e-300), 0.2 * size / max(abs(step[0]), 1e-300))
        there = energy_at(hull, volume, gravity, state + step)
        gained, noise = here.value - there.value, 1e-13 * (abs(here.value) + volume * size)
        closer = np.abs(there.slope[free] / scale).max() < np.abs(slope / scale).max()
        if gained > 0 or (abs(gained) <= noise and closer):
            state, here, damping = state + step, there, 0.2 * shift if shift > 1e-6 else 0.0
        elif np.abs(slope / scale).max() < 1e3 * _BALANCED:
            return state, least > 0
        else:
            damping = max(4 * shift, 1e-3)
    raise CannotFloatError(f"{hull.name}: no attitude was found in which it rests")


def float_free(
    hull: Hull,
    mass: float,
    centre_of_gravity: npt.ArrayLike,
    *,
    density: float = SEA_WATER,
    start: Attitude | None = None,
) -> Floating:
    """Where a hull floats with a mass [kg] and its centre of gravity, vessel axes (3,) [m].

    Args:
        hull: The hull.
        mass: of everything [kg].
        centre_of_gravity: of everything, vessel axes (3,) [m].
        density: of the water [kg/m^3].
        start: attitude to begin with; without it upright. The rest found is the one downhill of it.

    Raises:
        CannotFloatError: if it weighs more than all its volume displaces.
        TypeError: if mass or density is no number, the hull none, or the start no attitude.
        ValueError: if the centre of gravity is no point.
    """
    hull_of(hull)
    number(mass, "mass", "kilograms")
    number(density, "density", "kilograms per cubic metre")
    if start is not None:
        attitude_of(start)
    volume, whole = mass / density, hull.closure.volume
    if not 0 < volume < whole:
        raise CannotFloatError(
            f"{hull.name}: {mass / 1e3:g} t displace {volume:.6g} m³ of water, "
            f"and all of the hull has {whole:.6g} m³"
        )
    centre = point(centre_of_gravity)
    low, high = hull.box
    middle = float(low[0] + high[0]) / 2
    if start is None:
        draft = float(low[2] + (high[2] - low[2]) * volume / whole)
        start = Attitude(draft, 0.0, 0.0, middle)
    state, stable = settle(hull, volume, centre, (start.height, start.heel, start.trim))
    height, heel, trim = (float(part) for part in state)
    found = hydrostatics(hull, Attitude.of(height, heel, trim, middle), density)
    return Floating(found, centre, found.gm(centre), stable)
