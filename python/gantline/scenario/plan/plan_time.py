"""How long a plan takes at the least, by what it says itself."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.steps import HoldStep, MovingStep, PumpStep

__all__ = ["earliest_begins", "earliest_ends"]


def earliest_begins(plan: Sequence[MovingStep | LeadStep | PumpStep | HoldStep]) -> list[float]:
    """When each step of a plan can begin at the earliest [s]; see `earliest_ends`."""
    return [begin for begin, _ in _earliest(plan)]


def earliest_ends(plan: Sequence[MovingStep | LeadStep | PumpStep | HoldStep]) -> list[float]:
    """When each step of a plan can have ended at the earliest [s].

    Ways and amounts count at full speed, without ramps; conditions as if they were met at once, and ways `to`
    a place as if they were done.

    Args:
        plan: Its steps in order.
    """
    return [end for _, end in _earliest(plan)]


def _earliest(plan: Sequence[MovingStep | LeadStep | PumpStep | HoldStep]) -> Iterator[tuple[float, float]]:
    """When each step can begin, and have ended [s]."""
    began = over = 0.0  # the step before, and all before
    for step in plan:
        if isinstance(step, HoldStep):
            began = over
            over += step.hold if isinstance(step.hold, float) else 0.0
            yield began, over
            continue
        began = max(began if step.starts == "with_previous" else over, step.start_at or 0.0)
        stops = (getattr(step, key, None) or 0.0 for key in ("brake_from", "emergency_stop_at"))
        end = max(began + _least(step), *stops)
        over = max(over, end)
        yield began, end


def _least(step: MovingStep | LeadStep | PumpStep) -> float:
    """How long the way of a step takes at full speed [s]; 0 of a load that is turned."""
    if isinstance(step, LeadStep):
        return 0.0 if step.turn else math.hypot(*step.by) / step.speed
    return abs(step.by or 0.0) / (step.rate if isinstance(step, PumpStep) else step.speed)
