"""What a check comes to in one lift of many, by Gumbel's distribution of what it came to in some records."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from gantline.checks import Check
from gantline.results.alike import first_largest

__all__ = ["Extreme", "Gumbel", "extremes_of"]

#: Records that a distribution takes; of five the standard error of what one in ten exceeds is a scale.
LEAST_RECORDS = 5


@dataclass(frozen=True)
class Gumbel:
    """The distribution to which the largest of many tend, P(X ≤ x) = exp(−exp(−(x − location) / scale)).

    Attributes:
        location: Its most probable value.
        scale: How far it spreads.
        count: How many values it was estimated from.
    """

    location: float
    scale: float
    count: int

    @classmethod
    def of(cls, values: Sequence[float]) -> Gumbel:
        """Estimate it by probability-weighted moments, unbiased however few values there are (SE2).

        Args:
            values: Two or more.

        Raises:
            ValueError: If there are fewer.
        """
        if len(values) < 2:
            raise ValueError(f"values: of {len(values)} there is no spread; two or more are needed")
        ordered = np.sort(np.asarray(values, dtype=np.float64))
        count = len(ordered)
        mean = float(ordered.mean())
        # Of differences, so that values that are all alike have no spread at all.
        spread = float(np.mean((2.0 * np.arange(count) / (count - 1) - 1.0) * (ordered - mean)))
        scale = spread / math.log(2.0)
        return cls(mean - float(np.euler_gamma) * scale, scale, count)

    def exceeded_by(self, share: float) -> float:
        """The value that this share of all exceeds."""
        return self.location + self.scale * _variate(share)

    def error(self, share: float) -> float:
        """Standard error of that value, of many values; of ten it is up to a twentieth larger (SE4)."""
        reduced = _variate(share)
        variance = 1.1128 + 0.4574 * reduced + 0.8046 * reduced**2
        return self.scale * math.sqrt(variance / self.count)


def _variate(share: float) -> float:
    return -math.log(-math.log1p(-share))


@dataclass(frozen=True)
class Extreme:
    """A check in one lift of many.

    Attributes:
        check: The check, in the record in which it is worst.
        share: The share of lifts that are worse [1].
        value: What it comes to there, in the place of its value [SI].
        error: Standard error of that [SI].
    """

    check: Check
    share: float
    value: float
    error: float

    @property
    def utilisation(self) -> float | None:
        """The share of the limit that is used there [1]; None where that is no number."""
        return replace(self.check, value=self.value).utilisation

    @property
    def utilisation_error(self) -> float | None:
        """Standard error of that [1]."""
        used, limit = self.utilisation, self.check.limit
        if used is None or not limit:
            return None
        return used * self.error / self.value if self.check.at_least else self.error / limit

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units."""
        return {
            "check": self.check.name,
            "element": self.check.element,
            "step": self.check.step,
            "exceeded_by": self.share,
            "value": self.value,
            "error": self.error,
            "limit": self.check.limit,
            "at_least": self.check.at_least,
            "utilisation": self.utilisation,
            "utilisation_error": self.utilisation_error,
        }


def extremes_of(records: Sequence[Sequence[Check]], share: float) -> list[Extreme]:
    """What checks come to in one lift of many.

    Args:
        records: Checks of each record of a sea.
        share: The share of lifts that are worse than what is looked for [1].

    Returns:
        One for each check that has a value in every record, and everywhere the same limit, in the order of
        the first record; none of fewer than five records.
    """
    if len(records) < LEAST_RECORDS:
        return []
    found = []
    for one in records[0]:
        alike = [check for checks in records for check in checks if _is_same(check, one)]
        values = [check.value for check in alike if check.value is not None]
        if len(alike) != len(records) or len(values) != len(records) or not np.isfinite(values).all():
            continue
        way = -1.0 if one.at_least else 1.0
        gumbel = Gumbel.of([way * value for value in values])
        worst = first_largest(alike, lambda check: check.value or 0.0, one.unit, smallest=one.at_least)
        assert worst is not None
        found.append(Extreme(worst, share, way * gumbel.exceeded_by(share), gumbel.error(share)))
    return found


def _is_same(check: Check, other: Check) -> bool:
    """Whether it is the same check of another record; limits that depend on the record tell nothing."""
    return (check.name, check.step, check.limit, check.at_least) == (
        other.name,
        other.step,
        other.limit,
        other.at_least,
    )
