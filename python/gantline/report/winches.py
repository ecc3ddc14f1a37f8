"""Rows of the first page: what winches and strand jacks of `mechanics` pull."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from gantline.checks import values_of
from gantline.checks.drums import lifts_loads
from gantline.report.carried import load_cell, mass_of
from gantline.report.subject import Subject, as_given, number
from gantline.results import series
from gantline.results.gear import Drum
from gantline.results.ropes.upper_end import at_drum, own_weight, peak_at_upper_end
from gantline.results.variable import FloatArray

#: Rows that a first page has room for.
_MOST = 12


@dataclass(frozen=True)
class Gauge:
    """What is read of a rope on a drum.

    Attributes:
        drum: The drum; of one on several diameters that on which the rope lies first.
        rope: Name of the rope.
        reads: Pull of the part that comes to the drum, shape (time,) [N].
    """

    drum: Drum
    rope: str
    reads: FloatArray


def winch_gauges(subject: Subject) -> tuple[list[Gauge], int]:
    """Gauges of winches and jacks that have room on a first page, and how many have none.

    Of a lift that hangs in hooks those with a rated capacity or that lift beside them, of any other all.
    Where there are too many, those that pull most stand there, in the order of the lift file. A rope with
    both ends on one drum is read once, at the end that pulls more.
    """
    if not subject.is_lift or not subject.rig.drums or not len(subject.recording.time):
        return [], 0
    wound: dict[tuple[str, str], tuple[Drum, list[str]]] = {}
    for drum in subject.rig.drums:
        for rope, end in zip(drum.ropes, drum.ends, strict=True):
            if drum.rated_capacity or lifts_loads(subject.recording, rope):
                wound.setdefault((drum.joint, rope), (drum, []))[1].append(end)
    by_pull = sorted(wound, key=lambda one: _peak(subject, one[1]), reverse=True)[:_MOST]
    gauges = []
    for one, (drum, ends) in wound.items():
        if one in by_pull:
            reads = np.max([at_drum(subject.recording, one[1], end) for end in ends], axis=0)
            gauges.append(Gauge(drum, one[1], reads))
    return gauges, len(wound) - len(gauges)


def winch_rows(subject: Subject) -> tuple[list[dict[str, Any]], int]:
    """Readings of gauges of winches and jacks [t], peaks, and what these are of what is rated.

    Readings are of the part that is wound up; peak and share are those of the checks, of the tightest part at
    its upper end.

    Returns:
        The rows in the order of the lift file, and how many ropes are left out.
    """
    gauges, left_out = winch_gauges(subject)
    return [_row(subject, gauge) for gauge in gauges], left_out


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
