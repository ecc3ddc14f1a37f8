"""Steps that wind more rope onto the drum of a hook than it takes, or more off it than may go."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gantline.scenario.consistency.travel import Bounds
from gantline.scenario.cranes.hooks import Hook
from gantline.scenario.plan.movers import Mover
from gantline.scenario.plan.steps import HookStep

__all__ = ["doubtful_turns"]

#: Rounding of turns that steps add up [1].
_ROUNDING = 1e-9


def doubtful_turns(step: HookStep, hook: Hook, one: Mover, before: Bounds, after: Bounds) -> Iterator[str]:
    """What a step does for sure to the drum of a hook that has not been so before it.

    Args:
        step: The step.
        hook: The hook.
        one: The same, as the plan moves it.
        before: Height of the hook before the step, as its drum counts it [m].
        after: The same after it [m].
    """
    drum = hook.drum
    if drum is None or hook.reeving is None or drum.wraps_at_start is None or one.start is None:
        return
    turn, start, at_start = math.pi * drum.diameter, one.start, drum.wraps_at_start
    parts = hook.reeving.parts_each

    def turns(height: float) -> float:
        gone = height - start
        return at_start + parts * (gone if one.reel is None else one.reel.counted(gone)) / turn

    if step.sign > 0 and drum.wraps_per_layer is not None:
        room = drum.layers * drum.wraps_per_layer
        if turns(before[0]) <= room + _ROUNDING < turns(after[0]):
            winds = (
                f"step '{step.step}' hoists {one.name}: its drum has {turns(after[0]):.1f} turns or more then"
            )
            yield f"{winds}, and room for {room:g}; fewer turns at the start, or a larger drum"
    elif step.sign < 0 and turns(before[1]) >= drum.spare_turns - _ROUNDING > turns(after[1]):
        left = turns(after[1])
        has = (
            f"its drum has {left:.1f} turns or fewer then" if left >= 0.0 else "all rope is off its drum then"
        )
        sentence = f"step '{step.step}' lowers {one.name}: {has}, and {drum.spare_turns:g} have to stay"
        yield f"{sentence}; more turns at the start, or lower it less far"
