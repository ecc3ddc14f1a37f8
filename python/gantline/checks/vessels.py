"""Vessels: heel, trim and freeboard."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.checks.measure import Finding, extreme
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray


def heel(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Heel of a vessel to either side."""
    yield from _angle(recording, during, "vessel_heel")


def trim(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Trim of a vessel by bow or stern."""
    yield from _angle(recording, during, "vessel_trim")


def _angle(recording: Recording, during: BoolArray, variable: str) -> Iterator[Finding]:
    for vessel in recording.rig.vessels:
        angle = np.abs(recording.column(variable, vessel.name))
        yield from extreme(recording, angle, during, vessel.name)


def freeboard(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Height of the lowest of deck edge and openings above the water."""
    for vessel in recording.rig.vessels:
        height = recording.column("vessel_freeboard", vessel.name)
        yield from extreme(recording, height, during, vessel.name, smallest=True)
