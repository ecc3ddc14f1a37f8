"""Goliath cranes on one rail that the lift file starts, or takes, into each other, or past each other.

All stand with the middle of their span at x = 0, so that cranes of one span run on the same two rails. What
is known of how far they reach along these is the `base` of their legs or end carriages, of corner to corner;
bogies and buffers reach further, and without a `base` only the order in which cranes stand is known.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import combinations

from gantline.assembly.cranes.goliath import goliaths
from gantline.scenario import Scenario
from gantline.scenario.consistency.travel import Bounds, bounds_after
from gantline.scenario.cranes.goliath import Goliath
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.movers import mover
from gantline.scenario.plan.steps import HoldStep, MovingStep
from gantline.units import format_quantity

__all__ = ["doubtful_rails"]

#: Spans that differ by less than this share are of the same rails [1].
_SAME = 1e-6
#: Rounding of positions that steps add up [m].
_ROUNDING = 1e-9


def doubtful_rails(scenario: Scenario) -> Iterator[Doubt]:
    """Each pair of cranes that cannot both be where the lift file has them, when that is first so for sure.

    They are looked at where they start, and where each step and all beside it have ended. A step that ends at
    a time or on a condition leaves a crane somewhere on its way; what may be is left to the run.
    """
    cranes = goliaths(scenario)
    where = {name: (crane.position, crane.position) for name, crane in cranes.items()}
    pairs = [
        sorted(pair, key=lambda name: cranes[name].position)
        for pair in combinations(cranes, 2)
        if math.isclose(*(cranes[name].span for name in pair), rel_tol=_SAME)
        and math.isclose(*(cranes[name].rail_level for name in pair), abs_tol=_ROUNDING)
    ]
    apart = []
    for back, front in pairs:
        sentence = _in_one_place(cranes, where, back, front)
        if sentence is None:
            apart.append((back, front))
        else:
            yield Doubt(("cranes", front, "position"), f"at the start {sentence}")
    for place, step in enumerate(scenario.plan):
        if isinstance(step, MovingStep) and step.kind == "crane":
            where |= _moved(scenario, step, where)
        following = scenario.plan[place + 1 : place + 2]
        if any(not isinstance(one, HoldStep) and one.starts == "with_previous" for one in following):
            continue
        for back, front in tuple(apart):
            sentence = _in_one_place(cranes, where, back, front)
            if sentence is not None:
                apart.remove((back, front))
                yield Doubt(("plan", place), f"where step '{step.step}' ends {sentence}")


def _moved(scenario: Scenario, step: MovingStep, where: Mapping[str, Bounds]) -> dict[str, Bounds]:
    """Where the cranes of a step are after it."""
    found = (mover(scenario, step.kind, text) for text in step.moved)
    return {
        one.name: bounds_after(step, where[one.name])
        for one in found
        if one is not None and one.name in where
    }


def _in_one_place(
    cranes: Mapping[str, Goliath], where: Mapping[str, Bounds], back: str, front: str
) -> str | None:
    """What is said of two cranes, the second of which starts at larger y, that would be in one place."""
    apart = where[front][1] - where[back][0]
    reach = sum((cranes[name].standing.base or 0.0) / 2 for name in (back, front))
    if apart > reach + _ROUNDING:
        return None
    at = f"{back} is at {_at(where[back], 0)}, and {front} on the same rails at {_at(where[front], 1)}"
    if apart < -_ROUNDING:
        return f"{at}: they cannot pass each other"
    if reach == 0.0:
        return f"{at}: both are in one place"
    stand = "legs" if all(cranes[name].legs is not None for name in (back, front)) else "end carriages"
    return f"{at}: their {stand} need more than {format_quantity(reach, 'm', 2)} by their 'base' alone"


def _at(bounds: Bounds, end: int) -> str:
    """A place, or the end of bounds that is the nearest to what the other crane may be at."""
    shown = format_quantity(bounds[end], "m", 2)
    return shown if bounds[0] == bounds[1] else f"{shown} or {'less' if end else 'more'}"
