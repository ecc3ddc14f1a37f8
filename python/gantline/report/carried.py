"""Rows of the first page: what hooks, slings, lugs, spreaders and equalizers carry."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from gantline.checks import values_of
from gantline.checks.sling_figures import SlingFigures, sling_figures
from gantline.report.subject import ABSENT, Subject, as_given, number, show
from gantline.results import series
from gantline.results.alike import first_peak
from gantline.results.cranes.chain_hoists import sling_lengths
from gantline.results.gear import Equalizer, Hook, Sling, Spreader
from gantline.results.loads.hinges import is_shut
from gantline.results.loads.hook_peaks import hook_peak
from gantline.results.ropes.parting import ATTACHED, DETACHED, PARTING, PLANNED, partings
from gantline.results.ropes.travel import most_used, ways_of
from gantline.results.variable import BoolArray, FloatArray

#: Shares of the weight over at which a load cell is read.
READINGS = (0.25, 0.5, 0.75, 1.0)
#: A load cell is read over this time once the load is clear, some swings of the load on its ropes [s].
READ_OVER = 5.0


#: What the plan does to slings, in a word beside their names, for which there is little room.
_OFF_AND_ON = {DETACHED: "off", ATTACHED: "on"}


def hook_row(subject: Subject, hook: Hook) -> dict[str, Any]:
    """Load-cell readings of a hook [t], its largest hoist load and what that is of its rated capacity."""
    load = subject.recording.column("hoist_load", hook.name)
    highest, _ = hook_peak(subject.recording, hook.name, "hoist_load", subject.counts)
    shares = values_of(subject.recording, "hoist_load_of_rated_capacity")
    own = {"trolley": ABSENT, "crane": ABSENT}
    for rating in subject.rig.ratings:
        if rating.level in own and hook.name in rating.hooks:
            own[rating.level] = number(shares.get(f"{rating.level} {rating.name}"), "%", 1)
    height = values_of(subject.recording, "hook_height_margin").get(hook.name)
    aside = values_of(subject.recording, "falls_out_of_plumb").get(hook.name)
    return {
        **own,
        "highest": number(_highest(subject, hook), "m", 2),
        "room": number(height, "m", 2),
        "aside": number(aside, "deg", 2),
        "name": hook.name,
        "readings": [
            number(reading, "t", 1)
            for reading in load_cell(subject, load, is_alone=len(subject.rig.hooks) == 1)
        ],
        "static": number(mass_of(subject, subject.static(load)), "t", 1),
        "peak": number(highest / subject.rig.gravity, "t", 1),
        "rated": as_given(mass_of(subject, hook.rated_capacity)),
        "used": number(shares.get(hook.name), "%", 1),
    }


def _highest(subject: Subject, hook: Hook) -> float | None:
    """Highest place of a hook's bearing [m]."""
    recording = subject.recording
    if hook.name not in recording.coordinates.get("crane_hook", ()):
        return None
    return float(recording.column("hook_height", hook.name)[subject.counts].max())


def mass_of(subject: Subject, force: float | None) -> float | None:
    """What a force [N] holds up at rest [kg]; None of none."""
    return None if force is None else force / subject.rig.gravity


def load_cell(subject: Subject, load: FloatArray, *, is_alone: bool) -> list[float | None]:
    """What a load cell reads when a share of the loads' weight has come over [kg].

    Args:
        subject: What the page is of.
        load: The force that it measures, shape (time,) [N]: hoist load, or tension of a rope.
        is_alone: Whether nothing else lifts the loads.

    Returns:
        One for each of `READINGS`; None where that is not known.
    """
    recording = subject.recording
    if "load_transferred" not in recording or not subject.rig.loads:
        return [None for _ in READINGS]
    transferred = recording["load_transferred"].values.min(axis=1)
    # Where a hinge holds a part that hangs from the start, what comes over tells how far the load has turned.
    known_from = READINGS[0] if subject.rig.hinges else READINGS[-2]
    if recording.is_equilibrium or transferred[0] >= known_from:
        whole = subject.static(load) if _hangs_whole(subject).any() else None
        return [*(None for _ in READINGS[1:]), mass_of(subject, whole)]
    if subject.rig.is_in_waves:
        return _between_crests(subject, load, is_alone=is_alone)
    found: list[float | None] = []
    for part in READINGS[:-1]:
        over = np.flatnonzero(transferred >= part)
        if not over.size or over[0] == 0:
            found.append(None)
            continue
        at = int(over[0])
        low, high = float(transferred[at - 1]), float(transferred[at])
        between = (part - low) / (high - low)
        found.append(float(load[at - 1] + between * (load[at] - load[at - 1])) / subject.rig.gravity)
    return [*found, mass_of(subject, _once_clear(subject, load))]


