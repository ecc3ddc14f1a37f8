"""Steps of the plan: on the first page as far as it has room, the rest in a table on the second sheet."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from gantline.checks import LIMITS
from gantline.report.holds import shares
from gantline.report.section import Section
from gantline.report.subject import Subject, as_given, show, typeset
from gantline.results.afloat.moorings import MooringLine
from gantline.results.rig import Step
from gantline.results.ropes.tag_lines import TagLine

_MOST = 16
#: Of lifts afloat, whose vessels take room on the sheet.
_MOST_AFLOAT = 10
#: Lines that they may take together, and letters of one, about.
_MOST_LINES, _MOST_LINES_AFLOAT = 30, 21
_WIDE = 38
#: So few that when to stop has room in their column.
_FEW = 6

#: Steps whose speed is that of something that goes along a line.
_ALONG = ("hoist", "lower", "traverse", "travel", "lead", "haul_in", "pay_out", "haul", "veer")
#: Keys by which a step stops at a time.
_AT_A_TIME = ("brake_from", "emergency_stop_at")
#: Steps whose speed is that of a boom or an upper structure that turns.
_TURNING = ("luff", "slew")


class StepsContinued(Section):
    """The steps for which the first page has no room: nobody signs for steps that the sheets leave out."""

    anchor = "steps"
    title = "Steps, continued"
    template = "steps.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        every = step_rows(subject)
        first = _most(subject, every)
        rows = every[first:]
        return {"rows": rows, "first": first + 1} if rows else None


def first_steps(subject: Subject) -> dict[str, Any]:
    """Steps of the first page, in words where the others are, and whether their column has room for more."""
    rows = step_rows(subject)
    most = _most(subject, rows)
    left = len(rows) - most
    joint = "and" if left == 2 else "to"
    numbers = f"Step {len(rows)}" if left == 1 else f"Steps {most + 1} {joint} {len(rows)}"
    return {
        "rows": rows[:most],
        "elsewhere": numbers if left > 0 else "",
        "has_room": 0 < len(rows) <= _FEW,
    }


def step_rows(subject: Subject) -> list[dict[str, Any]]:
    """Each step of the plan: when it begins, what it does, waits for and requires, how hooks share then."""
    times = {name: time for time, _, name in subject.recording.events("step_begin")}
    ends = {name: time for time, _, name in subject.recording.events("step_end")}
    rig, shared = subject.rig, shares(subject)
    hooks = {hook.name for hook in rig.hooks}
    made_fast: list[MooringLine | TagLine] = [*rig.mooring_lines, *rig.tag_lines]
    lines = {line.rope: line.name for line in made_fast}
    return [
        {
            "name": step.step,
            "begin": show(times.get(step.step), "s", 1),
            "does": _does(step, hooks, lines),
            "until": _waits(step, ends.get(step.step)),
            "is_hold": _is_hold_point(step, rig.plan[-1]),
            "shares": shared.get(step.step, ""),
            "require": ", ".join(_requirement(key, bounds) for key, bounds in step.require.items()),
        }
        for step in rig.plan
    ]


def _most(subject: Subject, rows: Sequence[dict[str, Any]]) -> int:
    """How many steps the first page has room for: so many, or fewer that take as many lines as it has."""
    is_afloat = bool(subject.rig.vessels)
    most, left = (_MOST_AFLOAT, _MOST_LINES_AFLOAT) if is_afloat else (_MOST, _MOST_LINES)
    for place, row in enumerate(rows[:most]):
        left -= _lines(row)
        if left < 0:
            return max(1, place)
    return most


def _lines(row: Mapping[str, Any]) -> int:
    """Lines that a step takes in its column, about."""
    words = [row["name"], "hold point" if row["is_hold"] else "", row["begin"], row["does"], row["until"]]
    text = "  ".join(part for part in (*words, row["shares"]) if part)
    return math.ceil(len(text) / _WIDE) + math.ceil(len(row["require"]) / _WIDE)


def _is_hold_point(step: Step, last: Step) -> bool:
    """Whether something waits for a release: after the last step nothing does, unless it requires some."""
    return step.kind == "hold" and (step is not last or bool(step.require))


def _does(step: Step, hooks: set[str], lines: Mapping[str, str]) -> str:
    """What a step moves, how fast and how far, with which pins, and what goes or comes as it begins.

    `lines` are names of mooring and tag lines in the lift file by those of their ropes.
    """
    pins = [
        f"{words} pins of {', '.join(names)}"
        for words, names in (("pull", step.pull_pins), ("put in", step.put_in_pins))
        if names
    ]
    gear = [
        f"{words} {', '.join(name.removeprefix('sling.') for name in names)}"
        for words, names in (
            ("take off", step.detach),
            ("put on", step.attach),
            ("let go of", [lines[name] for name in step.cut if name in lines]),
            ("cut", [name for name in step.cut if name not in lines]),
            ("take away", step.remove_supports),
            ("open", [*step.open_hinges, *step.open_holes]),
            ("close", step.close_holes),
        )
        if names
    ]
    verb = "" if step.kind == "hold" else step.kind.replace("_", " ")
    moved = f"{verb}{_moved(step, hooks)}{_speed(step)}{_way(step)}{_pumped(step)}"
    return "; ".join(part for part in (moved, *_still(step), *pins, *gear) if part)


def _waits(step: Step, end: float | None) -> str:
    """What a step waits for and when that was, or that it never was; when one stops that does by time."""
    when = "not met" if end is None else show(end, "s", 1)
    if step.until:
        return typeset(f"until {step.until}, {when}")
    return f"until {when}" if step.ends_by in _AT_A_TIME and end is not None else ""


def _still(step: Step) -> list[str]:
    """Which hooks are kept still against heave, and over what."""
    over = step.relative_to or "the ground"
    names = ", ".join(step.compensate_heave)
    return [f"{names} kept still over {over}"] if names else []


def _moved(step: Step, hooks: set[str]) -> str:
    """What moves, unless that is every hook of the lift."""
    drives = {drive.removesuffix(".hoist") for drive in step.drives}
    all_lead = step.way is not None and len(step.moves) == len(hooks)
    return "" if not step.moves or drives == hooks or all_lead else f" {', '.join(step.moves)}"


def _speed(step: Step) -> str:
    if step.speed is None:
        return ""
    # What follows a load goes as fast as that asks for, and no faster than this.
    most = " up to" if step.keep_plumb else ""
    if step.kind in _TURNING:
        return f"{most} {np.rad2deg(60.0 * step.speed):.3g} deg/min"
    return f"{most} {60.0 * step.speed:.3g} m/min" if step.kind in _ALONG else ""


def _pumped(step: Step) -> str:
    """From where to where liquid is pumped, how fast and how much."""
    if step.rate is None:
        return ""
    source, target = step.pumps
    much = "" if step.pumped is None else f", {as_given(step.pumped)} t in all"
    return f" from {source} to {target} at {as_given(3600.0 * step.rate)} t/h{much}"


def _way(step: Step) -> str:
    """How far it goes, to where, which way, or after what."""
    if step.keep_plumb:
        return f", keeps {', '.join(step.keep_plumb)} plumb"
    if step.towards:
        return f" towards {step.towards}"
    if step.way is not None:
        return _led(step.way, step.turn)
    way = next(
        ((word, value) for word, value in (("by", step.by), ("to", step.to)) if value is not None), None
    )
    if way is None:
        return ""
    word, value = way
    return f" {word} {_length(np.rad2deg(value), 'deg') if step.kind in _TURNING else _length(value, 'm')}"


def _led(way: Sequence[float], turn: float) -> str:
    """How far a load is led, along which axes, and by how much it turns."""
    parts = [f"{_length(part, 'm')} along {axis}" for part, axis in zip(way, "xyz", strict=True) if part]
    level = f" by {', '.join(parts)}" if parts else ""
    return f"{level}, turned by {_length(np.rad2deg(turn), 'deg')}" if turn else level


def _length(value: float, unit: str) -> str:
    """As somebody gave it, to the millimetre or the thousandth of a degree."""
    digits = f"{value:.3f}".rstrip("0").rstrip(".")
    return typeset(f"{'0' if digits == '-0' else digits} {unit}")


def _requirement(key: str, bounds: Any) -> str:
    measure = LIMITS.get(key)
    texts = []
    for side, limit in bounds.items():
        bound = show(float(limit), measure.unit, measure.digits) if measure else str(limit)
        texts.append(f"{key.replace('_', ' ')} {side} {bound}")
    return ", ".join(texts)
