"""Hooks of all cranes, of whatever type, by their full names."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

from gantline.scenario.afloat.vessel import Vessel
from gantline.scenario.cranes.boom import FloatingCrane, PlacedBoom, boom_name
from gantline.scenario.cranes.crane import FixedHook, Hoist
from gantline.scenario.cranes.crane_types import AnyCrane, any_boom
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.cranes.goliath import Goliath
from gantline.scenario.cranes.hook_parts import CarriedHook, HookType
from gantline.scenario.cranes.reeving import HoistDrum, HookBlock, Reeving
from gantline.scenario.errors import PathPart

__all__ = ["PARTS", "Carrier", "Hook", "booms_of", "full_name", "full_names", "hooks_of", "trolley_name"]

#: What a hook of a trolley or boom has from itself or from its type.
PARTS = ("rated_capacity", "highest", "hook_block", "reeving", "drum", "hoist")
#: Of these, what it cannot do without.
NEEDED = ("hook_block", "reeving", "drum", "hoist")
#: Of these, what others say something about at its own place in the lift file.
_SAID = ("reeving", "drum", "rated_capacity", "highest", "hook_block", "hoist")
#: Of these, what lift files call otherwise.
_WORDS = {"hook_block": "block"}


@dataclass(frozen=True)
class Carrier:
    """What bears the upper sheaves of a hook and takes them along.

    Attributes:
        name: full name of a trolley or boom, which is also that of its body.
        kind: which of the two.
    """

    name: str
    kind: Literal["trolley", "boom"]


@dataclass(frozen=True)
class Hook:
    """A hook with all its parts.

    Attributes:
        name: full name: of its crane, or `<crane>.<hook>`.
        crane: name of its crane.
        carrier: what takes it along; None of a hook that no crane stands behind.
        paths: where the lift file says its parts, those of `_SAID`; the hook itself is `""`.
        place: of a hook at a boom along and across the boom, where its upper sheaves are pinned; of another x
            and y of its bearing point at the start, world axes [m].
        above: of a hook at a boom how far that pin is above the middle line of the boom, square to it [m].
        height: height of its bearing point at the start [m].
        highest: highest position of the bearing [m]; None if not said.
        hook_block_mass: mass of hook block and falls that are no part of the mechanics [kg].
    """

    name: str
    crane: str
    carrier: Carrier | None
    paths: Mapping[str, tuple[PathPart, ...]]
    place: tuple[float, float]
    above: float
    height: float
    rated_capacity: float | None
    rating_includes_hook_block: bool
    highest: float | None
    hook_block_mass: float
    hook_block: HookBlock | None
    reeving: Reeving | None
    drum: HoistDrum | None
    hoist: Hoist

    @property
    def pin(self) -> tuple[float, float, float]:
        """Where the sheave block of a hook at a boom is pinned, axes of the boom [m]."""
        return (*self.place, self.above)


def trolley_name(crane: str, trolley: str) -> str:
    """Full name of a trolley."""
    return f"{crane}.{trolley}"


def full_name(text: str, known: Mapping[str, object]) -> str | None:
    """The name among those `known` that a text means: itself, or the only one that ends in `.<text>`."""
    if text in known:
        return text
    fitting = [name for name in known if name.endswith(f".{text}")]
    return fitting[0] if len(fitting) == 1 else None


def full_names(texts: Iterable[str], known: Mapping[str, object]) -> list[str]:
    """The names that texts mean; of one that means none, nothing."""
    return [name for text in texts if (name := full_name(text, known)) is not None]


def booms_of(cranes: Mapping[str, AnyCrane], vessels: Mapping[str, Vessel]) -> dict[str, PlacedBoom]:
    """Booms of all cranes that have one, by the name of the crane."""
    found = {name: any_boom(name, crane, vessels) for name, crane in cranes.items()}
    return {name: boom for name, boom in found.items() if boom is not None}


def hooks_of(cranes: Mapping[str, AnyCrane], types: Mapping[str, HookType]) -> dict[str, Hook]:
    """All hooks, in the order of the lift file; hooks of which something is missing are left out."""
    found: dict[str, Hook] = {}
    for name, crane in cranes.items():
        if isinstance(crane, FixedHook):
            found[name] = _fixed(name, crane)
            continue
        includes = crane.rating_includes_hook_block
        for given, of in _carried(name, crane):
            one = _of_carrier(of, given, types.get(given.type or ""), includes)
            if one is not None:
                found[one.name] = one
    return found


def _carried(name: str, crane: Goliath | FloatingCrane | Crawler) -> Iterator[tuple[CarriedHook, _Place]]:
    """Each hook of a crane that bears several, what takes it along, and where."""
    if isinstance(crane, Goliath):
        for trolley, bears in crane.trolleys.items():
            carrier = Carrier(trolley_name(name, trolley), "trolley")
            for hook, given in bears.hooks.items():
                path = ("cranes", name, "trolleys", trolley, "hooks", hook)
                place = bears.position + given.along, crane.position + given.across
                yield given, _Place(f"{name}.{hook}", name, carrier, path, place)
        return
    carrier = Carrier(boom_name(name), "boom")
    for hook, at_head in crane.hooks.items():
        place = crane.boom.length + at_head.along, at_head.across
        of = "cranes", name, "hooks", hook
        yield at_head, _Place(f"{name}.{hook}", name, carrier, of, place, at_head.above)


def _fixed(name: str, crane: FixedHook) -> Hook:
    path = ("cranes", name)
    return Hook(
        name=name,
        crane=name,
        carrier=None,
        paths={"": path} | {key: (*path, _WORDS.get(key, key)) for key in _SAID},
        place=crane.at[:2],
        above=0.0,
        height=crane.at[2],
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
    carrier: Carrier
    path: tuple[PathPart, ...]
    place: tuple[float, float]
    above: float = 0.0


def parts_of(given: CarriedHook, kind: HookType | None) -> dict[str, object]:
    """The parts of a hook, its own before those of its type; None where neither has one."""
    own = {key: getattr(given, key) for key in PARTS}
    return {key: getattr(kind, key, None) if part is None else part for key, part in own.items()}


def _of_carrier(of: _Place, given: CarriedHook, kind: HookType | None, includes: bool) -> Hook | None:
    parts = parts_of(given, kind)
    if any(parts[key] is None for key in NEEDED):
        return None
    paths = {"": of.path}
    for key in _SAID:
        own = getattr(given, key) is not None
        word = _WORDS.get(key, key)
        paths[key] = (*of.path, word) if own else ("hook_types", str(given.type), word)
    return Hook(
        name=of.name,
        crane=of.crane,
        carrier=of.carrier,
        paths=paths,
        place=of.place,
        above=of.above,
        height=given.height,
        rating_includes_hook_block=includes,
        hook_block_mass=0.0,
        **parts,  # type: ignore[arg-type]
    )
