"""Booms into mechanics: a body on a hinge about the heel pins, and the boxes that pictures show."""

from __future__ import annotations

import math

from gantline.assembly.afloat.gusts import wind_of_limit
from gantline.assembly.afloat.hulls import hull_mesh
from gantline.assembly.cranes.boom_at_rest import RISES, add_what_gives
from gantline.assembly.cranes.reeving import hook_rig
from gantline.assembly.cranes.slewing import add_turned, add_upper
from gantline.assembly.parts import Json, Parts, box_shape, end, eye, material
from gantline.assembly.plan.operations import luff_drive
from gantline.assembly.ropes.rope_weight import lump_rope
from gantline.assembly.ropes.route import route_length
from gantline.assembly.spatial import about_axis
from gantline.scenario import Scenario
from gantline.scenario.cranes.boom import FloatingCrane, PlacedBoom
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.cranes.luffing import Tackles, luffing_drum
from gantline.scenario.rope_weight import rope_weight

__all__ = ["add_booms", "boom_rig", "boom_shape"]

#: Size of a heel pin in pictures [m].
_PIN = 2.0
#: Height of a pedestal in pictures where no hull is below it, over that of the heel pins [1].
_PEDESTAL = 0.3
#: How far a stop gives way under the level boom where the lift file names no stiffness [rad].
_STOP_GIVES = 1e-3
#: Mass that moves with the rope of a drum whose motion is prescribed [kg].
_DRIVEN = 1.0


def add_booms(parts: Parts, scenario: Scenario) -> None:
    """Add every boom, and what bears the heel pins of a floating crane; hooks come later."""
    for name, crane in (scenario.cranes or {}).items():
        if isinstance(crane, FloatingCrane):
            _add_base(parts, name, crane)
    for placed in scenario.booms.values():
        _add_boom(parts, placed, scenario.simulation.gravity)
        if placed.tackles is not None:
            _add_tackles(parts, scenario, placed, placed.tackles)


def _add_base(parts: Parts, name: str, crane: FloatingCrane) -> None:
    """What bears the heel pins: fixed to the vessel or the ground, of one that slews an upper structure."""
    place = crane.position or (0.0, 0.0, 0.0)
    turned = about_axis((0.0, 0.0, 1.0), crane.heading)
    parts.add_body(name, {"type": "fixed"}, parent=crane.vessel, position=place, orientation=turned)
    if crane.slewing_axis is None:
        return
    x, y = crane.slewing_axis
    lumps = [
        (one.mass, (one.at[0] - x, one.at[1] - y, one.at[2])) for one in (crane.upper_masses or {}).values()
    ]
    slew = (crane.slew, crane.slewing)
    add_upper(parts, name, name, (x, y, 0.0), lumps, slew)
    _, axes = parts.pose(name)
    heading = math.atan2(axes[1, 0], axes[0, 0])
    above = [float(part) for part in parts.place(name, (x, y, 0.0))]
    add_turned(parts, name, above, heading, slew)


def _add_boom(parts: Parts, placed: PlacedBoom, gravity: float) -> None:
    boom, drive = placed.boom, None
    if placed.luffing is not None:
        drive = luff_drive(placed.name)
        parts.add_drive(drive)
    hinge: Json = {"type": "fixed"}
    turned = [1.0, 0.0, 0.0, 0.0]
    if placed.luffing is None:
        turned = about_axis(RISES, boom.angle)
    else:
        hinge = {"type": "hinge", "axis": RISES, "position": boom.angle, "velocity": 0.0, "damping": 0.0}
        in_tackles = placed.tackles is not None
        hinge |= {"friction": 0.0, "drive": None if in_tackles else drive}
        hinge |= {"stops": _stops(placed, gravity) if in_tackles else None}
    # Two legs from the heel pins to the head, each of half the mass: along and square to it.
    aside = boom.mass * placed.apart**2 / 12
    across = boom.own_inertia
    parent, place = placed.base, placed.heel
    if boom.gives:
        parts.add_body(placed.told, hinge, parent=parent, position=place, orientation=turned)
        parent, hinge = add_what_gives(parts, placed)
        place, turned = (0.0, 0.0, 0.0), [1.0, 0.0, 0.0, 0.0]
    parts.add_body(
        placed.name,
        hinge,
        parent=parent,
        position=place,
        orientation=turned,
        mass=boom.mass,
        centre_of_gravity=(boom.centre_of_gravity * boom.length, 0.0, 0.0),
        inertia=(aside, across, across + aside, 0.0, 0.0, 0.0),
    )
    parts.lump(placed.name, (boom.length, 0.0, 0.0), boom.head_gear)


