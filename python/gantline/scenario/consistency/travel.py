"""Whether the steps of a plan keep to the limits of height and range, as far as that is known.

A step that ends on a condition or a time leaves a hook or trolley somewhere on its way, so positions are
followed as bounds: what passes its limit for sure is a mistake of the plan, what may is left to the run.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from gantline.scenario.cranes.goliath import Goliath
from gantline.scenario.cranes.hooks import trolley_name
from gantline.scenario.findings import Findings, Path
from gantline.scenario.model import Scenario
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import gone_along
from gantline.scenario.plan.movers import Mover, mover
from gantline.scenario.plan.positions import Places, boom_angles_at_end, places_of_cranes
from gantline.scenario.plan.steps import HookStep, Kind, MovingStep

__all__ = ["Bounds", "Moved", "bounds_after", "check_travel", "moved_by", "said"]

#: Rounding of positions that steps add up [m].
_ROUNDING = 1e-9

#: Between which positions something is, as `to` counts it [m, rad].
Bounds = tuple[float, float]

#: Units of messages: of positions, speeds and accelerations.
_METRES = {"position": ("m", 1.0), "speed": ("m/min", 60.0), "acceleration": ("m/s^2", 1.0)}
_DEGREES = {
    "position": ("deg", math.degrees(1)),
    "speed": ("deg/min", 60 * math.degrees(1)),
    "acceleration": ("deg/s^2", math.degrees(1)),
}


@dataclass(frozen=True)
class Moved:
    """What a step moves, and between which positions it is.

    Attributes:
        mover: What is moved.
        path: Where the file says how far.
        before: Where it is before the step.
        after: Where the step leaves it.
        head_up: How far the boom head that a hook hangs from has gone up [m].
        is_known: Whether the angle of that boom is known.
    """

    mover: Mover
    path: Path
    before: Bounds
    after: Bounds
    head_up: float
    is_known: bool


def said(kind: Kind, value: float, of: str) -> str:
    """A value of what moves in a message, such as '30 m/min'; `of` is position, speed or acceleration."""
    unit, factor = (_DEGREES if kind in ("boom", "upper") else _METRES)[of]
    return f"{value * factor:g} {unit}"


def check_travel(findings: Findings) -> None:
    """Note steps that leave the range of a trolley, crane or boom, or hoist a hook too high."""
    where: dict[str, Bounds] = {}
    plan, before_step = findings.scenario.plan, places_of_cranes(findings.scenario)
    for place, (step, angles) in enumerate(zip(plan, boom_angles_at_end(findings.scenario), strict=True)):
        if isinstance(step, LeadStep):
            key = "by" if any(step.by) else "turn"
            _lead(findings, ("plan", place, key), step, before_step[place], where)
        if not isinstance(step, MovingStep):
            continue
        for one in moved_by(findings.scenario, place, step, angles, where):
            if isinstance(step, HookStep):
                _check_direction(findings, one.path, step, _raised(one.before, one.head_up))
            if one.is_known:
                _check_range(findings, one.path, one.mover, _raised(one.after, one.head_up))
        aside = place + 1 < len(plan) and getattr(plan[place + 1], "starts", "") == "with_previous"
        if not aside:
            _check_distances(findings, ("plan", place), where)


def _lead(findings: Findings, path: Path, step: LeadStep, before: Places, where: dict[str, Bounds]) -> None:
    """Note hooks that a step that leads takes too high, and where it leaves what it moves.

    Ranges of booms and cranes are looked at along the whole way by `check_lead`.
    """
    for gone in gone_along(findings.scenario, step, before):
        led, end, up = gone.led, gone.poses[-1], gone.hoisted[-1]
        start = led.hoist.start or 0.0
        low, high = where.get(led.hoist.name, (start, start))
        where[led.hoist.name] = low + up, high + up
        head_up = 0.0 if led.hoist.head is None else led.hoist.head.rise(end.angle)
        _check_range(findings, path, led.hoist, _raised(where[led.hoist.name], head_up))
        ends = [(led.boom, end.angle), (led.upper, end.slew), (led.track, end.travel)]
        where |= {one.name: (at, at) for one, at in ends if one is not None}


def moved_by(
    scenario: Scenario, place: int, step: MovingStep, angles: Places, where: dict[str, Bounds]
) -> Iterator[Moved]:
    """What a step moves of that which has a start, one after the other.

    Args:
        scenario: The lift.
        place: Of the step in the plan.
        step: The step.
        angles: Of booms at its end, and whether they are known.
        where: Between which positions things are so far; each that is moved is put where the step leaves it.
    """
    for text in dict.fromkeys(step.moved):
        one = mover(scenario, step.kind, text)
        if one is None or one.start is None:
            continue
        # Hooks at booms as their drums count them: a height less what the boom head has gone up.
        angle, is_known = (0.0, True) if one.head is None else angles[one.head.boom]
        head_up = 0.0 if one.head is None else one.head.rise(angle)
        before = where.get(one.name, (one.start, one.start))
        where[one.name] = after = bounds_after(step, before, head_up)
        key = "to" if getattr(step, "to", None) is not None else "by" if step.by is not None else step.verb
        yield Moved(one, ("plan", place, key), before, after, head_up, is_known)


def _raised(bounds: Bounds, by: float) -> Bounds:
    return bounds[0] + by, bounds[1] + by


def bounds_after(step: MovingStep, before: Bounds, head_up: float = 0.0) -> Bounds:
    """Where a step leaves what it moves.

    Args:
        step: The step.
        before: Where that was before.
        head_up: How far the boom head that it hangs from has gone up [m].
    """
    to = getattr(step, "to", None)
    if to is not None:
        return to - head_up, to - head_up
    if step.by is not None:
        way = step.sign * step.by
        return before[0] + way, before[1] + way
    if getattr(step, "keep_plumb", None):
        return -math.inf, math.inf
    return (before[0], math.inf) if step.sign > 0 else (-math.inf, before[1])


def _check_direction(findings: Findings, path: Path, step: HookStep, before: Bounds) -> None:
    if step.to is None:
        return
    if step.sign > 0 and step.to < before[0] - _ROUNDING:
        sentence = f"the hook is at {before[0]:g} m or higher, and hoisting does not bring it down"
        findings.add(path, f"{sentence} to {step.to:g} m; a 'lower' step is right here")
    if step.sign < 0 and step.to > before[1] + _ROUNDING:
        sentence = f"the hook is at {before[1]:g} m or lower, and lowering does not bring it up"
        findings.add(path, f"{sentence} to {step.to:g} m; a 'hoist' step is right here")


def _check_range(findings: Findings, path: Path, one: Mover, after: Bounds) -> None:
    if one.range is None:
        return
    low, high = one.range
    far = (
        max(after[0], low)
        if after[0] > high + _ROUNDING
        else after[1]
        if after[1] < low - _ROUNDING
        else None
    )
    if far is None:
        return
    there, least, most = (said(one.kind, value, "position") for value in (far, low, high))
    if one.kind == "sling":
        longer = "longer" if far > 0.0 else "shorter"
        sentence = f"'{one.name}' would be {said(one.kind, abs(far), 'position')} {longer} than at the start"
        findings.add(path, f"{sentence}; the range of its chain hoist is {least} to {most}")
        return
    right = f"its highest position is {most}" if one.kind == "hook" else f"its range is {least} to {most}"
    findings.add(path, f"'{one.name}' would come to {there}; {right}")


def _check_distances(findings: Findings, path: Path, where: dict[str, Bounds]) -> None:
    """Hooks of different trolleys keep their distance where the trolleys come to rest."""
    for name, crane in (findings.scenario.cranes or {}).items():
        if not isinstance(crane, Goliath) or crane.hook_distance is None:
            continue
        places: list[tuple[str, Any, float]] = []
        for trolley, given in crane.trolleys.items():
            low, high = where.get(trolley_name(name, trolley), (given.position, given.position))
            if low != high:
                continue
            for hook, one in given.hooks.items():
                for other, second, there in places:
                    apart = abs(low + one.along - there)
                    if other != trolley and apart < crane.hook_distance - _ROUNDING:
                        sentence = f"'{hook}' would be {apart:g} m from '{second}' along the girder"
                        right = f"{crane.hook_distance:g} m is the least"
                        findings.add(path, f"{sentence}; {right}")
                places.append((trolley, hook, low + one.along))
