"""Equalizers: how evenly they share, how far their sheaves travel and their frames tilt, what they bear."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.checks.design_weight import largest_ratios
from gantline.checks.force import NO_STATIC, kilonewton, over
from gantline.checks.forces import raised_of_capacity, sum_force, with_upper_ends
from gantline.checks.measure import Caution, Finding, Found, Missing, Refused, extreme
from gantline.results import series
from gantline.results.gear import Compensator, Equalizer, Sling, Spreader
from gantline.results.recording import Recording
from gantline.results.ropes.parting import stops_met
from gantline.results.ropes.travel import Way, ways
from gantline.results.rotation import axes
from gantline.results.variable import BoolArray
from gantline.units import format_quantity

#: Slings pull a frame that is held upright this far off plumb below its hook before a warning says so.
_OFF_PLUMB = math.radians(1.0)


def pin_of_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Force on a locking pin, either way, raised to the design weight, over its capacity."""
    pins = set(recording.coordinates.get("pin", ()))
    for equalizer in recording.rig.equalizers:
        own = [sheave for sheave in equalizer.moving_sheaves if sheave in pins]
        if not equalizer.pin_capacity:
            yield from (Missing(f"pins of {equalizer.name}", "no capacity") for _ in own[:1])
            continue
        borne = {sling.to_load for sling in recording.rig.slings if sling.rope in equalizer.slings}
        ratios = largest_ratios(recording, borne)
        for sheave in own:
            force = np.abs(recording.column("pin_force", sheave))
            yield from raised_of_capacity(
                recording, during, f"pin of {sheave}", force, ratios, equalizer.pin_capacity
            )


