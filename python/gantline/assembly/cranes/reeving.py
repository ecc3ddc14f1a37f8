"""Reeving of a hook into mechanics: hook block and upper sheaves, ropes and drum.

Every part of line is plumb. Sheaves of the hook block stand side by side along y, the upper ones above the
gaps between them: a rope comes down at x = -r of a sheave of the hook block, goes up at x = +r, and over an
upper sheave to the next. Its dead end is above where its parts are even and on the hook block where they are
odd. The lead line goes from the last upper sheave down to the drum.

At a boom the upper sheaves hang in a sheave block that is pinned to the boom head, and so they stay above
those of the hook block as the boom luffs. The lead line ends on the sheave block itself; led along the boom
it would have no moment about the heel pins either.

The flow of the drum counts what the hook rises, as the drive of a hook without reeving does.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gantline.assembly.parts import Json, Parts, box_shape, drum_layers, end, half_turn, material
from gantline.assembly.ropes.rope_weight import lump_rope
from gantline.assembly.ropes.route import route_length
from gantline.assembly.ropes.sheave import add_sheave_flow
from gantline.assembly.spatial import about_axis, inertia_list, rotation_matrix, solid_box
from gantline.scenario import Scenario
from gantline.scenario.cranes.hooks import Hook
from gantline.scenario.cranes.reeving import HoistDrum, HookBlock, Reeving, hoist_drum, hoist_ropes
from gantline.scenario.cranes.slewing import turned_body
from gantline.scenario.rope_weight import rope_weight

__all__ = [
    "ReevedHook",
    "add_reeved_hook",
    "below_pin",
    "hang_in_ropes",
    "hook_rig",
    "mass_on",
    "reeved_hooks",
    "upper_sheaves",
]

#: Mass that moves with the rope of a drum whose motion is prescribed and whose inertia nobody says [kg].
_DRIVEN = 1.0
#: Distance of neighbouring sheaves along their axle where the lift file does not say it, over their radius.
_SPACING = 0.3


@dataclass(frozen=True)
class ReevedHook:
    """A hook with reeving, and the parts that belong to it.

    Attributes:
        name: name of the hook.
        hook: what the lift file says.
        hook_block, reeving, drum: its parts.
    """

    name: str
    hook: Hook
    hook_block: HookBlock
    reeving: Reeving
    drum: HoistDrum

    @property
    def ropes(self) -> list[str]:
        """Names of its ropes."""
        return hoist_ropes(self.name, self.reeving)

    @property
    def holds(self) -> float | None:
        """Hoist load that motor and brake both hold by themselves, on the first layer of the drum [N].

        Sheaves lose nothing of it; None where the motor pulls whatever it takes.
        """
        pulls = [pull for pull in (self.hook.hoist.capacity, self.hook.hoist.brake) if pull is not None]
        return min(pulls) * self.reeving.ropes * self.reeving.parts_each if pulls else None

    @property
    def has_weaker_brake(self) -> bool:
        """Whether the brake holds less than the motor."""
        capacity, brake = self.hook.hoist.capacity, self.hook.hoist.brake
        return capacity is not None and brake is not None and brake < capacity


def reeved_hooks(scenario: Scenario) -> list[ReevedHook]:
    """Hooks that hang in ropes, in the order of the lift file."""
    return [
        ReevedHook(name, hook, hook.hook_block, hook.reeving, hook.drum)
        for name, hook in scenario.hooks.items()
        if hook.reeving is not None and hook.hook_block is not None and hook.drum is not None
    ]


def upper_sheaves(hook: str) -> str:
    """Name of the body with the upper sheaves of a hook; with a stroke, which no name of a lift file has."""
    return f"{hook}/upper_sheaves"


def add_reeved_hook(parts: Parts, scenario: Scenario, hook: ReevedHook, drive: str, own_mass: float) -> None:
    """Add hook block, upper sheaves, drum and ropes of a hook.

    Args:
        parts: the system so far.
        scenario: the lift.
        hook: the hook.
        drive: name of the drive that hoists it.
        own_mass: mass that hangs on it beside the hook block, of shackles and slings [kg].
    """
    mass = hook.hook_block.mass + own_mass
    if hook.hook.carrier is None:
        guided = {"type": "slider", "axis": [0.0, 0.0, 1.0], "position": 0.0, "velocity": 0.0, "damping": 0.0}
        guided |= {"friction": 0.0, "drive": None, "stops": None}
        parts.add_body(hook.name, guided, position=_bearing(hook), mass=mass)
        at_top = (*hook.hook.place, _said(hook.reeving.upper_sheaves_at))
        parts.add_body(upper_sheaves(hook.name), {"type": "fixed"}, position=at_top)
    elif hook.hook.carrier.kind == "trolley":
        _add_swinging(parts, hook, _bearing(hook), 0.0, mass)
        at_top = (*hook.hook.place, _said(hook.reeving.upper_sheaves_at))
        trolley = hook.hook.carrier.name
        at_trolley = [float(part) for part in np.array(at_top) - parts.pose(trolley)[0]]
        parts.add_body(upper_sheaves(hook.name), {"type": "fixed"}, parent=trolley, position=at_trolley)
    else:
        _add_at_boom(parts, scenario, hook, hook.hook.carrier.name, mass)
    parts.add_drive(drive)
    _add_drum(parts, hook, drive)
    kind = (scenario.ropes or {})[hook.reeving.rope]
    radius = hook.reeving.diameter(kind.diameter) / 2
    losses = hook.reeving.losses(kind.diameter, kind.mass_per_length)
    weight = rope_weight(kind, hook.reeving.rope_weight, None)
    for place, name in enumerate(hook.ropes):
        route = []
        for at, guide in enumerate(_guides(hook, place, radius)):
            if guide["type"] == "half_turn":
                passing = add_sheave_flow(parts, f"{name}/sheave_{at}", losses)
                guide = half_turn(guide["body"], guide["enter"], guide["leave"], guide["bulge"], passing)
            route.append(guide)
        route[-1] = _on_drum(hook, route[-1], kind.diameter)
        length = route_length(parts, route)
        parts.add_rope(name, length, material(kind), route)
        lump_rope(parts, name, weight, length, route)


def _said(value: float | None) -> float:
    """What the check of the lift file has seen to."""
    assert value is not None
    return value


def _bearing(hook: ReevedHook) -> tuple[float, float, float]:
    return (*hook.hook.place, hook.hook.height)


def _add_swinging(parts: Parts, hook: ReevedHook, at: Sequence[float], heading: float, mass: float) -> None:
    """The hook as a point: it swings, upright, with its sheaves across a heading [rad].

    It is a point under the world, or under what turns as its crane slews.
    """
    turns = turned_body(hook.hook.crane)
    parent = turns if turns in parts.bodies else None
    origin, axes = parts.pose(parent)
    turned = about_axis((0.0, 0.0, 1.0), heading)
    position = rotation_matrix(turned).T @ (np.array(at) - origin)
    swings = {"type": "point", "position": [float(x) for x in position], "velocity": [0.0, 0.0, 0.0]}
    from_parent = about_axis((0.0, 0.0, 1.0), heading - math.atan2(axes[1, 0], axes[0, 0]))
    parts.add_body(hook.name, swings, parent=parent, orientation=from_parent, mass=mass)


def _add_at_boom(parts: Parts, scenario: Scenario, hook: ReevedHook, boom: str, mass: float) -> None:
    """The hook under a boom head, its upper sheaves in a sheave block pinned there, which hangs plumb.

    The pin is parallel to the heel pins: in the boom's plane the sheave block turns into the line of its
    falls.
    """
    pin = parts.place(boom, hook.hook.pin)
    axes = parts.pose(boom)[1]
    below, kind = _said(hook.reeving.below_head), (scenario.ropes or {})[hook.reeving.rope]
    lowest = pin[2] - below - hook.reeving.diameter(kind.diameter)
    highest = hook.hook.height + hook.hook_block.height
    if highest > lowest:
        sentence = f"the sheaves of the hook block start at {highest:g} m, and the upper ones hang at"
        sentence += f" {pin[2] - below:.3f} m under the boom head, not a sheave's diameter above"
        right = f"a 'height' of {lowest - hook.hook_block.height:.3f} m or less is right"
        raise scenario.start_error((*hook.hook.paths[""], "height"), f"{sentence}; {right}")
    heading = math.atan2(-axes[0, 1], axes[1, 1])
    _add_swinging(parts, hook, (pin[0], pin[1], hook.hook.height), heading, mass)
    up = axes.T @ np.array((0.0, 0.0, 1.0))
    plumb = math.atan2(-up[0], up[2])
    hinge = {"type": "hinge", "axis": [0.0, -1.0, 0.0], "position": plumb, "velocity": 0.0, "damping": 0.0}
    hung, size = _sheave_block(scenario, hook), hook.reeving.diameter(kind.diameter)
    parts.add_body(
        upper_sheaves(hook.name),
        hinge | {"friction": 0.0, "drive": None, "stops": None},
        parent=boom,
        position=hook.hook.pin,
        mass=hung,
        centre_of_gravity=(0.0, 0.0, -below),
        inertia=inertia_list(solid_box(hung, (size, size, size))),
    )


def _add_drum(parts: Parts, hook: ReevedHook, drive: str) -> None:
    parts_of_line, ropes = hook.reeving.parts_each, hook.reeving.ropes
    motor = {}
    if hook.hook.hoist.capacity is not None:
        # Of the hook, not of the ropes: forces are so many times as large.
        motor = {
            "capacity": hook.hook.hoist.capacity * ropes * parts_of_line,
            "power": hook.hook.hoist.power,
        }
    inertia = (hook.drum.inertia or _DRIVEN) * parts_of_line**2
    parts.add_flow(hoist_drum(hook.name), inertia, drive=drive, **motor)


def _on_drum(hook: ReevedHook, lead: Json, rope_diameter: float | None) -> Json:
    layers = drum_layers(hook.drum, hook.drum.diameter, rope_diameter)
    rate = -float(hook.reeving.parts_each)
    on = hoist_drum(hook.name), rate
    return end(lead["body"], lead["at"], on, laid_under=hook.drum.wound_under, layers=layers)


def _guides(hook: ReevedHook, rope: int, radius: float) -> list[Json]:
    """Dead end, sheaves in turn, and the place of the drum: the world, or what bears the upper sheaves."""
    count, above = hook.reeving.parts_each, upper_sheaves(hook.name)
    high = -below_pin(hook.hook)
    spacing = hook.reeving.sheave_spacing or _SPACING * radius
    # Each rope takes as many places along the axle as it has sheaves below; mirrored from one to the next.
    width = spacing * (count // 2 + 1)
    middle = width * (rope - (hook.reeving.ropes - 1) / 2)
    mirror = -1.0 if rope % 2 else 1.0
    if hook.hook.carrier is not None and hook.hook.carrier.kind == "boom":
        # All ropes about one middle, that of their parts: the hook block stays upright, so that ropes side by
        # side would hold up the boom that heels over it, where a real hook block tilts along.
        middle = spacing * mirror * (-(count // 2) / (2 * count) if count % 2 else 0.5)
    rows = [(k // 2 - (count // 2) / 2) * spacing * mirror + middle for k in range(count + 2)]
    low = hook.hook_block.height
    guides: list[Json] = []
    if count % 2:
        guides.append(end(hook.name, (0.0, rows[0], low)))
        enter, row, is_below = 0.0, 0, False
    else:
        guides.append(end(above, (-radius, rows[0], high)))
        enter, row, is_below = -radius, 0, True
    for _ in range(count):
        if is_below:
            guides.append(
                half_turn(hook.name, (enter, rows[2 * row], low), (radius, rows[2 * row], low), (0, 0, -1))
            )
            enter = radius
        else:
            leave = -radius
            guides.append(
                half_turn(above, (enter, rows[2 * row], high), (leave, rows[2 * row + 2], high), (0, 0, 1))
            )
            enter, row = leave, row + 1
        is_below = not is_below
    if hook.hook.carrier is not None:
        return [*guides, end(above, (enter, rows[2 * row], high - hook.reeving.lead_line))]
    x, y = hook.hook.place
    lead = (x + enter, y + rows[2 * row], _said(hook.reeving.upper_sheaves_at) - hook.reeving.lead_line)
    return [*guides, end(None, lead)]


def hook_block_shape(parts: Parts, scenario: Scenario, hook: ReevedHook) -> Json:
    """The box about the bearing of a hook and the sheaves of its hook block, whose ropes have been added.

    Along their axle it is as wide as they stand apart, and no less than the radius of one.
    """
    radius = hook.reeving.diameter((scenario.ropes or {})[hook.reeving.rope].diameter) / 2
    own = (rope for rope in parts.ropes if rope["name"] in hook.ropes)
    guides = [guide for rope in own for guide in rope["route"] if guide["body"] == hook.name]
    rows = [(guide["enter"] if guide["type"] == "half_turn" else guide["at"])[1] for guide in guides]
    width, height = max(max(rows) - min(rows), radius), hook.hook_block.height + radius
    return box_shape((2 * radius, width, height), (0.0, (max(rows) + min(rows)) / 2, height / 2))


def hang_in_ropes(parts: Parts, scenario: Scenario, hook: ReevedHook) -> None:
    """Give the ropes of a hook the lengths with which they carry what hangs on it at the start.

    Args:
        parts: the system with everything that hangs on the hook.
        scenario: the lift.
        hook: the hook.
    """
    weight = mass_on(parts, hook.name) * scenario.simulation.gravity
    kind = (scenario.ropes or {})[hook.reeving.rope]
    assert kind.stiffness is not None  # checked: a hoist rope stretches
    strain = weight / hook.reeving.parts / kind.stiffness
    for rope in parts.ropes:
        if rope["name"] in hook.ropes:
            rope["length"] /= 1 + strain


def falls_on_upper_sheaves(parts: Parts, scenario: Scenario, hook: ReevedHook) -> float:
    """What the upper sheaves bear of the mass of the falls [kg]: theirs, without a sheave block at a boom."""
    borne: float = parts.bodies[upper_sheaves(hook.name)]["mass"]
    if hook.hook.carrier is None or hook.hook.carrier.kind == "trolley":
        return borne
    return borne - _sheave_block(scenario, hook)


def _sheave_block(scenario: Scenario, hook: ReevedHook) -> float:
    return _said(hook.reeving.sheave_block_at_head((scenario.ropes or {})[hook.reeving.rope].diameter))


def mass_on(parts: Parts, body: str) -> float:
    """Mass of a body with everything that hangs on it by joints [kg]."""
    hanging = {body}
    for name, given in parts.bodies.items():  # parents stand before their children
        if given["parent"] in hanging:
            hanging.add(name)
    return math.fsum(parts.bodies[name]["mass"] for name in hanging)


def below_pin(hook: Hook) -> float:
    """How far the upper sheaves at a boom are below the pin of their sheave block, else none [m]."""
    return (hook.reeving.below_head if hook.reeving else None) or 0.0


def hook_rig(parts: Parts, hook: Hook) -> Json:
    """What results need to know of a hook that something takes along [SI]."""
    top = upper_sheaves(hook.name)
    return {
        "name": hook.name,
        "highest": hook.highest,
        "bearing": [-value for value in parts.bodies[hook.name]["centre_of_gravity"]],
        "sheaves_above": 0.0 if hook.hook_block is None else hook.hook_block.height,
        "top": top,
        "top_from": [-value for value in parts.bodies[top]["centre_of_gravity"]],
        "sheaves_below": below_pin(hook),
    }
