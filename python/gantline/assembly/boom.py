"""Booms into mechanics: a body on a hinge about the heel pins, and the boxes that pictures show."""

from __future__ import annotations

from gantline.assembly.operations import luff_drive
from gantline.assembly.parts import Json, Parts
from gantline.assembly.reeving import hook_rig
from gantline.assembly.spatial import about_axis
from gantline.scenario import Scenario
from gantline.scenario.boom import FloatingCrane, PlacedBoom

__all__ = ["add_booms", "boom_rig", "boom_shape"]

#: The axis about which a boom rises, axes of its base: to starboard.
_UP = [0.0, -1.0, 0.0]
#: Sizes that pictures have where the lift file names none: a boom over its length, a heel pin [m].
_THICK = 0.03
_PIN = 2.0


def add_booms(parts: Parts, scenario: Scenario) -> None:
    """Add every boom, and what bears the heel pins of a floating crane; hooks come later."""
    for name, crane in (scenario.cranes or {}).items():
        if isinstance(crane, FloatingCrane):
            place = crane.position or (0.0, 0.0, 0.0)
            turned = about_axis((0.0, 0.0, 1.0), crane.heading)
            fixed = {"type": "fixed"}
            parts.add_body(name, fixed, parent=crane.vessel, position=place, orientation=turned)
    for placed in scenario.booms.values():
        _add_boom(parts, placed)


def _add_boom(parts: Parts, placed: PlacedBoom) -> None:
    boom, drive = placed.boom, None
    if placed.luffing is not None:
        drive = luff_drive(placed.name)
        parts.add_drive(drive)
    hinge: Json = {"type": "fixed"}
    turned = [1.0, 0.0, 0.0, 0.0]
    if drive is None:
        turned = about_axis(_UP, boom.angle)
    else:
        hinge = {"type": "hinge", "axis": _UP, "position": boom.angle, "velocity": 0.0, "damping": 0.0}
        hinge |= {"friction": 0.0, "drive": drive, "stops": None}
    # Two legs from the heel pins to the head, each of half the mass: along and square to it.
    aside = boom.mass * placed.apart**2 / 12
    across = boom.own_inertia
    parts.add_body(
        placed.name,
        hinge,
        parent=placed.base,
        position=placed.heel,
        orientation=turned,
        mass=boom.mass,
        centre_of_gravity=(boom.centre_of_gravity * boom.length, 0.0, 0.0),
        inertia=(aside, across, across + aside, 0.0, 0.0, 0.0),
    )
    parts.lump(placed.name, (boom.length, 0.0, 0.0), boom.head_gear)


def boom_shape(scenario: Scenario, body: str) -> Json | None:
    """Boxes for pictures: a boom with its head, or the heel pins."""
    for placed in scenario.booms.values():
        if body == placed.name:
            return _boom(placed)
        if body == placed.base:
            x, y, z = placed.heel
            pins = [(x, y + side * placed.apart / 2, z) for side in (-1.0, 1.0)]
            return {"type": "boxes", "boxes": [_box((_PIN, _PIN, _PIN), pin) for pin in pins]}
    return None


def _boom(placed: PlacedBoom) -> Json:
    length = placed.boom.length
    thick = _THICK * length
    row = max(abs(hook.across) for hook in placed.hooks.values())
    boxes = [
        _box((length, max(placed.apart / 2, thick), thick), (length / 2, 0.0, 0.0)),
        _box((thick, 2 * row + thick, thick), (length, 0.0, 0.0)),
    ]
    return {"type": "boxes", "boxes": boxes}


def _box(size: tuple[float, float, float], centre: tuple[float, float, float]) -> Json:
    return {"type": "box", "size": list(size), "centre": list(centre)}


def boom_rig(scenario: Scenario, parts: Parts) -> list[Json]:
    """What results need to know of booms [SI]."""
    return [
        {
            "name": placed.crane,
            "boom": placed.name,
            "base": placed.base,
            "range": None if placed.luffing is None else list(placed.luffing.range_),
            "reach_from": list(placed.reach_from),
            "base_from": [-value for value in parts.bodies[placed.base]["centre_of_gravity"]],
            "hooks": [hook_rig(parts, scenario.hooks[f"{placed.crane}.{hook}"]) for hook in placed.hooks],
        }
        for placed in scenario.booms.values()
    ]