def tension_spread(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """(max - min)/mean over the slings of one equalizer, while it is loaded."""
    for equalizer in (one for one in recording.rig.equalizers if one.slings):
        on = series.are_whole(recording, equalizer.slings)
        counts = during & on.any(axis=0) & series.is_loaded(recording, equalizer)
        if counts.any():
            spread = series.tension_spread(recording, equalizer)
            yield from extreme(recording, spread, counts, equalizer.name)
        else:
            is_on = (during & on.any(axis=0)).any()
            yield Missing(equalizer.name, f"none of its slings {'carries' if is_on else 'is on'}")


def load_of_rated_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Static vertical force of all slings of an equalizer over its rated capacity below its moving sheaves.

    It is lifting gear, rated like a shackle for what hangs still; the peak is shown, and counts at a time as
    which the loads never hung still.
    """
    for equalizer in recording.rig.equalizers:
        slings = [sling for sling in recording.rig.slings if sling.rope in equalizer.slings]
        yield from hanging_of_capacity(recording, during, equalizer, slings)


def hanging_of_capacity(
    recording: Recording, during: BoolArray, gear: Equalizer | Spreader | Compensator, slings: Sequence[Sling]
) -> Iterator[Finding]:
    """Static vertical force of slings over the rated capacity of the lifting gear from which they hang."""
    if not gear.rated_capacity:
        yield Missing(gear.name, "rated capacity not known", is_strength=True)
    elif slings:
        vertical = [series.sling_upright(recording, sling) for sling in slings]
        force = sum_force(recording, np.sum(vertical, axis=0), slings[0].to_load, during)
        force = with_upper_ends(recording, slings, force)
        if force.static is None:
            # What never hung still is rated all the same: the peak is no less.
            yield from over(force, gear.rated_capacity, gear.name)
            yield Caution(NO_STATIC)
            return
        if force.static_caution:
            yield Caution(force.static_caution)
        rated = kilonewton(gear.rated_capacity)
        if (way := force.on_the_way) is not None:
            # What it bears as a load is turned, between two holds, is no dynamics.
            yield Found(way.raised / gear.rated_capacity, gear.name, way.time, f"{way.text} / {rated}")
            return
        text = f"{force.static_text} / {rated}"
        text += f" (peak {kilonewton(force.peak)})" if force.peak is not None else ""
        yield Found(force.static / gear.rated_capacity, gear.name, formula=text)


def travel_used(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Travel of a moving sheave over its stroke that way, once the load is clear."""
    clear = during & series.is_clear(recording)
    yield from _travel(recording, clear if clear.any() else during)
    if during.all():
        yield from _stopped(recording, clear)
    past = _past_stroke(recording)
    if past:
        yield Caution(past)


def _stopped(recording: Recording, clear: BoolArray) -> Iterator[Refused]:
    """Sheaves that met a stop while the load hung: between samples they may have been there and back."""
    sheaves = {sheave for equalizer in recording.rig.equalizers for sheave in equalizer.moving_sheaves}
    for time, kind, joint in recording.events():
        # Of a load that is lifted twice, what is met as it stands in between says nothing about it hanging.
        if kind == "stop_hit" and joint in sheaves and clear[_around(recording, time)].any():
            reason = f"met its stop at {time:.2f} s, with the load hanging"
            yield Refused(joint, reason, _at_stop(recording, clear, joint, time))
            return


def _around(recording: Recording, time: float) -> slice:
    """The samples before and after a time [s]."""
    after = int(np.searchsorted(recording.time, time))
    return slice(max(after - 1, 0), after + 1)


def _at_stop(recording: Recording, clear: BoolArray, sheave: str, time: float) -> Found | None:
    """Its stroke that way, all of it at that time [s]; the farthest sample where one is beyond a stroke.

    Between samples it may have been there and back, and a stop gives a little.
    """
    furthest = max(_travel(recording, clear), key=lambda one: one.value, default=None)
    if furthest is not None and furthest.value > 1.0:
        return furthest
    own = [way for way in ways(recording) if way.sheave == sheave]
    if not own:
        return None
    around = _around(recording, time)
    way = max(own, key=lambda one: one.travel[around].max() / one.stroke)
    stroke = format_quantity(way.stroke, "m", 3)
    return Found(1.0, way.element, time, f"{stroke} / {stroke}")


def frame_tilt(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle from plumb of frames that tilt under their hooks."""
    for equalizer in recording.rig.equalizers:
        if equalizer.tilts:
            yield from extreme(recording, series.frame_tilt(recording, equalizer), during, equalizer.name)


def held_upright(recording: Recording) -> list[Check]:
    """A warning for each frame that its hook holds upright although its slings pull well beside the hook.

    A frame does not tilt unless the lift file says so, and no real hook bears that moment.
    """
    checks = []
    for equalizer in recording.rig.equalizers:
        found = None if equalizer.tilts else _moment_on_hook(recording, equalizer)
        if found is None or found.off_plumb <= _OFF_PLUMB:
            continue
        moment = format_quantity(found.moment, "kN m", 0)
        remark = (
            f"the hook holds the frame of {equalizer.name} upright with {moment}: its slings pull "
            f"{found.beside:.2f} m beside the hook. A real frame tilts, and shares otherwise; "
            "'tilts: true' under 'hinge' simulates that"
        )
        meaning = "slings of a frame that cannot tilt pull from below its hook"
        check = Check("frame_held_upright", Verdict.WARNING, meaning, element=equalizer.name, remark=remark)
        checks.append(check)
    return checks


@dataclass(frozen=True)
class _Moment:
    """What a hook bears of its slings about its bearing, while the load hangs still.

    Attributes:
        moment: About level axes [N m].
        beside: The same over the vertical force of the slings [m].
        off_plumb: Angle from plumb of the line from the bearing to where the slings pull [rad].
    """

    moment: float
    beside: float
    off_plumb: float


def _moment_on_hook(recording: Recording, equalizer: Equalizer) -> _Moment | None:
    """When it is largest; None where the load never hung still, or where the hook is not known."""
    if equalizer.bearing is None:
        return None
    attitude = axes(recording.column("body_orientation", equalizer.body))
    hook = recording.column("body_position", equalizer.body) + attitude @ np.asarray(equalizer.bearing)
    moment, force, depth = np.zeros_like(hook), np.zeros(len(hook)), np.zeros(len(hook))
    for sling in (one for one in recording.rig.slings if one.rope in equalizer.slings):
        # From its sheave, or where that would be on the frame.
        arm = series.rope_ends(recording, sling.rope)[0] - hook
        tension = series.sling_tension(recording, sling)
        pull = -tension[:, None] * series.sling_direction(recording, sling)
        moment += np.cross(arm, pull)
        force -= pull[:, 2]
        depth += arm[:, 2] * pull[:, 2]
    level = np.hypot(moment[:, 0], moment[:, 1])
    most, window = series.greatest_static(recording, level)
    carried = series.static_value(recording, force, window)
    lever = series.static_value(recording, depth, window)
    if most is None or not carried or not lever or carried <= 0.0:
        return None
    return _Moment(most, most / carried, math.atan2(most, lever))


def travel_at_any_time(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Travel of a moving sheave over its stroke that way, also while the load is still supported."""
    yield from _travel(recording, during)


def _past_stroke(recording: Recording) -> str:
    """Where a sheave came to the end of its stroke at any time, clear or not; empty if none did."""
    sheaves = {sheave for equalizer in recording.rig.equalizers for sheave in equalizer.moving_sheaves}
    met = [one for one in stops_met(recording.events()) if one.joint in sheaves]
    if met:
        return ", ".join(f"{one.joint} met its stop at {one.time:.2f} s" for one in met)
    everywhen = series.everywhere(recording)
    past = [(found, way) for way in ways(recording) for found in _one_way(recording, everywhen, way)]
    furthest, way = max(past, key=lambda one: one[0].value, default=(None, None))
    if furthest is None or way is None or furthest.value <= 1.0:
        return ""
    when = "" if furthest.time is None else f" at {furthest.time:.2f} s"
    place = f"{furthest.element} {100.0 * furthest.value:.1f} %{when}"
    # One that stands at its stop from the start, as in an equilibrium, has not met it.
    if way.has_stop:
        return f"{place}: it stands at its stop, which gives"
    return f"{place}: it would have met its stop, which is not simulated"


def _travel(recording: Recording, during: BoolArray) -> Iterator[Found]:
    for way in ways(recording):
        yield from _one_way(recording, during, way)


def _one_way(recording: Recording, during: BoolArray, way: Way) -> Iterator[Found]:
    def text(at: int) -> str:
        return f"{format_quantity(float(way.travel[at]), 'm', 3)} / {format_quantity(way.stroke, 'm', 3)}"

    yield from extreme(recording, way.travel / way.stroke, during, way.element, text)
