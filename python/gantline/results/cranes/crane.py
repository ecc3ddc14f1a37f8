"""Cranes in a recording: hooks under trolleys and booms, loads of the corners of Goliath cranes, overloads.

Sizes and weights come with the rig; docs/concepts/goliath.md and docs/concepts/booms.md have the equations.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Self

import numpy as np

from gantline.results.bodies import places_of
from gantline.results.file.form import Vector
from gantline.results.passing import passed
from gantline.results.strength import FromJson, Rating
from gantline.results.variable import Columns, Derived, FloatArray, Names, Variable

__all__ = [
    "CARRIAGE_CORNERS",
    "CORNERS",
    "Crane",
    "CraneHook",
    "Trolley",
    "bearing_and_falls",
    "corner_loads",
    "crane_events",
    "hook_state",
]

#: Corners of a crane: leg, and side along the rails.
CORNERS = ("fixed.front", "fixed.back", "hinged.front", "hinged.back")
#: The same of an overhead crane: end carriage, left at the least x, in place of the leg.
CARRIAGE_CORNERS = ("left.front", "left.back", "right.front", "right.back")


@dataclass(frozen=True)
class CraneHook(FromJson):
    """A hook under a trolley or a boom.

    Attributes:
        name: Its name.
        highest: Highest position of its bearing [m]; None if not said.
        bearing: Its bearing from the centre of gravity of its body, axes of that [m].
        sheaves_above: How far above the bearing the sheaves of its hook block are [m].
        top: Body of its upper sheaves.
        top_from: Their middle, under a boom their pin, from the centre of gravity of that body, its axes [m].
        sheaves_below: How far below that pin they are, down in the axes of their body [m].
        along: Where it is under its trolley, along the girder [m].
        across: Where it is across the girder [m].
    """

    name: str
    highest: float | None = None
    bearing: Vector = (0.0, 0.0, 0.0)
    sheaves_above: float = 0.0
    top: str = ""
    top_from: Vector = (0.0, 0.0, 0.0)
    sheaves_below: float = 0.0
    along: float = 0.0
    across: float = 0.0


@dataclass(frozen=True)
class Trolley(FromJson):
    """A trolley.

    Attributes:
        name: Its name, also of its body and its joint, whose position is its place along the girder.
        weight: Without hook blocks and falls [N].
        hooks: Its hooks.
    """

    name: str
    weight: float = 0.0
    hooks: Sequence[CraneHook] = ()

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        hooks = tuple(CraneHook.from_json(one) for one in document.get("hooks", ()))
        return super().from_json({**document, "hooks": hooks})


@dataclass(frozen=True)
class Crane(FromJson):
    """A Goliath crane, or an overhead crane of a hall.

    Attributes:
        name: Its name.
        span: Distance of its rails [m].
        rail_level: Height of the rails in the world [m].
        has_legs: Whether it stands on legs; an overhead crane stands on end carriages.
        fixed_leg_at: Place of the fixed leg along the girder [m].
        base: Distance of the corners of a leg along the rails [m]; None if not said.
        weights: Of `girder`, `fixed`, `hinged` (legs) and `bogies` [N].
        hook_approach: Smallest distance of a hook from a rail [m]; None if not said.
        hook_distance: Smallest distance of hooks of two trolleys along the girder [m]; None if not said.
        wind_limit: Largest gust [m/s]; None if not said.
        wind: Gust of this lift [m/s]; None if not said.
        trolleys: Its trolleys.
    """

    name: str
    span: float = 0.0
    rail_level: float = 0.0
    has_legs: bool = True
    fixed_leg_at: float = 0.0
    base: float | None = None
    weights: Mapping[str, float] = field(default_factory=dict)
    hook_approach: float | None = None
    hook_distance: float | None = None
    wind_limit: float | None = None
    wind: float | None = None
    trolleys: Sequence[Trolley] = ()

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        trolleys = tuple(Trolley.from_json(one) for one in document.get("trolleys", ()))
        return super().from_json({**document, "trolleys": trolleys})

    @property
    def hooks(self) -> list[tuple[Trolley, CraneHook]]:
        """All hooks with their trolleys."""
        return [(trolley, hook) for trolley in self.trolleys for hook in trolley.hooks]

    @property
    def corners(self) -> list[str]:
        """Names of its corners, fixed leg or left carriage first."""
        return [f"{self.name}.{corner}" for corner in (CORNERS if self.has_legs else CARRIAGE_CORNERS)]


def bearing_and_falls(columns: Columns, names: Names, hook: CraneHook) -> tuple[FloatArray, FloatArray]:
    """Where the bearing of a hook is, and the way up its falls, shapes (time, 3) [m].

    The falls go from the sheaves of the hook block, which stays upright, to the upper ones. At a boom these
    hang in a sheave block that does not turn across it: not at its pin, where a side-lead would seem less.
    """
    bearing = places_of(columns, names, hook.name, hook.bearing)
    sheaves = places_of(columns, names, hook.top, np.asarray(hook.top_from) - (0.0, 0.0, hook.sheaves_below))
    return bearing, sheaves - bearing - (0.0, 0.0, hook.sheaves_above)


def hook_state(columns: Columns, names: Names, hooks: Sequence[CraneHook], loads: Sequence[str]) -> Derived:
    """Heights and angles of hooks, swing of loads.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        hooks: Hooks that a trolley or a boom takes along.
        loads: Names of the loads, which hang from their hooks together.
    """
    if not hooks:
        return {}, {}
    heights, angles, aside = [], [], []
    for hook in hooks:
        bearing, falls = bearing_and_falls(columns, names, hook)
        aside.append((bearing - places_of(columns, names, hook.top, hook.top_from))[:, :2])
        heights.append(bearing[:, 2])
        angles.append(np.arctan2(np.linalg.norm(falls[:, :2], axis=1), falls[:, 2]))
    swing = np.linalg.norm(np.mean(aside, axis=0), axis=1)
    dims = ("time", "crane_hook")
    found = {
        "hook_height": Variable(dims, np.stack(heights, axis=1), "m", "height of a hook's bearing"),
        "falls_out_of_plumb": Variable(
            dims, np.stack(angles, axis=1), "rad", "angle of the falls of a hook from plumb"
        ),
    }
    if loads:
        found["load_swing"] = Variable(
            ("time", "load"),
            np.repeat(swing[:, None], len(loads), axis=1),
            "m",
            "distance of a load from plumb under upper sheaves or boom heads: mean of its hooks, as a vector",
        )
    return found, {"crane_hook": [hook.name for hook in hooks]}


def corner_loads(
    columns: Columns, names: Names, cranes: Sequence[Crane], hoist: Mapping[str, FloatArray]
) -> Derived:
    """Loads of the corners of Goliath cranes; `hoist` is the hoist load by hook, shape (time,) [N]."""
    if not cranes:
        return {}, {}
    carried = np.concatenate([_corner_loads(columns, names, crane, hoist) for crane in cranes], axis=1)
    variable = Variable(
        ("time", "corner"),
        carried,
        "N",
        "load of a corner of a crane by moments of weights and of the pull of its falls, without its inertia",
    )
    return {"corner_load": variable}, {"corner": [corner for crane in cranes for corner in crane.corners]}


def _corner_loads(
    columns: Columns, names: Names, crane: Crane, hoist: Mapping[str, FloatArray]
) -> FloatArray:
    """Loads of the four corners, in the order of `CORNERS`, shape (time, 4) [N].

    Falls out of plumb also pull level, high above the rails: their pull has the moments of its upright part
    where their line, carried on down, comes to rail level.
    """
    joints = list(names["joint"])
    time = len(columns["time"])
    own = crane.weights
    loads = np.zeros((time, 4))
    loads[:, :2] += own["fixed"] / 2 + own["bogies"] / 4
    loads[:, 2:] += own["hinged"] / 2 + own["bogies"] / 4
    loads += own["girder"] / 4
    sign = -np.sign(crane.fixed_leg_at)  # of a place towards the hinged leg

    def put(weight: FloatArray | float, along: FloatArray, across: FloatArray | float) -> None:
        share = 0.5 + sign * along / crane.span  # of the hinged leg
        lever = across / crane.base if crane.base else 0.0
        for place, (of_leg, side) in enumerate(
            ((1 - share, 0.5 + lever), (1 - share, 0.5 - lever), (share, 0.5 + lever), (share, 0.5 - lever))
        ):
            loads[:, place] += weight * of_leg * side

    for trolley in crane.trolleys:
        along = columns["joint_position"][:, joints.index(trolley.name)]
        put(trolley.weight, along, 0.0)
        for hook in trolley.hooks:
            _, falls = bearing_and_falls(columns, names, hook)
            top = places_of(columns, names, hook.top, hook.top_from)
            upright = hoist[hook.name] * falls[:, 2] / np.linalg.norm(falls, axis=1)
            aside = (
                falls[:, :2] / falls[:, 2:] * (top[:, 2:] - crane.rail_level)
            )  # on the way down to the rails
            put(upright, along + hook.along - aside[:, 0], hook.across - aside[:, 1])
    return loads


def crane_events(
    time: FloatArray,
    ratings: Sequence[Rating],
    loads: Mapping[str, Mapping[str, FloatArray]],
    hooks: Sequence[CraneHook],
    heights: Mapping[str, FloatArray],
) -> Iterator[tuple[float, str, str]]:
    """Moments at which a rated capacity or a highest position is passed: time [s], kind, element.

    Args:
        time: Shape (time,) [s].
        ratings: Rated capacities.
        loads: `hook_load` and `hoist_load` by hook, shape (time,) [N].
        hooks: Hooks that a trolley or a boom takes along, whose heights may be limited.
        heights: Height of the bearing by hook, shape (time,) [m].
    """
    for rating in ratings:
        if rating.rated_capacity:
            of = loads["hoist_load" if rating.includes_hook_block else "hook_load"]
            total = np.sum([of[name] for name in rating.hooks], axis=0)
            for at in passed(time, total - rating.rated_capacity):
                yield at, "overload", rating.name
    for hook in hooks:
        if hook.highest is not None:
            for at in passed(time, heights[hook.name] - hook.highest):
                yield at, "hook_too_high", hook.name
