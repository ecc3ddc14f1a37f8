"""Cranes: falls out of plumb, height of hooks; of Goliath cranes distances, loads of corners, wind."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

import numpy as np

from gantline.checks.alarms import FALLS
from gantline.checks.below_hooks import hoist_ratios
from gantline.checks.force import kilonewton
from gantline.checks.measure import Finding, Found, Missing, Refused, extreme
from gantline.results import series
from gantline.results.cranes.boom import Boom
from gantline.results.cranes.crane import Crane, corner_loads
from gantline.results.cranes.pulled_aside import hooks_that_stay, pull_aside
from gantline.results.gear import Hook
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray, FloatArray

_OF_FALLS = "falls_out_of_plumb"
#: Share of its largest load from which the pull at a hook counts [1]: as slings come taut one after another
#: it goes to and fro.
_BEARS = 0.25
#: How far lugs may come aside from where they hung, until falls would lean [m]: those of 1.5 m by 2 deg.
_IN_PLACE = 0.05


def falls_out_of_plumb(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle of the falls of a hook from plumb; of one that stays where it is, that at which falls would hang.

    Of those that stay nothing is said that nobody asks for, as long as it is within the bound past which
    falls warn, and nothing while they take up or let go of a load below where it hangs.
    """
    for hook in recording.rig.carried_hooks:
        yield from extreme(recording, recording.column("falls_out_of_plumb", hook.name), during, hook.name)
    rig = recording.rig
    is_asked = _OF_FALLS in rig.limits or any(_OF_FALLS in step.require for step in rig.plan)
    for fixed in hooks_that_stay(recording):
        for found in _would_hang(recording, during, fixed):
            if is_asked or found.value > FALLS.value(recording, fixed.name):
                yield found


def _would_hang(recording: Recording, during: BoolArray, hook: Hook) -> Iterator[Found]:
    """Angle from plumb of all that pulls down at a hook that does not lean, while it bears something."""
    aside, down = pull_aside(recording, hook), recording.column("hoist_load", hook.name)
    load = recording.column("hook_load", hook.name)
    bears = load > _BEARS * np.max(load, initial=0.0)
    bears &= ~_stands_below(recording, hook, bears)

    def text(at: int) -> str:
        pulls = f"{kilonewton(aside[at])} aside, {kilonewton(down[at])} down"
        return f"{pulls}: {hook.name} stays where falls would lean"

    yield from extreme(recording, np.arctan2(aside, down), during & bears, hook.name, text)


def _stands_below(recording: Recording, hook: Hook, bears: BoolArray) -> BoolArray:
    """Samples at which a load stands below where it hung, or will hang, in a hook that stays, shape (time,).

    Slings of unlike lengths come taut and go slack one after another then, and those that carry pull aside
    at a hook that cannot give way. Falls would lean until it is over these, and by no more; a load that has
    been moved aside since it hung, or is moved aside as it comes clear, pulls falls aside too, and counts.
    """
    ends = [
        series.rope_ends(recording, sling.rope)
        for sling in recording.rig.slings
        if recording.rig.hook_of(sling) == hook.name and sling.over is None
    ]
    hung = np.asarray(series.is_clear(recording) & bears, dtype=np.bool_)
    if not ends or not hung.any():
        return np.zeros_like(bears)
    aside = np.mean([upper[:, :2] - lower[:, :2] for upper, lower in ends], axis=0)
    places = np.arange(len(hung))
    before = np.maximum.accumulate(np.where(hung, places, -1))
    after = np.minimum.accumulate(np.where(hung, places, len(hung))[::-1])[::-1]
    below = np.zeros_like(hung)
    for at in (before, after):
        is_known = (at >= 0) & (at < len(hung))
        way = aside - aside[np.where(is_known, at, 0)]
        below |= is_known & (np.linalg.norm(way, axis=1) < _IN_PLACE)
    return below & ~series.is_clear(recording)


