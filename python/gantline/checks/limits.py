"""The limits that a lift file can set, and where in a recording each finds its governing value.

A limit is one entry of `LIMITS`: how it is worded, and a function that gives every candidate (value, where,
when) within a mask of samples. The worst candidate governs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.parting import stops_met
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray, FloatArray

#: Most ropes that a remark names.
_MOST_NAMED = 3


@dataclass(frozen=True)
class Candidate:
    """A value that a limit is held against: how much [SI], where and when [s]."""

    value: float
    where: str
    time: float | None


Candidates = Callable[[Recording, BoolArray], Iterator[Candidate]]


@dataclass(frozen=True)
class Limit:
    """How one limit is checked.

    Attributes:
        formula: What is compared with what, in words.
        unit: Unit in which people read it.
        digits: Decimals with which people read it.
        candidates: Gives the values within a mask of samples.
        at_least: Whether the limit is the smallest allowed value, not the largest.
        when_clear: Whether only samples count at which the loads are clear of their supports.
        warns_up_to: A value over the limit but not over this one is a warning, not a failure.
        caution: What to warn of even within the limit; empty for nothing.
    """

    formula: str
    unit: str
    digits: int
    candidates: Candidates
    at_least: bool = False
    when_clear: bool = False
    warns_up_to: float | None = None
    caution: Callable[[Recording], str] | None = None


def _extreme(
    recording: Recording, values: FloatArray, during: BoolArray, where: str, smallest: bool = False
) -> Iterator[Candidate]:
    found = series.peak(recording, -values if smallest else values, during)
    if found is not None:
        yield Candidate(-found[0] if smallest else found[0], where, found[1])


def _load_tilt(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for load in recording.rig.loads:
        yield from _extreme(recording, recording.column("load_tilt", load.name), during, load.name)


def _sling_angle(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for sling in recording.rig.slings:
        carrying = during & series.is_carrying(series.sling_tension(recording, sling))
        yield from _extreme(recording, series.sling_angle(recording, sling), carrying, sling.name)


def _out_of_plane(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for sling in recording.rig.slings:
        carrying = during & series.is_carrying(series.sling_tension(recording, sling))
        for lug, angle in series.out_of_plane_angles(recording, sling).items():
            yield from _extreme(recording, angle, carrying, f"{sling.to_load}.{lug}")


def _fleet_angle(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for sheave in recording.rig.wrapped_sheaves:
        carrying = during & series.is_carrying(recording.column("rope_tension", sheave.rope))
        yield from _extreme(recording, series.fleet_angle(recording, sheave), carrying, sheave.name)


def _sling_factor(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for sling in recording.rig.slings:
        if sling.minimum_breaking_force is not None:
            yield from _factor(recording, during, sling.rope, sling.minimum_breaking_force, sling.name)


def _rope_factor(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for rope in recording.rig.ropes:
        if rope.minimum_breaking_force is not None:
            yield from _factor(recording, during, rope.name, rope.minimum_breaking_force, rope.name)


def _factor(
    recording: Recording, during: BoolArray, rope: str, strength: float, where: str
) -> Iterator[Candidate]:
    highest = series.peak(recording, recording.column("rope_tension", rope), during)
    if during.all():
        highest = max(series.rope_peak(recording, rope), highest or (0.0, 0.0))
    if highest is not None and highest[0] > 0.0:
        yield Candidate(strength / highest[0], where, highest[1])


def _slings_of_unknown_strength(recording: Recording) -> str:
    slings = recording.rig.slings
    return _of_unknown_strength([sling.name for sling in slings if sling.minimum_breaking_force is None])


def _ropes_of_unknown_strength(recording: Recording) -> str:
    ropes = recording.rig.ropes
    return _of_unknown_strength([rope.name for rope in ropes if rope.minimum_breaking_force is None])


def _of_unknown_strength(names: Sequence[str]) -> str:
    """What the factor says nothing about; empty if it covers all."""
    if not names:
        return ""
    more = f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
    return f"not checked, minimum breaking force not known: {', '.join(names[:_MOST_NAMED])}{more}"


def _smallest_tension(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for sling in recording.rig.slings:
        yield from _extreme(
            recording, series.sling_tension(recording, sling), during, sling.name, smallest=True
        )


def _spread(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for equalizer in recording.rig.equalizers:
        if equalizer.slings:
            spread = series.tension_spread(recording, equalizer)
            yield from _extreme(recording, spread, during, equalizer.name)


def _travel_used(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    clear = during & series.is_clear(recording)
    yield from _travel(recording, clear if clear.any() else during)


def _travel_past_stroke(recording: Recording) -> str:
    """Where a sheave came to the end of its stroke at any time, clear or not; empty if none did."""
    sheaves = {sheave for equalizer in recording.rig.equalizers for sheave in equalizer.moving_sheaves}
    met = [one for one in stops_met(recording.events()) if one.joint in sheaves]
    if met:
        return ", ".join(f"{one.joint} met its stop at {one.time:.2f} s" for one in met)
    furthest = max(_travel(recording, everywhere(recording)), key=lambda found: found.value, default=None)
    if furthest is None or furthest.value <= 1.0:
        return ""
    place = f"{furthest.where} {100.0 * furthest.value:.1f} % at {furthest.time:.2f} s"
    return f"{place}: it would have met its stop, which is not simulated"


def _travel(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    # Sheaves of an approximated equalizer do not travel: a limit of travel says nothing about it.
    for equalizer in (one for one in recording.rig.equalizers if one.mechanism == "sheaves"):
        for sheave in equalizer.moving_sheaves:
            travel = recording.column("sheave_travel", sheave)
            if equalizer.travel_up:
                yield from _extreme(recording, -travel / equalizer.travel_up, during, f"{sheave} up")
            if equalizer.travel_down:
                yield from _extreme(recording, travel / equalizer.travel_down, during, f"{sheave} down")


def _hook_dynamic_factor(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for hook in recording.rig.hooks:
        force = recording.column("hook_load", hook.name)
        static = series.static_value(recording, force)
        if static:
            yield from _extreme(recording, force / static, during, hook.name)


def _of_rated_capacity(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for hook in recording.rig.hooks:
        if hook.rated_capacity:
            rated_for = "hoist_load" if hook.rating_includes_hook_block else "hook_load"
            force = recording.column(rated_for, hook.name)
            yield from _extreme(recording, force / hook.rated_capacity, during, hook.name)


def _load_transferred(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for load in recording.rig.loads:
        yield from _extreme(recording, recording.column("load_transferred", load.name), during, load.name)


def _hook_load(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for hook in recording.rig.hooks:
        yield from _extreme(recording, recording.column("hook_load", hook.name), during, hook.name)


def _sling_tension(recording: Recording, during: BoolArray) -> Iterator[Candidate]:
    for sling in recording.rig.slings:
        yield from _extreme(recording, series.sling_tension(recording, sling), during, sling.name)


LIMITS: dict[str, Limit] = {
    "load_tilt": Limit("largest angle of the load's own z axis from plumb", "deg", 2, _load_tilt),
    "sling_angle_from_vertical": Limit(
        "largest angle of a carrying sling from the vertical", "deg", 1, _sling_angle
    ),
    "lug_out_of_plane_angle": Limit(
        "largest angle between a carrying sling and the main plate of its lug", "deg", 1, _out_of_plane
    ),
    "fleet_angle": Limit("largest angle of a carrying rope to the plane of a sheave", "deg", 2, _fleet_angle),
    "sling_factor_on_breaking_force": Limit(
        "minimum breaking force / peak tension of the same sling",
        "",
        2,
        _sling_factor,
        at_least=True,
        caution=_slings_of_unknown_strength,
    ),
    "rope_factor_on_breaking_force": Limit(
        "minimum breaking force / peak tension of the same rope, slings and all other ropes",
        "",
        2,
        _rope_factor,
        at_least=True,
        caution=_ropes_of_unknown_strength,
    ),
    "smallest_sling_tension_when_clear": Limit(
        "smallest sling tension while the load is clear",
        "kN",
        1,
        _smallest_tension,
        at_least=True,
        when_clear=True,
    ),
    "tension_spread_when_clear": Limit(
        "(max - min)/mean over one equalizer's slings while the load is clear",
        "%",
        2,
        _spread,
        when_clear=True,
    ),
    "equalizer_travel_used": Limit(
        "largest travel of a moving sheave / its stroke that way, once the load is clear",
        "%",
        1,
        _travel_used,
        warns_up_to=1.0,
        caution=_travel_past_stroke,
    ),
    "hook_dynamic_factor": Limit("peak / static hook load of the same hook", "", 3, _hook_dynamic_factor),
    "hoist_load_of_rated_capacity": Limit(
        "largest hoist load (hook load, if the rating leaves the hook block out) / rated capacity",
        "%",
        1,
        _of_rated_capacity,
    ),
    "tension_spread": Limit("(max - min)/mean over one equalizer's slings", "%", 2, _spread),
    "load_transferred": Limit("1 - support forces / weight of the load", "%", 1, _load_transferred),
    "hook_load": Limit("largest hook load", "kN", 1, _hook_load),
    "sling_tension": Limit("largest sling tension", "kN", 1, _sling_tension),
}


def governing(limit: Limit, recording: Recording, during: BoolArray) -> Candidate | None:
    """The worst candidate of a limit within a mask of samples; None if there is none."""
    inside = during & series.is_clear(recording) if limit.when_clear else during
    if not inside.any():
        return None
    pick = min if limit.at_least else max
    return pick(limit.candidates(recording, inside), key=lambda candidate: candidate.value, default=None)


def everywhere(recording: Recording) -> BoolArray:
    """The mask of all samples."""
    return np.ones(len(recording.time), dtype=np.bool_)
