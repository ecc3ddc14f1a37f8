"""Warnings of a run: what a program moved, ropes that left their sheaves, and what is between samples."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Mapping
from typing import Any

import numpy as np

from gantline.results.bodies import places_of
from gantline.results.loads.guides import guide_force
from gantline.results.rig import Rig
from gantline.results.ropes.parting import stops_met
from gantline.results.variable import Columns, FloatArray, Names
from gantline.units import format_quantity

__all__ = [
    "command_warnings",
    "compensation_warnings",
    "ground_warnings",
    "missed_bumps",
    "missed_crests",
    "missed_incidents",
    "missed_peaks",
    "sheave_warnings",
    "still_growing",
    "stop_warnings",
]

#: Share by which the peak of a rope over all steps may be more than that of samples without a word.
_MISSED = 0.02
#: Ropes whose peaks are less than this share of the largest are not looked at.
_LITTLE = 0.1
#: Share of the height of waves that may come and go between two samples without a word; of a period, as long
#: as what is just about that: 1 - cos(π/10) = 4.9 %.
_UNSEEN, _OF_PERIOD = 0.05, 0.1
#: Of the largest sample of a bump those beside it have this share in the mean where 5 % is missed at most.
_BESIDE = 0.8
#: Share of its largest sample that those beside a bump have at most [1].
_STANDS_OUT = 0.99
#: Least share of its peak that a bump has in one of two samples within it: cos(π/4).
_TWO_WITHIN = math.sqrt(0.5)
#: Share of the force of a landing guide that one contact of it has whose peak over all steps will do.
_ALONE = 0.95
#: How far below the ground a hook is told [m].
_BELOW = 0.1


def missed_incidents(
    document: Mapping[str, Any], rig: Rig, duration: float, happened: Collection[str]
) -> list[str]:
    """A warning of what the lift file cuts, takes away or stops as the run ends, or later.

    Args:
        document: What has been assembled of the lift.
        rig: Its rig.
        duration: Of the run [s].
        happened: Kinds of its events.
    """
    held = [*document.get("ropes", ()), *document.get("forces", ())]
    stop = document.get("emergency_stop", {}).get("at", {})
    times = {
        "cut": [(one["name"], one.get("cut_at")) for one in held],
        "removed": list(dict.fromkeys((one.group, one.removed_at) for one in rig.supports)),
        "stopped": [("emergency stop", stop.get("time"))],
    }
    found = []
    for done, of_all in times.items():
        late = [f"{name} at {time:g} s" for name, time in of_all if time is not None and time >= duration]
        if late:
            there = f"the run ends at {duration:g} s, and what is {done} then or later is not seen"
            found.append(f"{there}: {', '.join(late)}")
    if "step" in stop and "emergency_stop" not in happened:
        after = f", {stop['after']:g} s after that begins" if stop["after"] else ""
        step = rig.plan[stop["step"]].step
        found.append(f"the run ends before the emergency stop in '{step}'{after}: it is not seen")
    return found


def missed_peaks(rig: Rig, columns: Columns, names: Names) -> list[str]:
    """A warning where samples are too far apart for peaks, as ropes show, whose peaks are those of all steps.

    Of a hook by itself the load is kept when its ropes pulled most. What several bear together is that of
    samples, and was more as well where their ropes had more between two of them.
    """
    time = columns["time"]
    if not rig.hooks or len(time) < 3:
        return []
    in_falls = {fall.rpartition("/")[0] for hook in rig.hooks for fall in hook.falls}
    at_hooks = {rope for hook in rig.hooks for rope, _ in hook.direct_ropes}
    loaded = {sling.rope for sling in rig.slings} | in_falls | at_hooks
    peaks = columns["rope_peak_tension"]
    found = []
    for place, rope in enumerate(names["rope"]):
        if rope not in loaded or columns["rope_peak_time"][place] > time[-1]:
            continue
        parts = [at for at, part in enumerate(names["segment"]) if part.rpartition("/")[0] == rope]
        sampled = max(
            float(columns["rope_tension"][:, place].max()),
            float(columns["segment_tension"][:, parts].max(initial=0.0)),
        )
        found.append((float(peaks[place]), sampled, rope, float(columns["rope_peak_time"][place])))
    largest = max((peak for peak, *_ in found), default=0.0)
    missed = [one for one in found if one[0] > max((1 + _MISSED) * one[1], _LITTLE * largest)]
    if not missed:
        return []
    peak, sampled, rope, when = min(missed, key=lambda one: one[1] / one[0])
    apart = format_quantity(float(np.median(np.diff(time))), "s", 2)
    had, most = (format_quantity(value, "kN", 1) for value in (peak, sampled))
    missing = f"samples {apart} apart miss peaks: {rope} carried {had} at {when:.2f} s, and {most} in samples"
    of_samples = "loads of several hooks together, angles and distances are those of samples"
    return [f"{missing}; {of_samples}: a shorter 'sample_interval' has their peaks"]


def missed_crests(rig: Rig, columns: Columns) -> list[str]:
    """A warning where crests come and go between samples, whether or not a rope shows it.

    Half-way between two samples Δt apart a wave of the period T may be higher than at both by 1 - cos(πΔt/T)
    of its amplitude. Of several waves that counts by their heights.
    """
    time = columns["time"]
    if not rig.vessels or rig.sea is None or not rig.sea.trains or len(time) < 3:
        return []
    apart = float(np.median(np.diff(time)))
    heights, periods = (
        np.array([getattr(one, key) for one in rig.sea.trains]) for key in ("height", "period")
    )
    lost = 1.0 - np.cos(math.pi * np.minimum(apart / periods, 0.5))
    share = float(heights @ lost / heights.sum())
    if share <= _UNSEEN:
        return []
    period = float(periods[np.argmax(heights * lost)])
    missed = (
        f"samples {format_quantity(apart, 's', 2)} apart miss up to {100.0 * share:.0f} % of the height of"
    )
    of_samples = "heel, trim, freeboard, angles and distances are those of samples"
    right = f"a 'sample_interval' of {_OF_PERIOD * period:.2g} s has their peaks"
    return [f"{missed} waves every {format_quantity(period, 's', 1)}: {of_samples}; {right}"]


def still_growing(document: Mapping[str, Any], rig: Rig, columns: Columns, names: Names) -> list[str]:
    """Warnings of runs that see little of waves, gusts or records, and of loads lifted before they are whole.

    All grow at the start. They should be whole for as long again, over which what they do averages.

    Args:
        document: What has been assembled of the lift.
        rig: Its rig.
        columns: What was recorded, with events.
        names: Names along their dimensions.
    """
    forces = document.get("forces", ())
    by_raos = any(vessel.is_carried and vessel.grows_over == 0.0 for vessel in rig.vessels)
    push = {
        "waves": by_raos or any(one["type"] == "wave" for one in forces),
        "gusts": any(one.get("gusty", False) for one in forces),
    }
    time, found = columns["time"], []
    events = list(zip(columns["event_time"], names["event_kind"], names["event_name"], strict=True))
    for what, whole in rig.growing.items():
        if not push.get(what, True) or not len(time):
            continue
        end = float(time[-1])
        if end < 2 * whole:
            there = f"the run ends at {end:g} s, and its {what} grow until {whole:g} s"
            found.append(f"{there}: it sees little of them; {2 * whole:g} s at least are right")
        for load in rig.loads:
            lifted = [float(at) for at, kind, name in events if (kind, name) == ("lift_off", load.name)]
            if lifted and lifted[0] < min(whole, end):
                when = f"{load.name} lifts off at {lifted[0]:.2f} s, while {what} grow, until {whole:g} s"
                found.append(f"{when}: smaller than the lift file has them; hold it that long first")
    return found


def missed_bumps(rig: Rig, columns: Columns, names: Names) -> list[str]:
    """A warning where several contacts of a landing guide are pressed and let go within few samples.

    Peaks over all steps are kept of contacts one by one: where one has all of it they tell. Of half a
    swing that takes D samples Δt apart have cos(πΔt/2D) of the peak P at least. Whenever they are taken,
    y = P cos(πt/D) has (y(t - Δt) + y(t + Δt))/2y(t) = cos(πΔt/D): 95 % and 0.8 of Δt/D = 0.2. What counts
    may be past its capacity: 71 % of it where two samples at least are within the swing.
    """
    contact = {name: place for place, name in enumerate(names["contact"])}
    pressed, time = columns["contact_force"], columns["time"]
    bumps = [
        _bump(
            one.name,
            guide_force(one, pressed, contact),
            pressed[:, [contact[name] for name in one.contacts]].max(axis=1),
            _TWO_WITHIN * one.capacity,
        )
        for one in rig.guides
        if one.capacity is not None
    ]
    found = [bump for bump in bumps if bump is not None]
    if not found:
        return []
    largest, name, at = max(found)
    apart = format_quantity(float(np.median(np.diff(time))), "s", 2)
    when = f"{format_quantity(largest, 'kN', 1)} at {float(time[at]):.2f} s"
    missed = f"samples {apart} apart miss the peaks of landing guides: {name} has {when}"
    return [f"{missed}, and much less beside it; a shorter 'sample_interval' has more of them"]


def _bump(name: str, force: FloatArray, one: FloatArray, least: float) -> tuple[float, str, int] | None:
    """Largest bump of a force over time from `least` [N] on: its sample [N], the name, its place; or None.

    What has stood and is let go, or lifts, has as much as the sample before and is no bump. Where `one`
    contact has nearly all of it there is nothing to tell.
    """
    top, before, after = force[1:-1], force[:-2], force[2:]
    stands_out = np.maximum(before, after) < _STANDS_OUT * top
    missed = (before + after < 2 * _BESIDE * top) & stands_out & (top >= least) & (one[1:-1] < _ALONE * top)
    if not missed.any():
        return None
    at = int(np.argmax(np.where(missed, top, 0.0)))
    return float(top[at]), name, at + 1


def command_warnings(columns: Mapping[str, Any], names: Mapping[str, Any]) -> list[str]:
    """A note of what a program has moved: the plan says no more how it moved."""
    times: dict[tuple[str, str], list[float]] = {}
    for at, name, motion in zip(
        columns.get("command_time", ()),
        names.get("command_name", ()),
        names.get("command_motion", ()),
        strict=True,
    ):
        times.setdefault((name, motion), []).append(at)
    return [
        f"{name} was moved by a program from {at[0]:.2f} s on and not by the plan ({motion}, "
        f"commands: {len(at)})"
        for (name, motion), at in times.items()
    ]


def compensation_warnings(columns: Columns, names: Names) -> list[str]:
    """Warnings of heave compensation that could not follow: once for each hook, the first time."""
    first: dict[str, tuple[str, float]] = {}
    for moment, kind, hook in zip(
        columns["event_time"], names["event_kind"], names["event_name"], strict=True
    ):
        if limit := re.fullmatch("compensation_(.+)_limit", kind):
            first.setdefault(hook, (limit[1], float(moment)))
    return [
        f"heave compensation of {hook} comes to the limit of its {limit} at {when:.2f} s, and follows no "
        "more than that lets it"
        for hook, (limit, when) in first.items()
    ]


def ground_warnings(rig: Rig, level: float, columns: Columns, names: Names) -> list[str]:
    """A warning of each hook whose bearing goes below the ground, at a level [m], which stops no hook."""
    time, found = columns["time"], []
    events = zip(columns["event_time"], names["event_kind"], names["event_name"], strict=True)
    parted = {name: float(moment) for moment, kind, name in events if kind in ("cut", "broken")}
    bearings = {hook.name: hook.bearing for hook in rig.carried_hooks}
    for hook in rig.hooks if len(time) else ():
        height = places_of(columns, names, hook.name, bearings.get(hook.name, (0.0, 0.0, 0.0)))[:, 2]
        below = height < level - _BELOW
        if below.any():
            deepest = format_quantity(level - float(height.min()), "m", 2)
            when = float(time[int(np.argmax(below))])
            first = f"{hook.name} goes below the ground at {when:.2f} s"
            ropes = [rope for rope in names["rope"] if rope.startswith(f"hoist.{hook.name}.")]
            # A hook that has fallen was not lowered too far by a step that could be shorter.
            fell = bool(ropes) and all(parted.get(rope, np.inf) <= when for rope in ropes)
            advice = "its hoist ropes have parted" if fell else "lower it less far"
            found.append(f"{first}, up to {deepest}: nothing stops it there; {advice}")
    return found


def sheave_warnings(
    rig: Mapping[str, Any], columns: Mapping[str, Any], names: Mapping[str, Any]
) -> list[str]:
    """Warnings of ropes that left a sheave which they may not leave: once for each sheave, the first time."""
    held = {sheave["name"] for sheave in rig.get("wrapped_sheaves", ()) if not sheave["may_lift_off"]}
    first: dict[str, float] = {}
    for time_off, kind, name in zip(
        columns["event_time"], names["event_kind"], names["event_name"], strict=True
    ):
        if kind == "rope_off_sheave" and name in held:
            first.setdefault(name, float(time_off))
    return [
        f"the rope leaves the sheave {name} at {when:.3f} s: it is followed as if it were held in the groove"
        "; 'may_lift_off: true' lets it run straight past"
        for name, when in first.items()
    ]


def stop_warnings(rig: Rig, columns: Columns, names: Names) -> list[str]:
    """A warning of each joint that met its stops, but for rods that go in as a load is set down."""
    events = zip(columns["event_time"], names["event_kind"], names["event_name"], strict=True)
    strokes = {one.rod: one.stroke for one in rig.compensators}
    counted = (
        event
        for event in events
        if event[2] not in strokes or not _goes_in(rig, columns, names, event, strokes[event[2]])
    )
    return [f"{met.joint} met its stop at {met.time:.2f} s{met.again}" for met in stops_met(counted)]


def _goes_in(rig: Rig, columns: Columns, names: Names, event: tuple[float, str, str], stroke: float) -> bool:
    """Whether a rod meets its inner stop while something stands below it, as it is meant to."""
    time, _, rod = event
    after = min(int(np.searchsorted(columns["time"], time)), len(columns["time"]) - 1)
    around = slice(max(after - 1, 0), after + 1)
    out = columns["joint_position"][after, list(names["joint"]).index(rod)]
    borne = {contact for load in rig.loads for contact in load.contacts}
    at = [place for place, name in enumerate(names["contact"]) if name in borne]
    return bool(out < 0.5 * stroke and columns["contact_force"][around][:, at].any())
