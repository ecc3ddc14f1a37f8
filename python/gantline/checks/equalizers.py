"""Equalizers: how evenly they share, how far their sheaves travel, what they bear."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from gantline.checks.forces import NO_STATIC, kilonewton, sum_force
from gantline.checks.measure import Caution, Finding, Found, Missing, Refused, everywhere, extreme
from gantline.results import series
from gantline.results.parting import stops_met
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity


def tension_spread(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """(max - min)/mean over the slings of one equalizer."""
    for equalizer in recording.rig.equalizers:
        if equalizer.slings:
            spread = series.tension_spread(recording, equalizer)
            yield from extreme(recording, spread, during, equalizer.name)


def load_of_rated_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Static vertical force of all slings of an equalizer over its rated capacity below its moving sheaves.

    It is lifting gear, rated like a shackle for what hangs still; the peak is shown.
    """
    for equalizer in recording.rig.equalizers:
        slings = [sling for sling in recording.rig.slings if sling.rope in equalizer.slings]
        if not equalizer.rated_capacity:
            yield Missing(equalizer.name, "rated capacity not known")
        elif slings:
            vertical = [
                series.sling_tension(recording, sling) * series.sling_direction(recording, sling)[:, 2]
                for sling in slings
            ]
            force = sum_force(recording, np.sum(vertical, axis=0), slings[0].to_load, during)
            if force.static is None:
                yield Missing(equalizer.name, NO_STATIC)
                continue
            text = f"{force.static_text} / {kilonewton(equalizer.rated_capacity)}"
            text += f" (peak {kilonewton(force.peak)})" if force.peak is not None else ""
            yield Found(force.static / equalizer.rated_capacity, equalizer.name, formula=text)


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
    hung = recording.time[clear]
    for time, kind, joint in recording.events():
        if kind == "stop_hit" and joint in sheaves and hung.size and hung[0] <= time <= hung[-1]:
            reason = f"met its stop at {time:.2f} s, with the load hanging"
            yield Refused(joint, reason, _at_stop(recording, clear, joint, time))
            return


def _at_stop(recording: Recording, clear: BoolArray, sheave: str, time: float) -> Found | None:
    """Its stroke that way, all of it at that time [s]; the farthest sample where one is beyond a stroke.

    Between samples it may have been there and back, and a stop gives a little.
    """
    furthest = max(_travel(recording, clear), key=lambda one: one.value, default=None)
    if furthest is not None and furthest.value > 1.0:
        return furthest
    after = int(np.searchsorted(recording.time, time))
    around = slice(max(after - 1, 0), after + 1)
    ways = [way for way in _ways(recording) if way.sheave == sheave]
    if not ways:
        return None
    way = max(ways, key=lambda one: one.travel[around].max() / one.stroke)
    stroke = format_quantity(way.stroke, "m", 3)
    return Found(1.0, way.element, time, f"{stroke} / {stroke}")


def travel_at_any_time(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Travel of a moving sheave over its stroke that way, also while the load is still supported."""
    yield from _travel(recording, during)


def _past_stroke(recording: Recording) -> str:
    """Where a sheave came to the end of its stroke at any time, clear or not; empty if none did."""
    sheaves = {sheave for equalizer in recording.rig.equalizers for sheave in equalizer.moving_sheaves}
    met = [one for one in stops_met(recording.events()) if one.joint in sheaves]
    if met:
        return ", ".join(f"{one.joint} met its stop at {one.time:.2f} s" for one in met)
    furthest = max(_travel(recording, everywhere(recording)), key=lambda found: found.value, default=None)
    if furthest is None or furthest.value <= 1.0:
        return ""
    when = "" if furthest.time is None else f" at {furthest.time:.2f} s"
    place = f"{furthest.element} {100.0 * furthest.value:.1f} %{when}"
    return f"{place}: it would have met its stop, which is not simulated"


@dataclass(frozen=True)
class _Way:
    """A moving sheave one way: its name, that way in a word, its travel and stroke that way [m]."""

    sheave: str
    word: str
    travel: FloatArray
    stroke: float

    @property
    def element(self) -> str:
        """Both in words."""
        return f"{self.sheave} {self.word}"


def _ways(recording: Recording) -> Iterator[_Way]:
    # Sheaves of an approximated equalizer do not travel: a limit of travel says nothing about it.
    for equalizer in (one for one in recording.rig.equalizers if one.mechanism == "sheaves"):
        for sheave in equalizer.moving_sheaves:
            travel = recording.column("sheave_travel", sheave)
            if equalizer.travel_up:
                yield _Way(sheave, "up", -travel, equalizer.travel_up)
            if equalizer.travel_down:
                yield _Way(sheave, "down", travel, equalizer.travel_down)


def _travel(recording: Recording, during: BoolArray) -> Iterator[Found]:
    for way in _ways(recording):
        yield from _one_way(recording, during, way)


def _one_way(recording: Recording, during: BoolArray, way: _Way) -> Iterator[Found]:
    def text(at: int) -> str:
        return f"{format_quantity(float(way.travel[at]), 'm', 3)} / {format_quantity(way.stroke, 'm', 3)}"

    yield from extreme(recording, way.travel / way.stroke, during, way.element, text)
