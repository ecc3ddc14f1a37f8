"""One sea, and a lift in each of its records."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from gantline.checks import Check, Outcome, failed_names, governing, outcome_of, verdict_of
from gantline.results.alike import first_largest
from gantline.results.file.saved_json import list_in, number_in, object_of, text_in
from gantline.study.extremes import Extreme, extremes_of

__all__ = ["NoSeaError", "Sea", "SeaRecord"]

#: Share of lifts that extremes leave to be worse, unless asked otherwise: what codes call P90.
ONE_IN_TEN = 0.1
#: From the worst to the best: a sea is as good as its worst record.
_WORST_FIRST = (Outcome.NO_GO, Outcome.NO_VERDICT, Outcome.GO_WITH_WARNINGS, Outcome.GO)


class NoSeaError(ValueError):
    """A lift has no such seas, or waves cannot have such a value.

    Attributes:
        name: The argument of `run_seas` that asks for it.
        sentence: What is wrong.
    """

    def __init__(self, name: str, sentence: str) -> None:
        super().__init__(f"{name}: {sentence}")
        self.name, self.sentence = name, sentence

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle: an error of a process that works for another one arrives there whole."""
        return type(self), (self.name, self.sentence)


@dataclass(frozen=True)
class SeaRecord:
    """The lift in one record of a sea.

    Attributes:
        number: Which one, from 1; record 1 has the seeds of the lift file, each further one those after.
        time: Simulated time that it got to [s].
        checks: Its checks.
        warnings: Of lift file and run, sentences.
        cause: Why it could not start or not go on, in one sentence; empty where it did.
        starts: Whether it could start.
    """

    number: int
    time: float = 0.0
    checks: Sequence[Check] = ()
    warnings: Sequence[str] = ()
    cause: str = ""
    starts: bool = True

    @property
    def outcome(self) -> Outcome:
        """Go or no-go; a lift that cannot start or go on is none."""
        return Outcome.NO_GO if self.cause else outcome_of(self.checks)

    @property
    def governing(self) -> Check | None:
        """The check that uses most of its limit; None where there is none with a limit."""
        return governing(self.checks)

    @property
    def failed(self) -> tuple[str, ...]:
        """Names of the checks that failed."""
        return failed_names(self.checks)

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units."""
        check = self.governing
        return {
            "record": self.number,
            "outcome": self.outcome.value,
            "time": self.time,
            "starts": self.starts,
            "cause": self.cause,
            "failed": list(self.failed),
            "governing": None
            if check is None
            else {"check": check.name, "element": check.element, "utilisation": check.utilisation},
            "verdict": "" if self.cause else verdict_of(self.checks),
            "warnings": list(self.warnings),
            "checks": [one.to_json() for one in self.checks],
        }

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> SeaRecord:
        """Read what `to_json` made.

        Raises:
            ValueError: If it is something else.
        """
        return cls(
            int(number_in(document, "record")),
            number_in(document, "time"),
            tuple(Check.from_json(object_of(one)) for one in list_in(document, "checks")),
            tuple(str(one) for one in list_in(document, "warnings")),
            text_in(document, "cause"),
            document.get("starts") is True,
        )


@dataclass(frozen=True)
class Sea:
    """One sea, or waves that are all alike, and the lift in it.

    Attributes:
        height: Significant height, or height of waves that are all alike [m].
        period: Peak period, or period [s].
        direction: In which they run [rad].
        highest: Height beyond which no such waves are, for their steepness [m].
        records: The lift in each of its records; none where it is too steep, or was not run.
    """

    height: float
    period: float
    direction: float
    highest: float
    records: Sequence[SeaRecord] = field(default=())

    @property
    def is_too_steep(self) -> bool:
        """Whether there are no such waves."""
        return self.height > self.highest

    @property
    def outcome(self) -> Outcome | None:
        """That of its worst record; None where it was not run."""
        outcomes = [record.outcome for record in self.records]
        return min(outcomes, key=_WORST_FIRST.index, default=None)

    @property
    def is_allowed(self) -> bool:
        """Whether the lift is a go in every record, with warnings or without."""
        return self.outcome in (Outcome.GO, Outcome.GO_WITH_WARNINGS)

    @property
    def is_refused(self) -> bool:
        """Whether it is none in one of them."""
        return self.outcome is Outcome.NO_GO

    @property
    def worst(self) -> SeaRecord | None:
        """Of the records with its outcome the one that uses most of a limit; None where it was not run."""
        worst = [record for record in self.records if record.outcome is self.outcome]
        return first_largest(worst, _used)

    def extremes(self, share: float = ONE_IN_TEN) -> list[Extreme]:
        """What checks come to in one lift of many in this sea, by Gumbel's distribution of its records.

        Args:
            share: The share of lifts that are worse [1].

        Returns:
            One for each check that has a value, and the same limit, in all records; none of fewer than five
            records, nor where the lift could not start or go on in one.

        Raises:
            ValueError: If there is no such share.
        """
        if not 0.0 < share < 1.0:
            raise ValueError(f"share: {share!r} is none between 0 and 1")
        if any(record.cause for record in self.records):
            return []
        return extremes_of([record.checks for record in self.records], share)

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units."""
        outcome, worst = self.outcome, self.worst
        return {
            "height": self.height,
            "period": self.period,
            "direction": self.direction,
            "too_steep": self.is_too_steep,
            "outcome": None if outcome is None else outcome.value,
            "allowed": self.is_allowed,
            "refused": self.is_refused,
            "worst_record": None if worst is None else worst.number,
            "extremes": [one.to_json() for one in self.extremes()],
            "records": [record.to_json() for record in self.records],
        }


def _used(record: SeaRecord) -> float:
    """Largest share of a limit that is used [1]; infinite of what failed without a number."""
    check = record.governing
    if record.cause or (check is not None and check.utilisation is None):
        return math.inf
    return 0.0 if check is None or check.utilisation is None else check.utilisation