def _stops(placed: PlacedBoom, gravity: float) -> Json:
    """Stops at both ends of the range, of a boom that hangs in ropes and may fall onto either."""
    assert placed.luffing is not None and placed.tackles is not None
    boom, (low, high) = placed.boom, placed.luffing.range_
    level = max(boom.mass * gravity, 1.0) * boom.centre_of_gravity * boom.length
    return {
        "lower": low,
        "upper": high,
        "stiffness": placed.tackles.stop_stiffness or max(level, 1.0) / _STOP_GIVES,
        "damping_time": placed.tackles.stop_damping_time,
    }


def _add_tackles(parts: Parts, scenario: Scenario, placed: PlacedBoom, tackles: Tackles) -> None:
    """Every part of line of the tackles, as eyes at their tops and at the boom head, and the drum of all."""
    drum = luffing_drum(placed.name)
    parts.add_flow(drum, _DRIVEN, drive=luff_drive(placed.name))
    kind = (scenario.ropes or {})[tackles.rope]
    weight = rope_weight(kind, tackles.rope_weight, None)
    for name, across in zip(placed.ropes, placed.tackles_across, strict=True):
        top = (placed.base, (tackles.from_[0], placed.heel[1] + across, tackles.from_[2]))
        head = (placed.name, (placed.boom.length, across, 0.0))
        along = [head if part % 2 else top for part in range(tackles.parts, -1, -1)]
        (ends_on, at), (x, y, z) = along[0], top[1]
        route = [end(ends_on, at), *(eye(*place) for place in along[1:])]
        # Each part gets shorter by what the drive counts.
        route.append(end(placed.base, (x, y, z - tackles.lead_line), (drum, -float(tackles.parts))))
        length = route_length(parts, route)
        parts.add_rope(name, length, material(kind), route)
        lump_rope(parts, name, weight, length, route)


def boom_shape(scenario: Scenario, body: str) -> Json | None:
    """Boxes for pictures: a boom with its head, or the heel pins."""
    for placed in scenario.booms.values():
        if body == placed.name:
            return _boom(placed)
        if body == placed.base:
            x, y, z = placed.heel
            pins = [(x, y + side * placed.apart / 2, z) for side in (-1.0, 1.0)]
            boxes = [box_shape((_PIN, _PIN, _PIN), pin) for pin in pins]
            return {
                "type": "boxes",
                "boxes": boxes + _platform(scenario, placed) + _a_frame(scenario, placed),
            }
    return None


def _boom(placed: PlacedBoom) -> Json:
    length = placed.boom.length
    thick = placed.boom.section_depth
    width = placed.boom.section_width(placed.apart)
    places: dict[tuple[float, float], float] = {(0.0, 0.0): 0.0}  # along and above: half of the row there
    for hook in placed.hooks.values():
        at = hook.along, hook.above
        places[at] = max(places.get(at, 0.0), abs(hook.across))
    boxes = [box_shape((length, width, thick), (length / 2, 0.0, 0.0))]
    for (along, above), row in places.items():
        boxes.append(box_shape((thick, 2 * row + thick, thick), (length + along, 0.0, above)))
        boxes += _jib(length, along, above, thick)
    return {"type": "boxes", "boxes": boxes}


def _jib(length: float, along: float, above: float, thick: float) -> list[Json]:
    """What bears hooks beyond the head or beside the boom: a post square to it, and what goes on outwards."""
    foot = length + min(along, 0.0)
    post = box_shape((thick, thick, abs(above)), (foot, 0.0, above / 2))
    arm = box_shape((along, thick, thick), (length + along / 2, 0.0, above))
    return [*([post] if above else []), *([arm] if along > 0.0 else [])]


