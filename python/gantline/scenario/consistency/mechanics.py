"""Whether the plain bodies and ropes of `mechanics` fit together."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from gantline.scenario.consistency.vessels import check_afloat, check_inertia
from gantline.scenario.cranes.compensator import gas_rope
from gantline.scenario.cranes.crane_parts import crane_bodies
from gantline.scenario.cranes.drum import Drum
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.loads.load import Load
from gantline.scenario.mechanics import (
    Ball,
    Body,
    Fixed,
    Free,
    Guide,
    HalfTurn,
    HingeJoint,
    Joint,
    Mechanics,
    MechanicsRope,
    Point,
    RopeEnd,
    Sheave,
    Slider,
)
from gantline.scenario.model import Scenario
from gantline.scenario.plan.motion import SpeedRamp, TurnRamp
from gantline.scenario.plan.parting import rigging_ropes
from gantline.scenario.rope_weight import check_rope_weight
from gantline.scenario.sheave import check_losses, sheave_losses

__all__ = ["check_mechanics", "of_slings_alone", "yard_bodies"]

_SMALLEST = 1e-9


def check_mechanics(findings: Findings, mechanics: Mechanics) -> None:
    """Note everything that is wrong with `mechanics`."""
    scenario = findings.scenario
    known = [*yard_bodies(scenario), *mechanics.bodies]
    for name, body in mechanics.bodies.items():
        path: Path = ("mechanics", "bodies", name)
        _check_parent(findings, mechanics, name, body, known)
        _check_joint(findings, (*path, "joint"), body.joint)
        if body.orientation is not None:
            _check_direction(findings, (*path, "orientation", "about"), body.orientation.about)
        _check_mass(findings, path, body)
        check_afloat(findings, path, body)
    _check_ropes(findings, mechanics, known)
    _check_drums(findings, mechanics)
    rigid = _rigid_with(mechanics)
    for name, rope in (mechanics.ropes or {}).items():
        _check_ways(findings, ("mechanics", "ropes", name, "route"), rope, rigid)
    _check_contacts(findings, mechanics, known, rigid)


def _check_ropes(findings: Findings, mechanics: Mechanics, known: Sequence[str]) -> None:
    scenario = findings.scenario
    held = None if scenario.load is None else scenario.load.name
    taken = [*rigging_ropes(scenario), *map(gas_rope, scenario.compensators or {})]
    taken += [f"{equalizer}.equalizing" for equalizer in scenario.equalizers or {}]
    for name, rope in (mechanics.ropes or {}).items():
        path: Path = ("mechanics", "ropes", name)
        if rope.rope not in (scenario.ropes or {}):
            sentence = f"'{rope.rope}' is not a name of 'ropes'; {nearest(rope.rope, scenario.ropes or {})}"
            findings.add((*path, "rope"), sentence)
        else:
            _check_weight(findings, path, rope)
            _check_spring(findings, path, rope)
            _check_flows(findings, path, rope, mechanics.drums or {})
        for place, guide in enumerate(rope.route):
            is_last = place in (0, len(rope.route) - 1)
            _check_guide(findings, (*path, "route", place), guide, is_last, known)
        if name in taken:
            findings.add(path, f"'{name}' is already the name of a rope of the rigging; use another name")
        if rope.comes_free and held not in (rope.route[0].body, rope.route[-1].body):
            sentence = "what 'comes_free' holds the load down, and ends at it; this rope does not"
            findings.add((*path, "comes_free"), sentence)


def _check_contacts(
    findings: Findings, mechanics: Mechanics, known: Sequence[str], rigid: Mapping[str, str]
) -> None:
    scenario = findings.scenario
    touching = [*(f"corner_{place}" for place in range(1, 9)), "rim_1", "rim_2"]
    corners = [f"{scenario.load.name}.{point}" for point in touching] if scenario.load else []
    for name, contact in (mechanics.contacts or {}).items():
        path: Path = ("mechanics", "contacts", name)
        if contact.body not in known:
            findings.add((*path, "body"), _no_body(scenario, contact.body, known))
        elif rigid.get(contact.body) == "world":
            sentence = f"'{contact.body}' stands still, as the plane does; name a body that moves"
            findings.add((*path, "body"), sentence)
        if name in corners:
            findings.add(path, f"'{name}' is already the name of a corner of the load; use another name")
        _check_direction(findings, (*path, "plane", "normal"), contact.plane.normal)


def yard_bodies(scenario: Scenario) -> list[str]:
    """Names of the bodies that the yard words make."""
    names = [*(scenario.vessels or {}), *scenario.hooks, *crane_bodies(scenario.cranes or {})]
    for name, equalizer in (scenario.equalizers or {}).items():
        kind = (scenario.equalizer_types or {}).get(equalizer.type or "")
        sheaves = equalizer.moving_sheaves or (kind.moving_sheaves if kind is not None else None)
        names.append(name)
        if sheaves is not None and scenario.moves_sheaves(name):
            names += [f"{name}.{place + 1}" for place in range(len(sheaves.along))]
    if scenario.load is not None:
        names.append(scenario.load.name)
    return names


def of_slings_alone(scenario: Scenario, name: str) -> str | None:
    """What a name stands for that bodies, ropes and tag lines cannot be made fast to, in words; or None."""
    gear = {
        "a spreader": scenario.spreaders,
        "a compensator": scenario.compensators,
        "an extension sheave": scenario.extension_sheaves,
    }
    what = next((what for what, named in gear.items() if name in (named or {})), None)
    return None if what is None else f"'{name}' is {what}, which slings alone are made fast to"


def _no_body(scenario: Scenario, name: str, known: Sequence[str]) -> str:
    """What is wrong with a name that is none of these bodies."""
    own = of_slings_alone(scenario, name)
    if own is not None:
        return f"{own}; for anything else make it a body of 'mechanics'"
    return f"'{name}' is not a body; {nearest(name, known)}"


def _check_parent(
    findings: Findings, mechanics: Mechanics, name: str, body: Body, known: Sequence[str]
) -> None:
    path: Path = ("mechanics", "bodies", name, "parent")
    if body.parent is not None and body.parent not in (*known, "world"):
        findings.add(path, _no_body(findings.scenario, body.parent, known))
    chain = [name]
    parent = body.parent
    while parent is not None and parent in mechanics.bodies and parent not in chain:
        chain.append(parent)
        parent = mechanics.bodies[parent].parent
    if parent == name:
        loop = " -> ".join([*chain, name])
        findings.add(path, f"hangs in a circle ({loop}); in the end every body hangs on the world")


def _rigid_with(mechanics: Mechanics) -> dict[str, str]:
    """By body what it is fixed to in the end: the world, or the last body down its fixed joints."""

    def last(name: str) -> str:
        passed = [name]
        while (body := mechanics.bodies.get(passed[-1])) is not None and isinstance(body.joint, Fixed):
            parent = body.parent or "world"
            if parent in passed:  # a circle, which is told where it is
                break
            passed.append(parent)
        return passed[-1]

    return {name: last(name) for name in ("world", *mechanics.bodies)}


def _check_ways(findings: Findings, path: Path, rope: MechanicsRope, rigid: Mapping[str, str]) -> None:
    """Something gives way to an inextensible rope; one that stretches may tell how long a route is."""
    kind = (findings.scenario.ropes or {}).get(rope.rope)
    bodies = list(dict.fromkeys(guide.body for guide in rope.route))
    if kind is None or not kind.inextensible or len({rigid.get(body, body) for body in bodies}) > 1:
        return
    named = ", ".join(map(repr, bodies))
    sentence = f"nothing gives way to this inextensible rope: all its guides are on {named}"
    findings.add(path, f"{sentence}, which do not move against each other; name another body")


def _check_joint(findings: Findings, path: Path, joint: Joint) -> None:
    if isinstance(joint, (Ball, Free)) and joint.orientation is not None:
        _check_direction(findings, (*path, "orientation", "about"), joint.orientation.about)
    if not isinstance(joint, (HingeJoint, Slider)):
        return
    _check_direction(findings, (*path, "axis"), joint.axis)
    if joint.stops is not None:
        _check_stops(findings, path, joint)
    if joint.motion is not None:
        if joint.velocity != 0:
            sentence = "a joint with a given motion starts at rest; leave 'velocity' out"
            findings.add((*path, "velocity"), sentence)
        if joint.friction != 0:
            sentence = "a given motion takes place whatever holds against it; leave 'friction' out"
            findings.add((*path, "friction"), sentence)
        _check_motion(findings, (*path, "motion"), joint.motion)


def _check_stops(findings: Findings, path: Path, joint: HingeJoint | Slider) -> None:
    stops = joint.stops
    assert stops is not None
    lower = -math.inf if stops.lower is None else stops.lower
    upper = math.inf if stops.upper is None else stops.upper
    if stops.lower is None and stops.upper is None:
        findings.add((*path, "stops"), "says neither 'lower' nor 'upper'; a stop is at one of them at least")
    elif not (lower < upper or (stops.loaded and lower == upper)):
        findings.add((*path, "stops"), "has 'lower' not below 'upper'; between them the joint moves")
    elif not lower <= joint.position <= upper and not stops.loaded:
        sentence = "is beyond a stop; a joint starts between its stops, unless they say 'loaded: true'"
        findings.add((*path, "position"), sentence)
    if joint.motion is not None:
        findings.add((*path, "stops"), "a joint with a given motion has no stops; leave one of both out")


def _check_motion(findings: Findings, path: Path, motion: Sequence[SpeedRamp | TurnRamp]) -> None:
    end, duration = 0.0, findings.scenario.duration
    if motion and motion[0].at > duration:
        sentence = f"{motion[0].at:g} s is after the end of the lift at {duration:g} s, so that nothing moves"
        findings.add((*path, 0, "at"), f"{sentence}; make 'duration' longer or this time earlier")
    for place, ramp in enumerate(motion):
        if ramp.at < end:
            sentence = f"{ramp.at:g} s is before the end of the change before it, at {end:g} s"
            findings.add((*path, place, "at"), f"{sentence}; one change follows the other")
        end = max(end, ramp.at + ramp.duration)


def _check_mass(findings: Findings, path: Path, body: Body) -> None:
    joint, inertia = body.joint, body.inertia
    if isinstance(joint, (Point, Free)) and body.mass <= 0:
        findings.add(
            (*path, "mass"), f"a {joint.type} body without mass cannot move as forces say; give it a mass"
        )
    if isinstance(joint, Free) and any(body.centre_of_gravity):
        sentence = "the axes of a free body begin at its centre of gravity; leave this out"
        findings.add((*path, "centre_of_gravity"), sentence)
    elif body.mass == 0 and any(body.centre_of_gravity):
        sentence = "a body without mass has no centre of gravity; give it 'mass', or leave this out"
        findings.add((*path, "centre_of_gravity"), sentence)
    if inertia is None:
        if isinstance(joint, Free):
            findings.add(path, f"'inertia' is missing; a free body needs it{_of_solid_box(body)}")
        return
    check_inertia(findings, path, inertia, is_free=isinstance(joint, Free))


def _of_solid_box(body: Body) -> str:
    """What to write for a body of even density that fills its shape."""
    if body.shape is None or body.mass <= 0:
        return ""
    x, y, z = (size * size for size in body.shape.box)
    given = {"xx": y + z, "yy": x + z, "zz": x + y}
    said = ", ".join(f"{key}: {body.mass / 12 * square:.4g} kg m^2" for key, square in given.items())
    return f", such as {{{said}}} of a solid box of its shape"


def _check_weight(findings: Findings, path: Path, rope: MechanicsRope) -> None:
    scenario = findings.scenario
    check_rope_weight(
        lambda key, sentence: findings.add((*path, key), sentence),
        rope.rope,
        (scenario.ropes or {})[rope.rope],
        rope.rope_weight,
        nodes_said=rope.rope_nodes is not None,
        over_sheaves="this rope" if len(rope.route) > 2 else "",
        gravity=scenario.simulation.gravity,
    )


def _check_spring(findings: Findings, path: Path, rope: MechanicsRope) -> None:
    """A rope that starts stretched can stretch, is longer than something, and is one piece."""
    if not rope.stretched:
        return
    if (findings.scenario.ropes or {})[rope.rope].inextensible:
        wrong = f"rope '{rope.rope}' is inextensible; give it an axial stiffness"
    elif isinstance(rope.length, str):
        wrong = "'length: as_routed' is just taut at the start; give it a length"
    elif rope.rope_weight == "distributed":
        wrong = "a rope with nodes starts as it hangs; write 'rope_weight: lumped', or 'none'"
    else:
        return
    findings.add((*path, "stretched"), wrong)


def _check_drums(findings: Findings, mechanics: Mechanics) -> None:
    """Each drum has a rope, and its motion is in order."""
    ends = [guide for rope in (mechanics.ropes or {}).values() for guide in rope.route]
    used = {guide.drum for guide in ends if isinstance(guide, RopeEnd)}
    for name, drum in (mechanics.drums or {}).items():
        path: Path = ("mechanics", "drums", name)
        if name not in used:
            sentence = "no rope ends on this drum"
            findings.add(path, f"{sentence}; name it at an end of a route, or leave it out")
        if drum.motion is not None:
            _check_motion(findings, (*path, "motion"), drum.motion)


def _check_flows(findings: Findings, path: Path, rope: MechanicsRope, drums: Mapping[str, Drum]) -> None:
    """Whether the sheaves and drums of a rope can be simulated with its kind of rope."""
    kind = (findings.scenario.ropes or {})[rope.rope]
    on_drum = any(isinstance(end, RopeEnd) and end.drum is not None for end in rope.route)
    if len(rope.route) > 2 or on_drum:
        bent = kind.bent(rope.rope, "a rope over sheaves" if len(rope.route) > 2 else "a rope on a drum")
        if bent is not None:
            findings.add((*path, "rope"), bent)
    for place, guide in enumerate(rope.route):
        at: Path = (*path, "route", place)

        def add(key: str, sentence: str, at: Path = at) -> None:
            findings.add((*at, key) if key else at, sentence)

        if isinstance(guide, HalfTurn | Sheave):
            losses = sheave_losses(guide, guide.radius, kind.mass_per_length)
            check_losses(add, guide, losses, rope.rope, kind.inextensible)
            if isinstance(guide, Sheave) and guide.may_lift_off and not losses.is_ideal:
                sentence = "a rope does not leave a sheave with losses or inertia"
                add("may_lift_off", f"{sentence}; leave this out, or the losses")
        elif not isinstance(guide, RopeEnd) or guide.drum is None:
            continue
        elif guide.drum not in drums:
            add("drum", f"'{guide.drum}' is not a name of 'drums'; {nearest(guide.drum, drums)}")
        elif kind.inextensible:
            sentence = f"rope '{rope.rope}' is inextensible, and a rope on a drum has to stretch"
            add("drum", f"{sentence}; give it an axial stiffness")
        elif drums[guide.drum].layers > 1 and drums[guide.drum].layer_step is None and kind.diameter is None:
            sentence = f"the diameter of rope '{rope.rope}' is not known, which says how thick a layer is"
            add("drum", f"{sentence}; give the drum a 'layer_step', such as 'layer_step: 36 mm'")
        elif rope.rope_weight == "distributed":
            add("drum", "a rope with nodes cannot be paid out by a drum; 'rope_weight: lumped' is right here")


def _check_guide(findings: Findings, path: Path, guide: Guide, is_last: bool, known: Sequence[str]) -> None:
    is_end = isinstance(guide, RopeEnd)
    if is_end != is_last:
        sentence = "a route begins and ends with 'type: end', with only sheaves and eyes between"
        findings.add((*path, "type"), sentence)
    allowed = [*known, "world"]
    if guide.body not in allowed:
        lug = _lug_meant(findings.scenario.load, guide.body) if is_end else None
        right = f"'{guide.body}' is not a body; an end at that lug is written '{lug}'"
        sentence = right if lug else _no_body(findings.scenario, guide.body, allowed)
        findings.add((*path, "body"), sentence)
    elif isinstance(guide, RopeEnd) and guide.lug is not None:
        _check_lug(findings, (*path, "lug"), guide.body, guide.lug)
    if isinstance(guide, Sheave):
        _check_direction(findings, (*path, "axis"), guide.axis)
    if isinstance(guide, HalfTurn):
        _check_direction(findings, (*path, "bulge"), guide.bulge)
        across = [leave - enter for enter, leave in zip(guide.enter, guide.leave, strict=True)]
        along = sum(a * b for a, b in zip(across, guide.bulge, strict=True))
        if _size(across) < _SMALLEST:
            findings.add((*path, "leave"), "is the same place as 'enter'; a sheave has a diameter")
        elif abs(along) > 1e-6 * _size(across) * _size(guide.bulge):
            findings.add((*path, "bulge"), "has to be square to the line from 'enter' to 'leave'")


def _lug_meant(load: Load | None, name: str) -> str | None:
    """An end at the lug that a name means, `module.L1` as slings have it or `L1`; None if it means none."""
    lug = "" if load is None else name.removeprefix(f"{load.name}.")
    if load is None or lug not in load.lugs:
        return None
    return f"{{type: end, body: {load.name}, lug: {lug}}}"


def _check_lug(findings: Findings, path: Path, body: str, lug: str) -> None:
    load = findings.scenario.load
    if load is None or body != load.name:
        findings.add(path, f"'{body}' has no lugs; the load alone has, of other bodies 'at' says where")
    elif lug not in load.lugs:
        findings.add(
            path, f"'{lug}' is not a lug of '{body}'; {nearest(lug.removeprefix(f'{body}.'), load.lugs)}"
        )


def _size(direction: Sequence[float]) -> float:
    return float(sum(part * part for part in direction) ** 0.5)


def _check_direction(findings: Findings, path: Path, direction: Sequence[float]) -> None:
    if _size(direction) < _SMALLEST:
        findings.add(path, "has no length; a direction is written like [0, 0, 1]")
