"""Which cranes lift the load: by slings, or by ropes and bodies of `mechanics`."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.crane_parts import crane_parts

__all__ = ["lifting_by_mechanics", "lifting_cranes"]

_WORLD = "world"


def lifting_cranes(scenario: Scenario, rigging: Rigging) -> set[str]:
    """Cranes in whose hooks slings hang, and those of `lifting_by_mechanics`."""
    hooks = {sling.hook for sling in rigging.slings.values()} & set(scenario.hooks)
    return {_crane_of(scenario, hook) for hook in hooks} | set(lifting_by_mechanics(scenario, rigging))


def lifting_by_mechanics(scenario: Scenario, rigging: Rigging) -> list[str]:
    """Cranes to which ropes and bodies of `mechanics` lead from the load, over whatever hangs between.

    What hangs in a hook beside the load is none of it. Nothing leads through a vessel or what stands fixed: a
    rope made fast there and one of a crane are two things.
    """
    if scenario.load is None or scenario.mechanics is None:
        return []
    cranes = _crane_bodies(scenario)
    stand = {*(scenario.vessels or {}), _WORLD} | {
        name
        for name, body in scenario.mechanics.bodies.items()
        if body.parent is None and body.joint.type == "fixed"
    }
    beside: dict[str, set[str]] = {}
    for one, other in _links(scenario, rigging):
        beside.setdefault(one, set()).add(other)
        beside.setdefault(other, set()).add(one)
    reached, ahead, found = {scenario.load.name}, [scenario.load.name], set()
    while ahead:
        for body in beside.get(ahead.pop(), set()) - reached:
            reached.add(body)
            if body in cranes:
                found.add(cranes[body])
            elif body not in stand:
                ahead.append(body)
    return sorted(found)


def _crane_of(scenario: Scenario, hook: str) -> str:
    """The crane of a hook; of one that moves as told, which may be of one crane with others, its group."""
    crane = scenario.hooks[hook].crane
    groups = sorted((scenario.hook_groups or {}).items(), key=lambda one: one[1].type == "trolley")
    of_groups = (name for name, group in groups if hook in group.hooks)
    return next(of_groups, crane) if crane == hook else crane


def _crane_bodies(scenario: Scenario) -> dict[str, str]:
    """The crane of each of its bodies."""
    parts = {name: str(path[1]) for name, _, path in crane_parts(scenario.cranes or {})}
    own = {name: name for name in scenario.cranes or {}}
    return {**parts, **own, **{hook: _crane_of(scenario, hook) for hook in scenario.hooks}}


def _links(scenario: Scenario, rigging: Rigging) -> Iterator[tuple[str, str]]:
    """Pairs of bodies of which one bears the other, but for slings in hooks."""
    assert scenario.load is not None
    assert scenario.mechanics is not None
    for rope in (scenario.mechanics.ropes or {}).values():
        bodies = [guide.body for guide in rope.route]
        yield from pairwise(bodies)
    for name, body in scenario.mechanics.bodies.items():
        if body.parent is not None:
            yield name, body.parent
    for sling in rigging.slings.values():
        lower = [end.held or scenario.load.name for end in sling.ends]
        upper = [] if sling.upper_body == sling.hook else [sling.upper_body]
        yield from pairwise([*upper, *lower])
        if sling.equalizer is not None:
            yield sling.equalizer, sling.upper_body
        if sling.compensator is not None:
            yield sling.compensator, sling.upper_body
