"""Rows of the first page: what winches and strand jacks of `mechanics` pull."""

from __future__ import annotations

from typing import Any

from gantline.checks import values_of
from gantline.report.carried import load_cell, mass_of
from gantline.report.subject import Subject, as_given, number
from gantline.results import series
from gantline.results.gear import Drum
from gantline.results.ropes.upper_end import own_weight, peak_at_upper_end

#: Rows that a first page has room for.
_MOST = 12


def winch_rows(subject: Subject) -> tuple[list[dict[str, Any]], int]:
    """Readings of the gauges of winches and jacks [t], their peaks, and what these are of what is rated.

    Of a lift that hangs in hooks those with a rated capacity, of any other all. Where there are too many,
    those that pull most stand there.

    Returns:
        The rows in the order of the lift file, and how many ropes are left out.
    """
    drums = [one for one in subject.rig.drums if one.rated_capacity or not subject.rig.hooks]
    ropes = [(drum, rope) for drum in drums for rope in drum.ropes] if subject.is_lift else []
    if not len(subject.recording.time):
        return [], 0
    by_pull = sorted(ropes, key=lambda one: _peak(subject, one[1]), reverse=True)[:_MOST]
    rows = [_row(subject, drum, rope) for drum, rope in ropes if (drum, rope) in by_pull]
    return rows, len(ropes) - len(rows)


def _peak(subject: Subject, rope: str) -> float:
    """Largest pull at the upper end of a rope [N]; of an equilibrium what it is."""
    highest = None if subject.recording.is_equilibrium else peak_at_upper_end(subject.recording, rope)
    if highest is not None:
        return highest.tension
    pull = series.tightest_tension(subject.recording, rope) + own_weight(subject.recording, rope)
    return float(pull[-1])


def _row(subject: Subject, drum: Drum, rope: str) -> dict[str, Any]:
    recording, name = subject.recording, drum.joint
    pull = series.tightest_tension(recording, rope) + own_weight(recording, rope)
    shares = values_of(recording, "drum_load_of_rated_capacity")
    return {
        "name": name,
        "rope": rope,
        "readings": [number(reading, "t", 1) for reading in load_cell(subject, pull, is_alone=False)],
        "static": number(mass_of(subject, subject.static(pull)), "t", 1),
        "peak": number(mass_of(subject, _peak(subject, rope)), "t", 1),
        "rated": as_given(mass_of(subject, drum.rated_capacity)),
        "used": number(shares.get(name, shares.get(f"{name}/{rope}")), "%", 1),
    }
