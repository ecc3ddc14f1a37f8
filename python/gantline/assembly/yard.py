"""Yard words into mechanics: hooks, equalizers and slings. The load has a module of its own."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from gantline.assembly.cranes.chain_hoists import add_chain_hoist, paid_out_by
from gantline.assembly.cranes.hook_aside import hook_aside
from gantline.assembly.cranes.reeving import add_reeved_hook, reeved_hooks
from gantline.assembly.parts import ORIGIN, Json, Parts, end, eye, half_turn, material, sheave
from gantline.assembly.plan.slinging import check_reach, hangs_load, warn_of_off
from gantline.assembly.ropes.rope_weight import add_free_rope, lump_rope, mass_at_end
from gantline.assembly.ropes.route import end_to_end, most_strain, route_length, too_far
from gantline.assembly.ropes.sheave import add_sheave_flow
from gantline.assembly.spatial import inertia_list, solid_box
from gantline.scenario import Scenario, StartError
from gantline.scenario.errors import Problem
from gantline.scenario.extension import SlingEnd
from gantline.scenario.rigging import EqualizerRigging, Rigging, SlingRigging

__all__ = [
    "add_equalizers",
    "add_hooks",
    "add_slings",
    "hoist_drive",
    "lower_end",
    "lower_lump",
    "slider",
    "sling_route",
    "turning_body",
    "upper_lump",
]

#: A load that has settled hangs in slack slings: they may be too short by this much at most [m].
_TAUT = 1e-6
#: Lengths of a sling at the start over its way, from which a digit too many is likelier than a low hook [1].
_MOST_SLACK = 5.0


def hoist_drive(hook: str) -> str:
    """Name of the drive that hoists a hook."""
    return f"{hook}.hoist"


def upper_lump(sling: SlingRigging) -> float:
    """Mass at the upper end of a sling: upper shackle, chain hoist, what the end carries of the rope [kg].

    One that is put on later hangs there with all its weight.
    """
    own = mass_at_end(sling.weight, sling.length) + (sling.top[1].mass if sling.top else 0.0)
    own += sling.chain_hoist.mass if sling.chain_hoist else 0.0
    return own if sling.starts_on else own + _lower_mass(sling)


def lower_lump(sling: SlingRigging) -> float:
    """Mass at a lower end of a sling: the lower shackle and what the end carries of the rope [kg].

    Nothing of one that is put on later.
    """
    return _lower_mass(sling) if sling.starts_on else 0.0


def _lower_mass(sling: SlingRigging) -> float:
    rope = mass_at_end(sling.weight, sling.length) / len(sling.ends)
    return rope + (sling.bottom[1].mass if sling.bottom else 0.0)


def add_hooks(parts: Parts, scenario: Scenario, rigging: Rigging) -> None:
    """Each hook is a vertical slider, driven or hung in ropes; slings under it lump their mass on it."""
    reeved = {one.name: one for one in reeved_hooks(scenario)}
    for name, hook in scenario.hooks.items():
        direct = [
            sling for sling in rigging.slings.values() if sling.equalizer is None and sling.hook == name
        ]
        drive = hoist_drive(name)
        if name in reeved:
            own_mass = math.fsum(upper_lump(sling) for sling in direct)
            add_reeved_hook(parts, scenario, reeved[name], drive, own_mass)
            continue
        parts.add_drive(drive)
        parts.add_body(
            name,
            slider((0.0, 0.0, 1.0), drive),
            position=(*hook.place, hook.height),
            mass=math.fsum(upper_lump(sling) for sling in direct),
        )


def add_equalizers(parts: Parts, rigging: Rigging, pins: Mapping[str, bool]) -> None:
    """Frames on hinges under their hooks, moving sheaves that slide in them, equalizing ropes.

    `pins`: moving sheaves that have locking pins, and whether they are in at the start.

    Where lengths are adjusted instead, the sheaves are masses on the frame and there is no equalizing rope.
    """
    for equalizer in rigging.equalizers.values():
        _add_frame(parts, equalizer)
        hanging = [sling for sling in rigging.slings.values() if sling.equalizer == equalizer.name]
        carried = {sling.sheave: upper_lump(sling) for sling in hanging}
        held = {sling.sheave for sling in hanging if sling.starts_on}
        sheaves = equalizer.moving_sheaves
        if not equalizer.has_sheaves:
            for place in range(1, len(sheaves.along) + 1):
                mass = sheaves.mass + carried.get(place, 0.0)
                parts.lump(equalizer.name, sheave_place(equalizer, place), mass)
            names = [f"sling.{sling.name}" for sling in hanging]
            factor = equalizer.adjusting_factor
            parts.adjusters.append({"name": equalizer.name, "ropes": names, "factor": factor})
            continue
        for place in range(1, len(sheaves.along) + 1):
            name = f"{equalizer.name}.{place}"
            if place not in held and name not in pins and not equalizer.travel.stops:
                parts.doubt(
                    ("equalizers", equalizer.name),
                    f"no sling hangs from moving sheave {name}: without 'stops: true' in 'travel' the rope "
                    "hauls it up to the fixed sheaves",
                )
            mass = sheaves.mass + carried.get(place, 0.0)
            _add_moving_sheave(parts, equalizer, place, mass, pins.get(name))
        turned = _equalizing_route(parts, equalizer)
        is_free = sheaves.guided == "none"
        rope = f"{equalizer.name}.equalizing"
        route = [_touched(guide) for guide in turned] if is_free else turned
        # Where it touches sheaves that hang free, and so how long it is, is the core's to say.
        length = None if is_free else route_length(parts, turned)
        parts.add_rope(rope, length, material(equalizer.rope), route)
        lump_rope(parts, rope, equalizer.weight, length, turned)


def _add_moving_sheave(
    parts: Parts, equalizer: EqualizerRigging, place: int, mass: float, pin: bool | None
) -> None:
    """A slider, down positive; that of a sheave that hangs free rides on two more, along and across."""
    name, parent = f"{equalizer.name}.{place}", equalizer.name
    position = sheave_place(equalizer, place)
    if equalizer.moving_sheaves.guided == "none":
        for way, axis in (("along", (1.0, 0.0, 0.0)), ("across", (0.0, 1.0, 0.0))):
            parts.add_body(f"{name}/{way}", slider(axis, None), parent=parent, position=position)
            parent, position = f"{name}/{way}", ORIGIN
    joint = {**slider((0.0, 0.0, -1.0), None, _travel_stops(equalizer)), "pin": pin}
    parts.add_body(name, joint, parent=parent, position=position, mass=mass)


def _touched(guide: Json) -> Json:
    """In place of half a turn the sheave, which the rope touches where its parts lead; an end stays one."""
    if guide["type"] != "half_turn":
        return guide
    enter, leave = np.array(guide["enter"]), np.array(guide["leave"])
    axis = np.cross(guide["bulge"], leave - enter)
    real = sheave(guide["body"], ((enter + leave) / 2).tolist(), axis.tolist(), math.dist(enter, leave) / 2)
    return real | {key: guide[key] for key in ("flow", "ratio", "groove") if key in guide}


def sheave_place(equalizer: EqualizerRigging, sheave: int) -> tuple[float, float, float]:
    """Where a moving sheave is at the start, in the frame of its equalizer [m]; `sheave` counts from 1."""
    sheaves = equalizer.moving_sheaves
    return sheaves.along[sheave - 1], 0.0, -sheaves.below_hook


def sling_route(
    scenario: Scenario, rigging: Rigging, sling: SlingRigging, lugs: Mapping[str, Sequence[float]]
) -> list[Json]:
    """From the top of a sling to its lower end, or from end to end over an extension sheave.

    `lugs` are positions in the load's body frame.
    """
    ends = [lower_end(scenario, lugs, one) for one in sling.ends]
    top = paid_out_by(sling, _upper_end(scenario, rigging, sling))
    return [top, *ends] if sling.over is None else [ends[0], top, ends[1]]


def _upper_end(scenario: Scenario, rigging: Rigging, sling: SlingRigging) -> Json:
    """What a sling hangs from: of a spreader its lug, of an approximated equalizer a place on its frame."""
    if sling.over is not None:
        return eye(sling.over, ORIGIN)
    if sling.spreader is not None and sling.upper_lug is not None:
        return _at_spreader(scenario, sling.spreader, sling.upper_lug)
    if sling.equalizer is not None and sling.sheave is not None:
        equalizer = rigging.equalizers[sling.equalizer]
        if not equalizer.has_sheaves:
            return end(equalizer.name, sheave_place(equalizer, sling.sheave))
    return end(sling.upper_body)


def _travel_stops(equalizer: EqualizerRigging) -> Json | None:
    travel = equalizer.travel
    if not travel.stops:
        return None
    stiffness, damping_time = travel.stop_stiffness, travel.stop_damping_time
    return {
        "lower": -travel.up,
        "upper": travel.down,
        "stiffness": stiffness,
        "damping_time": damping_time,
    }


def slider(axis: Sequence[float], drive: str | None, stops: Json | None = None) -> Json:
    """A joint along an axis, at its start and at rest; of a `drive`, or between stops, or free."""
    return {
        "type": "slider",
        "axis": list(axis),
        "position": 0.0,
        "velocity": 0.0,
        "damping": 0.0,
        "friction": 0.0,
        "drive": drive,
        "stops": stops,
    }


def turning_body(equalizer: EqualizerRigging) -> str:
    """Name of what turns about the vertical under the hook: the frame, or what it tilts in."""
    return f"{equalizer.name}/turn" if equalizer.hinge.tilts else equalizer.name


def _hinge(axis: Sequence[float], friction: float, damping: float) -> Json:
    return {
        "type": "hinge",
        "axis": list(axis),
        "position": 0.0,
        "velocity": 0.0,
        "damping": damping,
        "friction": friction,
        "drive": None,
    }


def _add_frame(parts: Parts, equalizer: EqualizerRigging) -> None:
    frame = equalizer.frame
    box = np.diag(solid_box(frame.mass, (frame.length, frame.width, frame.height)))
    given = (frame.inertia_about_length, frame.inertia_about_width, frame.inertia_about_vertical)
    inertia = [float(own if value is None else value) for own, value in zip(box, given, strict=True)]
    parent, hinge = equalizer.hook, equalizer.hinge
    axes = parts.pose(parent)[1]  # of a hook at a boom turned with its vessel
    joint = _hinge((0.0, 0.0, 1.0), hinge.friction, hinge.damping)
    joint["position"] = equalizer.heading - math.atan2(axes[1, 0], axes[0, 0])
    if hinge.tilts:  # in the hook's pin, which turns with the frame
        turn, over = turning_body(equalizer), f"{equalizer.name}/over"
        tilt = hinge.tilt_friction, hinge.tilt_damping
        parts.add_body(turn, joint, parent=parent)
        parts.add_body(over, _hinge((1.0, 0.0, 0.0), *tilt), parent=turn)
        parent, joint = over, _hinge((0.0, 1.0, 0.0), *tilt)
    parts.add_body(
        equalizer.name,
        joint,
        parent=parent,
        mass=frame.mass,
        centre_of_gravity=(0.0, 0.0, -frame.centre_of_gravity_below_hook),
        inertia=inertia_list(np.diag(inertia)),
    )


def _equalizing_route(parts: Parts, equalizer: EqualizerRigging) -> list[Json]:
    """Dead end, around moving sheave 1, over fixed sheave 1, around moving sheave 2, ..., dead end."""
    losses = equalizer.sheave_losses
    name = equalizer.name
    ends, fixed, moving = equalizer.rope_ends, equalizer.fixed_sheaves, equalizer.moving_sheaves
    radius = moving.pitch_diameter / 2
    route = [end(name, (ends.along[0], 0.0, -ends.below_hook))]
    for place in range(len(moving.along)):
        passing = add_sheave_flow(parts, f"{name}/moving_{place + 1}", losses["moving_sheaves"])
        enter, leave = (-radius, 0.0, 0.0), (radius, 0.0, 0.0)
        route.append(half_turn(f"{name}.{place + 1}", enter, leave, (0.0, 0.0, -1.0), passing))
        if place < len(fixed.along):
            along, high, reach = fixed.along[place], -fixed.below_hook, fixed.pitch_diameter / 2
            passing = add_sheave_flow(parts, f"{name}/fixed_{place + 1}", losses["fixed_sheaves"])
            enter, leave = (along - reach, 0.0, high), (along + reach, 0.0, high)
            route.append(half_turn(name, enter, leave, (0.0, 0.0, 1.0), passing))
    return [*route, end(name, (ends.along[1], 0.0, -ends.below_hook))]


def add_slings(parts: Parts, scenario: Scenario, rigging: Rigging, lugs: dict[str, list[float]]) -> None:
    """Each sling from its moving sheave (or hook) to its lug; `lugs` are positions in the load's body frame.

    Raises:
        ScenarioError: if slings are too short for where their ends are at the start, or cannot hang there.
    """
    if scenario.load is None:
        return
    too_short: list[tuple[SlingRigging, list[Json]]] = []
    off: list[str] = []  # slings on which the load seems to hang at the start, and which are not on
    loose: dict[str, tuple[float, float]] = {}  # slings much longer than their way, with both
    below: dict[str, float] = {}  # slings whose upper end is below the lug that they hold, and by how much
    for sling in rigging.slings.values():
        route = sling_route(scenario, rigging, sling, lugs)
        distance = route_length(parts, route)
        if not sling.starts_on:
            check_reach(parts, scenario, sling, route)
            if hangs_load(scenario, sling, distance):
                off.append(sling.name)
        if sling.starts_on and distance - sling.length > _may_be_short(
            parts, scenario, rigging, sling, distance
        ):
            too_short.append((sling, route))
            continue
        path = ("slings", sling.name)
        rope = f"sling.{sling.name}"
        if sling.weight.mass_per_length > 0:  # lumped where hook, sheaves and load are made
            parts.rope_mass[rope] = sling.weight.mass_per_length * sling.length, 0.0
        add_chain_hoist(parts, scenario, sling)
        add_free_rope(parts, scenario, path, rope, sling.rope, sling.weight, sling.length, route)
        if (
            sling.starts_on
            and sling.over is None
            and sling.lugs
            and (rise := float(end_to_end(parts, route)[2])) > 0.0
        ):
            below[sling.name] = rise
        elif sling.starts_on and sling.length > _MOST_SLACK * distance:
            loose[sling.name] = sling.length, distance
    if too_short:
        raise StartError(scenario.source, _too_short(parts, scenario, rigging, too_short, lugs))
    warn_of_off(parts, scenario, off)
    _doubt_below(parts, rigging, scenario.load.name, below)
    _doubt_long(parts, rigging, scenario.load.name, loose)


def _doubt_below(parts: Parts, rigging: Rigging, load: str, below: dict[str, float]) -> None:
    """Slings whose upper end is below the lug that they hold, by how much [m]."""
    if below:
        deepest = max(below, key=lambda name: below[name])
        more = f" and {len(below) - 1} more" if len(below) > 1 else ""
        way = _way(load, rigging.slings[deepest])
        parts.doubt(
            ("slings", deepest),
            f"sling {deepest}{more} cannot lift where this begins: {way} it goes {below[deepest]:.3g} m up; "
            "the height of a hook is that of its bearing",
        )


def _doubt_long(parts: Parts, rigging: Rigging, load: str, loose: dict[str, tuple[float, float]]) -> None:
    """Slings much longer than their way, both [m]."""
    if loose:
        loosest = max(loose, key=lambda name: loose[name][0])
        more = f" and {len(loose) - 1} more" if len(loose) > 1 else ""
        length, distance = loose[loosest]
        way = f"{_way(load, rigging.slings[loosest])} it is {distance:.4g} m at the start"
        parts.doubt(
            ("slings", loosest, "length"),
            f"sling {loosest}{more} is {length:g} m long, and {way}; check the number and its unit",
        )


def _stretches(scenario: Scenario, sling: SlingRigging) -> bool:
    """Whether a sling may begin stretched; one that an extension sheave or a spreader hangs on does."""
    at_rest = scenario.load_has_settled and sling.lugs
    return not (at_rest or sling.rope.inextensible)


def _may_be_short(
    parts: Parts, scenario: Scenario, rigging: Rigging, sling: SlingRigging, distance: float
) -> float:
    """By how much a sling may be shorter than its way at the start [m]."""
    if _stretches(scenario, sling):
        return most_strain(sling.rope) * sling.length
    held = sling.over or sling.spreader or sling.compensator
    if held is None or sling.rope.stiffness is None or _outweighed(parts, scenario, rigging, sling, distance):
        return _TAUT
    # Gear that is not plumb below its hook leans on the slings below it, with no more than it weighs.
    gear = [*rigging.extensions, *(scenario.spreaders or {}), *(scenario.compensators or {})]
    weight = sum(float(parts.bodies[name]["mass"]) for name in gear) * scenario.simulation.gravity
    return _TAUT + weight / sling.rope.stiffness * sling.length


def _outweighed(
    parts: Parts, scenario: Scenario, rigging: Rigging, sling: SlingRigging, distance: float
) -> str:
    """What pulls a sling taut over an extension sheave, where a heavier one on its sling does; else empty.

    Where lugs hold a sling over the lighter of two, that goes up until it is taut, wherever the hook is.
    """
    if sling.over is None or sling.rope.stiffness is None:
        return ""
    above = rigging.slings[rigging.extensions[sling.over].hangs_on]
    others = [end.extension for end in above.ends if end.extension not in (None, sling.over)]
    weight = {
        name: parts.bodies[name]["mass"] * scenario.simulation.gravity for name in (sling.over, *others)
    }
    tension = sling.rope.stiffness * (distance / sling.length - 1.0)
    for other in others:
        # Its two legs share what the other has more; they stand within 60 degrees of plumb.
        if 0.0 < tension <= weight[other] - weight[sling.over]:
            more = (weight[other] - weight[sling.over]) / scenario.simulation.gravity
            return (
                f"'{other}' is {more:.3g} kg heavier, with what is lumped on it, and draws '{sling.over}' up"
            )
    return ""


def _too_short(
    parts: Parts,
    scenario: Scenario,
    rigging: Rigging,
    slings: Sequence[tuple[SlingRigging, list[Json]]],
    lugs: Mapping[str, Sequence[float]],
) -> list[Problem]:
    """What is wrong with slings that do not reach from end to end at the start, with their routes."""
    assert scenario.load is not None
    sideways = {sling.name: float(np.hypot(*end_to_end(parts, route)[:2])) for sling, route in slings}
    aside = {sling.name for sling, _ in slings if sling.over is None and sideways[sling.name] > sling.length}
    problems = []
    for sling, route in slings:
        distance = route_length(parts, route)
        apart = f"{_way(scenario.load.name, sling)} it is {_not_shorter(distance, sling.length)} m"
        sentence = f"the sling is {sling.length:g} m, but {apart} at the start"
        stretches = _stretches(scenario, sling)
        sentence += f": {too_far(distance, sling.length, most_strain(sling.rope))}; " if stretches else "; "
        # No height of the hook helps any sling where it is too far aside for one of them.
        advice = "put crane, boom or load elsewhere" if aside else "lower the hook or make the sling longer"
        if not aside and (sling.compensator or any(one.compensator for one in sling.ends)):
            advice += ", or have the rod out where the lift begins, by 'out_at_start'"
        if sling.name in aside:
            way = f"{sideways[sling.name]:.3f} m of that sideways"
            sentence += f"{way}, which no height of the hook makes up; "
        beside = hook_aside(parts, scenario, rigging, sling, distance - sling.length, lugs)
        if beside and aside:
            advice += f": {beside}"
        elif beside:
            sentence += f"{beside}; "
        if outweighed := _outweighed(parts, scenario, rigging, sling, distance):
            sentence += f"{outweighed}; "
            advice = "two extension sheaves on one sling have equal masses"
        if scenario.load_has_settled and distance - sling.length <= most_strain(sling.rope) * sling.length:
            advice += ", or write 'start: as_given' if it shall pull from the start"
        problem = scenario.problem(("slings", sling.name), sentence + advice)
        problems.append(replace(problem, short=0.0 if aside or beside else distance - sling.length))
    return problems


def lower_end(scenario: Scenario, lugs: Mapping[str, Sequence[float]], end_of_sling: SlingEnd) -> Json:
    """A lower end of a sling: a lug of the load or of a spreader, an extension sheave or a compensator."""
    bearing = end_of_sling.extension or end_of_sling.compensator
    if bearing is not None:
        return end(bearing)
    assert scenario.load is not None  # slings have been checked to lead to its lugs
    assert end_of_sling.lug is not None  # each end is at one of the two
    if end_of_sling.spreader is not None:
        return _at_spreader(scenario, end_of_sling.spreader, end_of_sling.lug)
    return end(scenario.load.name, lugs[end_of_sling.lug])


def _at_spreader(scenario: Scenario, spreader: str, lug: str) -> Json:
    return end(spreader, (scenario.spreaders or {})[spreader].lugs[lug].at)


def _way(load: str, sling: SlingRigging) -> str:
    """From where to where a sling goes, in words."""
    beside = [one.extension or one.compensator for one in sling.ends]
    lugs = [f"{one.spreader or load}.{one.lug}" for one in sling.ends]
    names = [f"'{other or lug}'" for other, lug in zip(beside, lugs, strict=True)]
    if sling.over is None:
        lug = "" if sling.upper_lug is None else f".{sling.upper_lug}"
        return f"from '{sling.upper_body}{lug}' to {names[0]}"
    return f"from {names[0]} over '{sling.over}' to {names[1]}"


def _not_shorter(distance: float, length: float) -> str:
    """Distance with as many digits as it takes to tell it from the length."""
    digits = max(3, 1 - math.floor(math.log10(distance - length)))
    return f"{distance:.{min(digits, 9)}f}"
