"""Whether Goliath cranes can be built as written, and what their parts are called."""

from __future__ import annotations

from collections.abc import Mapping

from gantline.scenario.crane import FixedHook, Hoist
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.goliath import Goliath, HookType, Trolley, TrolleyHook
from gantline.scenario.hooks import NEEDED, parts_of, trolley_name
from gantline.scenario.reeving import HoistDrum

__all__ = ["check_goliaths", "crane_bodies", "crane_parts", "girder_body"]

_RIGHT = {
    "hook_block": "block: {mass: 12 t, height: 3 m}",
    "reeving": "reeving: {parts_each: 8, rope: hoist_42, sheave_diameter: 1 m, upper_sheaves_at: 88 m}",
    "drum": "drum: {diameter: 1.6 m}",
    "hoist": "hoist: {speed: 5 m/min, acceleration: 0.02 m/s^2}",
}


def girder_body(crane: str) -> str:
    """Name of the part of a girder that bends."""
    return f"{crane}.girder"


def crane_bodies(cranes: Mapping[str, FixedHook | Goliath]) -> list[str]:
    """Names of the bodies of cranes, without hooks."""
    return [str(name) for name, _, _ in crane_parts(cranes)] + [
        name for name, crane in cranes.items() if isinstance(crane, Goliath)
    ]


def crane_parts(cranes: Mapping[str, FixedHook | Goliath]) -> list[tuple[str, str, Path]]:
    """Names that the parts of Goliath cranes take, what they are, and where the file says them."""
    found: list[tuple[str, str, Path]] = []
    for name, crane in cranes.items():
        if not isinstance(crane, Goliath):
            continue
        path = ("cranes", name)
        found.append((girder_body(name), "the girder of a crane", (*path, "girder")))
        for trolley, given in crane.trolleys.items():
            at = (*path, "trolleys", trolley)
            found.append((trolley_name(name, trolley), "a trolley", at))
            found += [(f"{name}.{hook}", "a hook", (*at, "hooks", hook)) for hook in given.hooks]
    return found


def check_goliaths(findings: Findings) -> None:
    """Note everything that is wrong with Goliath cranes beyond the reeving of their hooks."""
    for name, crane in (findings.scenario.cranes or {}).items():
        if not isinstance(crane, Goliath):
            continue
        path = ("cranes", name)
        if crane.travel is not None:
            low, high = crane.travel.range_
            _check_within(findings, (*path, "position"), crane.position, (low, high), "range of travel")
        for trolley, given in crane.trolleys.items():
            at = (*path, "trolleys", trolley)
            _check_trolley(findings, at, crane, given)
            for hook, one in given.hooks.items():
                _check_hook(findings, (*at, "hooks", hook), one)
        _check_distance(findings, path, crane)


def _check_within(findings: Findings, path: Path, at: float, limits: tuple[float, float], what: str) -> None:
    low, high = limits
    if not low <= at <= high:
        findings.add(path, f"{at:g} m is outside of the {what}, {low:g} m to {high:g} m")


def _check_trolley(findings: Findings, path: Path, crane: Goliath, trolley: Trolley) -> None:
    reach = crane.span / 2 - (crane.hook_approach or 0.0)
    limits = trolley.traverse.range_
    _check_within(findings, (*path, "position"), trolley.position, limits, "range of traverse")
    ends = [end + hook.along for hook in trolley.hooks.values() for end in limits]
    if max(abs(end) for end in ends) > reach * (1 + 1e-9):
        sentence = f"hooks of this trolley would come to {max(ends, key=abs):g} m along the girder"
        right = f"with this span and approach {reach:g} m is the most"
        findings.add((*path, "traverse", "range"), f"{sentence}; {right}")


def _check_hook(findings: Findings, path: Path, hook: TrolleyHook) -> None:
    types = findings.scenario.hook_types or {}
    kind: HookType | None = None
    if hook.type is not None:
        kind = types.get(hook.type)
        if kind is None:
            sentence = f"'{hook.type}' is not a name of 'hook_types'; {nearest(hook.type, types)}"
            findings.add((*path, "type"), sentence)
            return
    parts = parts_of(hook, kind)
    for key in NEEDED:
        if parts[key] is None:
            word = "block" if key == "hook_block" else key
            sentence = f"'{word}' is missing; a hook of a trolley needs it, or a type that has it"
            findings.add(path, f"{sentence}, such as '{_RIGHT[key]}'")
    hoist, drum = parts["hoist"], parts["drum"]
    is_limited = isinstance(hoist, Hoist) and hoist.capacity is not None
    if is_limited and isinstance(drum, HoistDrum) and drum.inertia is None:
        sentence = "a hoist with a capacity needs the inertia of its drum"
        findings.add(path, f"{sentence}; give 'drum' a 'moment_of_inertia' or 'rotating_mass'")
    highest = parts["highest"]
    if isinstance(highest, float) and hook.height > highest:
        findings.add((*path, "height"), f"{hook.height:g} m is above the highest position, {highest:g} m")


def _check_distance(findings: Findings, path: Path, crane: Goliath) -> None:
    if crane.hook_distance is None:
        return
    places = [
        (trolley, hook, given.position + one.along)
        for trolley, given in crane.trolleys.items()
        for hook, one in given.hooks.items()
    ]
    for index, (trolley, hook, at) in enumerate(places):
        for other, second, there in places[:index]:
            if other != trolley and abs(at - there) < crane.hook_distance:
                sentence = f"'{hook}' starts {abs(at - there):g} m from '{second}' along the girder"
                findings.add((*path, "hook_distance"), f"{sentence}; {crane.hook_distance:g} m is the least")
