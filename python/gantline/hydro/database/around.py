"""Wave forces between the frequencies and between the directions of a file."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
import numpy.typing as npt

__all__ = ["ForcesAround", "all_round", "beside", "cubics_around"]

Array = npt.NDArray[np.float64]
Complex = npt.NDArray[np.complex128]
Values = TypeVar("Values", npt.NDArray[np.float64], npt.NDArray[np.complex128])

#: Directions that are the same [rad].
_SAME = math.radians(1e-6)
#: The highest frequency of a file may come with another last digit.
_ROUNDED = 1e-6
#: Directions that are further apart have nothing to say of what is between them [rad].
_WIDEST = math.radians(60.0) + _SAME


def beside(known: Array, wanted: float) -> tuple[int, float, float] | None:
    """The direction before one, the share of the way to the next, and how far that is from it [rad].

    The last two are 0 where the direction is known; None is a gap of more than 60°.

    Args:
        known: directions (k,) [rad].
        wanted: a direction [rad].
    """
    ahead, behind = (known - wanted) % math.tau, (wanted - known) % math.tau
    after, before = int(np.argmin(ahead)), int(np.argmin(behind))
    gap = float(ahead[after] + behind[before])
    if min(ahead[after], behind[before]) < _SAME:
        return (after if ahead[after] < behind[before] else before), 0.0, 0.0
    return (before, float(behind[before]) / gap, gap) if gap <= _WIDEST else None


def all_round(directions: Array, forces: Values, mirror: Array | None) -> tuple[Values, Array]:
    """Forces by rising direction, mirrored where the other side has none, and these directions [rad].

    A file for a body with two sides alike needs half of the directions.

    Args:
        directions: of the file (k,) [rad].
        forces: (n, k, m).
        mirror: sign of each on the other side (m,); None of a body that has no two sides alike.
    """
    missing = np.array([mirror is not None and beside(directions, -angle) is None for angle in directions])
    own = np.degrees(directions)
    around = np.round(np.concatenate([own, -own[missing]]), 6) % 360.0
    order = np.unique(around, return_index=True)[1]
    both = np.concatenate([forces, forces[:, missing] * (1.0 if mirror is None else mirror)], axis=1)
    return both[:, order], np.radians(around[order])


@dataclass(frozen=True, eq=False)
class ForcesAround:
    """Forces of some waves, over their amplitude or its square, by the direction that these run in.

    Attributes:
        directions: from x towards y, rising from 0 to below 2π (k,) [rad].
        cubics: terms of 1, s, s² and s³, s the share of the way from a direction to the next
            (n, k, 4, 6) [N/m, N]; of drift forces (n, k, 4, 3) [N/m², N/m].
    """

    directions: Array
    cubics: Complex

    @classmethod
    def between(cls, known: Array, forces: Complex, frequency: Array, directions: Array) -> ForcesAround:
        """By cubic splines, over frequency and over direction.

        Above the highest frequency there is nothing, below the lowest it is as at the lowest.

        Args:
            known: frequencies, rising (m,) [rad/s].
            forces: (m, k, 6) [N/m, N].
            frequency: of waves (n,) [rad/s].
            directions: as the attribute.
        """
        from scipy.interpolate import CubicSpline  # takes a second to load

        given = (frequency <= known[-1] * (1 + _ROUNDED))[:, np.newaxis, np.newaxis]
        wanted = np.clip(frequency, known[0], known[-1])
        smooth = CubicSpline(known, forces)(wanted) if len(known) > 1 else forces
        return cls(directions, cubics_around(directions, np.where(given, smooth, 0.0)))

    @classmethod
    def drifts_between(
        cls, known: Array, drifts: Array, frequency: Array, directions: Array, *, derivative: int = 0
    ) -> ForcesAround:
        """Drift forces, surge, sway and yaw, by cubics that keep their sign and shape over frequency.

        Near a resonance they rise and fall by far within a second of period; a spline would go below zero
        beside it. Beyond the frequencies of the file they are as at its ends: waves that are short beside a
        body are thrown back whole whatever their length.

        Args:
            known: frequencies, rising (m,) [rad/s].
            drifts: (m, k, 3) [N/m², N/m].
            frequency: of waves (n,) [rad/s].
            directions: as the attribute.
            derivative: over the frequency, 0 or 1.
        """
        from scipy.interpolate import PchipInterpolator  # takes a second to load

        wanted = np.clip(frequency, known[0], known[-1])
        if len(known) > 1:
            smooth = PchipInterpolator(known, drifts)(wanted, derivative)
        else:
            smooth = np.repeat(drifts, len(frequency), axis=0)
        if derivative:
            changes = (wanted == frequency) & (len(known) > 1)
            smooth = np.where(changes[:, np.newaxis, np.newaxis], smooth, 0.0)
        return cls(directions, cubics_around(directions, np.asarray(smooth, dtype=np.complex128)))

    def at(self, direction: float) -> Complex | None:
        """Those of waves in one direction [rad], shape (n, 6 or 3); None in a gap of more than 60°."""
        place = beside(self.directions, direction)
        if place is None:
            return None
        before, share, _ = place
        found: Complex = np.einsum("npj,p->nj", self.cubics[:, before], share ** np.arange(4))
        return found

    def everywhere(self, directions: Array) -> tuple[Complex, Complex]:
        """Those of waves in any directions (m,) [rad], and their derivatives over these (n, m, 6 or 3)."""
        way = self.directions[0] + (directions - self.directions[0]) % math.tau
        place = np.searchsorted(self.directions, way, side="right") - 1
        gaps = np.diff(self.directions, append=self.directions[0] + math.tau)[place, np.newaxis]
        share = (way - self.directions[place])[:, np.newaxis] / gaps
        power = np.arange(4)
        terms = (share**power, power * share ** np.maximum(power - 1, 0) / gaps)
        found, slope = (np.einsum("nmpj,mp->nmj", self.cubics[:, place], term) for term in terms)
        return found, slope


def cubics_around(directions: Array, forces: Complex) -> Complex:
    """A periodic spline, or one along each run of directions and straight lines across what is missing.

    Args:
        directions: rising within a turn (k,) [rad].
        forces: (n, k, m).

    Returns:
        Terms of 1, s, s² and s³ from each direction to the next, s the share of the way (n, k, 4, m).
    """
    count = len(directions)
    gaps = np.diff(directions, append=directions[0] + math.tau)
    cubics = np.zeros((len(forces), count, 4, forces.shape[2]), dtype=np.complex128)
    cubics[:, :, 0], cubics[:, :, 1] = forces, np.roll(forces, -1, axis=1) - forces
    wide = np.flatnonzero(gaps > _WIDEST)
    if not len(wide):
        _fill(cubics, forces, gaps, np.arange(count + 1), periodic=True)
    for last, end in zip(wide, np.append(wide[1:], wide[:1] + count), strict=True):
        _fill(cubics, forces, gaps, np.arange(last + 1, end + 1), periodic=False)
    return cubics


def _fill(
    cubics: Complex, forces: Complex, gaps: Array, run: npt.NDArray[np.int_], *, periodic: bool
) -> None:
    """The spline along a run of places, counted on beyond one turn, into the cubics between them."""
    places = run % len(gaps)
    if len(run) < 3:
        return  # a straight line, as it is
    from scipy.interpolate import CubicSpline  # takes a second to load

    steps = gaps[places[:-1]]
    way = np.concatenate([[0.0], np.cumsum(steps)])
    spline = CubicSpline(way, forces[:, places], axis=1, bc_type="periodic" if periodic else "not-a-knot")
    terms = spline.c[::-1] * (steps ** np.arange(4)[:, np.newaxis])[:, :, np.newaxis, np.newaxis]
    cubics[:, places[:-1]] = terms.transpose(2, 1, 0, 3)
