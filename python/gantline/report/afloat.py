"""Rows of the first page of lifts afloat: how vessels lie after each step, sea, moorings, sudden release.

In waves, how a vessel lies at one moment says no more than where in a wave it was: there the table has means
over the end of each step, and the least freeboard in it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from gantline.report.seas import allowed_seas
from gantline.report.subject import ABSENT, Subject, number, share, show
from gantline.results import series
from gantline.results.afloat.tanks import ran_through_holes
from gantline.results.afloat.vessels import AS_CARRIED, Vessel
from gantline.results.alike import first_peak
from gantline.results.file.saved import SavedLostLoad, SavedSwing
from gantline.results.loads.contact_peaks import contact_peak
from gantline.results.progress import spans
from gantline.results.ropes.parting import PLANNED, partings
from gantline.results.rotation import axes
from gantline.results.variable import BoolArray, FloatArray

#: Rows of a vessel that the first page has.
_MOST_ROWS = 5
#: Draft [m] and angle [rad] by which a vessel lies otherwise after a step than before it.
_SAME_DRAFT, _SAME_ANGLE = 0.02, 0.0005
#: Share of what a tank holds at most whose change counts as pumped.
_MOVED = 1e-6
_MOST_TANKS = 6

#: How a vessel lies at a moment: variable, unit, decimals.
_LIES = (
    ("vessel_draft_aft", "m", 2),
    ("vessel_draft_forward", "m", 2),
    ("vessel_trim", "deg", 2),
    ("vessel_heel", "deg", 2),
    ("vessel_freeboard", "m", 2),
)

#: What is told of the whole way where the table does not have it: words, variable, unit, what is no
#: difference, and of what it is the largest value.
_EXTREMES: tuple[tuple[str, str, str, float, Callable[[FloatArray], FloatArray]], ...] = (
    ("heel", "vessel_heel", "deg", _SAME_ANGLE, np.abs),
    ("trim", "vessel_trim", "deg", _SAME_ANGLE, np.abs),
    ("least freeboard", "vessel_freeboard", "m", _SAME_DRAFT, np.negative),
)


@dataclass(frozen=True)
class _Moment:
    """When a table says how a vessel lies.

    Attributes:
        name: Of the step that ends then.
        begin: Its first sample.
        at: Its last sample.
    """

    name: str
    begin: int
    at: int


def vessel_tables(subject: Subject) -> list[dict[str, Any]]:
    """How each vessel lies at the start and at the end of each step, with its ballast."""
    if not len(subject.recording.time):
        return []
    return [_vessel(subject, vessel) for vessel in subject.rig.vessels]


def _vessel(subject: Subject, vessel: Vessel) -> dict[str, Any]:
    recording = subject.recording
    tanks = [tank for tank in subject.rig.tanks if tank.name.startswith(f"{vessel.name}.")]
    held = sum((recording.column("tank_content", tank.name) for tank in tanks), np.zeros(len(recording.time)))
    moments = _changes(subject, vessel)
    rows = [
        {
            "name": moment.name,
            "lies": [
                number(_value(subject, vessel, variable, moment), unit, digits)
                for variable, unit, digits in _LIES
            ],
            "displacement": number(_value(subject, vessel, "vessel_displacement", moment), "t", 0),
            "ballast": number(float(held[moment.at]), "t", 0) if tanks else ABSENT,
        }
        for moment in moments
    ]
    return {
        "name": vessel.name,
        "when": _when(subject, moments) + (f"; {AS_CARRIED}" if vessel.is_carried else ""),
        "rows": rows,
        "left_out": max(0, len(_moments(subject)) - len(moments)),
        "beyond": _beyond(subject, vessel, moments),
        "gm": _gm(subject, vessel),
        "may_have_gm": not vessel.is_carried,
        "pumped": _pumped(subject, vessel),
        "has_tanks": bool(tanks),
    }


def _when(subject: Subject, moments: Sequence[_Moment]) -> str:
    """Of which part of each step the numbers of a table are."""
    last = subject.rig.time_to_average
    if last == 0.0:
        return "at the end of each step"
    time = subject.recording.time
    is_short = any(time[moment.at] - time[moment.begin] < last for moment in moments[1:])
    whole = ", or all of a shorter one" if is_short else ""
    over = ", over still water" if subject.rig.moved_in_still_water else ""
    return f"mean over the last {show(last, 's', 0)} of each step{whole}; freeboard: the least in it{over}"


def _value(subject: Subject, vessel: Vessel, variable: str, moment: _Moment) -> float:
    """How a vessel lies at the end of a step; in waves and gusts a mean over it, the freeboard its least."""
    values = subject.recording.column(variable, vessel.name)
    last = subject.rig.time_to_average
    if last == 0.0:
        return float(values[moment.at])
    during = values[moment.begin : moment.at + 1]
    if variable == "vessel_freeboard":
        return float(during.min())
    time = subject.recording.time[moment.begin : moment.at + 1]
    late = time >= time[-1] - last
    return series.mean_over(time[late], during[late])


def _moments(subject: Subject) -> list[_Moment]:
    """The start, and the end of each step that has begun, with their samples; of several together one.

    Where a run did not reach its end, that too.
    """
    time = subject.recording.time
    ends: dict[float, tuple[float, str]] = {}
    for name, (begin, end) in spans(subject.recording).items():
        if end > begin or end == time[-1]:
            ends[begin] = (max(end, ends[begin][0]) if begin in ends else end, name)

    def sample(moment: float) -> int:
        return max(0, int(np.searchsorted(time, moment, side="right")) - 1)

    moments = sorted((end, begin, name) for begin, (end, name) in ends.items())
    steps = [_Moment(name, sample(begin), sample(end)) for end, begin, name in moments]
    known = [_Moment("at the start", 0, 0), *steps]
    last = len(time) - 1
    # Of a run that failed between steps, or without a plan, the end is what there is to see.
    is_missing = subject.ending is not None and known[-1].at < last
    return [*known, _Moment("where the run ended", last, last)] if is_missing else known


def _changes(subject: Subject, vessel: Vessel) -> list[_Moment]:
    """The start, the end, and of the other moments those with the largest changes of how it lies."""
    found = _moments(subject)
    if len(found) <= _MOST_ROWS:
        return found
    scale = {"vessel_draft_aft": _SAME_DRAFT, "vessel_draft_forward": _SAME_DRAFT, "vessel_heel": _SAME_ANGLE}
    lies = [
        np.array([_value(subject, vessel, name, moment) / step for name, step in scale.items()])
        for moment in found
    ]
    kept = [0]
    for place in range(1, len(found)):
        if np.abs(lies[place] - lies[kept[-1]]).max() > 1.0:
            kept.append(place)
    steps = list(pairwise(kept))
    steps.sort(key=lambda two: -float(np.abs(lies[two[1]] - lies[two[0]]).max()))
    shown = {0, len(found) - 1, *(place for _, place in steps[: _MOST_ROWS - 2])}
    return [found[place] for place in sorted(shown)]


def _beyond(subject: Subject, vessel: Vessel, moments: Sequence[_Moment]) -> str:
    """How much farther a vessel heels, trims and sinks on the way than a table of some moments says."""
    said = []
    for words, variable, unit, same, sign in _EXTREMES:
        values = sign(subject.recording.column(variable, vessel.name))
        told = max(float(sign(np.array(_value(subject, vessel, variable, moment)))) for moment in moments)
        peak = subject.peak(values)
        if peak is not None and peak[0] > told + same:
            at = int(np.searchsorted(subject.recording.time, peak[1]))
            value = float(subject.recording.column(variable, vessel.name)[at])
            said.append(f"{words} {show(value, unit, 2)} at {show(peak[1], 's', 0)}")
    return ", ".join(said)


def _gm(subject: Subject, vessel: Vessel) -> str:
    """GM at rest as `gantline statics` found it beside the recording; empty where it did not."""
    rest = subject.beside.equilibrium
    said = None if rest is None else rest.attributes["statics"].get("metacentric_heights")
    own = said.get(vessel.name) if isinstance(said, Mapping) else None
    if not isinstance(own, list) or len(own) != 2 or not all(isinstance(one, int | float) for one in own):
        return ""
    return f"{show(float(own[0]), 'm', 2)} for heel, {show(float(own[1]), 'm', 1)} for trim"


def _pumped(subject: Subject, vessel: Vessel) -> str:
    """Tanks whose content changes, from what to what."""
    found = []
    for tank in subject.rig.tanks:
        if not tank.name.startswith(f"{vessel.name}."):
            continue
        content = subject.recording.column("tank_content", tank.name)
        if float(np.ptp(content)) > _MOVED * max(tank.capacity, 1.0):
            ends = f"{number(float(content[0]), 't', 0)} to {show(float(content[-1]), 't', 0)}"
            found.append(f"{tank.name.removeprefix(f'{vessel.name}.')} {ends}")
    more = f" and {len(found) - _MOST_TANKS} more tanks" if len(found) > _MOST_TANKS else ""
    return ", ".join(found[:_MOST_TANKS]) + more


def afloat_facts(subject: Subject) -> list[tuple[str, str]]:
    """Sea, largest forces of mooring lines and fenders, what a release does, what runs through holes."""
    rig = subject.rig
    if not rig.vessels:
        return _holes(subject)
    return [*_sea(subject), *_moorings(subject), *_release(subject), *_holes(subject)]


def _holes(subject: Subject) -> list[tuple[str, str]]:
    """What has run through holes of tanks, and until when."""
    recording = subject.recording
    contents = {tank.name: recording.column("tank_content", tank.name) for tank in subject.rig.tanks}
    rows = []
    for ran in ran_through_holes(subject.rig, recording.time, contents):
        until = ", and it still runs" if ran.goes_on else f" from {show(ran.until, 's', 0)} on"
        ends = f"{show(ran.first, 't', 1)} in it at the start, {show(ran.last, 't', 1)}"
        rows.append(
            (f"holes of {ran.tank}", f"{ends} {'at the end' if ran.goes_on else ''}".rstrip() + until)
        )
    more = len(rows) - _MOST_TANKS
    return [*rows[:_MOST_TANKS], ("holes", f"of {more} more tanks")] if more > 0 else rows


def _sea(subject: Subject) -> list[tuple[str, str]]:
    """The waves of the lift file, and what of them came to each vessel."""
    recording, sea = subject.recording, subject.rig.sea
    if recorded := subject.rig.moved_in_still_water:
        names = " and ".join(recorded)
        return [("sea", f"none in the lift file: the water stays still, {names} by a record of motions")]
    if sea is None or "vessel_wave_elevation" not in recording or not len(recording.time):
        return []
    rows = [("sea", train.in_words) for train in sea.trains]
    for vessel in subject.rig.vessels:
        body = list(recording.coordinates["body"]).index(vessel.body)
        ahead = axes(recording["body_orientation"].values[:1, body])[0, :, 0]
        heading = float(np.arctan2(ahead[1], ahead[0]))
        sides = [train.comes_from(heading) for train in sea.trains]
        waves = recording.column("vessel_wave_elevation", vessel.name)[subject.counts]
        ends = f"{show(float(waves.min()), 'm', 2)} to {show(float(waves.max()), 'm', 2)} amidships"
        rows.append((f"waves at {vessel.name}", ", ".join([*dict.fromkeys(sides), ends])))
    seas = subject.beside.seas
    return rows if seas is None else [*rows, (f"{seas.waves} allowed", allowed_seas(seas))]


def _moorings(subject: Subject) -> list[tuple[str, str]]:
    recording, rig = subject.recording, subject.rig
    rows = []
    pulls = [(*series.rope_peak(recording, line.rope), line) for line in rig.mooring_lines]
    if pulls:
        force, time, line = pulls[first_peak([one[0] for one in pulls])]
        used = share(force, line.minimum_breaking_force)
        text = f"{line.name} {show(force, 'kN', 0)} at {show(time, 's', 1)}"
        rows.append(("largest mooring force", text + (f", {show(used, '%', 0)} of breaking" if used else "")))
    presses = [(contact_peak(recording, fender.contact), fender) for fender in rig.fenders]
    if presses:
        (force, time), fender = presses[first_peak([one[0][0] for one in presses])]
        used = fender.used_by(force)
        text = f"{fender.name} {show(force, 'kN', 0)} at {show(time, 's', 1)}"
        rows.append(("largest fender force", text + (f", {show(used, '%', 0)} of capacity" if used else "")))
    return rows


def _release(subject: Subject) -> list[tuple[str, str]]:
    """What vessels do after a rope has parted, or without a load; else what cases say, or that nobody did."""
    recording = subject.recording
    parted = [one.time for one in partings(recording) if one.kind not in PLANNED]
    if parted:
        after = recording.time >= min(parted)
        rows = [("sudden release", f"at {show(min(parted), 's', 1)}")]
        return rows + [(f"{one.name} after it", _swings(subject, one, after)) for one in subject.rig.vessels]
    lost = subject.beside.lost_load
    if lost is not None:
        rows = [(f"'{lost.load}' lost at once", f"at {show(lost.time, 's', 1)}, {_comes_back(lost)}")]
        return rows + [(f"{one.vessel} as it is lost", _first_swing(one)) for one in lost.swings]
    cases = subject.beside.cases
    asked = [] if cases is None else [one for one in cases.cases if "release" in one.name.lower()]
    if asked:
        return [(f"case {one.name}", "; ".join(one.troubles) or "sound, at rest") for one in asked]
    if all(vessel.is_carried for vessel in subject.rig.vessels):
        return [("sudden release of the load", "not answered by vessels whose motion is given")]
    loads = [load.name for load in subject.rig.loads]
    ask = f"; 'gantline statics LIFT --lost {loads[0]} -o DIR' says what it does" if loads else ""
    return [("sudden release of the load", f"not simulated{ask}")]


def _comes_back(lost: SavedLostLoad) -> str:
    if lost.flooded:
        return f"UNDER WATER ALREADY WITH IT: {', '.join(lost.flooded)}"
    if not lost.swings:
        return "no vessel turns" if lost.is_sound else "no vessel is stable without it"
    return "comes back" if lost.is_sound else "DOES NOT COME BACK"


def _first_swing(one: SavedSwing) -> str:
    farthest = "no end" if one.farthest is None else show(one.farthest, "deg", 2)
    freeboard = "" if one.freeboard is None else f", freeboard {show(one.freeboard, 'm', 2)}"
    heavier = "" if one.at_design is None else f", {one.at_design:.3g} with the design weight"
    return f"{farthest} towards its {one.towards}{freeboard}, A2/A1 {one.ratio:.3g}{heavier}"


def _swings(subject: Subject, vessel: Vessel, after: BoolArray) -> str:
    recording = subject.recording
    if not after.any():
        return ABSENT
    parts = []
    for variable, words in (("vessel_trim", "trim"), ("vessel_heel", "heel")):
        largest = float(np.abs(recording.column(variable, vessel.name)[after]).max())
        parts.append(f"{words} {show(largest, 'deg', 1)}")
    freeboard = float(recording.column("vessel_freeboard", vessel.name)[after].min())
    return f"{', '.join(parts)} at most, freeboard {show(freeboard, 'm', 2)} at least"
