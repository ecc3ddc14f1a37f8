"""Ropes: minimum breaking force over tension, utilisation with the rule's factors, bends, fleet angles."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from gantline.checks.force import OWN_WEIGHT, Force, Raised, kilonewton, over
from gantline.checks.forces import at_upper_end, factor, force_of_weight, rope_force, sling_forces
from gantline.checks.measure import Caution, Finding, Found, Missing, Refused, carrying, extreme
from gantline.checks.moorings import moors_by_its_limit
from gantline.checks.slings import bare_ends, bending_factor, bending_text, no_slings, sling_bend
from gantline.results import series
from gantline.results.alike import nothing
from gantline.results.gear import Rope, Sling
from gantline.results.recording import Recording
from gantline.results.ropes.upper_end import peak_at_upper_end
from gantline.results.variable import BoolArray

_NO_STRENGTH = "minimum breaking force not known"
_NO_SAFETY = (
    "neither limits nor rules say how far below its breaking force a sling has to stay: "
    "write 'sling_factor_on_breaking_force' under 'limits', or 'rope_factor_on_breaking_force' for all ropes"
)
_NONE_HELD = "the rules have factors on the breaking force of slings, and no sling is held against it"
_OVER_EYES = "bends about eyes or luffing sheaves, whose diameter is not known"
_EYES_TAKE = (
    "bending about its own diameter takes half of a rope's strength; "
    "a guide of 'type: sheave' has a diameter, luffing tackles a 'sheave_diameter'"
)
_FACTORS = ("sling_factor_on_breaking_force", "rope_factor_on_breaking_force")
_NEEDED = ("load_factor", "consequence_factor", "material_factor", "termination_factor")
_MAY_BE = ("least_safety_factor", "wear_factor")
#: What a sheave on rolling bearings leaves of the tension in its rope [1]: plausible, no document; plain
#: bearings leave less.
_LEAVES = 0.98


def sling_factor(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Minimum breaking force of a sling over its peak tension, or its static one with the design weight."""
    for sling in recording.rig.slings:
        yield from _factor(recording, during, sling.rope, sling.minimum_breaking_force, sling.name)
    yield from no_slings(recording)


