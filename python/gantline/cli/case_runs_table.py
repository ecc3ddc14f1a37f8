"""Tables of cases that were simulated: one line for each case, and the case that uses most of each limit."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Callable, Iterator, Sequence

from gantline.checks import Outcome
from gantline.cli.case_names import (
    SHORTEST_LABEL,
    case_name,
    is_numbered,
    listed_names,
    numbered_in,
    told_apart,
)
from gantline.cli.cases_table import nearest_to_limits
from gantline.cli.table import ABSENT, filled, show, table
from gantline.study.case_runs import CaseRun, CaseRuns
from gantline.units import format_quantity

__all__ = ["case_runs_table"]

#: From the worst to the best.
_WORST_FIRST = (Outcome.NO_GO, Outcome.NO_VERDICT, Outcome.GO_WITH_WARNINGS, Outcome.GO)
#: What came of a case, as its line has room for.
_WORDS = {
    Outcome.NO_GO: "NO-GO",
    Outcome.NO_VERDICT: "unknown",
    Outcome.GO_WITH_WARNINGS: "warns",
    Outcome.GO: "GO",
}
_INDENT, _FURTHER = "  ", "    "


def case_runs_table(result: CaseRuns, *, width: int, variants: bool) -> list[str]:
    """All that is shown of cases that were simulated.

    Args:
        result: Their runs.
        width: Columns that a line may have.
        variants: Whether each variant has a line of its own.
    """
    groups: list[tuple[str, list[CaseRun]]]
    if variants:
        groups = [(case_name(run.case, run.variant), [run]) for run in result.runs]
    else:
        groups = [(case_name(name, _count(result.of(name))), result.of(name)) for name in result.names]
    runs, nearest = _runs(groups, width), nearest_to_limits(groups, width)
    numbered = numbered_in([name for name, _ in groups], [*runs, *nearest], width)
    parts = [
        [f"{result.title}, simulated"],
        [*runs, *_why(result, width)],
        nearest,
        numbered,
        *_worst(result, width, len(groups) if numbered else 0),
        [_verdict(result)],
    ]
    return [line for part in parts if part for line in (*part, "")][:-1]


def _count(runs: Sequence[CaseRun]) -> str:
    return str(len(runs)) if len(runs) > 1 else ""


def _runs(groups: Sequence[tuple[str, Sequence[CaseRun]]], width: int) -> list[str]:
    """One line for each named group of runs, with the worst of each peak."""

    def most(runs: Sequence[CaseRun], *names: str, of: Callable[[list[float]], float] = max) -> float | None:
        found = [run.peaks[name] for run in runs for name in names if name in run.peaks]
        return of(found) if found else None

    rows = [
        (
            "",
            show(most(runs, "least_sling_tension_when_clear", of=min), "kN", 1),
            show(most(runs, "peak_sling_tension"), "kN", 1),
            show(most(runs, "peak_hook_load"), "kN", 1),
            show(most(runs, "peak_load_tilt"), "deg", 2),
            show(most(runs, "travel_used_up", "travel_used_down"), "%", 1),
            _told(runs),
        )
        for _, runs in groups
    ]
    head, known, align = filled(("", "slings", "to", "hook load", "tilt", "stroke", ""), rows, "lrrrrrl")
    taken = max(len(line) for line in table(head, known, align))
    names = told_apart([name for name, _ in groups], max(SHORTEST_LABEL, width - taken))
    named = [(name, *row[1:]) for name, row in zip(names, known, strict=True)]
    return table(("Case", *head[1:]), named, align)


def _told(runs: Sequence[CaseRun]) -> str:
    """What came of the worst of some runs, in a word or two."""
    if any(not run.starts for run in runs):
        return "NO START"
    if any(run.cause for run in runs):
        return "STOPPED"
    return _WORDS[min((run.outcome for run in runs), key=_WORST_FIRST.index)]


def _why(result: CaseRuns, width: int) -> Iterator[str]:
    """Why cases did not start, stopped or were not simulated, and what failed, each reason once."""
    reasons: dict[str, list[int]] = {}
    failed: dict[str, list[int]] = {}
    short = [place for place, run in enumerate(result.runs) if run.short > 0.0]
    longest = max((result.runs[place] for place in short), key=lambda run: run.short, default=None)
    if longest is not None:
        yield from _lines(f"cannot start: {longest.cause}: {_in_cases(result, short)}", width)
        yield from _lines(_more_slack(longest.short), width)
    for place, run in enumerate(result.runs):
        if run.cause and not run.short:
            what = "stopped" if run.starts else "cannot start"
            reasons.setdefault(f"{what}: {run.cause}", []).append(place)
        if run.outcome is Outcome.NO_VERDICT:
            reasons.setdefault("no verdict", []).append(place)
        for check in run.failed:
            failed.setdefault(check, []).append(place)
    for found in dict.fromkeys(map(tuple, failed.values())):
        checks = [check for check, places in failed.items() if tuple(places) == found]
        reasons[f"{', '.join(checks)} failed"] = list(found)
    for reason, places in reasons.items():
        every = len(places) == len(result.runs) > 1
        yield from _lines(f"{reason}: {'everywhere' if every else _in_cases(result, places)}", width)
    for case, reason in result.left_out.items():
        yield from _lines(f"not simulated: {case}: {reason}", width)


def _more_slack(short: float) -> str:
    """What helps variants whose slings are too short for the start by up to a length [m]."""
    lower = format_quantity(math.ceil(100.0 * short) / 100.0, "m", 2)
    return (
        f"all variants start as the lift does: with its hooks {lower} lower at the start, a little more "
        "where slings stand aslant, and as much more to hoist, these start too"
    )


def _in_cases(result: CaseRuns, found: Sequence[int]) -> str:
    """Cases that some runs belong to, and how many of each."""
    cases = [result.runs[place].case for place in found]
    parts = []
    for case in dict.fromkeys(cases):
        every = len(result.of(case))
        parts.append(case_name(case, f"{cases.count(case)} of {every}" if every > 1 else ""))
    return ", ".join(parts)


def _worst(result: CaseRuns, width: int, numbered: int) -> list[list[str]]:
    """The run that uses most of each limit, and what variants are whose names are cut off alike."""
    rows = [
        (
            check.name,
            check.shown(check.value),
            check.shown(check.limit),
            show(check.utilisation, "%", 1),
            check.element or ABSENT,
            case_name(run.case, run.variant if len(result.of(run.case)) > 1 else ""),
        )
        for check, run in result.worst
        if len(result.runs) > 1
    ]
    if not rows:
        return []
    head = ("Worst case of each limit", "value", "limit", "used", "of", "in")
    taken = max(len(line) for line in table(head, [(*row[:-1], "") for row in rows], "lrrrll")) + 2
    room = max(SHORTEST_LABEL, width - taken)
    long = [label for label in dict.fromkeys(row[-1] for row in rows) if len(label) > room]
    names = dict(zip(long, told_apart(long, room, numbered), strict=True))
    lines = table(head, [(*row[:-1], names.get(row[-1], row[-1])) for row in rows], "lrrrll")
    return [lines, listed_names(long, width, numbered) if is_numbered(names.values(), numbered) else []]


def _verdict(result: CaseRuns) -> str:
    """How many runs there were, and what came of them."""
    cases = len(result.names) - 1
    head = f"{cases} case{'' if cases == 1 else 's'}, {len(result.runs)} runs"
    if result.not_done:
        head = f"interrupted, not all was run of {', '.join(result.not_done)}; {head}"
    counts = [(told.value, sum(run.outcome is told for run in result.runs)) for told in _WORST_FIRST]
    return f"{head}: {', '.join(f'{count} {what}' for what, count in counts if count)}"


def _lines(text: str, width: int) -> list[str]:
    return textwrap.wrap(text, max(width, 60), initial_indent=_INDENT, subsequent_indent=_FURTHER)
