"""What `gantline seas` found, as its table, picture and report show it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gantline.results.afloat.sea_grid import SeaGrid
from gantline.results.alike import first_largest
from gantline.results.file.saved_json import list_in, number_in, object_of, text_in
from gantline.units import format_quantity, telling_digits

__all__ = ["SavedSea", "SavedSeas", "degrees"]


#: Errors of shares that take a decimal [1].
_A_DIGIT_BELOW = 0.01


@dataclass(frozen=True)
class SavedExtreme:
    """What one lift in ten uses of a limit, or more.

    Attributes:
        used: Share of the limit [1].
        error: Standard error of that [1].
        check: Name of the check.
        element: What it is about, in the worst record.
    """

    used: float
    error: float
    check: str
    element: str

    @property
    def share(self) -> str:
        """Share and its error as people read them; past its limit it does not read as if at it."""
        digits = 0 if self.error >= _A_DIGIT_BELOW else 1
        if self.used > 1.0:
            digits = telling_digits(self.used, 1.0, "%", digits)
        return f"{100.0 * self.used:.{digits}f} ± {format_quantity(self.error, '%', digits)}"


@dataclass(frozen=True)
class SavedSea:
    """One sea, or waves that are all alike, and the worst of the lift in it.

    Attributes:
        height: Significant height, or height [m].
        period: Peak period, or period [s].
        direction: In which they run [rad].
        is_too_steep: Whether there are no such waves.
        is_allowed: Whether the lift is a go in every record.
        is_refused: Whether it is no go in one.
        record: The worst record, from 1; 0 where it was not run.
        used: Largest share of a limit that is used there [1]; None without such a number.
        check: Name of the check that uses it; empty where there is none.
        element: What it is about.
        cause: Why the lift could not start or go on; empty where it did.
        starts: Whether it could start.
        verdict: The lift in it, in one sentence; empty where it was not run, or has a cause.
        extreme: What one lift in ten uses of the limit that is nearest then; None of few records.
    """

    height: float
    period: float
    direction: float
    is_too_steep: bool
    is_allowed: bool
    is_refused: bool
    record: int
    used: float | None
    check: str
    element: str
    cause: str
    starts: bool
    verdict: str
    extreme: SavedExtreme | None = None

    @property
    def is_run(self) -> bool:
        """Whether the lift was simulated in it, or could not start."""
        return self.record > 0

    @property
    def by(self) -> str:
        """The check that uses most of its limit, and what it is about; empty where there is none."""
        return " ".join(part for part in (self.check, self.element) if part)

    @property
    def only_warns(self) -> bool:
        """Whether the lift is a go in it, and yet past a limit that only warns."""
        return self.is_allowed and self.used is not None and self.used > 1.0

    @property
    def share(self) -> str:
        """Share of a limit that is used, as people read it; empty without one, or where it did not go on."""
        if self.used is None or self.cause:
            return ""
        within = self.is_allowed and not self.only_warns
        digits = 0 if within else telling_digits(self.used, 1.0, "%", 0)
        return format_quantity(self.used, "%", digits)

    @property
    def told(self) -> str:
        """What came of it, in a word or two beside the share; empty where it is a go within all limits."""
        if self.is_too_steep or not self.is_run:
            return "too steep" if self.is_too_steep else "not run"
        if self.is_allowed:
            return "warns" if self.only_warns else ""
        if self.cause:
            return "STOPPED" if self.starts else "NO START"
        return "FAILED" if self.has_verdict else "no verdict"

    @property
    def has_verdict(self) -> bool:
        """Whether it is known to be a go or none."""
        return self.is_allowed or self.is_refused


@dataclass(frozen=True)
class SavedSeas(SeaGrid[SavedSea]):
    """What `gantline seas` found.

    Attributes:
        scenario_sha256: Of the lift file's text.
        title: Title of the lift.
        waves: Name of the waves that were varied.
        is_regular: Whether these are all alike.
        records: Records of each sea.
        duration: What each run was to simulate [s]; 0 where none was, of files that do not say it.
        seas: All seas, by direction, period and height.
        allowed: Largest height [m] up to which the lift is a go, by direction [rad] and period [s]; None
            where it is none in the lowest sea.
        warnings: Of lift file and runs, each once.
        runs: How many records were run, or could not start.
        stopped: How many of them could not go on to the end.
        unstarted: How many could not start.
    """

    scenario_sha256: str
    title: str
    waves: str
    is_regular: bool
    records: int
    duration: float
    seas: Sequence[SavedSea]
    allowed: Mapping[tuple[float, float], float | None]
    warnings: Sequence[str]
    runs: int = 0
    stopped: int = 0
    unstarted: int = 0

    @classmethod
    def from_json(cls, document: Any) -> SavedSeas:
        """Read what `SeasResult.to_json` made.

        Raises:
            ValueError: If it is something else.
        """
        whole = object_of(document)
        listed = [object_of(one) for one in list_in(whole, "seas")]
        runs = [object_of(record) for sea in listed for record in list_in(sea, "records")]
        allowed = [object_of(one) for one in list_in(whole, "allowed")]
        return cls(
            text_in(whole, "scenario_sha256"),
            text_in(whole, "title"),
            text_in(whole, "waves"),
            whole.get("regular") is True,
            int(number_in(whole, "records")),
            _duration(whole, runs),
            [_sea(one) for one in listed],
            {
                (number_in(one, "direction"), number_in(one, "period")): None
                if one.get("height") is None
                else number_in(one, "height")
                for one in allowed
            },
            list(dict.fromkeys(str(one) for record in runs for one in list_in(record, "warnings"))),
            len(runs),
            sum(_has_stopped(record) for record in runs),
            sum(record.get("starts", True) is not True for record in runs),
        )

    @property
    def short(self) -> str:
        """How many runs did not come to their end, in words; empty where all did."""
        told = {"stopped on the way": self.stopped, "could not start": self.unstarted}
        counts = [f"{count} of {self.runs} {what}" for what, count in told.items() if count]
        return " and ".join(counts)

    def highest_allowed(self, direction: float, period: float) -> SavedSea | None:
        """The highest sea of a direction [rad] and a period [s] that is allowed; None of none."""
        height = self.allowed[direction, period]
        return next((sea for sea in self.of(direction, period) if sea.height == height), None)

    def stopper(self, direction: float, period: float) -> SavedSea | None:
        """The lowest sea of a direction [rad] and a period [s] in which the lift is no go; None of none."""
        run = (sea for sea in self.of(direction, period) if sea.is_run)
        return next((sea for sea in run if not sea.is_allowed), None)


def degrees(direction: float) -> str:
    """A direction [rad] as people read it, with a decimal where it has one."""
    angle = math.degrees(direction)
    return format_quantity(round(direction, 9), "deg", 0 if abs(angle - round(angle)) < 1e-6 else 1)


def _has_stopped(record: Mapping[str, Any]) -> bool:
    return bool(record.get("cause")) and record.get("starts", True) is True


def _duration(whole: Mapping[str, Any], runs: Sequence[Mapping[str, Any]]) -> float:
    """What runs were to simulate [s]; files of older versions have but how far each of them came."""
    if "duration" in whole:
        return number_in(whole, "duration")
    return max((number_in(record, "time") for record in runs if not record.get("cause")), default=0.0)


def _sea(given: Mapping[str, Any]) -> SavedSea:
    number = given.get("worst_record")
    records = [object_of(record) for record in list_in(given, "records")]
    worst = next((record for record in records if record.get("record") == number), {})
    found = worst.get("governing")
    governing = {} if found is None else object_of(found)
    used = governing.get("utilisation")
    return SavedSea(
        number_in(given, "height"),
        number_in(given, "period"),
        number_in(given, "direction"),
        given.get("too_steep") is True,
        given.get("allowed") is True,
        given.get("refused") is True,
        int(number) if isinstance(number, int) else 0,
        None if used is None else number_in(governing, "utilisation"),
        str(governing.get("check", "")),
        str(governing.get("element", "")),
        str(worst.get("cause", "")),
        worst.get("starts", True) is True,
        str(worst.get("verdict", "")),
        _extreme([object_of(one) for one in given.get("extremes") or ()]),
    )


def _extreme(given: Sequence[Mapping[str, Any]]) -> SavedExtreme | None:
    """The one that uses most of its limit."""
    found = [
        SavedExtreme(
            number_in(one, "utilisation"),
            number_in(one, "utilisation_error"),
            text_in(one, "check"),
            text_in(one, "element"),
        )
        for one in given
        if one.get("utilisation") is not None
    ]
    return first_largest(found, lambda one: one.used)