def rope_factor(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Minimum breaking force of a rope over its peak tension, or its static one with the design weight."""
    for rope in _of_rope(recording):
        yield from _factor(recording, during, rope.name, rope.minimum_breaking_force, rope.name)
    if any(sling.minimum_breaking_force is not None for sling in recording.rig.slings) and not _has_safety(
        recording
    ):
        yield Caution(_NO_SAFETY)


def _of_rope(recording: Recording) -> list[Rope]:
    """All ropes but what stands for mud or suction, which has no breaking force to stay below."""
    return [rope for rope in recording.rig.ropes if not rope.comes_free]


def _has_safety(recording: Recording) -> bool:
    """Whether limits or rules ask for slings that carry less than what breaks them."""
    asked = (recording.rig.limits.get(name) for name in _FACTORS)
    return any(limit is not None for limit in asked) or not _absent(recording)


def _absent(recording: Recording) -> list[str]:
    """Factors that the rules lack for rope forces."""
    return [name for name in _NEEDED if factor(recording, name) is None]


def _factor(
    recording: Recording, during: BoolArray, rope: str, strength: float | None, element: str
) -> Iterator[Finding]:
    if strength is None:
        yield Missing(element, _NO_STRENGTH, is_strength=True)
        return
    highest = peak_at_upper_end(recording, rope, during)
    # What rounding of lengths leaves in a rope that just reaches is no force, and a factor on it none.
    if highest is not None and highest.tension > nothing("kN"):
        force = kilonewton(highest.tension - highest.own_weight)
        if highest.own_weight > 0.0:
            force = f"({force} + {OWN_WEIGHT} {kilonewton(highest.own_weight)})"
        # Of what governs: tension [N], when [s], in words.
        most: tuple[float, float | None, str] = (highest.tension, highest.time, force)
        if (by_weight := force_of_weight(recording, rope, during)) is not None:
            if by_weight.static is not None and by_weight.counts_static:
                most = max(most, (by_weight.static, None, by_weight.static_text), key=lambda one: one[0])
            if (way := by_weight.on_the_way) is not None:
                most = max(most, (way.raised, way.time, way.text), key=lambda one: one[0])
        tension, time, text = most
        shown = f"({text})" if " x " in text else text
        contingency = 1.0 if by_weight is None else by_weight.contingency
        more = highest.tension + (contingency - 1.0) * (highest.tension - highest.own_weight)
        at_design = strength / more if more > tension else None
        formula = f"{kilonewton(strength)} / {shown}"
        line = _lead_line(recording, rope)
        with_losses = strength / (line * tension) if line > 1.0 else None
        yield Found(strength / tension, element, time, formula, at_design=at_design, with_losses=with_losses)


def _lead_line(recording: Recording, rope: str) -> float:
    """What a hoist rope has at its drum as it hoists, over its mean; 1 of others, and with losses of its own.

    Of n parts of line each sheave leaves η to the part before, T_k = T_drum η^k, with ΣT_k = n T: it is
    n (1 - η)/(η (1 - η^n)).
    """
    parts = sum(fall.rpartition("/")[0] == rope for hook in recording.rig.hooks for fall in hook.falls)
    if not parts or any(one.rope == rope and one.has_losses for one in recording.rig.sheaves):
        return 1.0
    return parts * (1.0 - _LEAVES) / (_LEAVES * (1.0 - _LEAVES**parts))


def load_of_breaking_force(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Dynamic force times the rule's factors over minimum breaking force; 0027/ND rev 11, 7.2 and 7.3.

    The factor is max(load x consequence x material factor, least safety factor) x wear factor x the larger of
    termination and bending factor. These are for what lifts: mooring lines with a limit of their own are left
    to that.
    """
    absent = _absent(recording)
    forces = sling_forces(recording, during)
    slings = {sling.rope: sling for sling in recording.rig.slings}
    for rope in _of_rope(recording):
        if moors_by_its_limit(recording, rope.name):
            continue
        if absent:
            yield Missing(rope.name, f"the rules have no {', '.join(absent)}")
        elif rope.minimum_breaking_force is None:
            yield Missing(rope.name, _NO_STRENGTH)
        else:
            sling = slings.get(rope.name)
            force = forces[sling.name] if sling is not None else rope_force(recording, rope.name, during)
            yield from _load(recording, rope, at_upper_end(recording, rope.name, force, during))
    if not absent and slings and not any(_is_held(recording, slings, rope) for rope in recording.rig.ropes):
        yield Caution(_NONE_HELD)
    # Of a sling over an extension sheave it is no way out: that has no guides, and its sheave a diameter.
    over_eyes = [rope for rope in recording.rig.ropes if rope.over_eyes and rope.name not in slings]
    if not absent and any(rope.minimum_breaking_force for rope in over_eyes):
        yield Caution(_EYES_TAKE)


def _is_held(recording: Recording, slings: Mapping[str, Sling], rope: Rope) -> bool:
    """Whether a rope is a sling whose breaking force and bending are known."""
    is_known = rope.name in slings and rope.minimum_breaking_force is not None
    return is_known and not isinstance(_bending(recording, rope), str)


def _load(recording: Recording, rope: Rope, force: Force) -> Iterator[Finding]:
    bending = _bending(recording, rope)
    if isinstance(bending, str):
        yield Missing(rope.name, bending)
        return
    if bending is None:
        yield Refused(rope.name, "bent so sharply that no strength is left")
        return
    assert rope.minimum_breaking_force is not None
    more = _lead_line(recording, rope.name)
    for found in over(force, rope.minimum_breaking_force, rope.name, _safety(recording, bending)):
        if isinstance(found, Found) and more > 1.0:
            yield replace(found, with_losses=more * found.value)
        else:
            yield found
    sling = next((one for one in recording.rig.slings if one.rope == rope.name), None)
    if sling is not None:
        yield from bare_ends(sling)


def _safety(recording: Recording, bending: float) -> Raised:
    """max(load x consequence x material, least safety factor) x wear x max(termination, bending)."""
    load, consequence, material, termination = (factor(recording, name) or 1.0 for name in _NEEDED)
    least, wear = (factor(recording, name) or 1.0 for name in _MAY_BE)
    names = [*_NEEDED[:3], *(name for name in _MAY_BE if factor(recording, name) is not None)]
    text = f"{load:.4g} x {consequence:.4g} x {material:.4g}"
    product = load * consequence * material
    if least > product:
        text = f"max({text}, {least:.4g})"
    if wear > 1.0:
        text += f" x wear {wear:.4g}"
    if bending > termination:
        text += f" x bending {bending:.3f}"
    else:
        text += f" x termination {termination:.4g}"
        names.append(_NEEDED[3])
    return Raised(max(product, least) * wear * max(termination, bending), f" x {text}", tuple(names))


def _bending(recording: Recording, rope: Rope) -> float | str | None:
    """Bending factor of a rope, 1 where nothing bends it; why it is not known; None if nothing is left."""
    sling = next((one for one in recording.rig.slings if one.rope == rope.name), None)
    bend = next((one for one in recording.rig.bends if one.rope == rope.name), None)
    diameter = bend.diameter if bend is not None else None
    if sling is not None:
        found = sling_bend(sling)
        if isinstance(found, str):
            return found
        diameter = found[0]
    elif rope.over_eyes:
        return _OVER_EYES
    if diameter is None:
        return 1.0
    if not rope.diameter:
        return "diameter not known"
    return bending_factor(diameter / rope.diameter)


def sheave_bending_ratio(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Pitch diameter of the smallest sheave or drum of a rope over its own."""
    for bend in recording.rig.bends:
        rope = recording.rig.rope(bend.rope)
        if rope is None or not rope.diameter:
            yield Missing(bend.rope, "diameter not known")
        else:
            text = bending_text(bend.diameter, rope.diameter)
            yield Found(bend.diameter / rope.diameter, bend.element, formula=text)


def fleet_angle(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle of a carrying rope to the plane of a sheave."""
    for sheave in recording.rig.wrapped_sheaves:
        angle = series.fleet_angle(recording, sheave)
        yield from extreme(recording, angle, carrying(recording, sheave.rope, during), sheave.name)
