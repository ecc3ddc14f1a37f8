"""What results, checks and drawings need to know of a lift: `rig` and `scene`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from gantline.assembly.boom import boom_rig, boom_shape
from gantline.assembly.catenary import end_mass
from gantline.assembly.checked import bends, limits_and_rules, rating_charts, ratings
from gantline.assembly.crawler import crawler_rig, crawler_shape
from gantline.assembly.goliath import crane_rig, crane_shape
from gantline.assembly.hulls import hull_mesh, hull_shape
from gantline.assembly.lifted import LiftedLoad
from gantline.assembly.moorings import mooring_rig
from gantline.assembly.operations import moved_drives
from gantline.assembly.parts import Json, Parts
from gantline.assembly.reeving import (
    ReevedHook,
    falls_on_upper_sheaves,
    reeved_hooks,
    upper_sheaves,
)
from gantline.assembly.shapes import members, watch_name
from gantline.assembly.sheave import spin_of
from gantline.assembly.spatial import Array
from gantline.assembly.supports import every_support, support_contact
from gantline.assembly.vessels import vessel_rig, vessel_shape
from gantline.assembly.yard import upper_lump
from gantline.scenario import Rigging, Scenario
from gantline.scenario.bounds import Bound
from gantline.scenario.crane_parts import crane_bodies
from gantline.scenario.drum import Drum
from gantline.scenario.extension import lugs_below
from gantline.scenario.gear import RopeMaterial, Shackle
from gantline.scenario.load import PLATE_NORMALS
from gantline.scenario.mechanics import RopeEnd
from gantline.scenario.mooring import line_rope
from gantline.scenario.parting import partings
from gantline.scenario.reeving import HoistDrum, hoist_drum
from gantline.scenario.rigging import EqualizerRigging, SlingRigging
from gantline.scenario.rope_weight import RopeWeight, rope_weight
from gantline.scenario.steps import HoldStep, MovingStep, PumpStep
from gantline.scenario.structures import Dock, dock_of
from gantline.scenario.tanks import bodies_afloat, ends_of_pump, tanks_of
from gantline.scenario.water import Water

__all__ = ["rig", "rope_kinds", "scene"]

#: Joints with translations of their own: a sheave on such a body is a moving sheave.
_MOVING = ("slider", "point", "free")


def rig(scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None, parts: Parts) -> Json:
    """Who carries whom, and what is allowed; SI."""
    head = scenario.lift
    return {
        "title": head.title,
        "number": head.number,
        "revision": head.revision,
        "remark": head.remark,
        "gravity": scenario.simulation.gravity,
        "loads": [_load(scenario, lifted, parts)] if lifted is not None else [],
        **({"vessels": vessels} if (vessels := vessel_rig(scenario, parts)) else {}),
        **mooring_rig(scenario),
        **({"cranes": cranes} if (cranes := crane_rig(scenario, parts)) else {}),
        **({"booms": booms} if (booms := boom_rig(scenario, parts)) else {}),
        **({"crawlers": crawlers} if (crawlers := crawler_rig(scenario, parts)) else {}),
        **({"rating_charts": charts} if (charts := rating_charts(scenario)) else {}),
        "hooks": [_hook(scenario, rigging, name, parts) for name in scenario.hooks],
        "equalizers": [_equalizer(scenario, rigging, name) for name in rigging.equalizers],
        "slings": [_sling(scenario, rigging, sling) for sling in rigging.slings.values()],
        "ropes": _ropes(scenario, rigging, parts),
        "sheaves": _sheaves_with_flow(parts),
        "drums": _drums(scenario),
        **_tanks(scenario),
        "wrapped_sheaves": (wrapped := _wrapped_sheaves(parts)),
        "ratings": ratings(scenario),
        "bends": bends(scenario, parts),
        **limits_and_rules(scenario, rigging, has_sheaves=bool(wrapped)),
        **_equalised_below(scenario),
        "plan": [_step(scenario, step) for step in scenario.plan],
        **_supports_and_watches(scenario),
    }


def _supports_and_watches(scenario: Scenario) -> Json:
    """Supports with what they bear, and pairs that are watched; nothing in a lift without."""
    supports = [
        {
            "name": support_contact(support),
            "group": support.group,
            "load": group.under,
            "capacity": _force(scenario, support.capacity),
            "removed_at": support.removed_at,
        }
        for group, support in every_support(scenario)
    ]
    watches = [
        {"name": watch_name(watch), "between": list(watch.between), "smallest": watch.smallest}
        for watch in scenario.watch
    ]
    return {key: given for key, given in (("supports", supports), ("watches", watches)) if given}


def _force(scenario: Scenario, mass: float | None) -> float | None:
    return None if mass is None else mass * scenario.simulation.gravity


def _load(scenario: Scenario, lifted: LiftedLoad, parts: Parts) -> Json:
    load = scenario.load
    assert load is not None
    body = parts.bodies[load.name]
    # Ropes of `mechanics` may have been lumped on it: that moves its centre of gravity, not its frame.
    centre = lifted.centre + np.array(body["centre_of_gravity"])
    contacts = parts.contacts_of(load.name)
    return {
        "name": load.name,
        "body": load.name,
        "weight": _force(scenario, body["mass"]),
        "simulated_mass": load.weight.simulated,
        "calculated_mass": load.weight.calculated,
        "contingency": load.weight.contingency,
        "design_mass": load.weight.design,
        "contact_group": load.name if contacts else None,
        "contacts": contacts,
        "lugs": {
            name: {
                "at": lifted.lugs[name],
                "main_plate_normal": list(PLATE_NORMALS[kind.main_plate or "xz"]),
                "capacity": _force(scenario, kind.capacity),
            }
            for name, lug in load.lugs.items()
            for kind in [lug.or_of((scenario.lug_types or {}).get(lug.type or ""))]
        },
        "centre_of_gravity_from_datum": [float(part) for part in centre],
        "centre_envelope": [float(part) for part in load.centre_of_gravity.envelope],
    }


def _hook(scenario: Scenario, rigging: Rigging, name: str, parts: Parts) -> Json:
    hook = scenario.hooks[name]
    bearing = [equalizer.name for equalizer in rigging.equalizers.values() if equalizer.hook == name]
    direct = [s for s in rigging.slings.values() if s.equalizer is None and s.hook == name]
    reeved = next((one for one in reeved_hooks(scenario) if one.name == name), None)
    falls: Json = {}
    if reeved is not None:
        gravity = scenario.simulation.gravity
        hung = reeved.reeving.parts_each
        above = falls_on_upper_sheaves(parts, scenario, reeved) * gravity
        falls = {
            "falls": [f"{rope}/{part}" for rope in reeved.ropes for part in range(hung)],
            "falls_weight_above": above,
            "direct_slings": [sling.name for sling in direct],
            "direct_weight": sum(upper_lump(sling) for sling in direct) * gravity,
        }
    elif direct:
        bearing = [name]  # the hook's own joint carries its slings, their shackles and its equalizers
    return {
        "name": name,
        "crane": hook.crane,
        "bearing_joints": bearing,
        "direct_slings": [],
        "rated_capacity": _force(scenario, hook.rated_capacity),
        "rating_includes_hook_block": hook.rating_includes_hook_block,
        "hoist_weight_extra": hook.hook_block_mass * scenario.simulation.gravity,
        "drive_body": name,
        **falls,
    }


def _equalizer(scenario: Scenario, rigging: Rigging, name: str) -> Json:
    equalizer = rigging.equalizers[name]
    hanging = [sling for sling in rigging.slings.values() if sling.equalizer == name]
    return {
        "name": name,
        "hook": equalizer.hook,
        "body": name,
        "mechanism": equalizer.mechanism,
        "adjusting_factor": equalizer.adjusting_factor,
        "equalizing_rope": f"{name}.equalizing" if equalizer.has_sheaves else "",
        "slings": [f"sling.{sling.name}" for sling in sorted(hanging, key=lambda sling: sling.sheave or 0)],
        "moving_sheaves": _sheaves_of(equalizer),
        "travel_up": equalizer.travel.up,
        "travel_down": equalizer.travel.down,
        "stops": equalizer.travel.stops,
        "locked": _locked(equalizer),
        "rated_capacity": _force(scenario, equalizer.rated_capacity),
        "heading_joint": name,
    }


def _sheaves_of(equalizer: EqualizerRigging) -> list[str]:
    return [f"{equalizer.name}.{place + 1}" for place in range(len(equalizer.moving_sheaves.along))]


def _locked(equalizer: EqualizerRigging) -> list[str]:
    """Moving sheaves that pins hold at the start: all, none, or those that are counted out."""
    locked = equalizer.travel.locked
    if isinstance(locked, bool):
        return _sheaves_of(equalizer) if locked else []
    return [f"{equalizer.name}.{place}" for place in sorted(locked)]


def _sling(scenario: Scenario, rigging: Rigging, sling: SlingRigging) -> Json:
    assert scenario.load is not None
    equalizer = None if sling.equalizer is None else rigging.equalizers[sling.equalizer]
    hangs_from_frame = equalizer is not None and not equalizer.has_sheaves
    # A sling to one lug is the rule; others say to which lugs they go, if to any.
    is_plain = sling.over is None and len(sling.lugs) == 1
    others = {} if is_plain else {"over": sling.over, "lugs": [end.lug for end in sling.ends]}
    return {
        "name": sling.name,
        "rope": f"sling.{sling.name}",
        "from": sling.equalizer if hangs_from_frame else sling.upper_body,
        "to_load": scenario.load.name if sling.lugs else None,
        "to_lug": sling.lugs[0] if is_plain else None,
        **others,
        "length": sling.length,
        "tolerance": sling.tolerance,
        "minimum_breaking_force": sling.rope.breaking_force,
        "shackles": {
            end: _shackle(scenario, *given)
            for end, given in (("top", sling.top), ("bottom", sling.bottom))
            if given is not None
        },
        "segment": f"sling.{sling.name}/0",
    }


def rope_kinds(scenario: Scenario, rigging: Rigging) -> dict[str, tuple[RopeMaterial, RopeWeight]]:
    """Every rope of the lift by its name: its kind, and how its weight acts."""
    kinds = {
        f"{name}.equalizing": (one.rope, one.weight)
        for name, one in rigging.equalizers.items()
        if one.has_sheaves
    }
    kinds |= {f"sling.{name}": (sling.rope, sling.weight) for name, sling in rigging.slings.items()}
    for hook in reeved_hooks(scenario):
        kind = (scenario.ropes or {})[hook.reeving.rope]
        weight = rope_weight(kind, hook.reeving.rope_weight, None)
        kinds |= dict.fromkeys(hook.ropes, (kind, weight))
    for placed in scenario.booms.values():
        if placed.tackles is not None:
            kind = (scenario.ropes or {})[placed.tackles.rope]
            weight = rope_weight(kind, placed.tackles.rope_weight, None)
            kinds |= dict.fromkeys(placed.ropes, (kind, weight))
    for name, line in (scenario.mooring_lines or {}).items():
        kind = (scenario.ropes or {})[line.rope]
        # A catenary's weight is its own; it is no body's mass.
        kinds[line_rope(name)] = kind, RopeWeight("none", 0.0, 0)
    plain = scenario.mechanics.ropes if scenario.mechanics is not None else None
    for name, rope in (plain or {}).items():
        kind = (scenario.ropes or {})[rope.rope]
        kinds[name] = kind, rope_weight(kind, rope.rope_weight, rope.rope_nodes)
    return kinds


def _ropes(scenario: Scenario, rigging: Rigging, parts: Parts) -> list[Json]:
    """Every rope of the lift with what is known of it."""
    parting = partings(scenario)
    return [
        {
            "name": name,
            "construction": kind.construction,
            "diameter": kind.diameter,
            "axial_stiffness": kind.stiffness,
            "mass_per_length": weight.mass_per_length,
            "minimum_breaking_force": kind.breaking_force,
            "breaks_at": parting[name].breaks_at,
            "weight": weight.way,
            "mass": mass,
            "mass_on_world": on_world,
            "nodes": weight.nodes,
            "end_mass": end_mass(mass, weight.nodes) if weight.nodes else None,
        }
        for name, (kind, weight) in rope_kinds(scenario, rigging).items()
        for mass, on_world in [parts.rope_mass.get(name, (0.0, 0.0))]
    ]


def _sheaves_with_flow(parts: Parts) -> list[Json]:
    """Every sheave that is not ideal, in the order of ropes and routes."""
    return [
        {
            "name": guide["flow"],
            "rope": rope["name"],
            "segments": [f"{rope['name']}/{place - 1}", f"{rope['name']}/{place}"],
            "ratio": guide.get("ratio"),
            "groove_friction": guide["groove"]["friction"] if "groove" in guide else None,
            "spins": spin_of(guide["flow"]) in parts.flows,
            "inertia": _inertia_of(parts, guide["flow"]),
            "inertia_from": parts.inertia_from[guide["flow"]],
        }
        for rope in parts.ropes
        for place, guide in enumerate(rope["route"])
        if "flow" in guide
    ]


def _inertia_of(parts: Parts, flow: str) -> float:
    """Mass of what turns with the rope over a sheave, or moves with it over one that does not turn [kg]."""
    spin = spin_of(flow)
    inertia: float = parts.flows[spin if spin in parts.flows else flow]["joint"]["inertia"]
    return inertia


def _drums(scenario: Scenario) -> list[Json]:
    plain = scenario.mechanics.drums if scenario.mechanics is not None else None
    ropes = scenario.ropes or {}
    on_drums = {
        guide.drum: ropes[rope.rope].diameter
        for rope in ((scenario.mechanics.ropes if scenario.mechanics is not None else None) or {}).values()
        for guide in rope.route
        if isinstance(guide, RopeEnd) and guide.drum is not None
    }
    drums = [_drum(name, drum, 1.0, on_drums.get(name)) for name, drum in (plain or {}).items()]
    for hook in reeved_hooks(scenario):
        paid_out = -float(hook.reeving.parts_each)
        drums.append(_drum(hoist_drum(hook.name), hook.drum, paid_out, ropes[hook.reeving.rope].diameter))
    return drums


def _drum(name: str, drum: Drum | HoistDrum, paid_out: float, rope_diameter: float | None) -> Json:
    return {
        "name": name,
        "diameter": drum.diameter,
        "paid_out": paid_out,
        "wraps_at_start": drum.wraps_at_start,
        "wraps_per_layer": drum.wraps_per_layer,
        "layers": drum.layers,
        "layer_step": drum.step(rope_diameter),
        "spare_turns": drum.spare_turns,
    }


def _tanks(scenario: Scenario) -> Json:
    """Tanks with what is in them at the start; nothing in a lift without."""
    tanks = [
        {"name": name, "content": tank.content, "capacity": tank.capacity}
        for name, tank in tanks_of(scenario).items()
    ]
    return {"tanks": tanks} if tanks else {}


def _shackle(scenario: Scenario, name: str, shackle: Shackle) -> Json:
    return {
        "name": name,
        "working_load_limit": _force(scenario, shackle.working_load_limit),
        "minimum_breaking_force": shackle.minimum_breaking_force,
        "proof_load": shackle.proof_load,
        "bow_diameter": shackle.bow_diameter,
        "pin_diameter": shackle.pin_diameter,
    }


def _wrapped_sheaves(parts: Parts) -> list[Json]:
    """Sheaves with true tangents, named as in recordings."""
    return [
        {
            "name": f"{rope['name']}/sheave_{place}",
            "rope": rope["name"],
            "may_lift_off": guide["may_lift_off"],
        }
        for rope in parts.ropes
        for place, guide in enumerate(rope["route"])
        if guide["type"] == "sheave"
    ]


def _equalised_below(scenario: Scenario) -> Json:
    """The tension spread by which the time to equalise is counted, if the lift file says it; no limit."""
    bound = None if scenario.limits is None else scenario.limits.equalised_below
    return {} if bound is None else {"equalised_below": bound}


def _step(scenario: Scenario, step: Any) -> Json:
    kind = "hold" if isinstance(step, HoldStep) else step.verb
    require = {}
    if step.require is not None:
        for measure in type(step.require).model_fields:
            bound = getattr(step.require, measure)
            if isinstance(bound, Bound):
                require[measure] = {bound.relation: bound.value}
    return {
        "step": step.step,
        "kind": kind,
        "drives": moved_drives(scenario, step),
        "report": list(step.report),
        "require": require,
        **_pumped(scenario, step),
        "speed": step.speed if isinstance(step, MovingStep) else None,
        "pull_pins": list(step.pull_pins),
        "put_in_pins": list(step.put_in_pins),
    }


def _pumped(scenario: Scenario, step: Any) -> Json:
    if not isinstance(step, PumpStep):
        return {}
    return {"tanks": [name for name in ends_of_pump(scenario, step) if name is not None]}


def scene(scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None, parts: Parts) -> Json:
    """What is needed to draw the system: bodies with shapes, sheaves, kinds of ropes, the ground."""
    # Of the parts that no lift file names nodes have no shape, nor has what only bears others.
    tops = {upper_sheaves(hook) for hook in scenario.hooks}
    return {
        "bodies": [
            _body(scenario, rigging, lifted, body)
            for name, body in parts.bodies.items()
            if "/" not in name or name in tops
        ],
        "sheaves": [*_sheaves(parts), *_extension_sheaves(scenario, rigging, lifted, parts)],
        "ropes": [{"name": rope, "kind": _rope_kind(rope, rigging)} for rope in parts.all_ropes],
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
    """What stands in the world, of boxes: supports by their contacts, and what is no hole in the ground."""
    shapes = {
        (name, "structure"): [parts.shapes[shape] for shape in members(parts.shapes, name)]
        for name, structure in (scenario.structures or {}).items()
        if scenario.ground is None or not isinstance(structure, Dock)
    }
    shapes |= {
        (support_contact(support), "support"): [parts.shapes[support.name]]
        for _, support in every_support(scenario)
    }
    return [
        {"name": name, "kind": kind, "boxes": [box for one in given for box in one["parts"]]}
        for (name, kind), given in shapes.items()
    ]


def _body(scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None, body: Json) -> Json:
    name = body["name"]
    shape: Json | None = None
    kind = "body"
    load = scenario.load
    plain = scenario.mechanics.bodies.get(name) if scenario.mechanics is not None else None
    if load is not None and lifted is not None and name == load.name:
        kind = "load"
        shape = _load_shape(lifted)
    elif name in rigging.equalizers:
        kind = "frame"
        frame = rigging.equalizers[name].frame
        size = [frame.length, frame.width, frame.height]
        shape = {"type": "box", "size": size, "centre": [0.0, 0.0, -frame.centre_of_gravity_below_hook]}
    elif name in scenario.hooks:
        kind = "hook"
        shape = next((_cheek(scenario, hook) for hook in reeved_hooks(scenario) if hook.name == name), None)
    elif name in map(upper_sheaves, scenario.hooks):
        kind = "body"
    elif name in crane_bodies(scenario.cranes or {}):
        shape = crane_shape(scenario, name) or crawler_shape(scenario, name) or boom_shape(scenario, name)
    elif name in (scenario.vessels or {}):
        kind, shape = "hull", vessel_shape(scenario, name)
    elif plain is None:
        kind = "sheave"
    elif plain.shape is not None:
        shape = {"type": "box", "size": list(plain.shape.box), "centre": list(plain.shape.centre)}
    elif plain.hull is not None:
        hull = hull_mesh(scenario, name, plain)
        kind, shape = "hull", None if hull is None else hull_shape(hull)
    return {"name": name, "kind": kind, "shape": shape, "centre_of_gravity": list(body["centre_of_gravity"])}


def _load_shape(lifted: LiftedLoad) -> Json:
    """A box, or a CAD file's light mesh with the corners of its contact hull, to a millimetre."""
    body = lifted.body
    if body.mesh is None:
        size, middle = body.box[1] - body.box[0], body.box.mean(axis=0) - lifted.centre
        return {"type": "box", "size": size.tolist(), "centre": middle.tolist()}
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
    return {"type": "box", "size": [width, width, height], "centre": [0.0, 0.0, height / 2]}


