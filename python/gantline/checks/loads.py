"""Loads: tilt, what keeps them from it, what their supports have given up, slings that run through them."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gantline.checks.check import Check, Verdict
from gantline.checks.measure import Caution, Finding, extreme, named
from gantline.results.recording import Recording
from gantline.results.through import slings_through_loads
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


def run_through(recording: Recording) -> list[Check]:
    """A warning where slings that carry run through a load: nothing in a simulation holds them off."""
    found = slings_through_loads(recording)
    if not found:
        return []
    worst = max(found, key=lambda one: math.inf if one.at is None else one.at)
    slings = named(one.sling for one in found)
    how = "hung from within or below" if worst.at is None else "through the skin of"
    off = "" if worst.at is None else f", up to {worst.at:.2f} m from their ends"
    return [
        Check(
            "sling_outside_load",
            Verdict.WARNING,
            "slings that carry stay outside of the load as drawn",
            element=worst.sling,
            time=worst.time,
            remark=f"{slings} {how} '{worst.load}'{off}",
        )
    ]
