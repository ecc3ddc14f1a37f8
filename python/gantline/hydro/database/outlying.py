"""Frequencies of a database whose added mass stands alone, as panel programs give it where they fail."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

__all__ = ["Outlier", "outliers"]

#: How far added mass may be from that of the frequencies beside, of the largest of all others [1].
_APART = 0.25
#: How many times farther than those are from each other.
_ALONE = 5.0


@dataclass(frozen=True)
class Outlier:
    """A frequency at which added mass stands alone.

    Attributes:
        place: Of the frequency among all of the file.
        axes: The motions, by their places.
        times: How many times of what stands beside it, where that is farthest from 1.
    """

    place: int
    axes: Sequence[int]
    times: float


def outliers(added_mass: npt.NDArray[np.float64]) -> Iterator[Outlier]:
    """Each frequency whose added mass is far from that beside it, which agrees with itself.

    Added mass goes smoothly with frequency, to a limit at both ends. A lowest frequency at which waves are
    too long for a program, or one at which water sloshes in a hull that is none, leaves a single value.

    Args:
        added_mass: Of the frequencies in their order (n, 6, 6) [kg, kg m, kg m^2].
    """
    count = len(added_mass)
    values = np.diagonal(added_mass, axis1=1, axis2=2)
    for place in range(count) if count > 3 else ():
        near = {0: (1, 2), count - 1: (count - 2, count - 3)}.get(place, (place - 1, place + 1))
        one, other = values[near[0]], values[near[1]]
        beside = one if place in (0, count - 1) else (one + other) / 2
        apart, most = np.abs(values[place] - beside), np.abs(np.delete(values, place, axis=0)).max(axis=0)
        axes = np.flatnonzero((apart > _APART * most) & (apart > _ALONE * np.abs(one - other)))
        if len(axes):
            times = np.abs(values[place][axes]) / np.maximum(np.abs(beside[axes]), 1e-9 * most[axes])
            farthest = int(np.argmax(np.abs(np.log(np.maximum(times, 1e-9)))))
            yield Outlier(place, axes.tolist(), float(times[farthest]))
