"""The parts of a system while it is put together, and where they are at the start."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np

from gantline.assembly.joints import placed_at_start
from gantline.assembly.spatial import (
    IDENTITY,
    Array,
    inertia_list,
    inertia_matrix,
    unit,
)
from gantline.cad.mass_properties import point_inertia
from gantline.scenario.cranes.drum import RopeOnDrum
from gantline.scenario.curve import energy_stiffness
from gantline.scenario.errors import Doubt, PathPart
from gantline.scenario.gear import RopeMaterial

__all__ = [
    "ORIGIN",
    "Parts",
    "axial_stiffness",
    "box_shape",
    "drum_layers",
    "end",
    "half_turn",
    "material",
    "sheave",
]

ORIGIN = (0.0, 0.0, 0.0)

Json = dict[str, Any]


@dataclass
class Parts:
    """Bodies, flows, ropes, contacts, drives and steps, in the form of the document that the core reads.

    Attributes:
        bodies: bodies by name, parents before their children.
        flows: rope that passes sheaves and leaves drums, and contents of tanks, by name; for the core, joints
            that move no body.
        inertia_from: what the inertia of the flow over a sheave is, in words.
        ropes: ropes in order; a rope with nodes in pieces from node to node.
        rope_names: ropes as the lift file knows them, in the same order.
        nodes: names of the bodies that are nodes of a rope.
        rope_mass: by rope with weight its mass, and what of it the world bears [kg].
        rope_lumps: by rope along a route with weight what of its mass is on which body [kg].
        adjusters: groups of ropes whose lengths are adjusted.
        contacts: contact points in order.
        supports: tops of supports in order.
        rims: of round loads, over the ground.
        landings: posts and walls that guide what lands.
        shapes: shapes by name: the body that each is on and its parts, see `gantline.assembly.shapes`.
        hook_shapes: those of hooks that are watched, for which the name of no crane stands.
        pairs: shapes that may touch.
        watches: distances that are recorded.
        pulls: groups of ropes of which it is recorded when they pull most together.
        forces: of water, wind and mooring lines on bodies, in order.
        sea: waves on the water; None where there are none.
        gusts: what comes on top of the mean speed of the wind; None where nothing does.
        vessels: what should stay upright, and which of their points above the water.
        drives: drives by name.
        compensators: hoists that can compensate heave.
        plan: steps in order.
        emergency_stop: what stops all drives of the plan, and when.
        doubts: what the lift file may have and cannot well mean, in order.
    """

    bodies: dict[str, Json] = field(default_factory=dict)
    flows: dict[str, Json] = field(default_factory=dict)
    inertia_from: dict[str, str] = field(default_factory=dict)
    ropes: list[Json] = field(default_factory=list)
    rope_names: list[str] = field(default_factory=list)
    nodes: set[str] = field(default_factory=set)
    rope_mass: dict[str, tuple[float, float]] = field(default_factory=dict)
    rope_lumps: dict[str, dict[str, float]] = field(default_factory=dict)
    adjusters: list[Json] = field(default_factory=list)
    contacts: list[Json] = field(default_factory=list)
    supports: list[Json] = field(default_factory=list)
    rims: list[Json] = field(default_factory=list)
    landings: list[Json] = field(default_factory=list)
    shapes: dict[str, Json] = field(default_factory=dict)
    hook_shapes: dict[str, Json] = field(default_factory=dict)
    pairs: list[Json] = field(default_factory=list)
    watches: list[Json] = field(default_factory=list)
    pulls: list[Json] = field(default_factory=list)
    forces: list[Json] = field(default_factory=list)
    sea: Json | None = None
    gusts: Json | None = None
    vessels: list[Json] = field(default_factory=list)
    drives: dict[str, Json] = field(default_factory=dict)
    compensators: list[Json] = field(default_factory=list)
    plan: list[Json] = field(default_factory=list)
    emergency_stop: Json | None = None
    doubts: list[Doubt] = field(default_factory=list)

    def doubt(self, path: tuple[PathPart, ...], sentence: str) -> None:
        """Note what cannot well be meant at a path of the lift file."""
        self.doubts.append(Doubt(path, sentence))

    def add_body(
        self,
        name: str,
        joint: Json,
        *,
        parent: str | None = None,
        position: Sequence[float] = ORIGIN,
        orientation: Sequence[float] = IDENTITY,
        mass: float = 0.0,
        centre_of_gravity: Sequence[float] = ORIGIN,
        inertia: Sequence[float] = (0.0,) * 6,
    ) -> None:
        """Add a body on a joint; `position` and `orientation` place the joint in the parent."""
        given = _body(name, joint)
        given |= {"parent": parent, "mass": mass}
        given["placement"] = {"position": list(position), "orientation": list(orientation)}
        given |= {"centre_of_gravity": list(centre_of_gravity), "inertia": list(inertia)}
        self.bodies[name] = given

    @property
    def all_ropes(self) -> list[str]:
        """Ropes as the recording knows them; mooring lines that hang by their weight come last."""
        return [*self.rope_names, *(one["name"] for one in self.forces if one["type"] == "mooring")]

    def add_spring(self, body: str, stiffness: float, share: float, inertia: float, neutral: float) -> None:
        """Hold the joint of a body by a spring: two stops at one place (N3), docs/concepts/stop.md.

        Args:
            body: its name; the joint is a hinge or a slider.
            stiffness: of the spring [N m/rad or N/m].
            share: damping, of the critical one.
            inertia: what that is critical for [kg m^2 or kg].
            neutral: where the spring pushes with nothing [rad or m].
        """
        self.bodies[body]["joint"]["stops"] = {
            "lower": neutral,
            "upper": neutral,
            "stiffness": stiffness,
            "damping_time": 2 * share * math.sqrt(inertia / stiffness),  # 2 zeta/omega
            "loaded": True,
        }

    def add_shape(self, name: str, body: str | None, parts: Sequence[Json]) -> None:
        """Add a shape on a body (None: the world); `gantline.assembly.shapes` says what its parts are."""
        self.shapes[name] = {"name": name, "body": body, "parts": list(parts)}

    def add_flow(self, name: str, inertia: float, **rest: Any) -> None:
        """Add rope that passes a sheave or leaves a drum.

        Args:
            name: name of the flow, in one set with the bodies.
            inertia: mass that moves with the rope [kg].
            rest: `velocity` [m/s], `damping` [N s/m], `brake` [N], `drive`, `capacity` [N], `power` [W],
                `keeps_pull`.
        """
        joint = {"type": "flow", "inertia": inertia, **rest}
        self.flows[name] = _body(name, joint)

    def add_content(self, name: str, body: str, drive: str) -> None:
        """Add the content of a tank of a body as a joint that a drive moves [kg]."""
        self.flows[name] = _body(name, {"type": "content", "drive": drive}) | {"parent": body}

    def add_drive(self, name: str, ramps: Sequence[Json] = ()) -> None:
        """Add a drive, at rest unless `ramps` give its motion in advance."""
        self.drives[name] = {"name": name, "ramps": list(ramps)}

    def add_rope(
        self,
        name: str,
        length: float | None,
        rope_material: Json,
        route: Sequence[Json],
        *,
        is_stretched: bool = False,
    ) -> None:
        """Add a rope with its unstretched length [m]; None is just taut at the start."""
        self.rope_names.append(name)
        spring = {"is_stretched": True} if is_stretched else {}
        self.ropes.append(_rope(name, length, rope_material, route) | spring)

    def add_rope_with_nodes(
        self,
        name: str,
        length: float,
        rope_material: Json,
        ends: Sequence[Json],
        nodes: Sequence[Sequence[float]],
        masses: Sequence[float],
    ) -> None:
        """Add a rope as equal pieces between nodes with mass.

        Pieces are called `<rope>/0`, `<rope>/1`, ..., and the node at the start of piece k `<rope>/k`: like
        the segments of a rope, which have names that no lift file can give.

        Args:
            name: name of the rope.
            length: unstretched length of the whole rope [m].
            rope_material: of every piece.
            ends: its two ends.
            nodes: places at the start, world axes (nodes, 3) [m]; they start at rest.
            masses: mass of each node (nodes,) [kg].
        """
        self.rope_names.append(name)
        guides = [ends[0]]
        for number, (place, mass) in enumerate(zip(nodes, masses, strict=True), start=1):
            node = f"{name}/{number}"
            self.nodes.add(node)
            joint = {"type": "point", "position": list(place), "velocity": [0.0, 0.0, 0.0]}
            self.add_body(node, joint, mass=mass)
            guides.append(end(node))
        guides.append(ends[1])
        part = length / (len(nodes) + 1)
        for number, piece in enumerate(pairwise(guides)):
            self.ropes.append(_rope(f"{name}/{number}", part, rope_material, piece))

    def lump(self, body: str | None, at: Sequence[float], mass: float) -> None:
        """Fix a point mass [kg] at a point of a body frame [m]; on the world it changes nothing.

        The body's frame stays where it is, its centre of gravity and its inertia follow.
        """
        if body is None or mass == 0:
            return
        given = self.bodies[body]
        own, total = given["mass"], given["mass"] + mass
        before, added = np.array(given["centre_of_gravity"]), np.array(at, dtype=np.float64)
        centre = (own * before + mass * added) / total
        inertia = inertia_matrix(given["inertia"])
        inertia = inertia + point_inertia(own, before - centre) + point_inertia(mass, added - centre)
        given["mass"] = total
        given["centre_of_gravity"] = [float(part) for part in centre]
        given["inertia"] = inertia_list(inertia)

    def pose(self, name: str | None) -> tuple[Array, Array]:
        """World position (3,) and rotation matrix (3, 3) of a body frame at the start; None is the world."""
        return placed_at_start(self.bodies, name)

    def place(self, body: str | None, at: Sequence[float]) -> Array:
        """World position (3,) of a point of a body at the start [m]."""
        position, rotation = self.pose(body)
        place: Array = position + rotation @ np.array(at)
        return place

    def contacts_of(self, group: str) -> list[str]:
        """Names of all contacts of a group, in the order of the recording."""
        points = [contact["name"] for contact in self.contacts if contact["group"] == group]
        points += [support["name"] for support in self.supports if support["group"] == group]
        points += [place for pair in self._pairs_of(group) for place in _places(pair)]
        return points + [rim["name"] for rim in self.rims if rim["group"] == group]

    def met_by(self, body: str) -> dict[str, str]:
        """The other body of every contact of a body with one that may move, by the name of the contact."""
        met: dict[str, str] = {}
        for pair in self._pairs_of(body):
            others = {self.shapes[shape]["body"] for shape in pair["shapes"]} - {body, None}
            met |= {place: other for other in others for place in _places(pair)}
        return met

    def _pairs_of(self, group: str) -> list[Json]:
        return [pair for pair in self.pairs if pair["group"] == group]

    def document(self, gravity: float) -> Json:
        """The document for the core; of shapes those that may touch something or are watched."""
        used = {shape for pair in self.pairs for shape in pair["shapes"]}
        used |= {shape for watch in self.watches for side in watch["between"] for shape in side["shapes"]}
        if_there = {
            "forces": self.forces,
            "vessels": self.vessels,
            "supports": self.supports,
            "rims": self.rims,
            "landings": self.landings,
            "shapes": [shape for name, shape in (self.shapes | self.hook_shapes).items() if name in used],
            "pairs": self.pairs,
            "watches": self.watches,
            "pulls": self.pulls,
            "compensators": self.compensators,
        }
        return {
            "gravity": [0.0, 0.0, -gravity],
            "bodies": [*self.bodies.values(), *self.flows.values()],
            "ropes": self.ropes,
            "adjusters": self.adjusters,
            "contacts": self.contacts,
            "drives": list(self.drives.values()),
            "plan": self.plan,
            **({} if self.sea is None else {"sea": self.sea}),
            **({} if self.gusts is None else {"gusts": self.gusts}),
            **({} if self.emergency_stop is None else {"emergency_stop": self.emergency_stop}),
            **{key: given for key, given in if_there.items() if given},
        }


def _body(name: str, joint: Json) -> Json:
    """A body without mass, its joint at the origin of the world."""
    return {
        "name": name,
        "parent": None,
        "placement": {"position": list(ORIGIN), "orientation": list(IDENTITY)},
        "joint": joint,
        "mass": 0.0,
        "centre_of_gravity": list(ORIGIN),
        "inertia": [0.0] * 6,
    }


def _rope(name: str, length: float | None, rope_material: Json, route: Sequence[Json]) -> Json:
    return {"name": name, "length": length, "material": rope_material, "route": list(route)}


def end(
    body: str | None, at: Sequence[float] = ORIGIN, drum: tuple[str, float] | None = None, **rest: Any
) -> Json:
    """An end of a rope on a body (None: the world).

    Args:
        body: what holds the end.
        at: its place in the body's axes [m].
        drum: flow of the drum that pays out here and the rope paid out per unit of it; None is a dead end.
        rest: of a drum `laid_under` [N] and `layers`, where they are not None.
    """
    guide = {"type": "end", "body": body, "at": list(at)}
    if drum is None:
        return guide
    said = {key: value for key, value in rest.items() if value is not None}
    return {**guide, "drum": {"flow": drum[0], "rate": drum[1], **said}}


def box_shape(size: Sequence[float] | Array, centre: Sequence[float] | Array) -> Json:
    """A box of a shape, with its edges along the axes of its body: sizes and middle [m], body frame."""
    return {"type": "box", "size": list(map(float, size)), "centre": list(map(float, centre))}


def drum_layers(drum: RopeOnDrum, diameter: float, rope_diameter: float | None) -> Json | None:
    """Layers of rope on a drum, as `end` takes them; None of one layer without end.

    Args:
        drum: what the lift file says.
        diameter: pitch diameter of the first layer of this rope [m].
        rope_diameter: diameter of the rope, where it is known [m].
    """
    if drum.layers == 1:
        return None
    turns, start = drum.wraps_per_layer, drum.wraps_at_start
    return {"radius": diameter / 2, "step": drum.step(rope_diameter), "turns": turns, "start": start}


def half_turn(
    body: str | None,
    enter: Sequence[float],
    leave: Sequence[float],
    bulge: Sequence[float],
    passing: Json | None = None,
) -> Json:
    """Half a turn over a sheave.

    Args:
        body: what carries the sheave; None is the world.
        enter: where the rope comes on, body axes [m].
        leave: where it goes off [m].
        bulge: side on which it lies.
        passing: what it says of the flow of the rope over the sheave; nothing of an ideal one.
    """
    guide = {
        "type": "half_turn",
        "body": body,
        "enter": list(enter),
        "leave": list(leave),
        "bulge": unit(bulge),
    }
    return guide | (passing or {})


def sheave(
    body: str | None,
    at: Sequence[float],
    axis: Sequence[float],
    radius: float,
    *,
    may_lift_off: bool = False,
) -> Json:
    """A sheave with true tangents; `axis` in body axes, the rope runs about it."""
    return {
        "type": "sheave",
        "body": body,
        "at": list(at),
        "axis": unit(axis),
        "radius": radius,
        "may_lift_off": may_lift_off,
    }


def eye(body: str | None, at: Sequence[float]) -> Json:
    """An eye on a body (None: the world) that the rope slides through."""
    return {"type": "eye", "body": body, "at": list(at)}


def material(kind: RopeMaterial) -> Json:
    """Material of a kind of rope, as the core reads it."""
    if kind.curve is not None:
        points = [list(point) for point in kind.curve.points]
        return {"type": "curved", "points": points, "damping_time": kind.damping_time}
    if kind.stiffness is None:
        return {"type": "inextensible"}
    return {"type": "elastic", "axial_stiffness": kind.stiffness, "damping_time": kind.damping_time}


def axial_stiffness(of: Json) -> float | None:
    """EA [N] of a material, of a curve that of the same energy up to its last point; None if inextensible."""
    if of["type"] == "curved":
        return energy_stiffness(of["points"])
    return float(of["axial_stiffness"]) if of["type"] == "elastic" else None


def _places(pair: Json) -> list[str]:
    """Names of the contacts of a pair of shapes."""
    return [f"{pair['name']}/{place}" for place in range(1, pair["places"] + 1)]
