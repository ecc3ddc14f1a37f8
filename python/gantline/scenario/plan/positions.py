"""Where booms, upper structures and cranes are before each step of a plan, as far as the plan says it."""

from __future__ import annotations

from gantline.scenario.cranes.boom import FloatingCrane
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.cranes.slewing import upper_body
from gantline.scenario.model import Scenario
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import gone_along, led_hooks
from gantline.scenario.plan.movers import mover, movers
from gantline.scenario.plan.steps import AlongStep

__all__ = ["Places", "boom_angles", "boom_angles_at_end", "places_of_cranes"]

#: By the name of what moves the last place that the plan says, as `to` counts it [m, rad], and whether it is
#: there still: a step that ends on a condition or at a time leaves it somewhere else.
Places = dict[str, tuple[float, bool]]
#: What steps take along of cranes with a boom.
_OF_CRANES = ("boom", "upper", "crane")


def boom_angles(scenario: Scenario) -> list[Places]:
    """Where booms are before each step of the plan, as their drives count it, by name [rad]."""
    return _of_booms(scenario, places_of_cranes(scenario)[:-1])


def boom_angles_at_end(scenario: Scenario) -> list[Places]:
    """The same where each step of the plan and all that goes on beside it have ended."""
    before, found = _of_booms(scenario, places_of_cranes(scenario)), []
    for place in range(len(scenario.plan)):
        after = place + 1
        while after < len(scenario.plan) and getattr(scenario.plan[after], "starts", "") == "with_previous":
            after += 1
        found.append(before[after])
    return found


def places_of_cranes(scenario: Scenario) -> list[Places]:
    """Where booms, upper structures and cranes that travel are before each step, and at the end of the plan.

    A step that leads, and cannot, leaves them somewhere that nobody knows.
    """
    where: Places = {placed.name: (placed.boom.angle, True) for placed in scenario.booms.values()}
    for name, crane in (scenario.cranes or {}).items():
        if isinstance(crane, Crawler) or (
            isinstance(crane, FloatingCrane) and crane.slewing_axis is not None
        ):
            where[upper_body(name)] = crane.slew, True
    where |= {name: (one.start or 0.0, True) for name, one in movers(scenario, "crane").items() if one}
    before = []
    for step in scenario.plan:
        before.append(dict(where))
        if isinstance(step, LeadStep):
            where |= _led_to(scenario, step, where)
        if not isinstance(step, AlongStep) or step.kind not in _OF_CRANES:
            continue
        for text in step.moved:
            one = mover(scenario, step.kind, text)
            if one is None:
                continue
            at, known = where[one.name]
            if step.to is not None:
                where[one.name] = step.to, True
            else:
                where[one.name] = at + (step.by or 0.0), known and step.by is not None
    return [*before, where]


def _of_booms(scenario: Scenario, before: list[Places]) -> list[Places]:
    booms = {placed.name for placed in scenario.booms.values()}
    return [{name: place for name, place in places.items() if name in booms} for places in before]


def _led_to(scenario: Scenario, step: LeadStep, before: Places) -> Places:
    """Where a step that leads leaves cranes."""
    found: Places = {}
    ends = {gone.led.name: gone.poses[-1] for gone in gone_along(scenario, step, before)}
    for led in led_hooks(scenario, step):
        names = [led.boom.name, led.upper.name, *([] if led.track is None else [led.track.name])]
        end = ends.get(led.name)
        known = end is not None and all(before[name][1] for name in names)
        ats = [before[name][0] for name in names] if end is None else [end.angle, end.slew, end.travel]
        found |= {name: (at, known) for name, at in zip(names, ats, strict=False)}
    return found
