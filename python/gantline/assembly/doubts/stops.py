"""Emergency stops that are no harder than any other, since nothing says how hard."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import movers_of_lead
from gantline.scenario.plan.movers import Mover, mover
from gantline.scenario.plan.plan import Step
from gantline.scenario.plan.plan_time import earliest_begins
from gantline.scenario.plan.steps import MovingStep

__all__ = ["doubtful_stops"]


def doubtful_stops(scenario: Scenario) -> Iterator[Doubt]:
    """All trolleys, cranes and booms that an emergency stop stops as any step does."""
    soft: dict[str, int] = {}
    stopped = _under_way(scenario)
    for place, step in enumerate(scenario.plan):
        if not isinstance(step, MovingStep | LeadStep):
            continue
        if place not in stopped and getattr(step, "emergency_stop_at", None) is None:
            continue
        if isinstance(step, LeadStep):
            moved: list[Mover | None] = [*movers_of_lead(scenario, step)]
        else:
            moved = [mover(scenario, step.kind, text) for text in step.moved]
        for one in moved:
            if one is not None and one.stops_as_usual:
                soft.setdefault(one.name, place)
    if soft:
        stops = any(place in stopped for place in soft.values())
        yield Doubt(
            ("emergency_stop",) if stops else ("plan", min(soft.values()), "emergency_stop_at"),
            f"the emergency stop of {', '.join(soft)} is as soft as any stop, with the usual acceleration: "
            "brakes that are thrown in stop harder; 'emergency_acceleration' says how hard",
        )


def _under_way(scenario: Scenario) -> set[int]:
    """Places of the steps that may be under way as the emergency stop of the lift comes, if there is one.

    That is none which can only begin later, and of a stop in a step none before that but those beside it.
    """
    stop, plan = scenario.emergency_stop, scenario.plan
    if stop is None:
        return set()
    begins = earliest_begins(plan)
    first = next((place for place, step in enumerate(plan) if step.step == stop.in_step), None)
    if first is None:
        return {place for place, begin in enumerate(begins) if stop.at is None or begin <= stop.at}
    latest = begins[first] + (stop.after or 0.0)
    while first > 0 and _goes_beside(plan[first]):
        first -= 1
    after = range(first, len(plan))
    # How long after the other a step begins that has a time of its own is not known.
    return {at for at in after if begins[at] <= latest or getattr(plan[at], "start_at", None) is not None}


def _goes_beside(step: Step) -> bool:
    """Whether a step begins as the one before it does."""
    return getattr(step, "starts", None) == "with_previous"
