"""What results and checks need to know of ropes, sheaves and drums."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gantline.assembly.cranes.compensators import gas_kind
from gantline.assembly.cranes.reeving import reeved_hooks
from gantline.assembly.parts import Json, Parts
from gantline.assembly.ropes.catenary import end_mass
from gantline.assembly.ropes.sheave import spin_of
from gantline.scenario import Rigging, Scenario
from gantline.scenario.afloat.mooring import line_rope, weight_on_nodes
from gantline.scenario.cranes.compensator import gas_rope
from gantline.scenario.cranes.drum import Drum
from gantline.scenario.cranes.reeving import HoistDrum, hoist_drum
from gantline.scenario.gear import RopeMaterial
from gantline.scenario.mechanics import RopeEnd
from gantline.scenario.plan.parting import partings
from gantline.scenario.rope_weight import RopeWeight, rope_weight
from gantline.scenario.tag_line import tag_rope

__all__ = ["drum_rig", "rope_kinds", "rope_rig", "sheaves_with_flow", "wrapped_sheaves"]


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
    for name, compensator in (scenario.compensators or {}).items():
        kinds[gas_rope(name)] = gas_kind(compensator)[1], RopeWeight("none", 0.0, 0)
    for name, line in (scenario.mooring_lines or {}).items():
        kind = (scenario.ropes or {})[line.rope]
        kinds[line_rope(name)] = kind, weight_on_nodes(line, kind)
    for name, tag in (scenario.tag_lines or {}).items():
        kinds[tag_rope(name)] = (scenario.ropes or {})[tag.rope], RopeWeight("none", 0.0, 0)
    plain = scenario.mechanics.ropes if scenario.mechanics is not None else None
    for name, rope in (plain or {}).items():
        kind = (scenario.ropes or {})[rope.rope]
        kinds[name] = kind, rope_weight(kind, rope.rope_weight, rope.rope_nodes)
    return kinds


def rope_rig(scenario: Scenario, rigging: Rigging, parts: Parts) -> list[Json]:
    """Every rope of the lift with what is known of it."""
    parting = partings(scenario)
    over_eyes = _over_eyes(scenario, parts)
    kinds = rope_kinds(scenario, rigging)
    # A rope that is simulated and not known here would be held against no breaking force, without a word.
    assert set(parts.rope_names) <= set(kinds)
    lengths = _of_constant_length(rigging, parts)
    plain = scenario.mechanics.ropes if scenario.mechanics is not None else None
    come_free = {name for name, rope in (plain or {}).items() if rope.comes_free}
    # What stands for the gas of a compensator is no rope that could break.
    gases = {gas_rope(name) for name in scenario.compensators or {}}
    return [
        {
            "name": name,
            "construction": kind.construction,
            "diameter": kind.diameter,
            "axial_stiffness": kind.stiffness,
            **({} if kind.curve is None else {"curve": kind.curve.points}),
            **({"length": lengths[name]} if name in lengths else {}),
            "mass_per_length": weight.mass_per_length,
            "minimum_breaking_force": kind.breaking_force,
            "breaks_at": parting[name].breaks_at,
            "weight": weight.way,
            "mass": mass,
            "mass_on_world": on_world,
            "nodes": weight.nodes,
            "end_mass": end_mass(mass, weight.nodes) if weight.nodes else None,
            **({"over_eyes": True} if name in over_eyes else {}),
            **({"comes_free": True} if name in come_free else {}),
        }
        for name, (kind, weight) in kinds.items()
        if name not in gases
        for mass, on_world in [parts.rope_mass.get(name, (0.0, 0.0))]
    ]


def _of_constant_length(rigging: Rigging, parts: Parts) -> dict[str, float]:
    """Unstretched lengths [m] of ropes straight from end to end that no drum feeds, but for slings."""
    slings = {f"sling.{name}" for name in rigging.slings}
    return {
        rope["name"]: float(rope["length"])
        for rope in parts.ropes
        if rope["name"] not in slings
        and rope.get("length") is not None
        and len(rope["route"]) == 2
        and not any(guide.get("drum") for guide in rope["route"])
    }


def _over_eyes(scenario: Scenario, parts: Parts) -> set[str]:
    """Ropes that bend about eyes of whose diameter nothing is said, luffing tackles among them."""
    known = {
        rope
        for placed in scenario.booms.values()
        if placed.tackles is not None and placed.tackles.sheave_diameter is not None
        for rope in placed.ropes
    }
    over = {rope["name"] for rope in parts.ropes if any(on["type"] == "eye" for on in rope["route"])}
    return over - known


def sheaves_with_flow(parts: Parts) -> list[Json]:
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


def wrapped_sheaves(parts: Parts) -> list[Json]:
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


def drum_rig(scenario: Scenario) -> list[Json]:
    """Every drum of the lift, those of hoists too."""
    plain = scenario.mechanics.drums if scenario.mechanics is not None else None
    ropes = scenario.ropes or {}
    drums = []
    for name, drum in (plain or {}).items():
        lying = _lying_on(scenario, name, drum)
        own = _parts_of_drum(name, drum, 1.0, lying["with"] or {drum.diameter: _Lying()})
        if lying["against"]:  # it pays out what the others haul in, and has turns of its own
            if not lying["with"]:
                own[-1] |= {"wraps_at_start": None, "first_sheave": None, "asks_for_turns": False}
            own += _parts_of_drum(_wound_against(name), drum, -1.0, lying["against"], name)
        if drum.rated_capacity is not None:
            rated = drum.rated_capacity * scenario.simulation.gravity
            own = [part | {"rated_capacity": rated} for part in own]
        drums += own
    for hook in reeved_hooks(scenario):
        paid_out, rope_diameter = -float(hook.reeving.parts_each), ropes[hook.reeving.rope].diameter
        name, on = hoist_drum(hook.name), hook.drum.diameter
        drums.append(_drum(name, hook.drum, on, paid_out, rope_diameter))
    return drums


@dataclass(frozen=True)
class _Lying:
    """Ropes on one diameter of a drum: names, which end of each, and the diameter of the thickest [m]."""

    ropes: tuple[str, ...] = ()
    ends: tuple[str, ...] = ()
    diameter: float | None = None


def _lying_on(scenario: Scenario, name: str, drum: Drum) -> dict[str, dict[float, _Lying]]:
    """The ropes on a drum by the pitch diameters on which they lie [m], either way round."""
    kinds = scenario.ropes or {}
    ropes = (scenario.mechanics.ropes if scenario.mechanics is not None else None) or {}
    lying: dict[str, dict[float, _Lying]] = {"with": {}, "against": {}}
    for rope, given in ropes.items():
        for place, guide in enumerate(given.route):
            if isinstance(guide, RopeEnd) and guide.drum == name:
                on, on_it = guide.drum_diameter or drum.diameter, lying[guide.wound or "with"]
                others, end = on_it.get(on, _Lying()), "last" if place else "first"
                known = [one for one in (others.diameter, kinds[given.rope].diameter) if one is not None]
                on_it[on] = _Lying((*others.ropes, rope), (*others.ends, end), max(known, default=None))
    return lying


def _parts_of_drum(
    name: str, drum: Drum, way: float, lying: Mapping[float, _Lying], flow: str = ""
) -> list[Json]:
    """What a drum pays out, one for each diameter on which rope lies: all have its turns, and other ways.

    That on its own diameter, or else the first, has the name.
    """
    main = drum.diameter if drum.diameter in lying else next(iter(lying))
    rest = [one for one in lying if one != main]
    named = {main: (name, flow)} | {one: (_on_diameter(name, one), flow or name) for one in rest}
    return [
        _drum(called, drum, on, way * on / drum.diameter, lying[on].diameter)
        | {"flow": of, "ropes": list(lying[on].ropes), "ends": list(lying[on].ends)}
        for on, (called, of) in named.items()
    ]


def _wound_against(drum: str) -> str:
    """Name of what lies on a drum the other way round; with a stroke, which no name of a lift file has."""
    return f"{drum}/against"


def _on_diameter(name: str, diameter: float) -> str:
    """Name of what lies on another diameter of a drum [m] than that of the drum."""
    return f"{name}/{1e3 * diameter:.10g} mm"


def _drum(
    name: str, drum: Drum | HoistDrum, diameter: float, paid_out: float, rope_diameter: float | None
) -> Json:
    return {
        "name": name,
        "diameter": diameter,
        "paid_out": paid_out,
        "wraps_at_start": drum.wraps_at_start,
        "wraps_per_layer": drum.wraps_per_layer,
        "layers": drum.layers,
        "layer_step": drum.step(rope_diameter),
        "first_sheave": drum.first_sheave,
        "rope_diameter": rope_diameter,
        "spare_turns": drum.spare_turns,
        "asks_for_turns": "spare_turns" in drum.model_fields_set,
    }
