"""Steps that take a crane or trolley away while the load in its slings stands: they drag it along."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.scenario import Rigging, Scenario
from gantline.scenario.consistency.travel import Bounds, bounds_after
from gantline.scenario.cranes.hooks import full_names
from gantline.scenario.cranes.kept_plumb import is_moved_by, slings_under
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.movers import Mover, mover
from gantline.scenario.plan.plan import Step
from gantline.scenario.plan.slinging import slings_on
from gantline.scenario.plan.steps import AlongStep, HoistStep, HookStep

__all__ = ["doubtful_dragging"]

#: A hook that goes less far while its load stands is brought over it, or gives its slings slack [m].
_FAR = 1.0
#: A hook is farther than this from what its crane slews and luffs about [m].
_LEVER = 10.0


def doubtful_dragging(scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """A step that takes a hook with slings on far away, `by` a way or `to` a place, from a load that stands.

    It stands until a step hoists one of its hooks by a way, or until more than a part of it hangs, and again
    where one lowers until something bears it. Loads in hinges turn while they stand.

    Args:
        scenario: The lift.
        rigging: Who carries whom.
    """
    load = scenario.load
    if load is None or load.stands_on is None or scenario.hinges:
        return
    stands, where = True, dict[str, Bounds]()
    for place, (step, on) in enumerate(zip(scenario.plan, slings_on(scenario), strict=True)):
        holding = {
            hook for hook in scenario.hooks if any(one.name in on for one in slings_under(rigging, hook))
        }
        if isinstance(step, AlongStep):
            for text in dict.fromkeys(step.moved):
                one = mover(scenario, step.kind, text)
                if one is None or one.start is None:
                    continue
                before = where.get(one.name, (one.start, one.start))
                where[one.name] = bounds_after(step, before)
                taken = sorted(hook for hook in holding if is_moved_by(one, scenario.hooks[hook]))
                if stands and taken and _least_way(one, before, where[one.name]) > _FAR:
                    drags = f"step '{step.step}' takes {' and '.join(taken)} away with slings on"
                    right = "lift it off before, 'until: {supports: clear}', or take its slings off"
                    yield Doubt(
                        ("plan", place), f"{drags} while {load.name} stands, and drags it along: {right}"
                    )
                    return
        stands = _stands_after(step, stands, holding, scenario)


def _least_way(one: Mover, before: Bounds, after: Bounds) -> float:
    """How far a step takes a hook at least [m]; 0 where that is not known."""
    least = max(0.0, after[0] - before[1], before[0] - after[1])
    return least * (_LEVER if one.kind in ("boom", "upper") else 1.0)


def _stands_after(step: Step, stands: bool, holding: set[str], scenario: Scenario) -> bool:
    """Whether a load stands for sure after a step, if it did before."""
    if isinstance(step, LeadStep):
        return stands and step.by[2] <= 0.0
    if not isinstance(step, HookStep) or holding.isdisjoint(full_names(step.moved, scenario.hooks)):
        return stands
    until = step.until
    if isinstance(step, HoistStep):
        is_partly = until is not None and until.load_transferred is not None and until.load_transferred < 1.0
        return stands and (is_partly or (until is not None and until.slings == "taut"))
    is_set_down = until is not None and (until.load_transferred is not None or until.supports == "touched")
    return stands or is_set_down
