"""Hooks and equalizers in which nothing hangs, and equalizers whose pins the plan forgets."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.assembly.plain import bodies_in_hook, ropes_ending_at, ropes_over
from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.hooks import full_names
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.pins import Pins
from gantline.scenario.plan.steps import HookStep

__all__ = ["doubtful_empty", "doubtful_pins"]


def doubtful_empty(scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """Each equalizer without a sling, and each hook that a step moves with nothing in it."""
    if not rigging.slings:
        return
    held = {sling.equalizer for sling in rigging.slings.values()}
    for name, equalizer in rigging.equalizers.items():
        sheaves = [f"{name}.{place + 1}" for place in range(len(equalizer.moving_sheaves.along))]
        if name not in held and not any(_bears_mechanics(scenario, body) for body in (name, *sheaves)):
            yield Doubt(("equalizers", name), f"no sling hangs from equalizer {name}")
    bearing = {sling.hook for sling in rigging.slings.values()}
    bearing |= {equalizer.hook for equalizer in rigging.equalizers.values()}
    for hook, (place, moves) in _moved_first(scenario).items():
        if hook not in bearing and not _bears_mechanics(scenario, hook):
            sentence = f"nothing hangs in hook {hook}, which step '{scenario.plan[place].step}' {moves}"
            yield Doubt(("plan", place), sentence)


def doubtful_pins(scenario: Scenario, rigging: Rigging, pins: Pins) -> Iterator[Doubt]:
    """Each equalizer that a step lifts and whose pins, all of them in at the start, no step ever pulls.

    One of which only some sheaves are locked is meant so.
    """
    moved = set(_moved_first(scenario))
    pulled = {sheave for sheaves in pins.pulled for sheave in sheaves}
    held = {sling.equalizer for sling in rigging.slings.values()}
    for name, equalizer in rigging.equalizers.items():
        sheaves = {f"{name}.{place + 1}" for place in range(len(equalizer.moving_sheaves.along))}
        are_in = all(pins.at_start.get(sheave, False) for sheave in sheaves)
        if name in held and equalizer.hook in moved and are_in and not sheaves & pulled:
            sentence = f"the pins of {name} hold all its sheaves, and no step of the plan pulls them"
            wanted = f"it shares as a rigid beam does; 'pull_pins: {name}' in a step lets it equalise"
            yield Doubt(("equalizers", name), f"{sentence}: {wanted}")


def _bears_mechanics(scenario: Scenario, body: str) -> bool:
    """Whether something of `mechanics` hangs on a body."""
    of_mechanics = (bodies_in_hook, ropes_ending_at, ropes_over)
    return any(find(scenario, body) for find in of_mechanics)


def _moved_first(scenario: Scenario) -> dict[str, tuple[int, str]]:
    """The first step that moves each hook, by its place, and the word for what it does."""
    found: dict[str, tuple[int, str]] = {}
    for place, step in enumerate(scenario.plan):
        if not isinstance(step, HookStep | LeadStep):
            continue
        for hook in full_names(step.lead if isinstance(step, LeadStep) else step.moved, scenario.hooks):
            found.setdefault(hook, (place, f"{step.verb}s"))
    return found
