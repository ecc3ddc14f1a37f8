"""Highest positions of hooks that their boom heads and upper sheaves do not let them come to."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.assembly.doubts.ways import top_of
from gantline.assembly.parts import Parts
from gantline.scenario import Scenario
from gantline.scenario.cranes.hooks import Hook
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.scenario.plan.movers import mover
from gantline.units import format_quantity

__all__ = ["doubtful_highest"]

#: Draft, trim and tide raise a boom head by some metres; a hook that may go higher than that above it is a
#: slip [m].
_ABOVE = 2.0


def doubtful_highest(parts: Parts, scenario: Scenario) -> Iterator[Doubt]:
    """Each hook whose highest position is above what it hangs from, however steep its boom stands.

    Args:
        parts: The system, with all its bodies.
        scenario: The lift.
    """
    told: set[Path] = set()
    for hook in scenario.hooks.values():
        top, path = top_of(parts, scenario, hook), hook.paths["highest"]
        if hook.highest is None or top is None or path in told:
            continue
        rise = _rise(scenario, hook)
        if hook.highest > top + rise + _ABOVE:
            highest, there = (format_quantity(one, "m", 1) for one in (hook.highest, top + rise))
            steep = " with its boom at its steepest" if rise > 0.0 else ""
            meets = f"its hook block meets the sheaves above at {there}{steep} (two-blocking)"
            sentence = f"the highest position of {hook.name} is {highest}, and {meets}"
            told.add(path)
            yield Doubt(path, f"{sentence}; a digit has slipped, or it is of another crane")


def _rise(scenario: Scenario, hook: Hook) -> float:
    """How much higher than at the start the sheaves above a hook can come as its boom luffs [m]."""
    one = mover(scenario, "hook", hook.name)
    luffing = scenario.booms[hook.crane].luffing if one is not None and one.head is not None else None
    if one is None or one.head is None or luffing is None:
        return 0.0
    return max(0.0, *(one.head.rise(angle) for angle in luffing.range_))
