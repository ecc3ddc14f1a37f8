"""Compensators: cylinder and rod as bodies, the gas between them as a rope with a curve."""

from __future__ import annotations

import numpy as np

from gantline.assembly.parts import ORIGIN, Json, Parts, box_shape, end, material
from gantline.assembly.spatial import Array, inertia_list
from gantline.assembly.yard import lower_lump, slider, upper_lump
from gantline.scenario import Rigging
from gantline.scenario.cranes.compensator import Compensator, gas_rope, rod_of
from gantline.scenario.curve import RopeCurve
from gantline.scenario.gear import RopeMaterial

__all__ = ["add_compensator", "compensator_shapes", "gas_kind", "hung_mass"]

#: The curve of the gas goes on past both ends by this share of the stroke, and of the length: stops give [1].
_PAST = 0.05
#: Strain of the rope that stands for the gas at the first point of its curve [1].
_FIRST = 0.01


def add_compensator(
    parts: Parts, rigging: Rigging, name: str, given: Compensator, pins: dict[str, bool]
) -> None:
    """Cylinder and rod, upright at the origin until their place is known; the gas comes with the ropes.

    Frames of both are at their bearings, z up.
    """
    still = {"velocity": [0.0, 0.0, 0.0], "angular_velocity": [0.0, 0.0, 0.0]}
    free = {"type": "free", "position": list(ORIGIN), "orientation": [1.0, 0.0, 0.0, 0.0], **still}
    own = given.cylinder
    parts.add_body(
        name,
        free,
        mass=own.mass,
        centre_of_gravity=(0.0, 0.0, -0.5 * own.length),
        inertia=inertia_list(_solid_cylinder(own.mass, own.length, own.diameter)),
    )
    rod = rod_of(name)
    stops = {
        "lower": 0.0,
        "upper": given.stroke,
        "stiffness": given.stop_stiffness,
        "damping_time": given.stop_damping_time,
    }
    parts.add_body(
        rod,
        {
            **slider((0.0, 0.0, -1.0), None, stops),
            "position": given.out_at_start,
            "damping": given.damping,
            # A pin holds the rod whatever that takes; plans that move it are refused where seals rub.
            "friction": 0.0 if rod in pins else given.seal_friction,
            "pin": pins.get(rod),
        },
        parent=name,
        position=(0.0, 0.0, -given.length),
        mass=given.rod.mass,
        centre_of_gravity=(0.0, 0.0, 0.5 * given.rod_length),
        inertia=inertia_list(_solid_cylinder(given.rod.mass, given.rod_length, given.rod.diameter)),
    )
    for sling in rigging.slings.values():
        if sling.compensator == name:
            parts.lump(rod, ORIGIN, upper_lump(sling))
        for _ in (one for one in sling.ends if one.compensator == name):
            parts.lump(name, ORIGIN, lower_lump(sling))
    length, kind = gas_kind(given)
    route = [end(name), end(rod)]
    parts.add_rope(gas_rope(name), length, material(kind), route, is_stretched=True)


def gas_kind(given: Compensator) -> tuple[float, RopeMaterial]:
    """Length [m] and kind of a rope from bearing to bearing that pulls as the gas does: (PC3).

    Its curve begins a little below the stroke and ends a little above it, since stops give.
    """
    law = given.law
    below = min(_PAST * given.stroke, _PAST * given.length)
    above = min(_PAST * given.stroke, 0.5 * (law.column - given.stroke))
    length = (given.length - below) / (1.0 + _FIRST)
    ways = law.ways(-below, given.stroke + above)
    strains = tuple((given.length + out) / length - 1.0 for out in ways)
    curve = RopeCurve.model_construct(strain=strains, tension=tuple(map(law.pull, ways)))
    return length, RopeMaterial.model_construct(curve=curve)


def hung_mass(parts: Parts, name: str, given: Compensator) -> tuple[float, Array]:
    """Mass of cylinder and rod with all that is lumped on them [kg], and its centre in the cylinder [m]."""
    bodies = [(parts.bodies[name], 0.0), (parts.bodies[rod_of(name)], -given.length - given.out_at_start)]
    mass = sum(body["mass"] for body, _ in bodies)
    places = (np.array(body["centre_of_gravity"]) + np.array((0.0, 0.0, z)) for body, z in bodies)
    moment = sum(body["mass"] * place for (body, _), place in zip(bodies, places, strict=True))
    return mass, moment / mass


def compensator_shapes(given: Compensator) -> tuple[Json, Json]:
    """Boxes around cylinder and rod, in the frames of their bodies."""
    (wide, long), (thin, reach) = (
        (given.cylinder.diameter, given.cylinder.length),
        (given.rod.diameter, given.rod_length),
    )
    return (
        box_shape((wide, wide, long), (0.0, 0.0, -0.5 * long)),
        box_shape((thin, thin, reach), (0.0, 0.0, 0.5 * reach)),
    )


def _solid_cylinder(mass: float, length: float, diameter: float) -> Array:
    """Inertia (3, 3) of a homogeneous cylinder along z about its middle [kg m^2]."""
    across = mass * (0.75 * diameter**2 + length**2) / 12.0
    return np.diag([across, across, mass * diameter**2 / 8.0])
