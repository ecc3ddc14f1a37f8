"""What a trolley or crane follows that keeps falls plumb, as the core reads it."""

from __future__ import annotations

from gantline.assembly.conditions import falls_of
from gantline.assembly.parting import pieces_of
from gantline.assembly.parts import Json, Parts
from gantline.scenario import Rigging, Scenario
from gantline.scenario.hooks import full_name
from gantline.scenario.kept_plumb import hooks_beside, slings_under
from gantline.scenario.movers import mover
from gantline.scenario.rigging import SlingRigging
from gantline.scenario.steps import FollowingStep

__all__ = ["followed"]


def followed(
    scenario: Scenario, rigging: Rigging, parts: Parts, step: FollowingStep, hooks: tuple[str, ...]
) -> Json:
    """The end of a step that follows.

    Args:
        scenario: the lift.
        rigging: who carries whom.
        parts: the system, all but its plan.
        step: the step.
        hooks: whose falls it keeps plumb, checked with the file.
    """
    one = mover(scenario, step.kind, step.moved[0])
    assert one is not None  # checked with the file
    own = [full_name(text, scenario.hooks) or text for text in hooks]
    return {
        "type": "follow",
        "own": [_lead(scenario, rigging, parts, name) for name in own],
        "others": [_lead(scenario, rigging, parts, name) for name in hooks_beside(scenario, rigging, one)],
    }


def _lead(scenario: Scenario, rigging: Rigging, parts: Parts, name: str) -> Json:
    """A hook with its falls, where it has any, and all slings down to the load."""
    hook = scenario.hooks[name]
    itself = [name, [0.0, 0.0, 0.0]]
    tip, at = (itself, itself) if hook.reeving is None else falls_of(hook)
    levels = []
    level = slings_under(rigging, name)
    while level:
        levels.append([_strand(parts, sling) for sling in level])
        ends = [end for sling in level for end in sling.ends]
        held = {end.spreader for end in ends} | {end.extension for end in ends}
        below = rigging.slings.values()
        level = [one for one in below if {one.spreader, one.over} & (held - {None})]
    return {"tip": tip, "hook": at, "levels": levels}


def _strand(parts: Parts, sling: SlingRigging) -> Json:
    """A sling as it pulls what hangs below it; one that runs over a sheave does so with both ends."""
    pieces = pieces_of(parts, f"sling.{sling.name}")
    first, last = pieces[0]["route"], pieces[-1]["route"]
    upper = [first[0]["body"], first[0]["at"]] if sling.over is None else [sling.over, [0.0, 0.0, 0.0]]
    lower = last[-1:] if sling.over is None else [first[0], last[-1]]
    return {
        "rope": pieces[0]["name"],
        "upper": upper,
        "lower": [[end["body"], end["at"]] for end in lower],
    }
