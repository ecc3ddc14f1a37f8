"""The largest of several values, where it is not for rounding to choose among those that are alike."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import TypeVar

import numpy as np

from gantline.results.variable import FloatArray

#: Values that differ by less are alike: a share, and by unit what is nothing beside any lift [SI].
ROUNDING = 1e-9
_NOTHING = {"kN": 1e-3}

_T = TypeVar("_T")


def differs(one: float, other: float, unit: str) -> bool:
    """Whether two values, SI, of a quantity that people read in a unit differ by more than rounding."""
    if math.isinf(one) or math.isinf(other):
        return one != other
    return without_rounding(one - other, other, unit) != 0.0


def without_rounding(difference: float, scale: float, unit: str) -> float:
    """A difference, SI, of a quantity that people read in a unit; 0 where it is no more than rounding.

    Args:
        difference: Of two values, or what is left of many such.
        scale: The larger of these.
        unit: Unit in which people read them.
    """
    if math.isinf(difference) or math.isinf(scale):
        return difference
    return 0.0 if abs(difference) <= max(ROUNDING * abs(scale), nothing(unit)) else difference


def nothing(unit: str) -> float:
    """What is nothing of a quantity that people read in a unit, SI."""
    return _NOTHING.get(unit, ROUNDING)


def first_largest(
    items: Iterable[_T], value: Callable[[_T], float], unit: str = "", *, smallest: bool = False
) -> _T | None:
    """The item with the largest value, or smallest, of those alike but for rounding the first.

    Args:
        items: In the order in which they count.
        value: Gives the value of one, SI.
        unit: Unit in which people read it.
        smallest: Whether the smallest is looked for.

    Returns:
        None where there is no item.
    """
    known = list(items)
    values = [value(one) for one in known]
    if not values:
        return None
    extreme = min(values) if smallest else max(values)
    alike = (one for one, its in zip(known, values, strict=True) if not differs(its, extreme, unit))
    return next(alike, known[values.index(extreme)])


def earliest_peak(*peaks: tuple[float, float]) -> tuple[float, float]:
    """The largest of peaks of one thing, and of those alike but for rounding the first time.

    Args:
        peaks: Value, SI, and time [s] of each, at least one; one that is no number counts only if all are.
    """
    known = [one for one in peaks if not math.isnan(one[0])] or peaks
    highest = max(value for value, _ in known)
    least = highest - ROUNDING * max(abs(highest), 1.0) if math.isfinite(highest) else highest
    return highest, min((time for value, time in known if value >= least), default=known[0][1])


def first_peak(values: FloatArray | Sequence[float]) -> int:
    """Index of the largest of a series, shape (n,), SI: of those alike but for rounding the first."""
    series = np.asarray(values, dtype=float)
    at = int(np.argmax(series))
    if not np.isfinite(series[at]):
        return at
    return int(np.argmax(series >= series[at] - ROUNDING * max(abs(float(series[at])), 1.0)))
