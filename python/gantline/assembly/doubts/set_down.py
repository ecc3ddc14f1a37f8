"""Steps that let a load down below what it was lifted off, and plans that never hold it as it hangs."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.hooks import full_names
from gantline.scenario.cranes.kept_plumb import slings_under
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.slinging import slings_on
from gantline.scenario.plan.steps import HoldStep, HookStep, LowerStep
from gantline.units import format_quantity

__all__ = ["doubtful_set_down"]

#: Slings are given so much slack below what a load stands on, to be taken off [m].
_SLACK = 1.0
#: A load that is let down by more than this below that stands for sure: slings stretch by less [m].
_SURE = 0.5


@dataclass(frozen=True)
class _Way:
    """How a plan takes a load up and down where it stood at the start.

    Attributes:
        place: Of the step in the plan.
        before: How high the load hangs as the step begins, over where its slings take it off, at most [m];
            None where it stands.
        after: The same as the step ends.
    """

    place: int
    before: float | None
    after: float | None


def doubtful_set_down(scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """The first way down that takes the hooks of a load farther than it hangs, and a plan without a hold.

    Nothing is said once hooks of a load go by themselves or aside, where supports are removed, and of loads
    that vessels, `mechanics`, hinges or water may bear.

    Args:
        scenario: The lift.
        rigging: Who carries whom.
    """
    load = scenario.load
    beside = scenario.vessels or scenario.mechanics or scenario.hinges
    if load is None or load.stands_on is None or load.in_water or beside:
        return
    ways, is_let_down = list(_ways(scenario, rigging)), False
    yield from _begins_down(scenario, load.name, ways)
    for way in ways:
        if not isinstance(scenario.plan[way.place], HookStep):
            continue
        is_first, is_let_down = not is_let_down, isinstance(scenario.plan[way.place], LowerStep)
        # What follows another way down gives slings slack, and the load may stand already.
        if not is_first or way.before is None or way.after is None:
            continue
        if -way.after > max(_SLACK, way.before):
            step, below = scenario.plan[way.place], format_quantity(-way.after, "m", 2)
            lowers = (
                f"step '{step.step}' lowers {load.name} to {below} below where it comes off what it stood on"
            )
            right = "it stands there again, and its slings go slack; is 'hoist' meant, or another way?"
            yield Doubt(("plan", way.place, "lower"), f"{lowers}: {right}")
            return
    yield from _never_held(scenario, load.name, ways)


def _begins_down(scenario: Scenario, load: str, ways: Sequence[_Way]) -> Iterator[Doubt]:
    """A plan that begins with a way down of the hooks of a load that stands, and takes no sling off."""
    first = next((way.place for way in ways if isinstance(scenario.plan[way.place], HookStep)), None)
    if first is None or any(step.detach or step.cut for step in scenario.plan):
        return
    step = scenario.plan[first]
    if not isinstance(step, LowerStep):
        return
    hooks = full_names(step.moved, scenario.hooks)
    lowest = min(scenario.hooks[name].height for name in hooks)
    way = step.by if step.by is not None else 0.0 if step.to is None else lowest - step.to
    if way > _SLACK:
        lowers = f"step '{step.step}' lowers {' and '.join(hooks)} by {format_quantity(way, 'm', 2)}"
        sentence = f"{lowers} while {load} stands, and nothing was lifted before: its slings go slack"
        yield Doubt(("plan", first, "lower"), f"{sentence}; is 'hoist' meant?")


def _never_held(scenario: Scenario, load: str, ways: Sequence[_Way]) -> Iterator[Doubt]:
    """A plan that sets the load down for sure in the end, and has no hold between lift-off and that."""
    lifts = [way.place for way in ways if way.after is not None]
    rest = scenario.plan[len(ways) :]
    is_let_go = bool(rest) and not list(slings_on(scenario))[len(ways)]
    if not lifts or not (is_let_go or all(isinstance(step, HoldStep | LowerStep) for step in rest)):
        return
    holds = [way for way in ways if isinstance(scenario.plan[way.place], HoldStep)]
    if all(_stands(way.before) for way in holds) and _stands(ways[-1].after):
        sentence = f"no step holds {load} while it hangs, so nothing tells what of its forces is static"
        yield Doubt(("plan", lifts[0]), f"{sentence}; a hold after it is lifted off does, 'hold: 60 s'")


def _stands(up: float | None) -> bool:
    """Whether a load stands for sure that hangs so high at most."""
    return up is None or up <= -_SURE


def _ways(scenario: Scenario, rigging: Rigging) -> Iterator[_Way]:
    """Steps of the plan, as far as its hooks all go up and down together."""
    holding = {hook for hook in scenario.hooks if slings_under(rigging, hook)}
    up: float | None = None
    for place, step in enumerate(scenario.plan):
        if step.remove_supports or step.detach or step.attach or step.cut:
            return
        before = up
        if isinstance(step, HookStep):
            moved = set(full_names(step.moved, scenario.hooks))
            if moved != holding:
                return
            up = _after(scenario, step, before)
        elif not isinstance(step, HoldStep):
            return
        yield _Way(place, before, up)


def _after(scenario: Scenario, step: HookStep, before: float | None) -> float | None:
    """How high a load hangs at most after a step; None where it stands for sure."""
    until = step.until
    if isinstance(step, LowerStep):
        is_set_down = until is not None and (
            until.supports == "touched" or until.load_transferred is not None
        )
        if before is None or is_set_down:
            return None
        ends = [before]
        ends += [] if step.by is None else [before - step.by]
    elif until is not None and (until.slings == "taut" or until.load_transferred not in (None, 1.0)):
        return None
    elif until is not None and (until.supports == "clear" or until.load_transferred == 1.0):
        return 0.0
    else:
        ends = [math.inf if step.by is None else (before or 0.0) + step.by]
    # Slings take a load off with its hooks where they are at the start, or higher.
    hooks = [scenario.hooks[name] for name in full_names(step.moved, scenario.hooks)]
    ends += [] if step.to is None else [step.to - min(hook.height for hook in hooks)]
    return min(ends)
