"""Conditions on which steps of the plan end, from words of the lift file to those of the core."""

from __future__ import annotations

from collections.abc import Collection

from gantline.assembly.cranes.reeving import below_pin, falls_on_upper_sheaves, reeved_hooks, upper_sheaves
from gantline.assembly.parts import Json, Parts
from gantline.assembly.plan.parting import pieces_of
from gantline.scenario import Rigging, Scenario
from gantline.scenario.afloat.mooring import line_rope
from gantline.scenario.cranes.hooks import Hook, full_name
from gantline.scenario.plan.condition import AngleReached, Condition, HoistLoadReached, TiltReached

__all__ = ["condition_of", "falls_of"]

#: Tension of falls that any hook block has, for a bound below the weight of the falls [N].
_LEAST = 1.0


def condition_of(
    scenario: Scenario,
    rigging: Rigging,
    parts: Parts,
    condition: Condition,
    weight: float,
    *,
    down: bool,
    on: Collection[str],
) -> Json:
    """What a step waits for, as the core reads it.

    Args:
        scenario: the lift.
        rigging: who carries whom.
        parts: the system, all but its plan.
        condition: as the lift file says it.
        weight: what the load weighs as it is simulated, with what is in its tanks then [N].
        down: whether the step lowers; shares of the weight then count what is left.
        on: names of the slings that are on in the step: those count where none are named.
    """
    if condition.hoist_load is not None:
        return _hoist_load(scenario, parts, condition.hoist_load)
    if condition.slings is not None:
        return _slings(scenario, rigging, parts, condition, on)
    if condition.load_tilt is not None:
        assert scenario.load is not None  # checked when the file was read
        return _attitude(scenario.load.name, "tilt", condition.load_tilt)
    if condition.tension_spread is not None:
        return _spread(rigging, parts, condition, on)
    for angle in ("heel", "trim"):
        reached = getattr(condition, angle)
        if reached is not None:
            return _attitude(reached.vessel, angle, reached)
    if condition.falls_out_of_plumb is not None:
        reeved = {name: hook for name, hook in scenario.hooks.items() if hook.reeving is not None}
        hooks = [full_name(text, reeved) or text for text in condition.of] or list(reeved)
        return {
            "type": "plumb",
            "falls": [falls_of(reeved[hook]) for hook in hooks],
            "at_most": condition.falls_out_of_plumb,
        }
    if condition.mooring_tension is not None:
        wanted = condition.mooring_tension
        segments = [[_upper(parts, line_rope(wanted.line)), 0]]
        gravity = scenario.simulation.gravity
        if wanted.above is not None:
            return {"type": "tension_above", "segments": segments, "bound": wanted.above.newtons(gravity)}
        assert wanted.below is not None  # one of both is given
        return {"type": "tension_below", "segments": segments, "bound": wanted.below.newtons(gravity)}
    assert scenario.load is not None  # checked when the file was read
    group = scenario.load.name
    if condition.load_transferred is not None:
        share = condition.load_transferred
        if down:
            return {"type": "load_returned", "group": group, "weight": weight, "at_most": share}
        return {"type": "load_transferred", "group": group, "weight": weight, "at_least": share}
    return {"type": "clear" if condition.supports == "clear" else "touched", "group": group}


def _hoist_load(scenario: Scenario, parts: Parts, reached: HoistLoadReached) -> Json:
    name = full_name(reached.hook, scenario.hooks) or ""
    hook = next(one for one in reeved_hooks(scenario) if one.name == name)  # checked with the file
    segments = [[rope, part] for rope in hook.ropes for part in range(hook.reeving.parts_each)]
    gravity = scenario.simulation.gravity
    # Of the hoist load the upper halves of the falls are no tension at the sheaves.
    above = falls_on_upper_sheaves(parts, scenario, hook) * gravity
    if reached.above is not None:
        bound = max(reached.above.newtons(gravity) - above, _LEAST)
        return {"type": "tension_above", "segments": segments, "bound": bound}
    assert reached.below is not None  # one of both is given
    bound = max(reached.below.newtons(gravity) - above, 0.0)
    return {"type": "tension_below", "segments": segments, "bound": bound}


def _spread(rigging: Rigging, parts: Parts, condition: Condition, on: Collection[str]) -> Json:
    names = condition.of or tuple(rigging.equalizers)
    hanging = [one for one in rigging.slings.values() if one.name in on]
    groups = [
        [_upper(parts, f"sling.{one.name}") for one in hanging if one.equalizer == name] for name in names
    ]
    groups = [group for group in groups if group]
    return {"type": "spread", "groups": groups, "at_most": condition.tension_spread}


def _attitude(body: str, angle: str, reached: TiltReached | AngleReached) -> Json:
    """An angle of a body above or below a bound [rad]."""
    is_above = reached.above is not None
    bound = reached.above if is_above else reached.below
    return {"type": "attitude", "body": body, "angle": angle, "above": is_above, "bound": bound}


def _upper(parts: Parts, rope: str) -> str:
    """The piece of a rope at its first end; the rope or line itself where it has no nodes."""
    pieces = pieces_of(parts, rope)
    return str(pieces[0]["name"]) if pieces else rope


def _slings(
    scenario: Scenario, rigging: Rigging, parts: Parts, condition: Condition, on: Collection[str]
) -> Json:
    """All of some slings are slack, or each of them carries.

    One that hangs by its own distributed weight is slack where no more than that pulls at its upper end.
    """
    names = [name.removeprefix("sling.") for name in condition.of] or [
        name for name in rigging.slings if name in on
    ]
    slings = [rigging.slings[name] for name in names]
    ropes = [_upper(parts, f"sling.{name}") for name in names]
    if condition.slings == "slack":
        hanging = sum(one.weight.mass_per_length * one.length for one in slings if one.weight.nodes)
        bound = float(hanging * scenario.simulation.gravity)
        return {"type": "tension_below", "segments": [[rope, 0] for rope in ropes], "bound": bound}
    # (max - min)/mean of n tensions is n at most, so that only their being taut is asked for.
    return {"type": "spread", "groups": [ropes], "at_most": float(len(ropes))}


def falls_of(hook: Hook) -> list[list[str | list[float]]]:
    """From the upper sheaves to those of the hook block, each as a body and a point of it [m]."""
    assert hook.hook_block is not None  # it hangs in ropes
    above: list[str | list[float]] = [upper_sheaves(hook.name), [0.0, 0.0, -below_pin(hook)]]
    return [above, [hook.name, [0.0, 0.0, hook.hook_block.height]]]
