"""Goliath cranes into mechanics: crane on rails, girder that bends, trolleys, each on a slider.

Legs and bogies, or the end carriages of an overhead crane, and the part of the girder that does not take
part in its bending are one body on a driven slider along the rails. On it stands what of the girder does: a
slider up and down on a spring that carries girder, trolleys and hooks where they are at the start. Trolleys
are driven sliders along that. Hook blocks are points under the world that hang in their ropes, so that they
swing.
"""

from __future__ import annotations

import math

from gantline.assembly.afloat.gusts import wind_of_limit
from gantline.assembly.cranes.reeving import hook_rig
from gantline.assembly.parts import Json, Parts, box_shape
from gantline.assembly.plan.operations import along_drive
from gantline.scenario import Scenario
from gantline.scenario.cranes.crane_parts import girder_body
from gantline.scenario.cranes.goliath import Goliath
from gantline.scenario.cranes.hooks import trolley_name

__all__ = ["BENDING_SHARE", "add_goliaths", "crane_rig", "crane_shape", "goliaths", "rest_on_girders"]

#: Mass at mid-span of a girder on two supports that moves like it, over its mass: 17/35, from the shape in
#: which a force there bends it (Rayleigh).
BENDING_SHARE = 17 / 35

#: Sizes that pictures have where the lift file names none: girder over its span, leg and trolley [m].
_GIRDER = 0.06
_LEG = 4.0
_TROLLEY = 8.0
#: The same over a span: an end carriage, across and up, and the trolley of a small crane.
_CARRIAGE = 0.03
_SMALL_TROLLEY = 0.12


def goliaths(scenario: Scenario) -> dict[str, Goliath]:
    """The Goliath cranes of a lift by name."""
    cranes = scenario.cranes or {}
    return {name: crane for name, crane in cranes.items() if isinstance(crane, Goliath)}


def add_goliaths(parts: Parts, scenario: Scenario) -> None:
    """Add the bodies of every Goliath crane, without hooks."""
    for name, crane in goliaths(scenario).items():
        legs, girder = crane.standing, crane.girder
        bends = girder.vertical_stiffness is not None
        moving = BENDING_SHARE * girder.mass if bends else girder.mass
        joint = {"type": "fixed"}
        position = (0.0, crane.position, crane.rail_level)
        if crane.travel is not None:
            joint, position = (
                _driven(parts, name, (0.0, 1.0, 0.0), crane.position),
                (0.0, 0.0, crane.rail_level),
            )
        standing = legs.fixed + legs.hinged + legs.bogies
        rest = girder.mass - moving
        x = (legs.fixed - legs.hinged) * legs.at / max(standing + rest, 1.0)
        z = ((legs.fixed + legs.hinged) / 2 + rest) * girder.underside / max(standing + rest, 1.0)
        parts.add_body(name, joint, position=position, mass=standing + rest, centre_of_gravity=(x, 0.0, z))
        sag: Json = {"type": "fixed"} if not bends else _slider((0.0, 0.0, 1.0), 0.0)
        height = girder.underside
        parts.add_body(girder_body(name), sag, parent=name, position=(0.0, 0.0, height), mass=moving)
        for trolley, given in crane.trolleys.items():
            full = trolley_name(name, trolley)
            along = _driven(parts, full, (1.0, 0.0, 0.0), given.position)
            parts.add_body(full, along, parent=girder_body(name), mass=given.mass)


def _driven(parts: Parts, name: str, axis: tuple[float, float, float], position: float) -> Json:
    parts.add_drive(along_drive(name))
    return _slider(axis, position) | {"drive": along_drive(name)}


def _slider(axis: tuple[float, float, float], position: float) -> Json:
    joint = {"type": "slider", "axis": list(axis), "position": position, "velocity": 0.0, "damping": 0.0}
    return joint | {"friction": 0.0, "drive": None, "stops": None}


def rest_on_girders(parts: Parts, scenario: Scenario) -> None:
    """Load the springs of all girders with what they carry where all hooks hang free of the load."""
    for name, crane in goliaths(scenario).items():
        stiffness = crane.girder.vertical_stiffness
        if stiffness is None:
            continue
        girder = girder_body(name)
        carried = {girder, *(hook.name for hook in scenario.hooks.values() if hook.crane == name)}
        for body, given in parts.bodies.items():  # parents stand before their children
            if given["parent"] in carried:
                carried.add(body)
        mass = math.fsum(parts.bodies[body]["mass"] for body in carried)
        empty = parts.bodies[girder]["mass"] + math.fsum(given.mass for given in crane.trolleys.values())
        neutral = mass * scenario.simulation.gravity / stiffness
        parts.add_spring(girder, stiffness, crane.girder.damping, empty, neutral)


def crane_shape(scenario: Scenario, body: str) -> Json | None:
    """Boxes for pictures: two legs or end carriages, a girder, or a trolley."""
    for name, crane in goliaths(scenario).items():
        if body == name:
            width = _LEG if crane.legs is not None else _CARRIAGE * crane.span
            height = crane.girder.underside if crane.legs is not None else width
            size = (width, crane.standing.base or _LEG, height)
            sides = (-crane.span / 2, crane.span / 2)
            return {"type": "boxes", "boxes": [_box(size, 0.5, side) for side in sides]}
        if body == girder_body(name):
            return _box((crane.span, _GIRDER * crane.span, _GIRDER * crane.span), 0.5)
        for trolley in crane.trolleys:
            if body == trolley_name(name, trolley):
                side = min(_TROLLEY, _SMALL_TROLLEY * crane.span)
                return _box((side, side, side / 4), -0.5)
    return None


def _box(size: tuple[float, float, float], above: float, along: float = 0.0) -> Json:
    return box_shape(size, (along, 0.0, above * size[2]))


def crane_rig(scenario: Scenario, parts: Parts) -> list[Json]:
    """What results need to know of Goliath cranes [SI]."""
    gravity = scenario.simulation.gravity
    return [
        {
            "name": name,
            "span": crane.span,
            "rail_level": crane.rail_level,
            "has_legs": crane.legs is not None,
            "fixed_leg_at": crane.standing.at,
            "base": crane.standing.base,
            "weights": {
                "girder": crane.girder.mass * gravity,
                "fixed": crane.standing.fixed * gravity,
                "hinged": crane.standing.hinged * gravity,
                "bogies": crane.standing.bogies * gravity,
            },
            "hook_approach": crane.hook_approach,
            "hook_distance": crane.hook_distance,
            "wind_limit": crane.wind_limit,
            "wind": wind_of_limit(scenario, crane.rail_level + crane.girder.underside),
            "trolleys": [
                {
                    "name": trolley_name(name, trolley),
                    "weight": given.mass * gravity,
                    "hooks": [
                        hook_rig(parts, scenario.hooks[f"{name}.{hook}"])
                        | {"along": one.along, "across": one.across}
                        for hook, one in given.hooks.items()
                    ],
                }
                for trolley, given in crane.trolleys.items()
            ],
        }
        for name, crane in goliaths(scenario).items()
    ]
