"""The time that two recordings have in common, and how far two series differ over it.

Two runs need not have the same samples. Their series are compared at the sample times of the recording that
has fewer of them in the common span, so that only the finer one is interpolated, linearly; with equally many,
at those of both. Swapping the recordings therefore changes nothing but the sign.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
import numpy.typing as npt

from gantline.results.alike import ROUNDING
from gantline.results.rotation import angle_between
from gantline.results.variable import FloatArray


@dataclass(frozen=True)
class Deviation:
    """How far a series of B is from that of A over the common time.

    Attributes:
        unit: SI unit of what follows.
        rms: Root of the mean square over time [unit].
        largest: B - A where its magnitude is largest [unit]; of distances and angles never negative.
        time: When that is [s].
    """

    unit: str
    rms: float
    largest: float
    time: float


@dataclass(frozen=True, eq=False)
class CommonTime:
    """Times at which two recordings are compared.

    Attributes:
        times: Increasing [s], shape (common,), at least one.
        times_a: Sample times of A [s].
        times_b: Sample times of B [s].
    """

    times: FloatArray
    times_a: FloatArray
    times_b: FloatArray

    @classmethod
    def of(cls, times_a: npt.ArrayLike, times_b: npt.ArrayLike) -> Self | None:
        """The common time of two recordings or programs; None if they have no time in common.

        Args:
            times_a: Sample times of A [s], increasing, shape (time,).
            times_b: Sample times of B [s], increasing, shape (time,).

        Raises:
            ValueError: If times are no such row.
        """
        times_a, times_b = _rising(times_a, "times_a"), _rising(times_b, "times_b")
        if not times_a.size or not times_b.size:
            return None
        first, last = max(times_a[0], times_b[0]), min(times_a[-1], times_b[-1])
        inside_a, inside_b = (times[(times >= first) & (times <= last)] for times in (times_a, times_b))
        if inside_a.size == inside_b.size:
            times = np.union1d(inside_a, inside_b)
        else:
            times = min(inside_a, inside_b, key=len)
        if not times.size:  # neither has a sample within the span of the other
            return None
        return cls(times, times_a, times_b)

    def a(self, values: npt.ArrayLike) -> FloatArray:
        """A series of A at the common times; shapes (time, ...) and (common, ...).

        Raises:
            ValueError: If it has not a value for each time of A.
        """
        return _at(self.times, self.times_a, values)

    def b(self, values: npt.ArrayLike) -> FloatArray:
        """A series of B at the common times; shapes (time, ...) and (common, ...).

        Raises:
            ValueError: If it has not a value for each time of B.
        """
        return _at(self.times, self.times_b, values)

    def difference(self, values_a: npt.ArrayLike, values_b: npt.ArrayLike) -> FloatArray:
        """B - A of two series, shape (common, ...)."""
        difference: FloatArray = self.b(values_b) - self.a(values_a)
        return difference

    def distance(self, places_a: npt.ArrayLike, places_b: npt.ArrayLike) -> FloatArray:
        """Distance of two places [m], each of shape (time, 3); shape (common,)."""
        distance: FloatArray = np.linalg.norm(self.difference(places_a, places_b), axis=1)
        return distance

    def turn(self, orientation_a: FloatArray, orientation_b: FloatArray) -> FloatArray:
        """Angle by which two attitudes differ [rad], about whatever axis.

        Args:
            orientation_a: Unit quaternions of A, shape (time, 4).
            orientation_b: Unit quaternions of B, shape (time, 4).

        Returns:
            Angles from 0 to pi, shape (common,).
        """
        # Between samples a quaternion is taken on the chord; the angle does not ask for its length.
        return angle_between(self.a(_continuous(orientation_a)), self.b(_continuous(orientation_b)))

    def deviation(self, unit: str, difference: FloatArray) -> Deviation:
        """Mean square and largest value of a difference over the common times, of those alike the first.

        Args:
            unit: SI unit of the difference.
            difference: Shape (common,).
        """
        size = np.abs(difference)
        at = int(np.argmax(size))
        if np.isfinite(size[at]):
            at = int(np.argmax(size >= (1.0 - ROUNDING) * size[at]))
        return Deviation(unit, self._rms(difference), float(difference[at]), float(self.times[at]))

    def _rms(self, values: FloatArray) -> float:
        """Weighted by time, so that uneven samples do not count more than they last."""
        span = float(self.times[-1] - self.times[0])
        if span == 0.0:
            return float(np.sqrt(np.mean(values**2)))
        squares = values**2
        return float(np.sqrt(np.sum((squares[1:] + squares[:-1]) / 2.0 * np.diff(self.times)) / span))


def _rising(times: npt.ArrayLike, which: str) -> FloatArray:
    row = np.asarray(times, dtype=np.float64)
    # Also false where a time is no number.
    if row.ndim != 1 or not bool(np.all(np.diff(row) >= 0.0)):
        raise ValueError(f"{which}: is no row of times [s] that rise")
    return row


def _at(times: FloatArray, sampled: FloatArray, given: npt.ArrayLike) -> FloatArray:
    values = np.asarray(given, dtype=np.float64)
    if len(np.atleast_1d(values)) != len(sampled):
        raise ValueError(f"a series of shape {values.shape} has no value for each of {len(sampled)} times")
    if np.array_equal(times, sampled):
        return values
    columns = values.reshape(len(sampled), -1).T
    rows = np.stack([np.interp(times, sampled, column) for column in columns], axis=-1)
    return rows.reshape(len(times), *values.shape[1:])


def _continuous(orientation: FloatArray) -> FloatArray:
    """The same attitudes with signs that do not jump: q and -q are one attitude."""
    along = np.sum(orientation[1:] * orientation[:-1], axis=1)
    signs = np.concatenate([[1.0], np.cumprod(np.where(along < 0.0, -1.0, 1.0))])
    continuous: FloatArray = orientation * signs[:, None]
    return continuous
