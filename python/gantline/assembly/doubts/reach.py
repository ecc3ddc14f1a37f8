"""Slings too long for how high the plan can bring their hooks: the load stands, whatever the run does."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gantline.assembly.doubts.ways import top_of
from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.parts import Parts
from gantline.scenario import Rigging, Scenario
from gantline.scenario.consistency.travel import bounds_after
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.movers import mover
from gantline.scenario.plan.plan_time import earliest_begins
from gantline.scenario.plan.steps import HoldStep, HookStep
from gantline.units import format_quantity

__all__ = ["doubtful_reach"]

#: What hooks are short by has to be more [m]: ground settles, and heights are round figures.
_ROUND = 0.1


def doubtful_reach(
    parts: Parts, scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None
) -> Iterator[Doubt]:
    """A load that stands, and none of whose slings goes taut as high as the plan can bring its hook.

    Nothing is said where hooks go aside, of gear between hook and load, and where anything but hooks may lift
    the load or let it down: vessels, `mechanics`, hinges, water, chain hoists, supports that are removed.

    Args:
        parts: The system, with all its bodies.
        scenario: The lift.
        rigging: Who carries whom.
        lifted: The load with what is lumped on it; None for none.
    """
    load, slings = scenario.load, list(rigging.slings.values())
    beside = scenario.vessels or scenario.mechanics or scenario.hinges
    if load is None or lifted is None or load.stands_on is None or load.in_water or beside or not slings:
        return
    if not all(isinstance(one, HookStep | HoldStep) and not one.remove_supports for one in scenario.plan):
        return
    if any(one.upper_body != one.hook or len(one.lugs) != 1 or one.chain_hoist for one in slings):
        return
    up = _most_up(parts, scenario)
    if not any(up.get(one.hook, 0.0) > 0.0 for one in slings):
        return
    centre, turned = parts.pose(load.name)
    short = {}
    for one in slings:
        hook = parts.pose(one.hook)[0]
        way = hook - centre - turned @ np.array(lifted.lugs[one.lugs[0]])
        level = float(np.linalg.norm(way[:2]))
        # Straight up from where it is, until the distance to its lug is the length of the sling.
        needed = math.sqrt(max(one.length**2 - level**2, 0.0)) - float(way[2])
        short[one.name] = needed - up.get(one.hook, 0.0), float(hook[2]) + needed
    nearest = min(short, key=lambda name: short[name])
    lacks, taut = short[nearest]
    if lacks > _ROUND:
        name = rigging.slings[nearest].hook
        first = f"sling {nearest}" if len(short) == 1 else f"sling {nearest}, the first of {len(short)},"
        goes = f"{first} goes taut with {name} at {format_quantity(taut, 'm', 2)}"
        comes = f"the plan brings {name} to {format_quantity(taut - lacks, 'm', 2)} at most"
        sentence = f"{load.name} is never lifted: {goes}, and {comes}"
        path = ("slings", nearest, "length")
        yield Doubt(path, f"{sentence}; see lengths, heights, steps and 'duration'")


def _most_up(parts: Parts, scenario: Scenario) -> dict[str, float]:
    """How far the plan can hoist each hook over its start at most [m], within its height and the duration."""
    where: dict[str, tuple[float, float]] = {}
    up: dict[str, float] = {}
    for step, begin in zip(scenario.plan, earliest_begins(scenario.plan), strict=True):
        if not isinstance(step, HookStep):
            continue
        for text in step.moved:
            one = mover(scenario, step.kind, text)
            if one is None or one.start is None:
                continue
            before = where.get(one.name, (one.start, one.start))
            low, high = bounds_after(step, before)
            left = max(scenario.duration - begin, 0.0)
            limits = [high, before[1] + step.speed * left if step.sign > 0 else before[1]]
            top = top_of(parts, scenario, scenario.hooks[one.name])
            limits += [one.range[1]] if one.range is not None else []
            limits += [] if top is None else [top]
            where[one.name] = low, min(limits)
            up[one.name] = max(up.get(one.name, 0.0), where[one.name][1] - one.start)
    return up
