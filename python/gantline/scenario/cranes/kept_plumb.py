"""Hooks between which a load hangs, as a step that keeps falls plumb sees them."""

from __future__ import annotations

from gantline.scenario.cranes.hooks import Hook
from gantline.scenario.cranes.slewing import upper_body
from gantline.scenario.model import Scenario
from gantline.scenario.plan.movers import Mover
from gantline.scenario.rigging import Rigging, SlingRigging

__all__ = ["hooks_beside", "is_moved_by", "slings_under"]


def slings_under(rigging: Rigging, hook: str) -> list[SlingRigging]:
    """The slings that hang from a hook, or from an equalizer under it."""
    return [sling for sling in rigging.slings.values() if sling.hook == hook]


def is_moved_by(one: Mover, hook: Hook) -> bool:
    """Whether a trolley, crane, boom or upper structure takes a hook along."""
    if one.kind in ("trolley", "boom"):
        return hook.carrier is not None and hook.carrier.name == one.name
    return one.name == (upper_body(hook.crane) if one.kind == "upper" else hook.crane)


def hooks_beside(scenario: Scenario, rigging: Rigging, one: Mover) -> list[str]:
    """Names of the hooks with slings that such a drive does not take along."""
    others = (name for name, hook in scenario.hooks.items() if not is_moved_by(one, hook))
    return [name for name in others if slings_under(rigging, name)]
