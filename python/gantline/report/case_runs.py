"""Section of the cases whose whole plan was simulated, as `gantline cases --simulate` found them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from gantline.report.section import Section
from gantline.report.subject import ABSENT, Subject, number, show, typeset
from gantline.results.file.saved_case_runs import SavedCaseRun, SavedCaseRuns, SavedCheck

#: Cases beside each other in a field; more come in fields below.
_ACROSS = 8
#: Variants, and cases of the first page, that are named; of more the rest is counted.
_MOST_NAMED = 3
_TONES = {"go": "good", "no go": "bad", "stopped": "bad", "warns": "warn"}


class SimulatedCases(Section):
    """What each case comes to in a run of the whole plan, against all limits."""

    anchor = "simulated-cases"
    title = "Cases, simulated"
    template = "case_runs.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        found = subject.beside.case_runs
        if found is None:
            return None
        names = found.names
        return {
            "counts": found.counts,
            "notes": list(_notes(found)),
            "cases": [_case(subject, name, found) for name in names],
            "has_strokes": any(_stroke(found.of(name)) is not None for name in names),
            "fields": [
                _field(found, names[first : first + _ACROSS]) for first in range(0, len(names), _ACROSS)
            ],
            "nearest": [_nearest(found, *one) for one in found.nearest],
        }


def no_go_cases(subject: Subject) -> str:
    """Which cases are no go when simulated, for the verdict; empty where none is, or nobody has asked."""
    found = subject.beside.case_runs
    if found is None:
        return ""
    return _listed([_name(name) for name in found.names if any(_is_bad(run) for run in found.of(name))])


def simulated_cases(subject: Subject) -> dict[str, str] | None:
    """What the first page says of cases that were simulated; None where nobody has asked."""
    found = subject.beside.case_runs
    if found is None:
        return None
    nearest = ""
    if found.nearest:
        check, run = found.nearest[0]
        nearest = f"{_words(check.name)} {check.element} {check.share}, {_name(run.case)}"
    return {"counts": found.counts, "nearest": nearest}


def _name(case: str) -> str:
    return case or "as given"


def _words(check: str) -> str:
    return check.replace("_", " ")


def _listed(names: Sequence[str]) -> str:
    more = f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
    return ", ".join(names[:_MOST_NAMED]) + more


def _is_bad(run: SavedCaseRun) -> bool:
    return run.outcome == "NO-GO"


def _case(subject: Subject, name: str, found: SavedCaseRuns) -> dict[str, Any]:
    """One case with the worst of its peaks, and what came of it."""
    runs = found.of(name)

    def most(peak: str, *, of: Callable[[list[float]], float] = max) -> float | None:
        known = [run.peaks[peak] for run in runs if peak in run.peaks]
        return of(known) if known else None

    hook_load = most("peak_hook_load")
    told = found.outcome(name)
    return {
        "name": _name(name),
        "runs": len(runs),
        "told": told,
        "tone": _TONES.get(told, "warn"),
        "least": number(most("least_sling_tension_when_clear", of=min), "kN", 1),
        "most": number(most("peak_sling_tension"), "kN", 1),
        "hook_load": number(None if hook_load is None else hook_load / subject.rig.gravity, "t", 1),
        "tilt": number(most("peak_load_tilt"), "deg", 2),
        "stroke": number(_stroke(runs), "%", 0),
        "said": "; ".join(_said(runs)),
    }


def _stroke(runs: Sequence[SavedCaseRun]) -> float | None:
    """Largest share of a stroke that a moving sheave used [1]; None where there is none."""
    names = ("travel_used_up", "travel_used_down")
    return max((run.peaks[name] for run in runs for name in names if name in run.peaks), default=None)


def _said(runs: Sequence[SavedCaseRun]) -> Iterator[str]:
    """Why runs of a case are no go, or without a verdict: each reason once, with the variants."""
    variants: dict[tuple[str, str], list[str]] = {}
    # Of slings that are too short for the start the one that lacks most tells what all of them need.
    shortest = max(runs, key=lambda run: run.short)
    for run in runs:
        if run.cause:
            cause = shortest.cause if run.short else run.cause
            variants.setdefault((run.told, f": {cause}"), []).append(run.variant)
        elif run.outcome == "NO VERDICT":
            variants.setdefault(("no verdict", ""), []).append(run.variant)
        if run.failed:
            failed = f"{_listed([_words(name) for name in run.failed])} failed"
            variants.setdefault((failed, ""), []).append(run.variant)
    for (what, why), found in variants.items():
        where = "" if len(runs) == 1 else f" in {len(found)} of {len(runs)}"
        which = f" ({_listed(found)})" if len(found) < len(runs) else ""
        yield what + where + which + why


def _notes(found: SavedCaseRuns) -> Iterator[str]:
    """What is missing."""
    for name, reason in found.left_out.items():
        yield f"{name} was not simulated: {reason}."
    if found.not_done:
        yield f"Interrupted: not all variants were simulated of {', '.join(found.not_done)}."


def _field(found: SavedCaseRuns, cases: Sequence[str]) -> dict[str, Any]:
    """Shares of limits, of some cases beside each other."""
    return {
        "cases": [{"name": _name(name), "runs": len(found.of(name))} for name in cases],
        "rows": [
            {"limit": _words(check.name), "cells": [_cell(found.worst(name, check.name)) for name in cases]}
            for check, _ in found.nearest
        ],
    }


def _cell(check: SavedCheck | None) -> dict[str, str]:
    if check is None:
        return {"tone": "", "text": ABSENT}
    return {"tone": _tone(check), "text": check.share}


def _tone(check: SavedCheck) -> str:
    return "bad" if check.has_failed else "warn" if check.only_warns else "good"


def _nearest(found: SavedCaseRuns, check: SavedCheck, run: SavedCaseRun) -> dict[str, str]:
    in_case = _name(run.case)
    return {
        "limit": _words(check.name),
        "value": typeset(check.value) or ABSENT,
        "bound": typeset(check.limit) or ABSENT,
        "used": show(check.used, "%", 0) if check.used is not None and check.used <= 1.0 else check.share,
        "tone": _tone(check),
        "element": check.element,
        "case": f"{in_case}, {run.variant}" if run.variant and len(found.of(run.case)) > 1 else in_case,
    }