def _between_crests(subject: Subject, load: FloatArray, *, is_alone: bool) -> list[float | None]:
    """What a load cell reads on the mean of many waves [kg]; of one wave a sample tells next to nothing.

    Supports bear (1 - p) W of the weight W when the share p has come over. Where one hook bears all the rest
    its hoist load is less than that of the load clear by just as much; how several share, or a hook and a
    hinge, only a plan without waves tells.
    """
    static, rig = subject.static(load), subject.rig
    if rig.hinges:
        static = _once_clear(subject, load)
    if static is None or not is_alone or rig.hinges:
        return [*(None for _ in READINGS[1:]), mass_of(subject, static)]
    weighs = sum((series.load_weight(subject.recording, one) for one in rig.loads), np.zeros(len(load)))
    weight = subject.static(weighs) or 0.0
    return [mass_of(subject, static - (1.0 - part) * weight) for part in READINGS]


def _once_clear(subject: Subject, load: FloatArray) -> float | None:
    """Mean of a series over the first seconds in which hooks alone bear the loads; None if they never do."""
    time, clear = subject.recording.time, _hangs_whole(subject)
    if not clear.any():
        return None
    begin = int(np.argmax(clear))
    standing = np.flatnonzero(~clear[begin:])
    end = begin + int(standing[0]) if standing.size else len(time)
    parted = [one.time for one in partings(subject.recording) if one.time > time[begin]]
    until = min([time[begin] + READ_OVER, *parted])
    first = begin + np.flatnonzero(time[begin:end] <= until)
    return series.mean_over(time[first], load[first])


def _hangs_whole(subject: Subject) -> BoolArray:
    """Samples at which neither supports nor a hinge bear anything of a load, shape (time,)."""
    hangs = series.is_clear(subject.recording)
    for hinge in subject.rig.hinges:
        hangs = hangs & ~is_shut(subject.recording, hinge)
    return hangs


def sling_rows(subject: Subject, most: int) -> tuple[list[dict[str, Any]], str]:
    """Slings in the order of the lift file, and in words which are left out where there are too many.

    Slings that break or are cut come before all others, then those that carry most and that use most of their
    rope, shackles and lugs.
    """
    every = {one.rope: one for one in partings(subject.recording)}
    parted = {rope for rope, one in every.items() if one.kind not in PLANNED}
    told: dict[str, list[str]] = {}
    for time, kind, rope in subject.recording.events():
        if kind in (*PARTING, ATTACHED):
            told.setdefault(rope, []).append(f"{_OFF_AND_ON.get(kind, kind)} {show(time, 's', 1)}")
    figures = sling_figures(subject.recording, subject.rig.slings)
    kept, left_out = _most_loaded(figures, parted, most)
    rows = [
        {
            **_sling(subject, one),
            "gone": ", ".join(told.get(one.sling.rope, ())),
            "is_parted": one.sling.rope in parted,
        }
        for one in figures
        if one.sling.name in kept
    ]
    return rows, left_out


def _most_loaded(figures: Sequence[SlingFigures], parted: set[str], most: int) -> tuple[set[str], str]:
    """Names of the slings that a table has room for, and what there is to say of the others."""
    if len(figures) <= most:
        return {one.sling.name for one in figures}, ""
    measures: tuple[Callable[[SlingFigures], float], ...] = (
        lambda one: one.of_breaking_force or 0.0,
        lambda one: one.peak,
        lambda one: one.of_working_load_limit or 0.0,
        lambda one: one.of_lug_capacity or 0.0,
    )
    largest = {figures[first_peak([measure(one) for one in figures])].sling.name for measure in measures}
    first = [one.sling.name for one in figures if one.sling.rope in parted]
    by_use_and_force = sorted(figures, key=lambda one: (measures[0](one), measures[1](one)), reverse=True)
    by_use = [one.sling.name for one in by_use_and_force]
    order = dict.fromkeys([*first, *(name for name in by_use if name in largest), *by_use])
    kept = set(list(order)[:most])
    count = len(figures) - len(kept)
    here = "; the largest force and the most used rope, shackle and lug are here"
    said = f"{count} {'is' if count == 1 else 'are'} left out" + (here if kept.issuperset(largest) else "")
    return kept, said


