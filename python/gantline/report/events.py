"""Section of events: what happened when, to and fro of one thing told once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from gantline.report.section import Section
from gantline.report.subject import Subject

_MOST_EVENTS = 400
#: Changes there and back of one thing that follow each other so soon are one thing to read [s].
_SOON = 10.0
#: As many of them as each have a line of their own.
_FEW = 4
#: An edge that bounces comes off and down again within this, and is one contact to read [s].
_BOUNCES = 1.0
_BACK = {
    "taut": "slack",
    "stick": "slip",
    "lift_off": "set_down",
    "stop_hit": "stop_left",
    "rope_off_sheave": "rope_on_sheave",
    "too_close": "clear_again",
    "drum_slips": "drum_holds",
}
_PAIR = {kind: pair for pair in _BACK.items() for kind in pair}
#: What there may be hundreds of; where there is no room for all, these are left out first.
_LESSER = frozenset(("taut", "slack", "stick", "slip"))

Event = tuple[float, str, str]


@dataclass
class _Row:
    """An event, or several of one thing there and back."""

    events: list[Event]

    @property
    def is_lesser(self) -> bool:
        return self.events[0][1] in _LESSER

    def cells(self) -> tuple[str, str, str]:
        """Time, or first and last time [s], what happened, and to what."""
        time, kind, name = self.events[0]
        if len(self.events) == 1:
            return f"{time:.3f}", _words(kind), name
        last_time, last, _ = self.events[-1]
        if len(self.events) <= _FEW and last == kind:  # of a contact alone
            count = (len(self.events) - 1) // 2
            bounces = f"{_words(kind)}, with {count} bounce{'' if count == 1 else 's'}"
            return f"{time:.3f} – {last_time:.3f}", bounces, name
        there_and_back = "/".join(_words(one) for one in _PAIR[kind])
        return f"{time:.3f} – {self.events[-1][0]:.3f}", f"{there_and_back}, {len(self.events)} changes", name


def _words(kind: str) -> str:
    return kind.replace("_", " ")


class Events(Section):
    """What happened when."""

    anchor = "events"
    title = "Events"
    template = "events.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        rows = _rows(subject.recording.events())
        if not rows:
            return None
        kept = _kept(rows)
        return {"rows": [row.cells() for row in kept], "left_out": len(rows) - len(kept)}


def _rows(events: Sequence[Event]) -> list[_Row]:
    """Events in order of time; what goes there and back in a short time is one row, at its first time."""
    rows: list[_Row] = []
    open_rows: dict[tuple[str, tuple[str, str]], _Row] = {}
    for event in events:
        time, kind, name = event
        pair = _PAIR.get(kind)
        row = open_rows.get((name, pair)) if pair else None
        if row is not None and time - row.events[-1][0] <= _SOON:
            row.events.append(event)
            continue
        rows.append(_Row([event]))
        if pair:
            open_rows[name, pair] = rows[-1]
    single = [one for row in rows for one in ([row] if len(row.events) > _FEW else _few(row))]
    return sorted(single, key=lambda row: row.events[0][0])


def _few(row: _Row) -> list[_Row]:
    """A line for each of a few events; of a contact one for all that an edge does as it bounces."""
    lines: list[_Row] = []
    for event in row.events:
        is_contact = event[1] in ("lift_off", "set_down")
        if is_contact and lines and event[0] - lines[-1].events[-1][0] <= _BOUNCES:
            lines[-1].events.append(event)
        else:
            lines.append(_Row([event]))
    return lines


def _kept(rows: list[_Row]) -> list[_Row]:
    """As many rows as there is room for, in their order: the lesser ones go first, from the end."""
    if len(rows) <= _MOST_EVENTS:
        return rows
    order = sorted(range(len(rows)), key=lambda index: (rows[index].is_lesser, index))
    return [rows[index] for index in sorted(order[:_MOST_EVENTS])]
