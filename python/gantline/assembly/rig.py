"""What results and checks need to know of a lift: who carries whom, and what is allowed."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from gantline.assembly.afloat.gusts import wind_of_limit, wind_rig
from gantline.assembly.afloat.moorings import mooring_rig
from gantline.assembly.afloat.vessels import vessel_rig
from gantline.assembly.checked import bends, limits_and_rules, rating_charts, ratings
from gantline.assembly.cranes.boom import boom_rig
from gantline.assembly.cranes.chain_hoists import chain_hoist_rig
from gantline.assembly.cranes.compensators import hung_mass
from gantline.assembly.cranes.crawler import crawler_rig
from gantline.assembly.cranes.falls_twist import twist_of_falls
from gantline.assembly.cranes.goliath import crane_rig
from gantline.assembly.cranes.lifting import lifting_by_mechanics
from gantline.assembly.cranes.reeving import falls_on_upper_sheaves, reeved_hooks
from gantline.assembly.loads.guides import guide_rig
from gantline.assembly.loads.hinges import hinge_rig
from gantline.assembly.loads.in_water import in_water_name
from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.loads.supports import every_support, support_contact
from gantline.assembly.parts import Json, Parts
from gantline.assembly.plain import bodies_in_hook, ropes_at_lugs, ropes_ending_at, ropes_over, ropes_tied_to
from gantline.assembly.plan.operations import moved_drives
from gantline.assembly.plan.ranges import range_rig
from gantline.assembly.plan.waits import waited_for
from gantline.assembly.ropes.rope_rig import drum_rig, rope_rig, sheaves_with_flow, wrapped_sheaves
from gantline.assembly.ropes.tag_lines import tag_rig
from gantline.assembly.shapes import watch_name, watched_hook
from gantline.assembly.yard import turning_body, upper_lump
from gantline.scenario import Rigging, Scenario
from gantline.scenario.afloat.tanks import SEA, ends_of_pump, load_tanks, tanks_of
from gantline.scenario.afloat.water import Water
from gantline.scenario.cranes.compensator import gas_rope, rod_of
from gantline.scenario.cranes.crane import FixedHook
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.cranes.reeving import hoist_drum
from gantline.scenario.gear import Shackle
from gantline.scenario.loads.lug import Lug
from gantline.scenario.plan.bounds import Bound
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.parting import steps_that_cut
from gantline.scenario.plan.steps import AlongStep, HoldStep, MovingStep, PumpStep
from gantline.scenario.rigging import EqualizerRigging, SlingRigging

__all__ = ["rig"]


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
        **({} if parts.sea is None else {"sea": {**parts.sea, "trains": _wave_trains(scenario)}}),
        **wind_rig(scenario, parts.gusts),
        **_current(scenario),
        **({"vessels": vessels} if (vessels := vessel_rig(scenario, parts)) else {}),
        **mooring_rig(scenario),
        **tag_rig(scenario),
        **guide_rig(scenario),
        **hinge_rig(scenario, None if lifted is None else lifted.centre),
        **({"cranes": cranes} if (cranes := crane_rig(scenario, parts)) else {}),
        **({"booms": booms} if (booms := boom_rig(scenario, parts)) else {}),
        **({"crawlers": crawlers} if (crawlers := crawler_rig(scenario, parts)) else {}),
        **range_rig(scenario),
        **({"rating_charts": charts} if (charts := rating_charts(scenario)) else {}),
        "hooks": [_hook(scenario, rigging, name, parts) for name in scenario.hooks],
        "equalizers": [_equalizer(scenario, rigging, name, parts) for name in rigging.equalizers],
        **({"spreaders": spreaders} if (spreaders := _spreaders(scenario, parts)) else {}),
        **({"compensators": compensators} if (compensators := _compensators(scenario, parts)) else {}),
        "slings": [_sling(scenario, rigging, sling) for sling in rigging.slings.values()],
        **chain_hoist_rig(scenario, rigging),
        "ropes": rope_rig(scenario, rigging, parts),
        "sheaves": sheaves_with_flow(parts),
        "drums": (drums := drum_rig(scenario)),
        "turning": [name for name, body in parts.bodies.items() if body["joint"]["type"] == "hinge"],
        **_tanks(scenario),
        "wrapped_sheaves": (wrapped := wrapped_sheaves(parts)),
        "ratings": ratings(scenario),
        **({"lifting_by_mechanics": lifting} if (lifting := lifting_by_mechanics(scenario, rigging)) else {}),
        "bends": bends(scenario, parts),
        **limits_and_rules(scenario, rigging, _led(wrapped, drums)),
        **_equalised_below(scenario),
        "plan": [_step(scenario, step) for step in scenario.plan],
        **_starts_off(rigging),
        **_supports_and_watches(scenario, parts),
    }


def _starts_off(rigging: Rigging) -> Json:
    """Ropes of the slings that a step puts on; nothing in a lift without."""
    later = [f"sling.{name}" for name, sling in rigging.slings.items() if not sling.starts_on]
    return {"starts_off": later} if later else {}


def _supports_and_watches(scenario: Scenario, parts: Parts) -> Json:
    """Supports with what they bear, pairs that are watched or touch, what stands about; nothing without."""
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
        {
            "name": watch_name(watch),
            "between": [watched_hook(parts, scenario, name) or name for name in watch.between],
            "smallest": watch.smallest,
            **{key: step for key in ("from_step", "to_step") if (step := getattr(watch, key)) is not None},
        }
        for watch in scenario.watch
    ]
    contacts = (scenario.mechanics and scenario.mechanics.body_contacts) or {}
    touching = [list(contact.between) for contact in contacts.values()]
    parts_of_it = (
        *(("supports", supports), ("watches", watches)),
        *(("touching", touching), ("fixtures", _fixtures(scenario))),
    )
    return {key: given for key, given in parts_of_it if given}


def _fixtures(scenario: Scenario) -> list[str]:
    """Bodies of `mechanics` with a shape that stand still on the world, a vessel or another hull."""
    bodies = {} if scenario.mechanics is None else scenario.mechanics.bodies

    def stands(name: str | None) -> bool:
        if name is None or name in (scenario.vessels or {}):
            return True
        body = bodies.get(name)
        if body is None or body.hull is not None:
            return body is not None
        return body.joint.type == "fixed" and stands(body.parent)

    return [name for name, body in bodies.items() if body.shape and body.hull is None and stands(name)]


def _force(scenario: Scenario, mass: float | None) -> float | None:
    return None if mass is None else mass * scenario.simulation.gravity


def _wave_trains(scenario: Scenario) -> list[Json]:
    return [
        {
            "name": name,
            "direction": train.direction,
            "height": train.main_height,
            "period": train.main_period,
            "is_regular": train.is_regular,
            "seed": None if train.is_regular else train.seed,
            **({} if train.phase is None else {"phase": train.phase}),
        }
        for name, train in (scenario.waves or {}).items()
    ]


def _current(scenario: Scenario) -> Json:
    """What results need to know of the current; SI."""
    current = scenario.current
    return {} if current is None else {"current": {"speed": current.speed, "direction": current.direction}}


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
        "other_ropes": _other_ropes(scenario, load.name),
        **({"ends_of_ropes": ends} if (ends := dict(ropes_ending_at(scenario, load.name))) else {}),
        **({"ropes_at_lugs": at_lugs} if (at_lugs := ropes_at_lugs(scenario)) else {}),
        **({"tied_to": tied} if (tied := ropes_tied_to(scenario, load.name)) else {}),
        **({"let_go_in": cut} if (cut := _let_go_in(scenario, tied)) else {}),
        "contact_group": load.name if contacts else None,
        "in_water": None if load.in_water is None else in_water_name(load.name),
        **({} if load.in_water is None else {"water_density": (scenario.water or Water()).density}),
        **({"tanks": tanks} if (tanks := list(load_tanks(scenario))) else {}),
        "contacts": contacts,
        **({"meets": met} if (met := parts.met_by(load.name)) else {}),
        "lugs": {name: _lug(scenario, lug, lifted.lugs[name]) for name, lug in load.lugs.items()},
        "centre_of_gravity_from_datum": [float(part) for part in centre],
        "centre_envelope": [float(part) for part in load.centre_of_gravity.envelope],
    }


def _let_go_in(scenario: Scenario, ropes: Iterable[str]) -> Json:
    """Steps that cut ropes as they begin, of those that some do."""
    return {rope: steps for rope in ropes if (steps := steps_that_cut(scenario, rope))}


def _lug(scenario: Scenario, lug: Lug, at: Sequence[float]) -> Json:
    kind = lug.or_of((scenario.lug_types or {}).get(lug.type or ""))
    return {
        "at": list(at),
        "main_plate_normal": list(kind.main_plate_normal),
        **({"plate_is_assumed": True} if kind.main_plate is None else {}),
        "capacity": _force(scenario, kind.capacity),
    }


def _spreaders(scenario: Scenario, parts: Parts) -> list[Json]:
    """Lifting gear between slings; nothing in a lift without."""
    return [
        {
            "name": name,
            "body": name,
            "weight": _force(scenario, parts.bodies[name]["mass"]),
            "size": list(spreader.size),
            "rated_capacity": _force(scenario, spreader.rated_capacity),
            "lugs": {
                lug: _lug(scenario, given, np.array(given.at) - parts.bodies[name]["centre_of_gravity"])
                for lug, given in spreader.lugs.items()
            },
        }
        for name, spreader in (scenario.spreaders or {}).items()
    ]


def _compensators(scenario: Scenario, parts: Parts) -> list[Json]:
    """Gas springs between slings; nothing in a lift without."""
    return [
        {
            "name": name,
            "body": name,
            "rod": rod_of(name),
            "gas": gas_rope(name),
            "weight": _force(scenario, hung_mass(parts, name, given)[0]),
            "stroke": given.stroke,
            "pull_in": given.law.pull(0.0),
            "pull_out": given.law.pull(given.stroke),
            "pulls": [[out, given.law.pull(out)] for out in given.law.ways(0.0, given.stroke)],
            "seal_friction": given.seal_friction,
            "locked": given.locked,
            "rated_capacity": _force(scenario, given.rated_capacity),
        }
        for name, given in (scenario.compensators or {}).items()
    ]


def _hook(scenario: Scenario, rigging: Rigging, name: str, parts: Parts) -> Json:
    hook = scenario.hooks[name]
    bearing = [equalizer.name for equalizer in rigging.equalizers.values() if equalizer.hook == name]
    direct = [s for s in rigging.slings.values() if s.equalizer is None and s.hook == name]
    joined, ropes = bodies_in_hook(scenario, name), ropes_ending_at(scenario, name)
    over = ropes_over(scenario, name)
    bearing += joined
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
            "direct_weight": (sum(map(upper_lump, direct)) + _lumped(scenario, parts, name)) * gravity,
            "direct_ropes": ropes,
            **({"ropes_over": over} if over else {}),
            "sheave_diameter": reeved.reeving.diameter((scenario.ropes or {})[reeved.reeving.rope].diameter),
            **twist_of_falls(scenario, reeved),
            "drum": hoist_drum(name),
            "holds": reeved.holds,
            **({"has_weaker_brake": True} if reeved.has_weaker_brake else {}),
        }
    elif direct or joined or ropes or over:
        bearing = [name]  # the hook's own joint carries all of them, shackles and equalizers too
    return {
        "name": name,
        "crane": hook.crane,
        "bearing_joints": bearing,
        "direct_slings": [],
        "rated_capacity": _force(scenario, hook.rated_capacity),
        "rating_includes_hook_block": hook.rating_includes_hook_block,
        "hoist_weight_extra": hook.hook_block_mass * scenario.simulation.gravity,
        "drive_body": name,
        "bears_mechanics": bool(joined or ropes or over),
        **falls,
        **_wind_at(scenario, hook.crane),
    }


def _led(wrapped: Sequence[Json], drums: Sequence[Json]) -> dict[str, bool]:
    """Limits of fleet angles, each with whether there is a sheave, or a drum, that it is of."""
    led_to_drums = any(drum["first_sheave"] is not None for drum in drums)
    return {"fleet_angle": bool(wrapped), "drum_fleet_angle": led_to_drums}


def _wind_at(scenario: Scenario, crane: str) -> Json:
    """The wind limit of a fixed hook, and the wind that is held against it; other cranes have their own."""
    given = (scenario.cranes or {})[crane]
    if not isinstance(given, FixedHook):
        return {}
    upper = None if given.reeving is None else given.reeving.upper_sheaves_at
    top = given.at[2] if upper is None else upper
    return {"wind_limit": given.wind_limit, "wind": wind_of_limit(scenario, top)}


def _other_ropes(scenario: Scenario, load: str) -> list[str]:
    """Ropes of `mechanics` that end at a load or run over it, each once."""
    ending = [rope for rope, _ in ropes_ending_at(scenario, load)]
    return list(dict.fromkeys([*ending, *(one["rope"] for one in ropes_over(scenario, load))]))


def _lumped(scenario: Scenario, parts: Parts, hook: str) -> float:
    """Mass that ropes of `mechanics` have lumped on a hook [kg]."""
    ropes = (scenario.mechanics.ropes if scenario.mechanics is not None else None) or {}
    return sum(parts.rope_lumps.get(rope, {}).get(hook, 0.0) for rope in ropes)


def _equalizer(scenario: Scenario, rigging: Rigging, name: str, parts: Parts) -> Json:
    equalizer = rigging.equalizers[name]
    hanging = [sling for sling in rigging.slings.values() if sling.equalizer == name]
    return {
        "name": name,
        "hook": equalizer.hook,
        "body": name,
        "mechanism": equalizer.mechanism,
        "adjusting_factor": equalizer.adjusting_factor,
        "guided": equalizer.moving_sheaves.guided,
        "equalizing_rope": f"{name}.equalizing" if equalizer.has_sheaves else "",
        "slings": [f"sling.{sling.name}" for sling in sorted(hanging, key=lambda sling: sling.sheave or 0)],
        "moving_sheaves": _sheaves_of(equalizer),
        "travel_up": equalizer.travel.up,
        "travel_down": equalizer.travel.down,
        "stops": equalizer.travel.stops,
        "locked": _locked(equalizer),
        "pin_capacity": _force(scenario, equalizer.travel.pin_capacity),
        "rated_capacity": _force(scenario, equalizer.rated_capacity),
        "heading_joint": turning_body(equalizer),
        "tilts": equalizer.hinge.tilts,
        "bearing": [-float(part) for part in parts.bodies[name]["centre_of_gravity"]],
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
    # A sling to one lug of the load is the rule; others say to which lugs they go, if to any, and of what.
    is_plain = sling.over is None and len(sling.lugs) == 1
    others: Json = {} if is_plain else {"over": sling.over, "lugs": [end.lug for end in sling.ends]}
    if any(end.spreader or end.compensator for end in sling.ends):
        others["lugs_of"] = [
            end.spreader or end.compensator or (None if end.lug is None else scenario.load.name)
            for end in sling.ends
        ]
    if sling.upper_lug is not None:
        others["from_lug"] = sling.upper_lug
    if sling.bends_about:
        others["bends_about"] = dict(sling.bends_about)
    if weight := upper_lump(sling) * scenario.simulation.gravity:
        others["upper_weight"] = weight
    return {
        "name": sling.name,
        "rope": f"sling.{sling.name}",
        "from": sling.equalizer if hangs_from_frame else sling.upper_body,
        "to_load": scenario.load.name if sling.lugs else None,
        "to_lug": sling.lugs[0] if is_plain else None,
        **others,
        "length": sling.length,
        "tolerance": sling.tolerance / sling.length,
        "minimum_breaking_force": sling.rope.breaking_force,
        "shackles": {
            end: _shackle(scenario, *given)
            for end, given in (("top", sling.top), ("bottom", sling.bottom))
            if given is not None
        },
        "segment": f"sling.{sling.name}/0",
    }


def _tanks(scenario: Scenario) -> Json:
    """Tanks with what is in them at the start; nothing in a lift without."""
    tanks = [
        {
            **{"name": name, "content": tank.content, "capacity": tank.capacity},
            **({"holes": list(tank.holes)} if tank.holes else {}),
        }
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


def _equalised_below(scenario: Scenario) -> Json:
    """The tension spread by which the time to equalise is counted, if the lift file says it; no limit."""
    bound = None if scenario.limits is None else scenario.limits.equalised_below
    return {} if bound is None else {"equalised_below": bound}


#: Keys of a step by which ropes and supports go, slings come, and holes open and close, as it begins.
_PARTS = ("cut", "detach", "attach", "remove_supports", "open_hinges", "open_holes", "close_holes")


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
        "hold_until": _held_until(step) if isinstance(step, HoldStep) else "",
        "lasts": step.hold if isinstance(step, HoldStep) and isinstance(step.hold, float) else None,
        "drives": moved_drives(scenario, step),
        "report": list(step.report),
        "require": require,
        **_pumped(scenario, step),
        "speed": step.speed if isinstance(step, MovingStep | LeadStep) else None,
        "pull_pins": list(step.pull_pins),
        "put_in_pins": list(step.put_in_pins),
        **{key: list(names) for key in _PARTS if (names := getattr(step, key))},
        **({"turns": True} if _turns(step) else {}),
        **_kept_plumb(scenario, step),
        **_ended_by(step),
        **waited_for(scenario, step),
        **_goes(step),
        **_compensated(step),
    }


def _goes(step: Any) -> Json:
    """What a step moves, as the lift file names it, and which way or how far."""
    if isinstance(step, LeadStep):
        travelling = {"travelling": list(step.travelling)} if step.travelling else {}
        return {"moves": list(step.lead), "way": list(step.by), "turn": step.turn, **travelling}
    if not isinstance(step, MovingStep):
        return {}
    way = {key: value for key in ("by", "to") if (value := getattr(step, key, None)) is not None}
    back = {"towards": "minus"} if getattr(step, "towards", "") == "minus" else {}
    return {"moves": list(step.moved), **way, **back}


def _compensated(step: Any) -> Json:
    """The hooks that a step keeps still, and over whose deck."""
    deck = {"relative_to": step.relative_to} if step.relative_to else {}
    return {"compensate_heave": list(step.compensate_heave), **deck} if step.compensate_heave else {}


def _turns(step: Any) -> bool:
    """Whether a step waits for, or asks for, a tilt of the load above some angle."""
    waits = step.until is not None and step.until.load_tilt is not None
    asked = step.require.load_tilt if step.require is not None else None
    return (waits and step.until.load_tilt.above is not None) or (
        asked is not None and asked.relation == "above"
    )


def _kept_plumb(scenario: Scenario, step: Any) -> Json:
    """The hooks whose falls a step keeps plumb."""
    if not isinstance(step, AlongStep) or not step.keep_plumb:
        return {}
    return {"keep_plumb": [full_name(text, scenario.hooks) or text for text in step.keep_plumb]}


def _ended_by(step: Any) -> Json:
    """The key that says when what a step moves stops; a step that leads stops where its way ends."""
    if isinstance(step, LeadStep):
        return {"ends_by": "by" if any(step.by) else "turn"}
    keys = step.ends if isinstance(step, MovingStep) else ("by", "until")
    given = [key for key in keys if getattr(step, key, None) is not None]
    return {} if isinstance(step, HoldStep) else {"ends_by": given[0]}


def _held_until(step: HoldStep) -> str:
    """What a hold without a length lasts until, `end` of the run or a condition is `met`."""
    return step.hold.removeprefix("until_") if isinstance(step.hold, str) else ""


def _pumped(scenario: Scenario, step: Any) -> Json:
    if not isinstance(step, PumpStep):
        return {}
    ends = ends_of_pump(scenario, step)
    way = [SEA if name is None else name for name in ends]
    much = {} if step.by is None else {"pumped": step.by}
    return {"tanks": [name for name in ends if name is not None], "pumps": way, "rate": step.rate, **much}
