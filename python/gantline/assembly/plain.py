"""The section `mechanics` into mechanics, one to one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from gantline.assembly.parts import Json, Parts, drum_layers, end, eye, half_turn, material, sheave
from gantline.assembly.ropes.rope_weight import add_free_rope, lump_rope
from gantline.assembly.ropes.route import most_strain, route_length, route_lengths, too_far
from gantline.assembly.ropes.sheave import add_sheave_flow
from gantline.assembly.spatial import IDENTITY, about_axis, unit
from gantline.scenario import Scenario
from gantline.scenario.cranes.drum import Drum
from gantline.scenario.errors import Doubt
from gantline.scenario.gear import RopeMaterial
from gantline.scenario.mechanics import (
    Ball,
    Body,
    BodyInertia,
    Eye,
    Fixed,
    HalfTurn,
    HingeJoint,
    HingeStops,
    Joint,
    Mechanics,
    MechanicsRope,
    Point,
    RopeEnd,
    Rotation,
    Sheave,
    Slider,
    SliderStops,
)
from gantline.scenario.rope_weight import rope_weight
from gantline.scenario.sheave import sheave_losses
from gantline.units import format_by_size, format_quantity

__all__ = [
    "add_mechanics",
    "bodies_in_hook",
    "drum_drive",
    "ropes_at_lugs",
    "ropes_ending_at",
    "ropes_over",
    "ropes_tied_to",
]

_WORLD = "world"
_ROUNDING = 1e-9
#: With how many times the weight of all bodies a contact may push at the start: at rest none bears more than
#: all of it, and what falls on one starts outside.
_MOST_PUSH = 10.0
#: That weight counts without gravity too [m/s^2].
_GRAVITY = 9.81


def add_mechanics(parts: Parts, scenario: Scenario) -> None:
    """Add plain bodies, drums, ropes and contacts.

    Raises:
        ScenarioError: if a rope is too short for its route at the start, or cannot hang there.
    """
    mechanics = scenario.mechanics
    if mechanics is None:
        return
    for name in _parents_first(mechanics):
        _add_body(parts, name, mechanics.bodies[name])
    for name, drum in (mechanics.drums or {}).items():
        _add_drum(parts, name, drum)
    for name, rope in (mechanics.ropes or {}).items():
        _add_rope(parts, scenario, name, rope)
    for name, contact in (mechanics.contacts or {}).items():
        parts.contacts.append(
            {
                "name": name,
                "group": contact.group or contact.body,
                "body": contact.body,
                "at": list(contact.at),
                "plane_point": list(contact.plane.point),
                "plane_normal": list(contact.plane.normal),
                "stiffness": contact.stiffness,
                "damping_time": contact.damping / contact.stiffness,
                "friction": contact.friction,
            }
        )
    if not scenario.starts_at_rest:
        parts.doubts += _thrown_out(parts, mechanics)


def _thrown_out(parts: Parts, mechanics: Mechanics) -> Iterator[Doubt]:
    """Each contact that starts so far behind its plane that its body is shot out."""
    weight = _GRAVITY * sum(body["mass"] for body in parts.bodies.values())
    for name, contact in (mechanics.contacts or {}).items():
        way = parts.place(contact.body, contact.at) - np.array(contact.plane.point)
        depth = -float(way @ np.array(unit(contact.plane.normal)))
        push = contact.stiffness * depth
        if push > _MOST_PUSH * weight:
            far = f"starts {format_quantity(depth, 'mm', 1)} behind its plane"
            held = f"pushes with {format_by_size(push, 'force', 3)}, where all bodies weigh"
            sentence = (
                f"{far} and {held} {format_by_size(weight, 'force', 3)}; it starts at its plane or outside"
            )
            yield Doubt(("mechanics", "contacts", name), sentence)


def bodies_in_hook(scenario: Scenario, hook: str) -> list[str]:
    """Bodies of `mechanics` that hang in a hook by a joint."""
    bodies = scenario.mechanics.bodies if scenario.mechanics is not None else {}
    return [name for name, body in bodies.items() if body.parent == hook]


def ropes_ending_at(scenario: Scenario, body: str) -> list[list[str]]:
    """Ropes of `mechanics` that end at a body, each with which of its ends does: `first` or `last`."""
    ropes = (scenario.mechanics.ropes if scenario.mechanics is not None else None) or {}
    return [
        [name, end]
        for name, rope in ropes.items()
        for end, guide in (("first", rope.route[0]), ("last", rope.route[-1]))
        if guide.body == body
    ]


def ropes_at_lugs(scenario: Scenario) -> dict[str, list[list[str]]]:
    """Ropes of `mechanics` made fast to lugs of the load, by these, each with which of its ends is.

    One that comes back to its lug is there twice.
    """
    ropes = (scenario.mechanics.ropes if scenario.mechanics is not None else None) or {}
    found: dict[str, list[list[str]]] = {}
    for name, rope in ropes.items():
        for which, guide in (("first", rope.route[0]), ("last", rope.route[-1])):
            if isinstance(guide, RopeEnd) and guide.lug is not None:
                found.setdefault(guide.lug, []).append([name, which])
    return found


def ropes_tied_to(scenario: Scenario, body: str) -> dict[str, str]:
    """Ropes of `mechanics` that no drum hauls from a body to what stands, and to what of it.

    That is the world, a vessel, or a body that is fixed to one of these, as a grillage on a deck.
    """
    ropes = (scenario.mechanics.ropes if scenario.mechanics is not None else None) or {}
    tied = {}
    for name, which in ropes_ending_at(scenario, body):
        own, other = ropes[name].route[0], ropes[name].route[-1]
        if which == "last":
            own, other = other, own
        is_hauled = any(isinstance(one, RopeEnd) and one.drum is not None for one in (own, other))
        if not is_hauled and _stands(scenario, other.body):
            tied[name] = other.body
    return tied


def _stands(scenario: Scenario, body: str) -> bool:
    """Whether a body is the world or a vessel, or fixed to one of these."""
    bodies = (scenario.mechanics.bodies if scenario.mechanics is not None else None) or {}
    while body in bodies and isinstance(bodies[body].joint, Fixed):
        body = bodies[body].parent or _WORLD
    return body == _WORLD or body in (scenario.vessels or {})


def ropes_over(scenario: Scenario, body: str) -> list[Json]:
    """Ropes of `mechanics` that run over a body: name, place along the route, and which guides are arcs."""
    ropes = (scenario.mechanics.ropes if scenario.mechanics is not None else None) or {}
    return [
        {
            "rope": name,
            "place": place,
            "arcs": [isinstance(one, HalfTurn | Sheave) for one in rope.route],
        }
        for name, rope in ropes.items()
        for place, guide in enumerate(rope.route[1:-1], start=1)
        if guide.body == body
    ]


def drum_drive(drum: str) -> str:
    """Name of the drive that turns a drum as the plan says."""
    return f"{drum}.drive"


def _add_drum(parts: Parts, name: str, drum: Drum) -> None:
    """A drum is a flow: the rope that it has paid out, on its own diameter."""
    drive = None
    if drum.motion is not None:
        drive = f"{name}.motion"
        parts.add_drive(drive, [_ramp(ramp) for ramp in drum.motion])
    elif drum.drive is not None:
        drive = drum_drive(name)
        parts.add_drive(drive)
    motor = {}
    if drum.drive is not None and drum.drive.capacity is not None:
        motor = {"capacity": drum.drive.capacity, "power": drum.drive.power}
    brake = drum.brake or 0.0
    rest = {"velocity": drum.velocity, "damping": drum.damping, "brake": brake, "drive": drive, **motor}
    parts.add_flow(name, drum.inertia, **rest)


def _add_rope(parts: Parts, scenario: Scenario, name: str, rope: MechanicsRope) -> None:
    kind = (scenario.ropes or {})[rope.rope]
    mechanics = scenario.mechanics
    drums = mechanics.drums if mechanics is not None else None
    route = _route(parts, scenario, drums or {}, name, rope, kind)
    length = None if isinstance(rope.length, str) else rope.length
    # Where the rope touches sheaves with true tangents, and so how long it is, is the core's to say.
    if not any(guide["type"] == "sheave" for guide in route):
        routed = route_length(parts, route)
        allowed = _ROUNDING if kind.inextensible else most_strain(kind)
        if length is not None and not rope.stretched and routed > length * (1 + allowed):
            sentence = f"the rope is {length:g} m, but its route has {routed:.9g} m at the start"
            advice = "make it longer, or write 'length: as_routed'"
            if not kind.inextensible:
                sentence += f": {too_far(routed, length, most_strain(kind))}"
                advice += ", or 'stretched: true' for a spring"
            raise scenario.start_error(("mechanics", "ropes", name, "length"), f"{sentence}; {advice}")
        if routed < _ROUNDING:
            raise scenario.start_error(
                ("mechanics", "ropes", name, "route"), "has no length; its ends are in one place"
            )
    weight = rope_weight(kind, rope.rope_weight, rope.rope_nodes)
    lump_rope(parts, name, weight, length, route)
    if weight.nodes:
        known = routed if length is None else length
        add_free_rope(parts, scenario, ("mechanics", "ropes", name), name, kind, weight, known, route)
    else:
        made_of = material(kind)
        parts.add_rope(name, length, made_of, route, is_stretched=rope.stretched)


def _parents_first(mechanics: Mechanics) -> list[str]:
    """Names of the bodies, each after its parent; otherwise in the order of the file."""
    order: list[str] = []
    for name in mechanics.bodies:
        line: list[str] = []
        current: str | None = name
        while current is not None and current in mechanics.bodies and current not in order:
            line.append(current)
            current = mechanics.bodies[current].parent
        order.extend(reversed(line))
    return order


def _add_body(parts: Parts, name: str, body: Body) -> None:
    parts.add_body(
        name,
        _joint(parts, name, body.joint),
        parent=None if body.parent in (None, _WORLD) else body.parent,
        position=body.at,
        orientation=_quaternion(body.orientation),
        mass=body.mass,
        centre_of_gravity=body.centre_of_gravity,
        inertia=_inertia(body.inertia),
    )


def _inertia(inertia: BodyInertia | None) -> Sequence[float]:
    if inertia is None:
        return (0.0,) * 6
    return (inertia.xx, inertia.yy, inertia.zz, inertia.xy, inertia.xz, inertia.yz)


def _quaternion(rotation: Rotation | None) -> list[float]:
    return list(IDENTITY) if rotation is None else about_axis(rotation.about, rotation.angle)


def _joint(parts: Parts, name: str, joint: Joint) -> Json:
    if isinstance(joint, Fixed):
        return {"type": "fixed"}
    if isinstance(joint, (HingeJoint, Slider)):
        drive = None
        if joint.motion is not None:
            drive = f"{name}.motion"
            parts.add_drive(drive, [_ramp(ramp) for ramp in joint.motion])
        return {
            "type": joint.type,
            "axis": list(joint.axis),
            "position": joint.position,
            "velocity": joint.velocity,
            "damping": joint.damping,
            "friction": joint.friction,
            "drive": drive,
            "stops": _stops(joint.stops),
        }
    if isinstance(joint, Ball):
        turning = list(joint.angular_velocity)
        return {"type": "ball", "orientation": _quaternion(joint.orientation), "angular_velocity": turning}
    if isinstance(joint, Point):
        return {"type": "point", "position": list(joint.position), "velocity": list(joint.velocity)}
    return {
        "type": "free",
        "position": list(joint.position),
        "orientation": _quaternion(joint.orientation),
        "velocity": list(joint.velocity),
        "angular_velocity": list(joint.angular_velocity),
    }


def _stops(stops: HingeStops | SliderStops | None) -> Json | None:
    if stops is None:
        return None
    damping_time = stops.damping / stops.stiffness
    return {
        "lower": stops.lower,
        "upper": stops.upper,
        "stiffness": stops.stiffness,
        "damping_time": damping_time,
        "loaded": stops.loaded,
    }


def _ramp(ramp: Any) -> Json:
    return {"at": ramp.at, "duration": ramp.duration, "velocity": ramp.velocity, "shape": ramp.shape}


def _route(
    parts: Parts,
    scenario: Scenario,
    drums: Mapping[str, Drum],
    name: str,
    rope: MechanicsRope,
    kind: RopeMaterial,
) -> list[Json]:
    """Guides of a rope; sheaves count from 1 along it, and those that are not ideal have a flow.

    Raises:
        ScenarioError: if the rope does not lie on one that is not ideal.
    """
    route: list[Json] = []
    for guide in rope.route:
        body = None if guide.body == _WORLD else guide.body
        if isinstance(guide, RopeEnd):
            route.append(_end(body, guide, drums, kind))
        elif isinstance(guide, Sheave):
            lifts = guide.may_lift_off
            route.append(sheave(body, guide.at, guide.axis, guide.radius, may_lift_off=lifts))
        elif isinstance(guide, Eye):
            route.append(eye(body, guide.at))
        else:
            route.append(half_turn(body, guide.enter, guide.leave, guide.bulge))
    _, arcs = route_lengths(parts, route)
    for place, guide in enumerate(rope.route):
        if isinstance(guide, HalfTurn | Sheave):
            losses = sheave_losses(guide, guide.radius, kind.mass_per_length, wrap=arcs[place] / guide.radius)
            # Nothing would move where it slips, and one that is seized would hold any tension.
            if arcs[place] == 0 and not losses.is_ideal:
                raise scenario.start_error(
                    ("mechanics", "ropes", name, "route", place),
                    "the rope does not lie on this sheave at the start, as on one with losses or inertia it "
                    "has to; turn 'axis' round if it runs the other way (more than 270° cannot be said)",
                )
            route[place] |= add_sheave_flow(parts, f"{name}/sheave_{place}", losses)
    return route


def _end(body: str | None, guide: RopeEnd, drums: Mapping[str, Drum], kind: RopeMaterial) -> Json:
    """A dead end, or a drum with the rope that it pays out there per unit of its flow."""
    if guide.drum is None:
        return end(body, guide.at)
    drum = drums[guide.drum]
    diameter = guide.drum_diameter or drum.diameter
    rate = diameter / drum.diameter
    layers = drum_layers(drum, diameter, kind.diameter)
    flow = (guide.drum, -rate if guide.wound == "against" else rate)
    return end(body, guide.at, flow, laid_under=drum.wound_under, layers=layers)
