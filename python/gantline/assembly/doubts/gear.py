"""What can be built of ropes, shackles and ground and cannot well be meant: a unit has slipped."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gantline.assembly.loads.load_body import radii_of_another
from gantline.cad.assumptions import STEEL
from gantline.scenario import Rigging, Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.scenario.gear import RopeMaterial
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.steps import LowerStep
from gantline.units import format_by_size

__all__ = ["doubtful_gear"]

#: By its law a rope pulls up to its damping time before it is taut [s].
_LONGEST_DAMPING = 0.5
_STEEL_DAMPING = "2 ms to 20 ms is usual for steel"
#: Elastic ropes break at 1.5 % (steel) to some ten per cent (fibre) of stretch; beyond these shares force and
#: stiffness are not of one rope [1].
_LEAST_STRETCH, _MOST_STRETCH = 0.002, 1.0
#: Modulus of solid steel [Pa], EN 1993-1-1, 3.2.6: no rope is stiffer over its circle.
_STEEL_MODULUS = 210e9
#: Ropes of fibre weigh a tenth of a bar of steel as thick, none of steel as much as that [1]; chain, whose
#: diameter is that of its bar of which two lie side by side, 3.2 to 3.6 times as much: 20 to 22 t/m times d².
_LIGHTEST_ROPE, _HEAVIEST_ROPE = 0.02, 5.0
#: What ropes break at over their circle [Pa]: compacted steel of grade 2160 some 1500 MPa, soft fibre 50 MPa.
_WEAKEST_ROPE, _STRONGEST_ROPE = 5e6, 3e9
#: Slings that stretch by this share under their part of the load are none [1]; those of nylon by a tenth.
_MOST_OF_LENGTH = 0.2
#: Shackles break at 4 to 6 times their limit; beyond this force and limit are not of one shackle [1].
_MOST_STRENGTH = 15.0
#: Shackles weigh some thousandths of their limit; more than this share is a slip [1].
_HEAVIEST = 0.03
#: Frames and spreaders weigh some hundredths of what they may carry; less than this share is a slip [1].
_LIGHTEST = 0.002
#: Radii of gyration of a frame about its middle are about 0.3 of its length [1].
_RADII = (0.03, 1.0)
#: Lugs and drop links reach so far from a spreader [m], of short ones this share of the longest side [1].
_OFF, _OFF_SHARE = 1.0, 0.25
#: Coefficients of friction of what loads stand on are 0.1 to 1; more than this is none [1].
_ROUGHEST = 2.0


def doubtful_gear(scenario: Scenario, rigging: Rigging) -> list[Doubt]:
    """Each thing that cannot well be meant of ropes, shackles, frames and friction."""
    gear = [*_ropes(scenario), *_soft_slings(scenario), *_sharp_eyes(rigging), *_shackles(scenario)]
    spreaders = (scenario.spreaders or {}).items()
    light = [
        doubt
        for name, one in spreaders
        for doubt in _of_its_rating(("spreaders", name), f"spreader {name}", one.mass, one.rated_capacity)
    ]
    return [
        *gear,
        *_frames(rigging),
        *light,
        *_spreaders_of_another_inertia(scenario),
        *_off_spreaders(scenario),
        *_rough(scenario),
        *_smooth(scenario),
    ]


def _ropes(scenario: Scenario) -> Iterator[Doubt]:
    for name, rope in (scenario.ropes or {}).items():
        if rope.damping_time > _LONGEST_DAMPING:
            pulls = "it pulls up to that long before it is taut, and hides how the lift rings"
            sentence = f"rope {name} has a damping time of {rope.damping_time:g} s: {pulls}; {_STEEL_DAMPING}"
            yield Doubt(("ropes", name), sentence)
        yield from _of_its_diameter(name, rope)
        stiffness, force = rope.stiffness, rope.breaking_force
        solid = _STEEL_MODULUS * math.pi / 4 * (rope.diameter or math.inf) ** 2
        if stiffness is not None and stiffness > solid:
            bar = f"a bar of solid steel of {_short(1e3 * (rope.diameter or 0.0))} mm has {_force(solid)}"
            sentence = (
                f"rope {name} has an EA of {_force(stiffness)}, and {bar}; one of both has a wrong unit"
            )
            yield Doubt(("ropes", name), sentence)
            continue
        if rope.curve is not None:
            yield from _of_its_curve(name, rope)
            continue
        if stiffness is None or force is None:
            continue
        stretch = force / stiffness
        if not _LEAST_STRETCH <= stretch <= _MOST_STRETCH:
            figures = f"breaks at {_force(force)} and has an EA of {_force(stiffness)}"
            at = f"it would break at {_short(100.0 * stretch)} % of stretch"
            usual = "about 1.5 % is usual for steel; one of both has a wrong unit"
            yield Doubt(("ropes", name), f"rope {name} {figures}: {at}; {usual}")


def _of_its_curve(name: str, rope: RopeMaterial) -> Iterator[Doubt]:
    """Strains that no rope has: a percent sign has been lost, or written where there was none."""
    assert rope.curve is not None
    points, force = rope.curve, rope.breaking_force
    stretch = points.strain[-1] if force is None else points.strain_under(force)
    if _LEAST_STRETCH <= stretch <= _MOST_STRETCH:
        return
    where = "at the last point of its curve" if force is None else f"where it breaks, at {_force(force)}"
    usual = "ropes break at about 1.5 % of steel to some ten per cent of fibre"
    sentence = f"rope {name} stretches by {_short(100.0 * stretch)} % {where}; {usual}"
    yield Doubt(
        ("ropes", name, "curve"), f"{sentence}, and a % has been lost or added, or a unit has slipped"
    )


def _of_its_diameter(name: str, rope: RopeMaterial) -> Iterator[Doubt]:
    """A mass or a strength that no rope of its diameter has."""
    if rope.diameter is None:
        return
    thick, area = f"{_short(1e3 * rope.diameter)} mm", math.pi / 4 * rope.diameter**2
    full = rope.mass_per_length / (STEEL * area)
    if rope.mass_per_length > 0.0 and not _LIGHTEST_ROPE <= full <= _HEAVIEST_ROPE:
        figures = f"is {thick} thick and weighs {_short(rope.mass_per_length)} kg/m"
        bar = f"a bar of solid steel has {_short(STEEL * area)} kg/m"
        yield Doubt(("ropes", name), f"rope {name} {figures}: {bar}; one of both has a wrong unit")
    force = rope.breaking_force
    if force is not None and not _WEAKEST_ROPE <= force / area <= _STRONGEST_ROPE:
        figures = f"is {thick} thick and breaks at {_force(force)}"
        over = f"{_short(force / area / 1e6)} N/mm^2 over its circle"
        usual = "ropes of steel have 500 to 1200, of fibre 100 to 1500"
        yield Doubt(("ropes", name), f"rope {name} {figures}, {over}; {usual}: one of both has a wrong unit")


def _soft_slings(scenario: Scenario) -> Iterator[Doubt]:
    """Of slings that would stretch by much of their length under their part of the load."""
    slings, load = scenario.slings or {}, scenario.load
    if load is None or not slings:
        return
    part = load.mass_at_start * scenario.simulation.gravity / len(slings)
    defaults = scenario.sling_defaults
    used = {sling.rope or (None if defaults is None else defaults.rope) for sling in slings.values()}
    for name, rope in (scenario.ropes or {}).items():
        stretch = 0.0 if rope.stiffness is None else rope.strain_under(part)
        if name in used and stretch > _MOST_OF_LENGTH:
            has = "a curve" if rope.curve is not None else f"an EA of {_force(rope.stiffness or 0.0)}"
            yield Doubt(
                ("ropes", name),
                f"rope {name} has {has}: its slings would stretch by "
                f"{_short(100.0 * stretch)} % under their part of the load; a unit has slipped, kN for MN",
            )


def _sharp_eyes(rigging: Rigging) -> Iterator[Doubt]:
    """Of eyes that bend about less than the rope of their sling is thick, all that do so alike at once."""
    alike: dict[tuple[str, float, float], list[tuple[str, str]]] = {}
    for name, sling in rigging.slings.items():
        for end, held in (("top", sling.top), ("bottom", sling.bottom)):
            about = sling.bends_about.get(end) if held is None else held[1].bow_diameter
            thick = sling.rope.diameter
            if about is not None and thick is not None and about < thick:
                by = "bends_about" if held is None else "shackles"
                alike.setdefault((by, about, thick), []).append((name, end))
    for (by, about, thick), eyes in alike.items():
        name, end = eyes[0]
        more = f" (and {len(eyes) - 1} more)" if len(eyes) > 1 else ""
        # What is left by 0027/ND rev 11, 7.8.1.
        share = max(0.0, 1.0 - 0.5 / math.sqrt(about / thick))
        left = f"{_short(100.0 * share)} % of what it breaks at is left" if share else "no strength is left"
        yield Doubt(
            ("slings", name, by),
            f"the {end} eye of {name}{more} bends about {_short(1e3 * about)} mm, less than the "
            f"{_short(1e3 * thick)} mm of its rope: {left}; rules ask for the diameter of the rope at least",
        )


def _shackles(scenario: Scenario) -> Iterator[Doubt]:
    for name, shackle in (scenario.shackles or {}).items():
        limit, force = shackle.working_load_limit, shackle.minimum_breaking_force
        if force is not None:
            strength = force / (limit * scenario.simulation.gravity)
            if strength > _MOST_STRENGTH:
                figures = f"breaks at {_force(force)}, {_short(strength)} times its limit of {_mass(limit)}"
                usual = "4 to 6 times is usual, and one of both has a wrong unit"
                yield Doubt(("shackles", name), f"shackle {name} {figures}; {usual}")
        if shackle.mass > _HEAVIEST * limit:
            figures = f"weighs {_mass(shackle.mass)} and may carry {_mass(limit)}"
            usual = "some thousandths are usual, and one of both has a wrong unit"
            yield Doubt(("shackles", name), f"shackle {name} {figures}; {usual}")


def _frames(rigging: Rigging) -> Iterator[Doubt]:
    for name, equalizer in rigging.equalizers.items():
        frame, rated = equalizer.frame, equalizer.rated_capacity
        path = ("equalizers", name)
        yield from _of_its_rating(path, f"the frame of {name}", frame.mass, rated)
        if frame.inertia_about_vertical is None:
            continue
        radius = math.sqrt(frame.inertia_about_vertical / frame.mass)
        if not _RADII[0] < radius / frame.length < _RADII[1]:
            figures = f"has a radius of gyration of {_short(radius)} m and a length of {frame.length:g} m"
            yield Doubt(path, f"the frame of {name} {figures}; a unit of its inertia or mass has slipped")


def _of_its_rating(path: Path, what: str, mass: float, rated: float | None) -> Iterator[Doubt]:
    """A frame or spreader that is too light for what it may carry, or heavier than that."""
    if rated is None or _LIGHTEST * rated <= mass <= rated:
        return
    slipped = "a unit has slipped, kg for t" if mass < rated else "a unit or digit has slipped"
    yield Doubt(path, f"{what} weighs {_mass(mass)} and may carry {_mass(rated)}; {slipped}")


def _spreaders_of_another_inertia(scenario: Scenario) -> Iterator[Doubt]:
    for name, one in (scenario.spreaders or {}).items():
        if one.inertia is None:
            continue
        half = np.array(one.size) / 2.0
        box = np.array([-half, half])
        found = radii_of_another(one.inertia, one.mass, np.array(one.centre_of_gravity), box)
        if found:
            radii = "make radii of gyration that its box does not allow"
            said = f"the inertia and the mass of spreader {name} {radii}"
            sentence = f"{said}: {', '.join(found)}; a unit or digit of one of both has slipped"
            yield Doubt(("spreaders", name, "inertia"), sentence)


def _off_spreaders(scenario: Scenario) -> Iterator[Doubt]:
    """Each spreader with lugs so far off its box that this seems to lie otherwise."""
    for name, spreader in (scenario.spreaders or {}).items():
        off = {lug: spreader.off(one.at) for lug, one in spreader.lugs.items()}
        most = min(_OFF, _OFF_SHARE * max(spreader.size))
        far = [lug for lug, distance in off.items() if distance > most]
        if far:
            lie = f"of spreader {name} lie up to {_short(max(off.values()))} m outside of its box"
            sentence = (
                f"lugs {', '.join(far)} {lie}; both are counted from its middle, length x and breadth y"
            )
            yield Doubt(("spreaders", name, "lugs", far[0]), sentence)


def _rough(scenario: Scenario) -> Iterator[Doubt]:
    ground = scenario.ground
    places: dict[Path, tuple[str, float | None]] = {
        ("ground",): ("the ground", None if ground is None else ground.friction)
    }
    for name, group in (scenario.supports or {}).items():
        places["supports", name] = f"supports {name}", group.friction
    mechanics = scenario.mechanics
    for kind in ("contacts", "body_contacts"):
        for name, contact in (getattr(mechanics, kind, None) or {}).items():
            places["mechanics", kind, name] = f"contact {name}", contact.friction
    for path, (place, friction) in places.items():
        if friction is not None and friction > _ROUGHEST:
            usual = f"0.1 to 1 is usual; '{friction:g} %' is {friction / 100.0:g}"
            sentence = f"the coefficient of friction of {place} is {friction:g}; {usual}"
            yield Doubt((*path, "friction"), sentence)


def _smooth(scenario: Scenario) -> Iterator[Doubt]:
    """Each group of supports that a load comes down on, if nothing says their friction."""
    load = scenario.load
    lowers = any(
        isinstance(step, LowerStep) or (isinstance(step, LeadStep) and step.by[2] < 0.0)
        for step in scenario.plan
    )
    if load is None or not lowers:
        return
    for name, group in (scenario.supports or {}).items():
        own = (*(group.each or {}).values(), *(group.places or {}).values())
        if name != load.stands_on and all(one.friction is None for one in (group, *own)):
            slides = "a load that is set down there slides on as on ice"
            sentence = f"nothing says the friction of supports {name}: {slides}; 0.1 to 1 is usual"
            yield Doubt(("supports", name), sentence)


def _force(force: float) -> str:
    return format_by_size(force, "force")


def _mass(mass: float) -> str:
    return format_by_size(mass, "mass")


def _short(number: float) -> str:
    """A number in three digits, however large."""
    return f"{float(f'{number:.3g}'):,.15g}"
