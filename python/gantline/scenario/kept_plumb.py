"""Hooks between which a load hangs, as a step that keeps falls plumb sees them."""

from __future__ import annotations

from gantline.scenario.hooks import Hook
from gantline.scenario.model import Scenario
from gantline.scenario.movers import Mover
from gantline.scenario.rigging import Rigging, SlingRigging

__all__ = ["hooks_beside", "is_moved_by", "slings_under"]


def slings_under(rigging: Rigging, hook: str) -> list[SlingRigging]:
    """The slings that hang from a hook, or from an equalizer under it."""
    return [sling for sling in rigging.slings.values() if sling.hook == hook]


def is_moved_by(one: Mover, hook: Hook) -> bool:
    """Whether a trolley or crane takes a hook along."""
    if one.kind == "trolley":
        return hook.carrier is not None and hook.carrier.name == one.name
    return hook.crane == one.name


def hooks_beside(scenario: Scenario, rigging: Rigging, one: Mover) -> list[str]:
    """Names of the hooks with slings that a trolley or crane does not take along."""
    others = (name for name, hook in scenario.hooks.items() if not is_moved_by(one, hook))
    return [name for name in others if slings_under(rigging, name)]
