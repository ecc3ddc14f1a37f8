"""Whether hooks that a trolley or a boom takes along are whole."""

from __future__ import annotations

from typing import Literal

from gantline.scenario.consistency.reeving import check_upper_sheaves
from gantline.scenario.cranes.crane import Hoist
from gantline.scenario.cranes.hook_parts import CarriedHook, HookType
from gantline.scenario.cranes.hooks import NEEDED, parts_of
from gantline.scenario.cranes.reeving import HoistDrum, Reeving
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path

__all__ = ["check_carried_hook"]

_RIGHT = {
    "hook_block": "block: {mass: 12 t, height: 3 m}",
    "drum": "drum: {diameter: 1.6 m}",
    "hoist": "hoist: {speed: 5 m/min, acceleration: 0.02 m/s^2}",
}


def check_carried_hook(
    findings: Findings, path: Path, hook: CarriedHook, kind_of_carrier: Literal["trolley", "boom"]
) -> None:
    """Note everything that is wrong with a hook of a trolley or boom beyond its reeving.

    Args:
        findings: what was found so far.
        path: where the lift file has the hook.
        hook: the hook.
        kind_of_carrier: what takes it along.
    """
    where = {"trolley": "upper_sheaves_at: 88 m", "boom": "below_head: 1.3 m"}[kind_of_carrier]
    types = findings.scenario.hook_types or {}
    kind: HookType | None = None
    if hook.type is not None:
        kind = types.get(hook.type)
        if kind is None:
            sentence = f"'{hook.type}' is not a name of 'hook_types'; {nearest(hook.type, types)}"
            findings.add((*path, "type"), sentence)
            return
    parts = parts_of(hook, kind)
    right = _RIGHT | {"reeving": f"reeving: {{parts_each: 8, rope: hoist_42, sheave_diameter: 1 m, {where}}}"}
    for key in NEEDED:
        if parts[key] is None:
            word = "block" if key == "hook_block" else key
            sentence = f"'{word}' is missing; a hook of a {kind_of_carrier} needs it, or a type that has it"
            findings.add(path, f"{sentence}, such as '{right[key]}'")
    hoist, drum, reeving = parts["hoist"], parts["drum"], parts["reeving"]
    if isinstance(reeving, Reeving) and any(parts[key] is None for key in NEEDED):
        # The reeving is looked at no further until the hook is whole; what it lacks itself need not wait.
        said_by: Path = path if hook.reeving is not None else ("hook_types", str(hook.type))
        at_boom = kind_of_carrier == "boom"
        check_upper_sheaves(findings, (*said_by, "reeving"), reeving, at_boom=at_boom)
    is_limited = isinstance(hoist, Hoist) and hoist.capacity is not None
    if is_limited and isinstance(drum, HoistDrum) and drum.inertia is None:
        sentence = "a hoist with a capacity needs the inertia of its drum"
        findings.add(path, f"{sentence}; give 'drum' a 'moment_of_inertia' or 'rotating_mass'")
    highest = parts["highest"]
    if isinstance(highest, float) and hook.height > highest:
        findings.add((*path, "height"), f"{hook.height:g} m is above the highest position, {highest:g} m")
