"""Hooks of all cranes, of whatever type, by their full names."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gantline.scenario.crane import FixedHook, Hoist
from gantline.scenario.errors import PathPart
from gantline.scenario.goliath import Goliath, HookType, TrolleyHook
from gantline.scenario.reeving import HoistDrum, HookBlock, Reeving

__all__ = ["PARTS", "Hook", "full_name", "hooks_of", "trolley_name"]

#: What a hook of a trolley has from itself or from its type.
PARTS = ("rated_capacity", "highest", "hook_block", "reeving", "drum", "hoist")
#: Of these, what it cannot do without.
NEEDED = ("hook_block", "reeving", "drum", "hoist")


@dataclass(frozen=True)
class Hook:
    """A hook with all its parts.

    Attributes:
        name: full name: of its crane, or `<crane>.<hook>`.
        crane: name of its crane.
        trolley: full name of its trolley, `<crane>.<trolley>`; None of a hook without one.
        paths: where the lift file says `reeving` and `drum`, and under `""` the hook itself.
        at: bearing point at the start, world axes [m].
        highest: highest position of the bearing [m]; None if not said.
        hook_block_mass: mass of hook block and falls that are no part of the mechanics [kg].
    """

    name: str
    crane: str
    trolley: str | None
    paths: Mapping[str, tuple[PathPart, ...]]
    at: tuple[float, float, float]
    rated_capacity: float | None
    rating_includes_hook_block: bool
    highest: float | None
    hook_block_mass: float
    hook_block: HookBlock | None
    reeving: Reeving | None
    drum: HoistDrum | None
    hoist: Hoist


def trolley_name(crane: str, trolley: str) -> str:
    """Full name of a trolley."""
    return f"{crane}.{trolley}"


def full_name(text: str, known: Mapping[str, object]) -> str | None:
    """The name among those `known` that a text means: itself, or the only one that ends in `.<text>`."""
    if text in known:
        return text
    fitting = [name for name in known if name.endswith(f".{text}")]
    return fitting[0] if len(fitting) == 1 else None


def hooks_of(cranes: Mapping[str, FixedHook | Goliath], types: Mapping[str, HookType]) -> dict[str, Hook]:
    """All hooks, in the order of the lift file; hooks of which something is missing are left out."""
    found: dict[str, Hook] = {}
    for name, crane in cranes.items():
        if isinstance(crane, FixedHook):
            found[name] = _fixed(name, crane)
            continue
        for trolley, carrier in crane.trolleys.items():
            for hook, given in carrier.hooks.items():
                x, y = carrier.position + given.along, crane.position + given.across
                own = ("cranes", name, "trolleys", trolley, "hooks", hook)
                of = _Place(f"{name}.{hook}", name, trolley_name(name, trolley), own, (x, y, given.height))
                one = _of_trolley(of, given, types.get(given.type or ""), crane)
                if one is not None:
                    found[one.name] = one
    return found


def _fixed(name: str, crane: FixedHook) -> Hook:
    path = ("cranes", name)
    return Hook(
        name=name,
        crane=name,
        trolley=None,
        paths={"": path, "reeving": (*path, "reeving"), "drum": (*path, "drum")},
        at=crane.at,
        rated_capacity=crane.rated_capacity,
        rating_includes_hook_block=crane.rating_includes_hook_block,
        highest=None,
        hook_block_mass=crane.hook_block_mass,
        hook_block=crane.hook_block,
        reeving=crane.reeving,
        drum=crane.drum,
        hoist=crane.hoist,
    )


@dataclass(frozen=True)
class _Place:
    name: str
    crane: str
    trolley: str
    path: tuple[PathPart, ...]
    at: tuple[float, float, float]


def parts_of(given: TrolleyHook, kind: HookType | None) -> dict[str, object]:
    """The parts of a hook, its own before those of its type; None where neither has one."""
    own = {key: getattr(given, key) for key in PARTS}
    return {key: getattr(kind, key, None) if part is None else part for key, part in own.items()}


def _of_trolley(of: _Place, given: TrolleyHook, kind: HookType | None, crane: Goliath) -> Hook | None:
    parts = parts_of(given, kind)
    if any(parts[key] is None for key in NEEDED):
        return None
    paths = {"": of.path}
    for key in ("reeving", "drum"):
        own = getattr(given, key) is not None
        paths[key] = (*of.path, key) if own else ("hook_types", str(given.type), key)
    return Hook(
        name=of.name,
        crane=of.crane,
        trolley=of.trolley,
        paths=paths,
        at=of.at,
        rating_includes_hook_block=crane.rating_includes_hook_block,
        hook_block_mass=0.0,
        **parts,  # type: ignore[arg-type]
    )
