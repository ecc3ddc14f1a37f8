"""What `gantline cases --simulate` found, as its picture and report show it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from gantline.results.alike import first_largest
from gantline.results.file.saved_json import list_in, number_in, object_of, text_in
from gantline.units import compared_digits, format_quantity, telling_digits

__all__ = ["SavedCaseRun", "SavedCaseRuns", "SavedCheck"]

#: Outcomes of runs, from the worst to the best, with the word for each.
_OUTCOMES = {"NO-GO": "no go", "NO VERDICT": "no verdict", "GO WITH WARNINGS": "warns", "GO": "go"}


@dataclass(frozen=True)
class SavedCheck:
    """One limit, and what a run used of it.

    Attributes:
        name: Name of the check.
        element: What it is about.
        verdict: `ok`, `warning` or `failed`.
        used: Share of the limit [1]; None where it failed without such a number.
        value: The value as people read it; empty without one.
        limit: The limit as people read it, with a sign for at least or at most; empty without one.
    """

    name: str
    element: str
    verdict: str
    used: float | None
    value: str
    limit: str

    @property
    def has_failed(self) -> bool:
        """Whether the limit is not kept."""
        return self.verdict == "failed"

    @property
    def only_warns(self) -> bool:
        """Whether it is past a limit that only warns."""
        return self.verdict == "warning" and self.used is not None and self.used > 1.0

    @property
    def share(self) -> str:
        """Share of the limit as people read it; past its limit it does not read as if at it."""
        if self.used is None:
            return "failed"
        digits = telling_digits(self.used, 1.0, "%", 0) if self.used > 1.0 else 0
        return format_quantity(self.used, "%", digits)

    @property
    def size(self) -> float:
        """Share of the limit [1]; infinite of what failed without one."""
        return math.inf if self.used is None else self.used


@dataclass(frozen=True)
class SavedCaseRun:
    """One run of a case.

    Attributes:
        case: Name of the case; empty for the lift as it is given.
        variant: What is different in it; empty where the case has this one alone.
        outcome: `GO`, `GO WITH WARNINGS`, `NO-GO` or `NO VERDICT`.
        cause: Why it could not start or go on; empty where it did.
        starts: Whether it could start.
        checks: Those that have a share of a limit, or failed, and were made.
        peaks: Of its recording, by the names of metrics [SI].
        short: By how much a sling is too short for the start [m]; 0 where none is.
    """

    case: str
    variant: str
    outcome: str
    cause: str
    starts: bool
    checks: Sequence[SavedCheck]
    peaks: Mapping[str, float]
    short: float = 0.0

    @property
    def told(self) -> str:
        """What came of it, in a word or two."""
        if self.cause:
            return "stopped" if self.starts else "no start"
        return _OUTCOMES[self.outcome]

    @property
    def failed(self) -> tuple[str, ...]:
        """Names of the checks that failed, what is farthest past its limit first."""
        failed = sorted((check for check in self.checks if check.has_failed), key=lambda check: -check.size)
        return tuple(dict.fromkeys(check.name for check in failed))


@dataclass(frozen=True)
class SavedCaseRuns:
    """What `gantline cases --simulate` found.

    Attributes:
        scenario_sha256: Of the lift file's text.
        title: Title of the lift.
        is_go: Whether the lift is a go in every case, and all of them were run.
        runs: All of them, the lift as it is given first.
        left_out: Why cases were not simulated, by name.
        not_done: Names of cases of which variants are missing.
    """

    scenario_sha256: str
    title: str
    is_go: bool
    runs: Sequence[SavedCaseRun]
    left_out: Mapping[str, str]
    not_done: Sequence[str]

    @classmethod
    def from_json(cls, document: Any) -> SavedCaseRuns:
        """Read what `CaseRuns.to_json` made.

        Raises:
            ValueError: If it is something else.
        """
        whole = object_of(document)
        left_out = object_of(whole.get("left_out"))
        runs = [run for case in list_in(whole, "cases") for run in _runs(object_of(case))]
        if not runs:
            raise ValueError("there are no runs")
        return cls(
            text_in(whole, "scenario_sha256"),
            text_in(whole, "title"),
            whole.get("go") is True,
            runs,
            {case: text_in(left_out, case) for case in left_out},
            [str(one) for one in list_in(whole, "not_done")],
        )

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the cases; the lift as it is given is the first and has an empty one."""
        return tuple(dict.fromkeys(run.case for run in self.runs))

    def of(self, case: str) -> list[SavedCaseRun]:
        """All runs of a case."""
        return [run for run in self.runs if run.case == case]

    def worst(self, case: str, limit: str) -> SavedCheck | None:
        """The check of a name that uses most of its limit in a case; None where none was made."""
        found = [check for run in self.of(case) for check in run.checks if check.name == limit]
        return first_largest(found, lambda check: check.size)

    @cached_property
    def nearest(self) -> list[tuple[SavedCheck, SavedCaseRun]]:
        """Of each limit the run that uses most of it, of those alike the first; most first."""
        by_limit: dict[str, list[tuple[SavedCheck, SavedCaseRun]]] = {}
        for run in self.runs:
            for check in run.checks:
                by_limit.setdefault(check.name, []).append((check, run))
        worst = [first_largest(found, lambda one: one[0].size) for found in by_limit.values()]
        return sorted((one for one in worst if one is not None), key=lambda one: -one[0].size)

    @property
    def counts(self) -> str:
        """How many runs there are, and what came of them."""
        cases = len(self.names) - 1
        told = [(kind, sum(run.outcome == kind for run in self.runs)) for kind in _OUTCOMES]
        head = f"{cases} case{'' if cases == 1 else 's'}, {len(self.runs)} runs"
        return f"{head}: {', '.join(f'{count} {kind}' for kind, count in told if count)}"

    def outcome(self, case: str) -> str:
        """What came of the worst run of a case, in a word or two."""
        order = list(_OUTCOMES)
        worst = min(self.of(case), key=lambda run: (run.starts, not run.cause, order.index(run.outcome)))
        return worst.told


