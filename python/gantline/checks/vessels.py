"""Vessels: heel, trim, freeboard and what rights them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Literal

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.checks.measure import Caution, Finding, Found, Missing, Refused, extreme
from gantline.results import series
from gantline.results.afloat.vessels import Vessel
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity

_UNTIL_PUSHED = "it lies so only while nothing pushes it, and turns over where anything does"


def heel(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Heel of a vessel to either side."""
    yield from _leans(recording, during, "heel")


def trim(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Trim of a vessel by bow or stern."""
    yield from _leans(recording, during, "trim")


def _leans(recording: Recording, during: BoolArray, way: Literal["heel", "trim"]) -> Iterator[Found]:
    for vessel in recording.rig.vessels:
        lies = recording.column(f"vessel_{way}", vessel.name)
        with_design = np.abs(lies + by_contingency(recording, vessel, way))
        for one in extreme(recording, np.abs(lies), during, vessel.name):
            worst = float(with_design[during].max())
            yield replace(one, at_design=worst if worst > one.value else None)


def by_contingency(
    recording: Recording, vessel: Vessel, of: Literal["heel", "trim", "freeboard"]
) -> FloatArray:
    """What the design weight changes of how a vessel lies, shape (time,) [rad, m].

    Known where steps end and tanks get or lose their surface; in between it is taken to change evenly.

    Args:
        recording: The recording.
        vessel: One of its vessels.
        of: What changes.
    """
    known = vessel.by_contingency
    if not known:
        return np.zeros(len(recording.time))
    changes: FloatArray = np.interp(
        recording.time, [one.time for one in known], [getattr(one, of) for one in known]
    )
    return changes


def freeboard(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Height of the lowest of deck edge and openings above the water.

    What goes under between two samples, and comes out, is seen by its event alone.
    """
    for vessel in recording.rig.vessels:
        height = recording.column("vessel_freeboard", vessel.name)
        least = float((height + by_contingency(recording, vessel, "freeboard"))[during].min(initial=np.inf))
        for one in extreme(recording, height, during, vessel.name, smallest=True):
            yield replace(one, at_design=least if least < one.value else None)
        if not (during.all() and height.min() >= 0.0):
            continue
        marks = {f"{vessel.name}.{mark}": mark for mark in vessel.marks}
        for time, _, name in [one for one in recording.events("flooding") if one[2] in marks][:1]:
            reason = f"its {marks[name]} goes under water between two samples"
            yield Refused(vessel.name, reason, Found(0.0, vessel.name, time))


def metacentric_height(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """GM of a vessel for heel, as an equilibrium knows it.

    Of a run the least of where it begins at rest, steps of its plan end, and it ends.
    """
    known = [vessel for vessel in recording.rig.vessels if vessel.righting]
    for vessel in known:
        time, height, _ = min(vessel.righting, key=lambda one: one[1])
        changes = {one.time: one.metacentric_height for one in vessel.by_contingency}
        with_design = [(one[0], one[1], changes.get(one[0])) for one in vessel.righting]
        least = min((gm + change for _, gm, change in with_design if change is not None), default=height)
        yield Found(height, vessel.name, time, at_design=least if least < height else None)
        unknown = [moment for moment, _, change in with_design if change is None]
        if unknown and any(load.more_mass > 0.0 for load in recording.rig.loads):
            yield Caution(
                f"what the design weight leaves of GM of {vessel.name} at {unknown[0]:.4g} s is not known, "
                "no equilibrium tells it: 'weight: {simulate: design}' does"
            )
    if known and recording.is_equilibrium:
        yield from _held_by_their_slings(recording)
    for vessel in recording.rig.vessels:
        if vessel.is_carried:
            yield Missing(vessel.name, "it moves by 'wave_motion', whatever rights it")
        elif vessel not in known:
            yield Missing(
                vessel.name, "what rights it is known where a run begins at rest, a step ends or it has ended"
            )


def _held_by_their_slings(recording: Recording) -> Iterator[Caution]:
    """Loads that press against what floats or moves while slings carry a part of them: GM is of both then.

    A run asks what rights its vessels with friction too, and takes the least.
    """
    for load in recording.rig.loads:
        presses = any(recording.column("contact_force", contact)[-1] > 0.0 for contact in load.meets)
        if presses and series.ends_partly_lifted(recording, load):
            yield Caution(
                f"{load.name}, partly lifted, holds its crane to what it stands on: set down with slack "
                "slings it may leave less; '--held' and a run say how much"
            )


def turn_over(recording: Recording) -> list[Check]:
    """A failure for each vessel that nothing rights: nothing in a run need push it.

    A warning for one that nothing rights with the design weight, or of which no equilibrium with it is found.
    """
    meaning = "what floats comes back where something heels or trims it"
    checks = []
    for vessel in recording.rig.vessels:
        for verdict, time, remark in [*_unrighted(vessel), *_unrighted_at_design(vessel)][:1]:
            checks.append(
                Check("floats_stably", verdict, meaning, element=vessel.name, time=time, remark=remark)
            )
    return checks


def _unrighted(vessel: Vessel) -> Iterator[tuple[Verdict, float, str]]:
    """When nothing rights a vessel [s], and in words."""
    for time, *heights in vessel.righting:
        if min(heights) < 0.0:
            shown = format_quantity(min(heights), "m", 2)
            yield Verdict.FAILED, time, f"its GM is {shown}: {_UNTIL_PUSHED}"


def _unrighted_at_design(vessel: Vessel) -> Iterator[tuple[Verdict, float, str]]:
    """The same with the design weight of loads, which is not simulated."""
    for one in vessel.by_contingency:
        if one.least_height is not None:
            shown = format_quantity(one.least_height, "m", 3)
            yield Verdict.WARNING, one.time, f"with the design weight its GM is {shown}: {_UNTIL_PUSHED}"
        elif not one.rests:
            said = "with the design weight no equilibrium is found from here"
            yield Verdict.WARNING, one.time, f"{said}: 'weight: {{simulate: design}}' tells"
