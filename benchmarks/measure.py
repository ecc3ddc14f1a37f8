"""Errors, and the time that an error costs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from benchmarks.contract import FloatArray, Setting

TARGETS = (0.01, 0.001)
"""rms errors at which the codes are compared."""


@dataclass(frozen=True)
class Errors:
    """Against the reference, relative to the mean final sling tension."""

    rms: float
    """Over all times and slings."""
    peak: float
    """Of the largest sling tension."""
    final: float
    """Largest of all slings at the last time."""


def errors(tension: FloatArray, reference: FloatArray, scale: float) -> Errors:
    """Both as (time, sling) at the same times; `scale` is the mean final sling tension [N]."""
    difference = tension - reference
    return Errors(
        rms=float(np.sqrt(np.mean(difference**2))) / scale,
        peak=abs(float(tension.max() - reference.max())) / scale,
        final=float(np.abs(difference[-1]).max()) / scale,
    )


@dataclass(frozen=True)
class Point:
    """One setting of one code on one lift. Without errors: the run failed, and `failure` says how."""

    setting: Setting
    seconds: float
    errors: Errors | None
    failure: str = ""

    @property
    def rms(self) -> float:
        """The rms error, infinite where the run failed."""
        return math.inf if self.errors is None else self.errors.rms


@dataclass(frozen=True)
class Cost:
    """What an error costs a code, and how that is known."""

    seconds: float
    interpolated: bool
    """Between two settings; otherwise the cheapest setting that is no worse."""


def cost(ladder: Sequence[Point], target: float) -> Cost | None:
    """Time to reach an rms error, or None if no setting does.

    Settings go from tight to loose. The first one that misses the target ends the search, so that a loose
    setting that is right by luck does not count. Towards that one the time is interpolated, both
    logarithmically, unless its run failed; where even the loosest setting meets the target, its time is the
    answer.
    """
    met: list[Point] = []
    for point in ladder:
        if point.rms > target:
            break
        met.append(point)
    if not met:
        return None
    best = min(point.seconds for point in met)
    if len(met) == len(ladder):
        return Cost(best, interpolated=False)
    last, missed = met[-1], ladder[len(met)]
    if math.isfinite(missed.rms) and missed.seconds < last.seconds:
        share = math.log(target / last.rms) / math.log(missed.rms / last.rms)
        between = last.seconds * (missed.seconds / last.seconds) ** share
        if between < best:
            return Cost(between, interpolated=True)
    return Cost(best, interpolated=False)


def growth(sizes: Sequence[float], seconds: Sequence[float]) -> float:
    """Exponent of growth by least squares in logarithms."""
    return float(np.polyfit(np.log(sizes), np.log(seconds), 1)[0])
