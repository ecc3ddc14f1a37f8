"""Steps that take a hook to a height under a boom of which nobody knows the angle before the run."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.movers import mover
from gantline.scenario.plan.positions import boom_angles_at_end
from gantline.scenario.plan.steps import HookStep
from gantline.units import format_quantity

__all__ = ["doubtful_heights"]


def doubtful_heights(scenario: Scenario) -> Iterator[Doubt]:
    """Each step that ends at a height which counts from a boom head that may be elsewhere."""
    known = zip(scenario.plan, boom_angles_at_end(scenario), strict=True)
    for place, (step, angles) in enumerate(known):
        if not isinstance(step, HookStep) or step.to is None:
            continue
        for text in step.moved:
            one = mover(scenario, step.kind, text)
            if one is None or one.head is None:
                continue
            angle, is_known = angles[one.head.boom]
            if not is_known:
                height = format_quantity(step.to, "m", 2)
                at = format_quantity(angle, "deg", 1)
                took = f"takes {one.name} to {height} as if {one.head.boom} stood at {at}"
                luffed = "it has luffed to where only the run knows, and its head is higher or lower by that"
                sentence = f"step '{step.step}' {took}; {luffed}: 'by' or 'until' says what is meant"
                yield Doubt(("plan", place, "to"), sentence)
