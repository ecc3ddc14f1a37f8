"""Ropes at a hook and pins of a hinge: the core keeps when they bear most together, between samples too."""

from __future__ import annotations

from collections.abc import Iterable

from gantline.assembly.cranes.reeving import reeved_hooks
from gantline.assembly.parts import Parts
from gantline.assembly.plain import ropes_ending_at, ropes_over
from gantline.scenario import Rigging, Scenario
from gantline.scenario.loads.hinge import PUSHES, TURNS, hinge_joints

__all__ = ["add_pulls"]


def add_pulls(parts: Parts, scenario: Scenario, rigging: Rigging) -> None:
    """A group of ropes for each hook, of what hangs in it and maybe none, then one for each that has falls.

    What hangs in a hook and its falls pull most at two moments: between them is the hook block. After them of
    each hinge the pins that hold its load, then those that keep it from turning askew.
    """
    pieces: dict[str, str] = {}
    for rope in parts.ropes:
        # Of a rope with nodes the first piece, its upper end.
        pieces.setdefault(rope["name"].removesuffix("/0"), rope["name"])
    groups: list[tuple[str, Iterable[str]]] = []
    for hook in scenario.hooks:
        slings = [f"sling.{one.name}" for one in rigging.slings.values() if one.hook == hook]
        ending = [rope for rope, _ in ropes_ending_at(scenario, hook)]
        groups.append((hook, [*slings, *ending, *(one["rope"] for one in ropes_over(scenario, hook))]))
    falls = {hook.name: hook.ropes for hook in reeved_hooks(scenario)}
    groups += [(f"{hook}/falls", falls[hook]) for hook in scenario.hooks if hook in falls]
    parts.pulls += [
        {"name": name, "ropes": [pieces[rope] for rope in dict.fromkeys(ropes) if rope in pieces]}
        for name, ropes in groups
    ]
    for hinge in scenario.hinges or {}:
        joints = hinge_joints(hinge)
        for part, ways in (("force", PUSHES), ("moment", TURNS)):
            parts.pulls.append({"name": f"{hinge}/{part}", "pins": [joints[way] for way in ways]})
