"""One sea, and a lift in each of its records."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from gantline.checks import Outcome
from gantline.results.alike import first_largest
from gantline.results.file.saved_json import number_in
from gantline.study.extremes import Extreme, extremes_of
from gantline.study.held_run import HeldRun

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


@dataclass(frozen=True, kw_only=True)
class SeaRecord(HeldRun):
    """The lift in one record of a sea.

    Attributes:
        number: Which one, from 1; record 1 has the seeds of the lift file, each further one those after.
    """

    number: int

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units."""
        return {"record": self.number, **super().to_json()}

    @classmethod
    def _more_in(cls, document: Mapping[str, Any]) -> dict[str, Any]:
        return {"number": int(number_in(document, "record"))}


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
        return first_largest(worst, lambda record: record.used)

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
