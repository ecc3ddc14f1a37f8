"""Steps that hoist a hook into the sheaves above it, or lower it below the ground, as the plan tells."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.assembly.parts import Parts
from gantline.scenario import Scenario
from gantline.scenario.consistency.travel import Bounds, bounds_after
from gantline.scenario.cranes.hooks import Hook
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.movers import mover
from gantline.scenario.plan.positions import boom_angles_at_end
from gantline.scenario.plan.steps import HookStep
from gantline.units import format_quantity

__all__ = ["doubtful_ways"]

#: Rounding of heights that steps add up, and how far below the ground a hook is told [m].
_ROUNDING, _BELOW = 1e-9, 0.1


def doubtful_ways(parts: Parts, scenario: Scenario) -> Iterator[Doubt]:
    """Each step by which a hook comes to its upper sheaves for sure, or below the ground.

    A step that ends on a condition leaves a hook somewhere on its way, so heights are followed as bounds, as
    the drum of the hook counts them: under a boom they go up and down with its head.

    Args:
        parts: The system with all its bodies.
        scenario: The lift.
    """
    where: dict[str, Bounds] = {}
    tops = {name: _top(parts, scenario, hook) for name, hook in scenario.hooks.items()}
    for place, (step, angles) in enumerate(zip(scenario.plan, boom_angles_at_end(scenario), strict=True)):
        if not isinstance(step, HookStep):
            continue
        for text in dict.fromkeys(step.moved):
            one = mover(scenario, step.kind, text)
            if one is None or one.start is None:
                continue
            angle, is_known = (0.0, True) if one.head is None else angles[one.head.boom]
            head_up = 0.0 if one.head is None else one.head.rise(angle)
            before = where.get(one.name, (one.start, one.start))
            where[one.name] = after = bounds_after(step, before, head_up)
            path = (
                "plan",
                place,
                "to" if step.to is not None else "by" if step.by is not None else step.verb,
            )
            top = tops[one.name]
            if top is not None and step.sign > 0 and before[0] <= top + _ROUNDING < after[0]:
                yield Doubt(path, _too_high(step, one.name, after[0] + head_up, top + head_up))
            ground = scenario.ground
            lowest = after[1] + head_up
            if ground is not None and is_known and step.sign < 0 and lowest < ground.level - _BELOW:
                below = format_quantity(ground.level - lowest, "m", 2)
                sentence = f"step '{step.step}' lowers {one.name} to {below} below the ground, or deeper"
                yield Doubt(path, f"{sentence}: nothing stops it there; lower it less far")


def _too_high(step: HookStep, hook: str, height: float, top: float) -> str:
    comes, meets = (format_quantity(one, "m", 2) for one in (height, top))
    there = f"where it is at {meets} its hook block meets the sheaves above (two-blocking)"
    return f"step '{step.step}' hoists {hook} to {comes} at least, and {there}; hoist it less far"


def _top(parts: Parts, scenario: Scenario, hook: Hook) -> float | None:
    """Height of a hook at which its sheaves touch those above as at the start [m]; None without reeving."""
    reeving, hook_block = hook.reeving, hook.hook_block
    if reeving is None or hook_block is None:
        return None
    rope = (scenario.ropes or {})[reeving.rope]  # checked with the file
    if reeving.upper_sheaves_at is not None:
        upper = reeving.upper_sheaves_at
    else:
        assert hook.carrier is not None and reeving.below_head is not None  # checked with the file
        upper = float(parts.place(hook.carrier.name, hook.pin)[2]) - reeving.below_head
    return upper - reeving.diameter(rope.diameter) - hook_block.height
