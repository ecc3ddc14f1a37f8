"""What waves push a vessel with on the whole, as it makes way through them and a current: Aranha 1994.

A vessel that makes way U in a water that streams with V meets waves of the wave number κ at the frequency
ω − κ e·U, e the direction in which they run, and w = U − V is its way through the water. By what waves carry
along rays, docs/concepts/waves.md derives

    D(w, U) = (1 − A e·w) D(ω − κ e·U, β − t·w/c)    A = κ/ω + 1/c − κ c′/c,

t across e, c = dω/dκ, c′ = dc/dω; in deep water A = 4ω/g. Derivatives over w and U are wave drift damping.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.hydro.database.around import ForcesAround, cubics_around
from gantline.hydro.waves import Components, group_velocity, wave_number

__all__ = ["Drifting", "cubics_over_heading", "mean_drift"]

Array = npt.NDArray[np.float64]

#: Headings that it is computed for: a spline between them is off by 8e-7 of what comes back once in a turn,
#: by 2e-4 of what does four times.
_HEADINGS = np.arange(72) * math.tau / 72


@dataclass(frozen=True, eq=False)
class Drifting:
    """Waves that run in one direction, with what they push a vessel with on the whole.

    Attributes:
        waves: the waves.
        drift: surge, sway and yaw about a point over the amplitude squared.
        over_frequency: its derivative [N s/m², N s/m].
    """

    waves: Components
    drift: ForcesAround
    over_frequency: ForcesAround


def mean_drift(
    pushes: list[Drifting],
    headings: Array,
    *,
    length: float,
    current: tuple[float, float],
    gravity: float,
    depth: float | None,
) -> Array:
    """Of all waves B over surge, sway and yaw, then the push C (h, 3, 4) [N s/m, N s, N m s; N, N m].

    The vessel axes turn with the heading. A turn is taken to be sway of each slice of the length, alike
    everywhere: L²/12 of the damping of sway resists yaw.

    Args:
        pushes: the waves.
        headings: of the vessel, from world x towards y (h,) [rad].
        length: L of the vessel [m].
        current: V, world x and y [m/s].
        gravity: g [m/s^2].
        depth: of the water [m]; None is deep.
    """
    found = np.zeros((len(headings), 3, 4))
    cos, sin = np.cos(headings), np.sin(headings)
    stream = np.stack([cos * current[0] + sin * current[1], cos * current[1] - sin * current[0]], axis=1)
    for one in pushes:
        omega = one.waves.frequency
        number = wave_number(omega, gravity, depth)
        speed, bend = group_velocity(omega, gravity, depth)
        # c′ = dc/dω = (dc/dκ)/c.
        carried = number / omega + 1 / speed - number * bend / speed
        towards = one.waves.direction - headings
        along = np.stack([np.cos(towards), np.sin(towards)], axis=1)
        across = np.stack([-np.sin(towards), np.cos(towards)], axis=1)
        squares = one.waves.amplitude**2
        drift, turned = (values.real for values in one.drift.everywhere(towards))
        met = one.over_frequency.everywhere(towards)[0].real
        over_rays = np.einsum("n,nhi,hj->hij", squares * carried, drift, along)
        over_rays += np.einsum("n,nhi,hj->hij", squares / speed, turned, across)
        over_frequency = np.einsum("n,nhi,hj->hij", squares * number, met, along)
        found[:, :, :2] += over_rays + over_frequency
        found[:, :, 3] += np.einsum("n,nhi->hi", squares, drift) + np.einsum("hij,hj->hi", over_rays, stream)
    found[:, 2, 2] = found[:, 1, 1] * length**2 / 12
    return found


def cubics_over_heading(
    pushes: list[Drifting],
    *,
    length: float,
    current: tuple[float, float],
    gravity: float,
    depth: float | None,
) -> Array:
    """The same as a periodic spline: terms of 1, s, s² and s³ from each heading to the next (h, 4, 3, 4)."""
    found = mean_drift(pushes, _HEADINGS, length=length, current=current, gravity=gravity, depth=depth)
    flat = found.reshape(1, len(_HEADINGS), 12).astype(np.complex128)
    cubics: Array = cubics_around(_HEADINGS, flat)[0].real.reshape(len(_HEADINGS), 4, 3, 4)
    return cubics
