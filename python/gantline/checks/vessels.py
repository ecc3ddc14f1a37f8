"""Vessels: heel, trim and freeboard."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.checks.measure import Finding, extreme, to_either_side
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray


def heel(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Heel of a vessel to either side."""
    yield from to_either_side(recording, "vessel_heel", _names(recording), during)


def trim(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Trim of a vessel by bow or stern."""
    yield from to_either_side(recording, "vessel_trim", _names(recording), during)


def _names(recording: Recording) -> list[str]:
    return [vessel.name for vessel in recording.rig.vessels]


def freeboard(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Height of the lowest of deck edge and openings above the water."""
    for vessel in recording.rig.vessels:
        height = recording.column("vessel_freeboard", vessel.name)
        yield from extreme(recording, height, during, vessel.name, smallest=True)
