"""The lift in the seas of a grid as a table for people: a field for each direction."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator

from gantline.cli.table import ABSENT, table, tables
from gantline.results.file.saved_seas import SavedSeas, degrees

__all__ = ["seas_table"]

_INDENT, _FURTHER = "  ", "    "
#: Warnings that are told; of more the rest is counted.
_MOST_WARNINGS = 5


def seas_table(found: SavedSeas, width: int) -> list[str]:
    """Lines of all tables, with what stops the lift and what to know of them below."""
    kind = "height over period" if found.is_regular else "significant height over peak period"
    each = "" if found.is_regular and found.records == 1 else f", {_records(found.records)} of each sea"
    lasts = f", {found.duration:g} s" if found.duration > 0.0 else ""  # nobody knows of an old file
    short = f"; {found.short}" if found.short else ""
    head = f"Waves '{found.waves}', {kind}{each}{lasts}{short}; share of the limit that is used most"
    lines = [found.title, *textwrap.wrap(head, max(width, 60), subsequent_indent=_INDENT), ""]
    for direction in found.directions:
        lines += [*_field(found, direction, width), ""]
    lines += _stops(found, width)
    lines += _one_in_ten(found)
    for note in _notes(found):
        lines += textwrap.wrap(note, max(width, 60), initial_indent=_INDENT, subsequent_indent=_FURTHER)
    return lines


def _field(found: SavedSeas, direction: float, width: int) -> list[str]:
    """Seas of one direction, the highest on top, and the height that is allowed."""
    heights = found.heights[::-1]
    columns = []
    for period in found.periods:
        seas = found.of(direction, period)[::-1]
        cells = [" ".join(filter(None, (sea.share, sea.told))) for sea in seas]
        allowed = found.allowed[direction, period]
        # The lowest sea is left out by Ctrl-C alone, and then nobody knows.
        is_known = seas[-1].is_run or seas[-1].is_too_steep
        none = "none" if is_known else ABSENT
        columns.append([f"{period:g} s", *cells, none if allowed is None else f"{allowed:g} m"])
    first = [f"Towards {degrees(direction)}", *(f"{height:g} m" for height in heights), "allowed"]
    return [line for part in tables(first, columns, width=width) for line in part]


def _stops(found: SavedSeas, width: int) -> list[str]:
    """What the lift fails by in the first sea in which it is no go, a row for each direction and period."""
    rows = []
    reasons: list[str] = []
    for direction in found.directions:
        for period in found.periods:
            sea = found.stopper(direction, period)
            if sea is None:
                continue
            why = sea.by
            reason = sea.cause or ("" if sea.has_verdict else sea.verdict)
            if reason:
                reasons += [] if reason in reasons else [reason]
                why = f"[{reasons.index(reason) + 1}]"
            shown = (
                degrees(direction),
                f"{period:g} s",
                f"{sea.height:g} m",
                sea.share or ABSENT,
                str(sea.record),
            )
            rows.append((*shown, why))
    if not rows:
        return []
    lines = table(("Not allowed", "period", "height", "used", "record", "by"), rows, "lrrrrl")
    for number, reason in enumerate(reasons, 1):
        head = f"{_INDENT}[{number}] "
        lines += textwrap.wrap(reason, max(width, 60), initial_indent=head, subsequent_indent=" " * len(head))
    return [*lines, ""]


def _one_in_ten(found: SavedSeas) -> list[str]:
    """What one lift in ten uses of a limit in the highest sea that is allowed, by direction and period."""
    rows = []
    for direction in found.directions:
        for period in found.periods:
            sea = found.highest_allowed(direction, period)
            if sea is None or sea.extreme is None:
                continue
            told = sea.extreme.share + (" OVER" if sea.extreme.used > 1.0 else "")
            by = f"{sea.extreme.check} {sea.extreme.element}"
            rows.append((degrees(direction), f"{period:g} s", f"{sea.height:g} m", told, by))
    return [*table(("One lift in ten", "period", "height", "uses", "by"), rows, "lrrrl"), ""] if rows else []


def _notes(found: SavedSeas) -> Iterator[str]:
    """What to know of the tables."""
    left_out = [sea for sea in found.seas if not sea.is_run and not sea.is_too_steep]
    is_beyond = {found.stopper(sea.direction, sea.period) is not None for sea in left_out}
    if True in is_beyond:
        yield "not run: higher than a sea in which the lift is no go; --every runs these, too"
    if False in is_beyond:
        yield "not run: the search was interrupted before"
    if any(sea.is_too_steep for sea in found.seas):
        limit = "they would break" if found.is_regular else "DNV-RP-C205, 3.5.4"
        yield f"too steep: there are no such waves ({limit})"
    if any(sea.is_run and not sea.has_verdict for sea in found.seas):
        yield "no verdict: the checks cannot show that the lift is a go"
    if not found.is_regular and found.runs > found.unstarted:
        yield (
            f"by {_records(found.records)} of each sea: the chance that one more is worse than the worst of "
            f"them is 1 in {found.records + 1}; --records asks for more"
        )
    if _one_in_ten(found):
        yield (
            "one lift in ten uses so much of the limit or more, by Gumbel's distribution of the records of "
            "the sea, ± a standard error; OVER: more than all of it, though none of the records does"
        )
    past = [sea.by for sea in found.seas if sea.only_warns]
    if past:
        yield f"warns: past a limit that only warns, so the sea is allowed: {', '.join(dict.fromkeys(past))}"
    for warning in found.warnings[:_MOST_WARNINGS]:
        yield f"warning: {warning}"
    if len(found.warnings) > _MOST_WARNINGS:
        yield f"and {len(found.warnings) - _MOST_WARNINGS} more warnings, which --json has"


def _records(count: int) -> str:
    return f"{count} record{'' if count == 1 else 's'}"
