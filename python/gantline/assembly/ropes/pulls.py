"""Ropes that pull at a hook together: the core keeps when they pull most, between samples too."""

from __future__ import annotations

from gantline.assembly.cranes.reeving import reeved_hooks
from gantline.assembly.parts import Parts
from gantline.assembly.plain import ropes_ending_at, ropes_over
from gantline.scenario import Rigging, Scenario

__all__ = ["add_pulls"]


def add_pulls(parts: Parts, scenario: Scenario, rigging: Rigging) -> None:
    """A group of ropes for each hook, in their order: what hangs in it, else its falls; it may be empty."""
    pieces: dict[str, str] = {}
    for rope in parts.ropes:
        # Of a rope with nodes the first piece, its upper end.
        pieces.setdefault(rope["name"].removesuffix("/0"), rope["name"])
    falls = {hook.name: hook.ropes for hook in reeved_hooks(scenario)}
    for hook in scenario.hooks:
        slings = [f"sling.{one.name}" for one in rigging.slings.values() if one.hook == hook]
        ending = [rope for rope, _ in ropes_ending_at(scenario, hook)]
        over = [one["rope"] for one in ropes_over(scenario, hook)]
        ropes = dict.fromkeys([*slings, *ending, *over]) or dict.fromkeys(falls.get(hook, ()))
        parts.pulls.append({"name": hook, "ropes": [pieces[rope] for rope in ropes if rope in pieces]})
