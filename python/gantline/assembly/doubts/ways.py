"""Steps that bring a hook into the sheaves above it, or below the ground, or its drum out of rope or room."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gantline.assembly.doubts.wound import doubtful_turns
from gantline.assembly.parts import Parts
from gantline.scenario import Scenario
from gantline.scenario.consistency.travel import Bounds, moved_by
from gantline.scenario.cranes.hooks import Hook
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import gone_along
from gantline.scenario.plan.positions import Places, boom_angles_at_end, places_of_cranes
from gantline.scenario.plan.steps import HookStep
from gantline.units import format_quantity

__all__ = ["doubtful_ways", "top_of"]

#: Rounding of heights that steps add up, and how far below the ground a hook is told [m].
_ROUNDING, _BELOW = 1e-9, 0.1


def doubtful_ways(parts: Parts, scenario: Scenario) -> Iterator[Doubt]:
    """Each step by which a hook comes to its upper sheaves for sure, below the ground, or its drum overflows.

    A step that ends on a condition leaves a hook somewhere on its way, so heights are followed as bounds, as
    the drum of the hook counts them: under a boom they go up and down with its head.

    Args:
        parts: The system with all its bodies.
        scenario: The lift.
    """
    where: dict[str, Bounds] = {}
    tops = {name: top_of(parts, scenario, hook) for name, hook in scenario.hooks.items()}
    before_step = places_of_cranes(scenario)
    for place, (step, angles) in enumerate(zip(scenario.plan, boom_angles_at_end(scenario), strict=True)):
        if isinstance(step, LeadStep):
            path: Path = ("plan", place, "by" if any(step.by) else "turn")
            told = _led(scenario, step, before_step[place], where, tops)
            yield from (Doubt(path, sentence) for sentence in told)
        if not isinstance(step, HookStep):
            continue
        for one in moved_by(scenario, place, step, angles, where):
            name, after, up = one.mover.name, one.after, one.head_up
            turns = doubtful_turns(step, scenario.hooks[name], one.mover, one.before, after)
            yield from (Doubt(one.path, sentence) for sentence in turns)
            top = tops[name]
            if top is not None and step.sign > 0 and one.before[0] <= top + _ROUNDING < after[0]:
                high = _too_high(f"step '{step.step}' hoists {name}", after[0] + up, top + up)
                yield Doubt(one.path, f"{high}; hoist it less far")
            below = _below(scenario, after[1] + up)
            if one.is_known and step.sign < 0 and below is not None:
                sentence = f"step '{step.step}' lowers {name} to {below} below the ground, or deeper"
                yield Doubt(one.path, f"{sentence}: nothing stops it there; lower it less far")


def _led(
    scenario: Scenario,
    step: LeadStep,
    before: Places,
    where: dict[str, Bounds],
    tops: Mapping[str, float | None],
) -> Iterator[str]:
    """The same of a step that leads, which takes boom heads along; notes where it leaves hooks.

    Amid a way a boom may have to flatten, with its head nearer to the hook than at both ends.
    """
    for gone in gone_along(scenario, step, before):
        hoist, head = gone.led.hoist, gone.led.hoist.head
        if hoist.start is None:
            continue
        low, high = where.get(hoist.name, (hoist.start, hoist.start))
        up, top = max(gone.hoisted), tops[hoist.name]
        where[hoist.name] = low + gone.hoisted[-1], high + gone.hoisted[-1]
        rises = [0.0 if head is None else head.rise(pose.angle) for pose in gone.poses]
        if top is not None and low <= top + _ROUNDING < low + up:
            there = rises[gone.hoisted.index(up)]
            leads = f"step '{step.step}' leads {hoist.name}"
            yield f"{_too_high(leads, low + up + there, top + there)}; lead it elsewhere, or lower"
        below = _below(scenario, high + gone.hoisted[-1] + rises[-1])
        if before[gone.led.boom.name][1] and step.by[2] < 0.0 and below is not None:
            leads = f"step '{step.step}' leads {hoist.name} to {below} below the ground, or deeper"
            yield f"{leads}: nothing stops it there; lead it less far down"


def _below(scenario: Scenario, height: float) -> str | None:
    """How far below the ground a hook is; None where it is not, or hardly."""
    ground = scenario.ground
    if ground is None or height >= ground.level - _BELOW:
        return None
    return format_quantity(ground.level - height, "m", 2)


def _too_high(does: str, height: float, top: float) -> str:
    comes, meets = (format_quantity(one, "m", 2) for one in (height, top))
    there = f"where it is at {meets} its hook block meets the sheaves above (two-blocking)"
    return f"{does} to {comes} at least, and {there}"


def top_of(parts: Parts, scenario: Scenario, hook: Hook) -> float | None:
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
