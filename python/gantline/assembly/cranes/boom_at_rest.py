"""How a boom is held at its angle at the start: lengths of its luffing ropes, springs of one that gives.

By moments about the heel pins, world axes; what hangs in a hook pulls at the pin of its upper sheaves.
docs/concepts/booms.md has the equations.
"""

from __future__ import annotations

import math

import numpy as np

from gantline.assembly.cranes.reeving import mass_on
from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import Array
from gantline.scenario import Scenario
from gantline.scenario.cranes.boom import PlacedBoom
from gantline.scenario.cranes.luffing import Tackles

__all__ = ["RISES", "add_what_gives", "hang_in_tackles", "rest_on_springs"]

#: The axis about which a boom rises, axes of its base and its own: to starboard.
RISES = [0.0, -1.0, 0.0]
#: The axis about which it gives aside, its own: square to the boom and to its heel pins.
_ASIDE = [0.0, 0.0, 1.0]


def add_what_gives(parts: Parts, placed: PlacedBoom) -> tuple[str, Json]:
    """Add what a boom that gives hangs on; the name of that, and the joint of the boom on it.

    Its springs follow once all that hangs at the boom is known, by `rest_on_springs`.
    """
    boom = placed.boom
    if boom.side_stiffness is None:
        return placed.told, _hinge(RISES)
    if boom.vertical_stiffness is None:
        return placed.told, _hinge(_ASIDE)
    parts.add_body(_aside(placed), _hinge(_ASIDE), parent=placed.told)
    return _aside(placed), _hinge(RISES)


def _aside(placed: PlacedBoom) -> str:
    """Name of what gives aside of a boom that gives upright too."""
    return f"{placed.name}/aside"


def _hinge(axis: list[float]) -> Json:
    hinge: Json = {"type": "hinge", "axis": axis, "position": 0.0, "velocity": 0.0, "damping": 0.0}
    return hinge | {"friction": 0.0, "drive": None}


def rest_on_springs(parts: Parts, scenario: Scenario) -> None:
    """Give each boom its springs: where all hooks hang free of the load it stands as the lift file has it."""
    for placed in scenario.booms.values():
        boom, body = placed.boom, parts.bodies[placed.name]
        empty = body["inertia"][1] + body["mass"] * body["centre_of_gravity"][0] ** 2
        if boom.vertical_stiffness is not None:
            # (BM7): a force at the head turns the boom by its level distance from the heel pins.
            stiffness = boom.vertical_stiffness * (boom.length * math.cos(boom.angle)) ** 2
            neutral = _weight_moment(parts, scenario, placed) / stiffness
            parts.add_spring(placed.name, stiffness, boom.damping, empty, neutral)
        if boom.side_stiffness is not None:
            name = placed.name if boom.vertical_stiffness is None else _aside(placed)
            parts.add_spring(name, boom.side_stiffness * boom.length**2, boom.damping, empty, 0.0)


def hang_in_tackles(parts: Parts, scenario: Scenario) -> None:
    """Give luffing ropes the lengths with which they hold each boom, and what hangs at it, at its angle."""
    for placed in scenario.booms.values():
        if placed.tackles is None:
            continue
        kind = (scenario.ropes or {})[placed.tackles.rope]
        assert kind.stiffness is not None  # checked: a luffing rope stretches
        tension = _weight_moment(parts, scenario, placed) / _levers(parts, placed, placed.tackles)
        for rope in parts.ropes:
            if rope["name"] in placed.ropes:
                rope["length"] /= 1 + max(tension, 0.0) / kind.stiffness


def _about_heel(parts: Parts, placed: PlacedBoom, at: Array, force: Array) -> float:
    """Moment of a force at a point about the axis of the heel pins, lifting positive."""
    heel, axes = parts.pose(placed.name)
    return float(axes @ np.array(RISES) @ np.cross(at - heel, force))


def _weight_moment(parts: Parts, scenario: Scenario, placed: PlacedBoom) -> float:
    """What boom, head gear and all that hangs there take to be held [N m]."""
    plumb = np.array((0.0, 0.0, scenario.simulation.gravity))
    carried = [placed.name]
    for name, given in parts.bodies.items():  # parents stand before their children
        if given["parent"] in carried:
            carried.append(name)
    moments = []
    for name in carried:
        body = parts.bodies[name]
        centre = parts.place(name, body["centre_of_gravity"])
        moments.append(_about_heel(parts, placed, centre, body["mass"] * plumb))
    for hook in placed.hooks:
        name = f"{placed.crane}.{hook}"
        pin = parts.place(placed.name, scenario.hooks[name].pin)
        moments.append(_about_heel(parts, placed, pin, mass_on(parts, name) * plumb))
    return math.fsum(moments)


def _levers(parts: Parts, placed: PlacedBoom, tackles: Tackles) -> float:
    """Moment of all parts of line for a tension of 1 N [m]."""
    total = 0.0
    for across in placed.tackles_across:
        head = parts.place(placed.name, (placed.boom.length, across, 0.0))
        top = (tackles.from_[0], placed.heel[1] + across, tackles.from_[2])
        way = parts.place(placed.base, top) - head
        total += tackles.parts * _about_heel(parts, placed, head, way / float(np.linalg.norm(way)))
    return total
