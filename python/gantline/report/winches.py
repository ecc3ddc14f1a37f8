"""Rows of the first page: what winches and strand jacks of `mechanics` pull."""

from __future__ import annotations

from typing import Any

from gantline.checks import Gauge, lug_figures, values_of, winch_gauges
from gantline.report.carried import load_cell, mass_of
from gantline.report.subject import Subject, as_given, number
from gantline.results import series
from gantline.results.ropes.upper_end import own_weight, peak_at_upper_end

#: Rows that a first page has room for.
_MOST = 12


def gauges_with_room(subject: Subject) -> tuple[list[Gauge], int]:
    """Gauges of winches and jacks that have room on a first page, and how many have none.

    Where there are too many, those that pull most stand there, in the order of the lift file.
    """
    gauges = winch_gauges(subject.recording)
    by_pull = sorted(gauges, key=lambda gauge: _peak(subject, gauge.rope), reverse=True)[:_MOST]
    return [gauge for gauge in gauges if any(gauge is one for one in by_pull)], len(gauges) - len(by_pull)


def winch_rows(subject: Subject) -> tuple[list[dict[str, Any]], int]:
    """Readings of gauges of winches and jacks [t], peaks, and what these are of what is rated, and of lugs.

    Readings are of the part that is wound up; peak and share are those of the checks, of the tightest part at
    its upper end.

    Returns:
        The rows in the order of the lift file, and how many ropes are left out.
    """
    gauges, left_out = gauges_with_room(subject)
    lugs = _shares_of_lugs(subject) if gauges else {}
    return [_row(subject, gauge) | {"lug_used": lugs.get(gauge.rope)} for gauge in gauges], left_out


def _shares_of_lugs(subject: Subject) -> dict[str, str]:
    """What of the capacity of the lug that it is made fast to is used, by rope; of those that have one."""
    known = [one for one in lug_figures(subject.recording) if one.used is not None]
    return {rope: number(one.used, "%", 1) for one in known for rope in one.slings}


def _peak(subject: Subject, rope: str) -> float:
    """Largest pull at the upper end of a rope [N]; of an equilibrium what it is."""
    highest = None if subject.recording.is_equilibrium else peak_at_upper_end(subject.recording, rope)
    if highest is not None:
        return highest.tension
    pull = series.tightest_tension(subject.recording, rope) + own_weight(subject.recording, rope)
    return float(pull[-1])


def _row(subject: Subject, gauge: Gauge) -> dict[str, Any]:
    name, rope, reads = gauge.drum.joint, gauge.rope, gauge.reads
    shares = values_of(subject.recording, "drum_load_of_rated_capacity")
    return {
        "name": name,
        "rope": rope,
        "readings": [number(reading, "t", 1) for reading in load_cell(subject, reads, is_alone=False)],
        "static": number(mass_of(subject, subject.static(reads)), "t", 1),
        "peak": number(mass_of(subject, _peak(subject, rope)), "t", 1),
        "rated": as_given(mass_of(subject, gauge.drum.rated_capacity)),
        "used": number(shares.get(name, shares.get(f"{name}/{rope}")), "%", 1),
    }
