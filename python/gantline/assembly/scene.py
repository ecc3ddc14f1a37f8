"""What is needed to draw a lift: bodies with shapes, sheaves, ropes, ground and water."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence

import numpy as np

from gantline.assembly.afloat.hulls import hull_mesh, hull_shape
from gantline.assembly.afloat.vessels import vessel_shape
from gantline.assembly.cranes.boom import boom_shape
from gantline.assembly.cranes.compensators import compensator_shapes
from gantline.assembly.cranes.crawler import crawler_shape
from gantline.assembly.cranes.goliath import crane_shape
from gantline.assembly.cranes.reeving import ReevedHook, reeved_hooks, upper_sheaves
from gantline.assembly.joints import translates
from gantline.assembly.loads.guides import guide_shape, guide_structures, stand_shape
from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.loads.supports import every_support, support_contact
from gantline.assembly.parts import Json, Parts, box_shape
from gantline.assembly.shapes import frame_shape, load_parts, members, round_boxes, spreader_shape
from gantline.assembly.spatial import Array
from gantline.assembly.yard import lower_end
from gantline.cad.assumptions import STEEL
from gantline.scenario import Rigging, Scenario
from gantline.scenario.afloat.tanks import bodies_afloat
from gantline.scenario.afloat.water import Water
from gantline.scenario.cranes.compensator import gas_rope, rod_of
from gantline.scenario.cranes.crane_parts import crane_bodies
from gantline.scenario.extension import ends_below
from gantline.scenario.loads.guide import guide_body, guide_stand
from gantline.scenario.loads.structures import CylinderStructure, Dock, dock_of
from gantline.scenario.mechanics import Body

__all__ = ["scene"]


def scene(scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None, parts: Parts) -> Json:
    """What is needed to draw the system: bodies with shapes, sheaves, kinds of ropes, the ground."""
    # Of the parts that no lift file names nodes have no shape, nor has what only bears others.
    tops = {upper_sheaves(hook) for hook in scenario.hooks}
    gases = {gas_rope(name) for name in scenario.compensators or {}}
    return {
        "bodies": [
            _body(scenario, rigging, lifted, body)
            for name, body in parts.bodies.items()
            if "/" not in name or name in tops
        ],
        "sheaves": [*_sheaves(parts), *_extension_sheaves(scenario, rigging, lifted, parts)],
        "ropes": [{"name": rope, "kind": _rope_kind(rope, rigging, gases)} for rope in parts.all_ropes],
        "contacts": [{key: one[key] for key in ("name", "body", "at")} for one in parts.contacts],
        "ground": _ground(scenario),
        **({"water": {"level": level}} if (level := _water_level(scenario)) is not None else {}),
        **({"structures": structures} if (structures := _structures(scenario, parts)) else {}),
        "axes": None,
    }


def _ground(scenario: Scenario) -> Json | None:
    """Level of the ground, and the hole in it where there is a dock."""
    if scenario.ground is None:
        return None
    level, dock = scenario.ground.level, dock_of(scenario)
    if dock is None:
        return {"level": level}
    return {"level": level, "holes": [{"x": list(dock.x), "y": list(dock.y), "floor": dock.floor}]}


def _water_level(scenario: Scenario) -> float | None:
    """Level of the water [m]; None in a lift on dry land."""
    if scenario.water is None and all(body.hull is None for body in bodies_afloat(scenario).values()):
        return None
    return (scenario.water or Water()).level


def _structures(scenario: Scenario, parts: Parts) -> list[Json]:
    """What stands in the world, of boxes: supports by their contacts, guides, all that is no hole."""
    shapes = {
        (name, "structure"): [
            {"parts": round_boxes(structure)}
            if isinstance(structure, CylinderStructure)
            else parts.shapes[shape]
            for shape in members(parts.shapes, name)
        ]
        for name, structure in (scenario.structures or {}).items()
        if scenario.ground is None or not isinstance(structure, Dock)
    }
    shapes |= {
        (support_contact(support), "support"): [parts.shapes[support.name]]
        for _, support in every_support(scenario)
    }
    boxes = [
        {"name": name, "kind": kind, "boxes": [box for one in given for box in one["parts"]]}
        for (name, kind), given in shapes.items()
    ]
    return boxes + guide_structures(scenario)


def _body(scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None, body: Json) -> Json:
    """A body with what stands for it."""
    name = body["name"]
    shape: Json | None = None
    kind = "body"
    load = scenario.load
    plain = scenario.mechanics.bodies.get(name) if scenario.mechanics is not None else None
    of_gear = _gear(scenario)
    if load is not None and lifted is not None and name == load.name:
        kind = "load"
        shape = _load_shape(lifted)
    elif name in rigging.equalizers:
        kind = "frame"
        shape = frame_shape(rigging.equalizers[name].frame)
    elif name in (scenario.spreaders or {}):
        kind, shape = "frame", spreader_shape(scenario, name)
    elif name in of_gear:
        kind, shape = of_gear[name]
    elif name in scenario.hooks:
        kind = "hook"
        shape = next((_cheek(scenario, hook) for hook in reeved_hooks(scenario) if hook.name == name), None)
    elif name in map(upper_sheaves, scenario.hooks):
        kind = "body"
    elif name in crane_bodies(scenario.cranes or {}):
        shape = crane_shape(scenario, name) or crawler_shape(scenario, name) or boom_shape(scenario, name)
    elif name in (scenario.vessels or {}):
        kind, shape = "hull", vessel_shape(scenario, name)
    elif name in (scenario.hinges or {}):
        kind = "hinge"
    elif plain is None:
        kind = "sheave"
    else:
        kind, shape = _plain_shape(scenario, name, plain)
    return {"name": name, "kind": kind, "shape": shape, "centre_of_gravity": list(body["centre_of_gravity"])}


def _gear(scenario: Scenario) -> dict[str, tuple[str, Json]]:
    """Kind and shape of cylinders, rods and both parts of landing guides, by their bodies."""
    found = dict[str, tuple[str, Json]]()
    for name, compensator in (scenario.compensators or {}).items():
        cylinder, rod = compensator_shapes(compensator)
        found |= {name: ("frame", cylinder), rod_of(name): ("body", rod)}
    for name, guide in (scenario.guides or {}).items():
        found |= {
            guide_body(name): ("body", guide_shape(guide)),
            guide_stand(name): ("body", stand_shape(guide)),
        }
    return found


def _plain_shape(scenario: Scenario, name: str, plain: Body) -> tuple[str, Json | None]:
    """Kind and shape of a body of `mechanics`; one without a shape in the lift file is a cube of steel."""
    if plain.shape is not None:
        return "body", box_shape(plain.shape.box, plain.shape.centre)
    if plain.hull is not None:
        hull = hull_mesh(scenario, name, plain)
        return "hull", None if hull is None else hull_shape(hull)
    side = (plain.mass / STEEL) ** (1 / 3)
    return "body", box_shape([side] * 3, plain.centre_of_gravity) if plain.mass > 0.0 else None


def _load_shape(lifted: LiftedLoad) -> Json:
    """A box, or a CAD file's light mesh with the corners of its contact hull, to a millimetre."""
    body = lifted.body
    if body.mesh is None:
        return load_parts(lifted)[0]
    return {
        "type": "mesh",
        "vertices": np.round(body.mesh.vertices - lifted.centre, 3).tolist(),
        "triangles": body.mesh.triangles.tolist(),
        "hull": np.round(body.hull - lifted.centre, 3).tolist(),
    }