def _sheaves(parts: Parts) -> list[Json]:
    """Every half turn and sheave of a rope on a body; it moves if its body has translations of its own."""
    found = []
    for rope in parts.ropes:
        for guide in rope["route"]:
            if guide["type"] == "sheave" and guide["body"] is not None:
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
        assert scenario.load is not None and lifted is not None  # slings have been checked to lead to lugs
        one, other = (
            np.mean([lifted.lugs[lug] for lug in lugs_below(end, rigging.extensions, rigging.slings)], axis=0)
            for end in rigging.slings[extension.carries].ends
        )
        way = parts.pose(scenario.load.name)[1] @ (other - one)
        across = np.array([-way[1], way[0], 0.0])
        size = float(np.linalg.norm(across))
        axis = across / size if size > 0 else np.array([0.0, 1.0, 0.0])
        found.append(_sheave(parts, name, np.zeros(3), axis, extension.pitch_diameter / 2))
    return found


def _sheave(
    parts: Parts, body: str, centre: Sequence[float] | Array, axis: Sequence[float] | Array, radius: float
) -> Json:
    moves = parts.bodies[body]["joint"]["type"] in _MOVING
    return {
        "body": body,
        "centre": [float(part) for part in centre],
        "axis": [float(part) for part in axis],
        "radius": radius,
        "kind": "moving" if moves else "fixed",
    }


def _rope_kind(name: str, rigging: Rigging) -> str:
    if name.startswith("sling.") and name[len("sling.") :] in rigging.slings:
        return "sling"
    if name in [f"{equalizer}.equalizing" for equalizer in rigging.equalizers]:
        return "equalizing"
    return "rope"
