"""Hooks of one crane that the lift file hangs, or takes, into one place: their falls would be in each other.

Hooks of two trolleys of a crane that has a `hook_distance` are held against that with the lift file.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations

from gantline.assembly.cranes.goliath import goliaths
from gantline.assembly.cranes.reeving import reeved_hooks
from gantline.scenario import Scenario
from gantline.scenario.consistency.travel import Bounds, bounds_after
from gantline.scenario.cranes.hooks import Hook
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.movers import mover
from gantline.scenario.plan.steps import HoldStep, MovingStep
from gantline.units import format_quantity

__all__ = ["doubtful_falls"]


@dataclass(frozen=True)
class _Pair:
    """Two hooks of two trolleys that cannot pass each other.

    Attributes:
        back: The one that hangs at smaller x at the start.
        front: The other.
        width: How near they are in each other, along the girder [m].
    """

    back: Hook
    front: Hook
    width: float


def doubtful_falls(scenario: Scenario) -> Iterator[Doubt]:
    """Each pair of hooks of a crane whose falls would be in one place, when that is first so for sure.

    They are nearer than a diameter of their sheaves, which lie side by side in any reeving. Hooks of two
    trolleys are looked at where they start, and where each step and all beside it have ended, as cranes on
    their rails are.
    """
    apart: list[_Pair] = []
    cranes, widths = goliaths(scenario), _widths(scenario)
    for pair in combinations(reeved_hooks(scenario), 2):
        one, other = (each.hook for each in pair)
        if one.carrier is None or other.carrier is None or one.crane != other.crane:
            continue
        width = (widths[one.name] + widths[other.name]) / 2
        if one.carrier == other.carrier:
            if math.dist(one.pin, other.pin) < width:
                sentence = f"{one.name} and {other.name} hang in one place of their {one.carrier.kind}"
                yield Doubt(other.paths[""], f"{sentence}: 'across' and 'along' tell hooks apart")
        elif cranes[one.crane].hook_distance is None and abs(one.place[1] - other.place[1]) < width:
            back, front = sorted((one, other), key=lambda each: each.place[0])
            apart.append(_Pair(back, front, width))
    yield from _over_the_plan(scenario, apart)


def _widths(scenario: Scenario) -> dict[str, float]:
    """Diameter of the sheaves of each hook [m]."""
    ropes = scenario.ropes or {}
    return {
        one.name: one.reeving.diameter(ropes[one.reeving.rope].diameter) for one in reeved_hooks(scenario)
    }


def _over_the_plan(scenario: Scenario, apart: list[_Pair]) -> Iterator[Doubt]:
    """Pairs of hooks of two trolleys that meet, at the start or where a step and all beside it have ended."""
    moved: dict[str, Bounds] = {}
    for pair in tuple(apart):
        if (sentence := _in_each_other(pair, moved)) is not None:
            apart.remove(pair)
            yield Doubt(pair.front.paths[""], f"at the start {sentence}")
    for place, step in enumerate(scenario.plan):
        if isinstance(step, MovingStep) and step.kind == "trolley":
            moved |= _moved(scenario, step, moved)
        following = scenario.plan[place + 1 : place + 2]
        if any(not isinstance(one, HoldStep) and one.starts == "with_previous" for one in following):
            continue
        for pair in tuple(apart):
            if (sentence := _in_each_other(pair, moved)) is not None:
                apart.remove(pair)
                yield Doubt(("plan", place), f"where step '{step.step}' ends {sentence}")


def _moved(scenario: Scenario, step: MovingStep, where: Mapping[str, Bounds]) -> dict[str, Bounds]:
    """How far trolleys of a step are from where they start after it [m]."""
    found = {}
    for text in step.moved:
        one = mover(scenario, step.kind, text)
        if one is not None and one.start is not None:
            low, high = where.get(one.name, (0.0, 0.0))
            after = bounds_after(step, (one.start + low, one.start + high))
            found[one.name] = (after[0] - one.start, after[1] - one.start)
    return found


def _in_each_other(pair: _Pair, moved: Mapping[str, Bounds]) -> str | None:
    """What is said of hooks of two trolleys that are in one place, or past each other."""
    back, front = pair.back, pair.front
    assert back.carrier is not None and front.carrier is not None  # trolleys have been told apart
    least = back.place[0] + moved.get(back.carrier.name, (0.0, 0.0))[0]
    most = front.place[0] + moved.get(front.carrier.name, (0.0, 0.0))[1]
    if most - least >= pair.width:
        return None
    across = format_quantity(abs(back.place[1] - front.place[1]), "m", 2)
    if most < least:
        said = f"{front.name} has gone past {back.name}, {across} beside it: falls do not pass each other"
    else:
        along = format_quantity(most - least, "m", 2)
        said = f"{back.name} and {front.name} are {along} apart along the girder and {across} across it"
        said = f"{said}: their falls are in each other"
    return f"{said}; 'hook_distance' of the crane says how near they may come"