def _sling(subject: Subject, one: SlingFigures) -> dict[str, Any]:
    # Lugs of one load are known by their own names; those of spreaders are called alike.
    alone = [load.name for load in subject.rig.loads] if len(subject.rig.loads) == 1 else []
    lugs = (lug if of in alone else f"{of}.{lug}" for _, of, lug in one.sling.at_lugs())
    return {
        "name": one.sling.name,
        "lug": ", ".join(lugs) or ABSENT,
        "length": _length(subject, one.sling),
        "static": number(one.static, "kN", 0),
        "peak": number(one.peak, "kN", 0),
        "time": number(one.peak_time, "s", 1),
        "least": number(one.least_clear, "kN", 0),
        "angle": number(one.largest_angle, "deg", 1),
        "rope": number(one.of_breaking_force, "%", 0),
        "shackle": number(one.of_working_load_limit, "%", 0),
        "lug_used": number(one.of_lug_capacity, "%", 0),
        "aside": number(one.out_of_plane, "deg", 1),
    }


def _length(subject: Subject, sling: Sling) -> str:
    """Length of a sling; of one with a chain hoist the shortest and the longest that it has."""
    lengths = sling_lengths(subject.recording, sling)
    if not lengths.size:
        return number(sling.length, "m", 2)
    least, most = (number(float(length), "m", 2) for length in (lengths.min(), lengths.max()))
    return least if least == most else f"{least}–{most}"


def equalizer_row(subject: Subject, equalizer: Equalizer) -> dict[str, Any]:
    """Travel used, tension spread and pins of an equalizer."""
    recording, clear = subject.recording, subject.clear
    spread = series.spread_when_clear(recording, equalizer) if equalizer.slings else None

    def used(word: str) -> str:
        own = list(ways_of(recording, equalizer, word))
        if not own:
            return ABSENT
        share = most_used(own, clear if clear.any() else subject.counts)
        return f"{show(share, '%', 0)} of {show(own[0].stroke, 'm', 2)}"

    return {
        "name": equalizer.name,
        "up": used("up"),
        "down": used("down"),
        "spread": show(spread, "%", 2),
        "pins": _pins(subject, equalizer),
    }


def _pins(subject: Subject, equalizer: Equalizer) -> str:
    """What has to be done with its locking pins, and before which step; without guides there are none."""
    if equalizer.mechanism == "approximated" or equalizer.guided == "none":
        return ABSENT

    def steps(key: str) -> list[str]:
        own = (equalizer.name, *equalizer.moving_sheaves)
        return [
            f"{number} “{step.step}”"
            for number, step in enumerate(subject.rig.plan, 1)
            if any(name in own for name in getattr(step, key))
        ]

    pulled, put_in = steps("pull_pins"), steps("put_in_pins")
    if not equalizer.locked:
        text = "any out before the first step"
    elif pulled:
        text = f"in at the start; pull before step {', '.join(pulled)}"
    else:
        text = "in over the whole lift"
    return f"{text}; put in before step {', '.join(put_in)}" if put_in else text


def spreader_row(subject: Subject, spreader: Spreader) -> dict[str, Any]:
    """What a spreader weighs and bears, and how it hangs, as the checks have it."""

    def found(check: str) -> float | None:
        return values_of(subject.recording, check).get(spreader.name)

    return {
        "name": spreader.name,
        "mass": number(spreader.weight / subject.rig.gravity, "t", 2),
        "rated": as_given(mass_of(subject, spreader.rated_capacity)),
        "used": number(found("spreader_load_of_rated_capacity"), "%", 1),
        "thrust": number(found("spreader_thrust"), "kN", 0),
        "tilt": number(found("spreader_tilt"), "deg", 2),
    }
