"""Hoists that compensate heave, and the steps of the plan in which they do."""

from __future__ import annotations

from gantline.assembly.parts import Json, Parts
from gantline.assembly.plan.conditions import falls_of
from gantline.assembly.plan.operations import reel_of
from gantline.assembly.yard import hoist_drive
from gantline.scenario import Scenario
from gantline.scenario.cranes.boom import FloatingCrane
from gantline.scenario.cranes.hooks import full_names
from gantline.scenario.plan.movers import mover

__all__ = ["add_compensation", "compensators"]


def compensators(scenario: Scenario) -> list[Json]:
    """What the hoists of hooks can do that steps of the plan keep still, in the order of the lift file."""
    used = {name for step in scenario.plan for name in full_names(step.compensate_heave, scenario.hooks)}
    found = []
    for name, hook in scenario.hooks.items():
        given = hook.hoist.heave_compensation
        one = mover(scenario, "hook", name)
        if name not in used or given is None or one is None:
            continue
        found.append(
            {
                "name": name,
                "drive": hoist_drive(name),
                "vessel": _vessel(scenario, hook.crane),
                "head": falls_of(hook)[0],
                "velocity": given.speed,
                "acceleration": given.acceleration,
                "stroke": given.stroke,
                "filter": given.filter,
                **reel_of(one),
            }
        )
    return found


def add_compensation(parts: Parts, scenario: Scenario) -> None:
    """Add to the steps of the document which hooks they keep still."""
    for place, (made, step) in enumerate(zip(parts.plan, scenario.plan, strict=True)):
        hooks = full_names(step.compensate_heave, scenario.hooks)
        if hooks and not scenario.waves:
            sentence = f"step '{step.step}' compensates heave, and there are no waves that heave anything"
            parts.doubt(("plan", place, "compensate_heave"), sentence)
        if hooks:
            made["compensates"] = [{"compensator": name, "against": step.relative_to} for name in hooks]


def _vessel(scenario: Scenario, crane: str) -> str:
    """Name of the vessel that bears a crane, which has one as the check of the plan has seen to."""
    given = (scenario.cranes or {})[crane]
    assert isinstance(given, FloatingCrane) and given.vessel is not None
    return given.vessel