def height_margin(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """How far a hook stays below its highest position."""
    for hook in recording.rig.carried_hooks:
        if hook.highest is None:
            yield Missing(hook.name, "highest position not known")
            continue
        left = hook.highest - recording.column("hook_height", hook.name)
        yield from extreme(recording, left, during, hook.name, smallest=True)


def approach_margin(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """How far a hook stays from a rail, beyond the smallest distance of the crane."""
    for crane in recording.rig.cranes:
        for trolley, hook in crane.hooks:
            if crane.hook_approach is None:
                yield Missing(hook.name, "hook approach not known")
                continue
            along = recording.column("joint_position", trolley.name) + hook.along
            left = crane.span / 2 - np.abs(along) - crane.hook_approach
            yield from extreme(recording, left, during, hook.name, smallest=True)


def distance_margin(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """How far hooks of two trolleys stay apart along the girder, beyond the least of the crane."""
    for crane in recording.rig.cranes:
        for (one, first), (other, second) in combinations(crane.hooks, 2):
            if one.name == other.name:
                continue
            element = f"{first.name} to {second.name}"
            if crane.hook_distance is None:
                yield Missing(element, "smallest distance of hooks not known")
                continue
            places: list[FloatArray] = [
                recording.column("joint_position", trolley.name) + hook.along
                for trolley, hook in ((one, first), (other, second))
            ]
            left = np.abs(places[0] - places[1]) - crane.hook_distance
            yield from extreme(recording, left, during, element, smallest=True)


def corner_load(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Load of a corner of a crane by moments, with the design weight; rails push and do not pull."""
    for crane in recording.rig.cranes:
        raised = _raised_corners(recording, crane)
        for name, design in zip(crane.corners, raised.T, strict=True):
            load = recording.column("corner_load", name)
            lifted = np.flatnonzero(during & (np.minimum(load, design) < 0.0))
            if lifted.size:
                at = float(recording.time[lifted[0]])
                yield Refused(name, f"it would lift off its rail at {at:.2f} s: the crane tips")
            for found in extreme(recording, np.maximum(load, design), during, name):
                simulated = float(np.interp(found.time or 0.0, recording.time, load))
                is_raised = found.value > simulated * (1.0 + 1e-9)
                text = f"{kilonewton(simulated)} simulated, with the design weight {kilonewton(found.value)}"
                yield replace(found, formula=text if is_raised else "")


def _raised_corners(recording: Recording, crane: Crane) -> FloatArray:
    """Loads of the corners with the design weight in all hooks, shape (time, 4) [N]."""
    names = [hook.name for _, hook in crane.hooks]
    ratios = {name: hoist_ratios(recording, [name]) for name in names}
    if all((ratio <= 1.0).all() for ratio in ratios.values()):
        return np.stack([recording.column("corner_load", name) for name in crane.corners], axis=1)
    columns = {name: one.values for name, one in recording.variables.items() if not one.is_text}
    hoist = {name: ratio * recording.column("hoist_load", name) for name, ratio in ratios.items()}
    found, _ = corner_loads(columns, recording.coordinates, [crane], hoist)
    loads: FloatArray = found["corner_load"].values
    return loads


def wind_of_limit(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Gust of the lift over the wind limit of a crane.

    Booms and overhead cranes, which stand in halls, without one are left out where nobody asks, and fixed
    hooks always: they stand for any crane.
    """
    rig = recording.rig
    at_top = " at its top" if rig.wind is not None and rig.wind.profile is not None else ""
    is_asked = rig.limits.get("wind_of_limit") is not None
    cranes: list[Crane | Boom | Hook] = [
        crane for crane in rig.cranes if is_asked or crane.has_legs or crane.wind_limit is not None
    ]
    cranes += [boom for boom in rig.booms if is_asked or boom.wind_limit is not None]
    cranes += [hook for hook in rig.fixed_hooks if hook.wind_limit is not None]
    for crane in cranes:
        if crane.wind_limit is None:
            yield Missing(crane.name, "wind limit not known")
        elif crane.wind is None:
            yield Missing(crane.name, "wind not said")
        elif during.any():
            text = f"{crane.wind:.3g} m/s{at_top} / {crane.wind_limit:g} m/s"
            yield Found(crane.wind / crane.wind_limit, crane.name, formula=text)