def _runs(case: Mapping[str, Any]) -> Iterator[SavedCaseRun]:
    name = text_in(case, "case")
    for run in map(object_of, list_in(case, "runs")):
        peaks = object_of(run.get("peaks"))
        outcome = text_in(run, "outcome")
        if outcome not in _OUTCOMES:
            raise ValueError(f"'{outcome}' is no outcome")
        yield SavedCaseRun(
            name,
            text_in(run, "variant"),
            outcome,
            text_in(run, "cause"),
            run.get("starts") is True,
            [found for one in list_in(run, "checks") if (found := _check(object_of(one))) is not None],
            {peak: number_in(peaks, peak) for peak in peaks},
            number_in(run, "short") if "short" in run else 0.0,
        )


def _check(given: Mapping[str, Any]) -> SavedCheck | None:
    """A check that says something of a limit; None of another."""
    verdict, has_share = text_in(given, "verdict"), given.get("utilisation") is not None
    if verdict == "not checked" or not (has_share or verdict == "failed"):
        return None
    value, limit = (None if given.get(key) is None else number_in(given, key) for key in ("value", "limit"))
    unit, digits = text_in(given, "unit"), int(number_in(given, "digits"))
    at_least = given.get("at_least") is True
    if value is not None:
        digits = compared_digits(value, limit, unit, digits, at_least=at_least)
    bound = "" if limit is None else f"{'≥' if at_least else '≤'} {format_quantity(limit, unit, digits)}"
    return SavedCheck(
        text_in(given, "name"),
        text_in(given, "element"),
        verdict,
        number_in(given, "utilisation") if has_share else None,
        "" if value is None else format_quantity(value, unit, digits),
        bound,
    )
