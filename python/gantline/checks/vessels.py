"""Vessels: heel, trim and freeboard."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.checks.check import Check, Verdict
from gantline.checks.measure import Finding, Found, Refused, extreme, to_either_side
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray
from gantline.units import format_quantity


def heel(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Heel of a vessel to either side."""
    yield from to_either_side(recording, "vessel_heel", _names(recording), during)


def trim(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Trim of a vessel by bow or stern."""
    yield from to_either_side(recording, "vessel_trim", _names(recording), during)


def _names(recording: Recording) -> list[str]:
    return [vessel.name for vessel in recording.rig.vessels]


def freeboard(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Height of the lowest of deck edge and openings above the water.

    What goes under between two samples, and comes out, is seen by its event alone.
    """
    for vessel in recording.rig.vessels:
        height = recording.column("vessel_freeboard", vessel.name)
        yield from extreme(recording, height, during, vessel.name, smallest=True)
        if not (during.all() and height.min() >= 0.0):
            continue
        marks = {f"{vessel.name}.{mark}": mark for mark in vessel.marks}
        for time, _, name in [one for one in recording.events("flooding") if one[2] in marks][:1]:
            reason = f"its {marks[name]} goes under water between two samples"
            yield Refused(vessel.name, reason, Found(0.0, vessel.name, time))


def turn_over(recording: Recording) -> list[Check]:
    """A failure for each vessel that nothing rights: nothing in a run need push it."""
    meaning = "what floats comes back where something heels or trims it"
    checks = []
    for vessel in recording.rig.vessels:
        for time, height in vessel.overturning[:1]:
            shown = format_quantity(height, "m", 2)
            lies = "it lies so only while nothing pushes it, and turns over where anything does"
            checks.append(
                Check(
                    "floats_stably",
                    Verdict.FAILED,
                    meaning,
                    element=vessel.name,
                    time=time,
                    remark=f"its GM is {shown}: {lies}",
                )
            )
    return checks