def _cheek(scenario: Scenario, hook: ReevedHook) -> Json:
    """A plate of a hook block, for pictures: from the bearing up to its sheaves, half as wide as they are."""
    rope = (scenario.ropes or {})[hook.reeving.rope]
    width, height = hook.reeving.diameter(rope.diameter) / 2, hook.hook_block.height
    return box_shape((width, width, height), (0.0, 0.0, height / 2))


def _sheaves(parts: Parts) -> list[Json]:
    """Every half turn and sheave of a rope on a body; it moves if its body has translations of its own.

    Those of the world are not drawn: pictures have places on bodies alone.
    """
    found = []
    for rope in parts.ropes:
        for guide in rope["route"]:
            if guide["body"] is None:
                continue
            if guide["type"] == "sheave":
                found.append(_sheave(parts, guide["body"], guide["at"], guide["axis"], guide["radius"]))
            if guide["type"] != "half_turn":
                continue
            enter, leave = np.array(guide["enter"]), np.array(guide["leave"])
            axis = np.cross(guide["bulge"], leave - enter)
            centre, radius = (enter + leave) / 2, math.dist(guide["enter"], guide["leave"]) / 2
            found.append(_sheave(parts, guide["body"], centre, axis / np.linalg.norm(axis), radius))
    return found


def _extension_sheaves(
    scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None, parts: Parts
) -> list[Json]:
    """Extension sheaves, each in the upright plane of the lugs that it serves."""
    found = []
    for name, extension in rigging.extensions.items():
        assert lifted is not None  # slings have been checked to lead to lugs
        one, other = (
            np.mean(
                [
                    parts.place(guide["body"], guide["at"])
                    for at_lug in ends_below(end, rigging.extensions, rigging.slings)
                    for guide in [lower_end(scenario, lifted.lugs, at_lug)]
                ],
                axis=0,
            )
            for end in rigging.slings[extension.carries].ends
        )
        way = other - one
        across = np.array([-way[1], way[0], 0.0])
        size = float(np.linalg.norm(across))
        axis = across / size if size > 0 else np.array([0.0, 1.0, 0.0])
        found.append(_sheave(parts, name, np.zeros(3), axis, extension.pitch_diameter / 2))
    return found


def _sheave(
    parts: Parts, body: str, centre: Sequence[float] | Array, axis: Sequence[float] | Array, radius: float
) -> Json:
    moves = translates(parts.bodies[body]["joint"])
    return {
        "body": body,
        "centre": [float(part) for part in centre],
        "axis": [float(part) for part in axis],
        "radius": radius,
        "kind": "moving" if moves else "fixed",
    }


def _rope_kind(name: str, rigging: Rigging, gases: Collection[str]) -> str:
    if name.startswith("sling.") and name[len("sling.") :] in rigging.slings:
        return "sling"
    if name in [f"{equalizer}.equalizing" for equalizer in rigging.equalizers]:
        return "equalizing"
    return "gas" if name in gases else "rope"
