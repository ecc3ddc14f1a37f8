"""Checks as a table for people and as JSON for programs."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

import typer

from gantline.checks import Check, Outcome, Verdict, has_failed, outcome_of, verdict_of
from gantline.cli.messages import CHECK_FAILED, DONE, NO_VERDICT
from gantline.cli.table import ABSENT, wrapped
from gantline.results.ending import ending_of
from gantline.results.file.gaps import without_gaps

if TYPE_CHECKING:
    from gantline.results.recording import Recording

#: Width where the output is no terminal and nothing says otherwise.
_USUAL_WIDTH = 100
_VERDICT_WIDTH = 11
_INDENT = " " * (_VERDICT_WIDTH + 2)
_CODES = {Outcome.NO_GO: CHECK_FAILED, Outcome.NO_VERDICT: NO_VERDICT}
_COLOURS = {
    Verdict.OK: typer.colors.GREEN,
    Verdict.WARNING: typer.colors.YELLOW,
    Verdict.FAILED: typer.colors.RED,
}


def exit_code(checks: Sequence[Check]) -> int:
    """The code that tells a script what these checks say of a lift: only of a go it is `DONE`."""
    return _CODES.get(outcome_of(checks), DONE)


def width_of_terminal() -> int:
    """Columns that a line may have."""
    return shutil.get_terminal_size((_USUAL_WIDTH, 24)).columns


def styled(verdict: Verdict) -> str:
    """A verdict in its column, with colour on a terminal."""
    text = verdict.value.upper() if verdict is Verdict.FAILED else verdict.value
    return typer.style(f"{text:<{_VERDICT_WIDTH}}", fg=_COLOURS.get(verdict))


def check_table(
    checks: Sequence[Check],
    rule: str,
    *,
    style: Callable[[Verdict], str] = styled,
    width: int,
    full: bool,
    with_unlimited: bool = True,
) -> list[str]:
    """Lines of the table of checks, with the verdict on the lift below it.

    Args:
        checks: What was checked.
        rule: Rule that the limits come from; empty if none is named.
        style: How a verdict is written, as wide as all others.
        width: Columns that a line may have.
        full: Whether each check shows its meaning, its formula with numbers, and its source.
        with_unlimited: Whether each quantity that has no limit has a line too; else one line names them.
    """
    shown = [check for check in checks if with_unlimited or not _is_unlimited(check)]
    if not shown:
        return []
    title = f"Check ({rule})" if rule else "Check"
    rows = [_row(check) for check in shown]
    head = (title, "value", "limit", "used")
    # The rule's name may be longer than any check's: then it stands alone.
    fits = len(title) <= max(len(row[0]) for row in rows)
    columns = zip(*rows, head if fits else ("", *head[1:]), strict=True)
    widths = [max(map(len, column)) for column in columns]
    lines = [] if fits else [f"{_INDENT}{title}"]
    lines.append(f"{_INDENT}{_line((title if fits else '', *head[1:]), widths)}".rstrip())
    for check, row in zip(shown, rows, strict=True):
        line = f"{_line(row, widths)}"
        place = _place(check)
        beside = len(_INDENT) + len(line) + 2 + len(place) <= width
        lines.append(f"{style(check.verdict)}  {line}{f'  {place}' if place and beside else ''}".rstrip())
        notes = [] if beside or not place else [place]
        for note in (*notes, *_notes(check, full=full)):
            lines += wrapped(note, width, f"{_INDENT}  ", f"{_INDENT}    ")
    if len(shown) < len(checks):
        unlimited = _named([check for check in checks if check not in shown])
        lines += wrapped(unlimited, width, f"{'no limit':<{_VERDICT_WIDTH}}  ", f"{_INDENT}  ")
    return [*lines, "", *wrapped(verdict_of(checks), width)]


def _is_unlimited(check: Check) -> bool:
    """Whether a quantity is shown because everybody has to hand it in, and has nothing to be held against."""
    return check.verdict is Verdict.NOT_CHECKED and check.limit is None and bool(check.meaning)


def _named(unlimited: Sequence[Check]) -> str:
    """Names of quantities without a limit, with those apart that have no value either and count as such."""
    known = ", ".join(one.name for one in unlimited if one.has_no_limit)
    unknown = ", ".join(one.name for one in unlimited if not one.has_no_limit)
    return "; ".join(part for part in (known, unknown and f"not checked either: {unknown}") if part)


def _row(check: Check) -> tuple[str, str, str, str]:
    used = "" if check.utilisation is None else f"{100.0 * check.utilisation:.1f} %"
    sign = "" if check.limit is None else ">= " if check.at_least else "<= "
    limit = f"{sign}{check.shown(check.limit)}"
    if check.limit is None:
        limit = "no limit" if check.has_no_limit else ABSENT
    return check.name, check.shown(check.value) or ABSENT, limit, used or ABSENT


def _line(cells: Sequence[str], widths: Sequence[int]) -> str:
    first, *others = (f"{cell:<{width}}" for cell, width in zip(cells[:1], widths[:1], strict=True))
    numbers = (f"{cell:>{width}}" for cell, width in zip(cells[1:], widths[1:], strict=True))
    return "  ".join([first, *others, *numbers])


def _place(check: Check) -> str:
    parts = [
        check.element,
        f"at {check.time:.2f} s" if check.time is not None else "",
        f"(end of '{check.step}')" if check.step else "",
    ]
    return " ".join(part for part in parts if part)


def _notes(check: Check, *, full: bool) -> Iterator[str]:
    if full:
        if check.meaning:
            yield check.meaning
        if check.formula:
            yield f"= {check.formula}"
        if check.source:
            yield f"[{check.source}]"
    if check.remark:
        yield f"({check.remark})"


def checks_json(recording: Recording, checks: Sequence[Check]) -> str:
    """All checks of a recording as a JSON document, SI units; null for a value that is no number."""
    rig, ending = recording.rig, ending_of(recording)
    document = {
        "title": rig.title,
        "number": rig.number,
        "revision": rig.revision,
        "rule": rig.limits.get("rule"),
        "status": recording.attributes.get("status"),
        "ending": None if ending is None else ending.to_json(),
        "failed": has_failed(checks),
        "outcome": outcome_of(checks).value,
        "verdict": verdict_of(checks),
        "checks": [check.to_json() for check in checks],
        "refinement": recording.attributes.get("refinement"),
    }
    return json.dumps(without_gaps(document), indent=2, allow_nan=False)