def _platform(scenario: Scenario, placed: PlacedBoom) -> list[Json]:
    """A platform from the heel pins to under the A-frame, and the pedestal that it slews on."""
    if placed.slew is None:
        return []
    x, y, z = placed.heel
    top = z - 1.5 * _PIN
    deck = _deck_below(scenario, placed, 0.0, 0.0)
    foot = top - _PEDESTAL * z if deck is None else min(deck, top)
    high = top - foot
    wide = max(abs(x), _PIN)
    behind = wide if placed.tackles is None else max(wide, _PIN / 2 - placed.tackles.from_[0])
    floor = box_shape((x + behind, placed.apart, _PIN), ((x - behind) / 2, y, z - _PIN))
    return [floor, *([box_shape((wide, wide, high), (0.0, 0.0, top - high / 2))] if high > 0.0 else [])]


def _deck_below(scenario: Scenario, placed: PlacedBoom, x: float, y: float) -> float | None:
    """How high the hull goes below a place in the axes of what bears a boom [m]; None where there is none."""
    crane = (scenario.cranes or {})[placed.crane]
    if not isinstance(crane, FloatingCrane) or crane.vessel is None:
        return None
    mesh = hull_mesh(scenario, crane.vessel, (scenario.vessels or {})[crane.vessel])
    ahead, left = crane.slewing_axis or (0.0, 0.0)
    return None if mesh is None else mesh.top_at(ahead + x, left + y)


def _a_frame(scenario: Scenario, placed: PlacedBoom) -> list[Json]:
    """Two posts up to the top from which tackles pull, from the platform or the deck, and what joins them."""
    if placed.tackles is None:
        return []
    (x, y, z), middle = placed.tackles.from_, placed.heel[1]
    posts = []
    for side in sorted({2 * middle - y, y}):
        low = placed.heel[2]
        if placed.slew is not None:
            low -= _PIN / 2
        elif (deck := _deck_below(scenario, placed, x, side)) is not None:
            low = min(low, deck)
        posts.append(box_shape((_PIN, _PIN, z - low), (x, side, (z + low) / 2)))
    return [*posts, box_shape((_PIN, 2 * abs(y - middle) + _PIN, _PIN), (x, middle, z))]


def boom_rig(scenario: Scenario, parts: Parts) -> list[Json]:
    """What results need to know of booms [SI]."""
    return [
        {
            "name": placed.crane,
            "boom": placed.name,
            "base": placed.base,
            "vessel": _vessel_of(scenario, placed),
            "ropes": placed.ropes,
            "parts": 0 if placed.tackles is None else placed.tackles.parts,
            "range": None if placed.luffing is None else list(placed.luffing.range_),
            "reach_from": list(placed.reach_from),
            "base_from": [-value for value in parts.bodies[placed.base]["centre_of_gravity"]],
            "wind_limit": _wind_limit(scenario, placed),
            "wind": wind_of_limit(scenario, boom_top(parts, placed)),
            "hooks": [hook_rig(parts, scenario.hooks[f"{placed.crane}.{hook}"]) for hook in placed.hooks],
            **_slew_rig(placed),
        }
        for placed in scenario.booms.values()
    ]


def boom_top(parts: Parts, placed: PlacedBoom) -> float:
    """How high a boom goes when it is upright, z of the world [m]."""
    return float(parts.place(placed.base, placed.heel)[2]) + placed.boom.length


def _vessel_of(scenario: Scenario, placed: PlacedBoom) -> str:
    crane = (scenario.cranes or {})[placed.crane]
    return crane.vessel or "" if isinstance(crane, FloatingCrane) else ""


def _wind_limit(scenario: Scenario, placed: PlacedBoom) -> float | None:
    crane = (scenario.cranes or {})[placed.crane]
    return crane.wind_limit if isinstance(crane, Crawler | FloatingCrane) else None


def _slew_rig(placed: PlacedBoom) -> Json:
    """What results need to know of how a boom slews, of one that is on an upper structure."""
    if placed.slew is None:
        return {}
    return {"slew": {"joint": placed.base, "at_start": placed.slew[0], "slews": placed.slew[1] is not None}}
