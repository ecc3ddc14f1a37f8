"""Loads: tilt, what keeps them from it, and what their supports have given up."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.checks.measure import Caution, Finding, extreme
from gantline.results.recording import Recording
from gantline.results.tilting import loose_tilt
from gantline.results.variable import BoolArray


def tilt(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle of a load's own z axis from plumb."""
    for load in recording.rig.loads:
        yield from extreme(recording, recording.column("load_tilt", load.name), during, load.name)
        loose = loose_tilt(recording, load)
        if loose is not None:
            yield Caution(str(loose))


def transferred(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """1 - support forces over weight."""
    for load in recording.rig.loads:
        yield from extreme(recording, recording.column("load_transferred", load.name), during, load.name)
