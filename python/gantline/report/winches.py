"""Rows of the first page: what winches and strand jacks of `mechanics` pull."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from gantline.checks import values_of
from gantline.report.carried import load_cell, mass_of
from gantline.report.subject import Subject, as_given, number
from gantline.results import series
from gantline.results.gear import Drum
from gantline.results.ropes.upper_end import at_drum, own_weight, peak_at_upper_end

#: Rows that a first page has room for.
_MOST = 12


def winch_rows(subject: Subject) -> tuple[list[dict[str, Any]], int]:
    """Readings of the gauges of winches and jacks [t], their peaks, and what these are of what is rated.

    Of a lift that hangs in hooks those with a rated capacity, of any other all. Where there are too many,
    those that pull most stand there. Readings are of the part that is wound up; peak and share are those of
    the checks, of the tightest part at its upper end.

    Returns:
        The rows in the order of the lift file, and how many ropes are left out.
    """
    if not len(subject.recording.time) or not subject.is_lift:
        return [], 0
    wound = _wound(subject)
    by_pull = sorted(wound, key=lambda one: _peak(subject, one[1]), reverse=True)[:_MOST]
    rows = [_row(subject, one, *wound[one]) for one in wound if one in by_pull]
    return rows, len(wound) - len(rows)


def _wound(subject: Subject) -> dict[tuple[str, str], tuple[Drum, list[str]]]:
    """Drums and ropes by their names, a rope once for each drum: the drum, and which ends lie there."""
    wound: dict[tuple[str, str], tuple[Drum, list[str]]] = {}
    for drum in subject.rig.drums:
        if drum.rated_capacity or not subject.rig.hooks:
            for rope, end in zip(drum.ropes, drum.ends, strict=True):
                wound.setdefault((drum.joint, rope), (drum, []))[1].append(end)
    return wound


def _peak(subject: Subject, rope: str) -> float:
    """Largest pull at the upper end of a rope [N]; of an equilibrium what it is."""
    highest = None if subject.recording.is_equilibrium else peak_at_upper_end(subject.recording, rope)
    if highest is not None:
        return highest.tension
    pull = series.tightest_tension(subject.recording, rope) + own_weight(subject.recording, rope)
    return float(pull[-1])


def _row(subject: Subject, of: tuple[str, str], drum: Drum, ends: Sequence[str]) -> dict[str, Any]:
    recording, (name, rope) = subject.recording, of
    gauge = np.max([at_drum(recording, rope, end) for end in ends], axis=0)
    shares = values_of(recording, "drum_load_of_rated_capacity")
    return {
        "name": name,
        "rope": rope,
        "readings": [number(reading, "t", 1) for reading in load_cell(subject, gauge, is_alone=False)],
        "static": number(mass_of(subject, subject.static(gauge)), "t", 1),
        "peak": number(mass_of(subject, _peak(subject, rope)), "t", 1),
        "rated": as_given(mass_of(subject, drum.rated_capacity)),
        "used": number(shares.get(name, shares.get(f"{name}/{rope}")), "%", 1),
    }
