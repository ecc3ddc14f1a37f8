"""What hangs from a compensator by weights alone, in air and in the water, and where that has its rod."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from gantline.assembly.loads.cells import displaced_volume
from gantline.assembly.yard import lower_lump, upper_lump
from gantline.scenario import Rigging, Scenario
from gantline.scenario.afloat.water import Water
from gantline.scenario.cranes.compensator import Compensator, own_period
from gantline.scenario.rigging import SlingRigging

__all__ = ["Stage", "stages"]


@dataclass(frozen=True)
class Stage:
    """A compensator with the load on it at rest, its seals aside.

    Attributes:
        name: The compensator.
        where: `in air`, or `in the water` of a load that is wholly wet.
        pull: What its gas has to pull, with the weight of its rod [N].
        out: How far the rod is out, between its stops [m].
        period: Own period of the load on the gas [s]; None where the rod is on a stop.
    """

    name: str
    where: str
    pull: float
    out: float
    period: float | None


def stages(scenario: Scenario, rigging: Rigging) -> Iterator[Stage]:
    """Each compensator from which all of the load hangs, in air and in the water.

    Of one that bears a part of the load nothing is known before the lift is at rest.
    """
    load, gravity = scenario.load, scenario.simulation.gravity
    if load is None:
        return
    for name, given in (scenario.compensators or {}).items():
        gear = _gear_below(scenario, rigging, name)
        if gear is None:
            continue
        mass = load.mass_at_start + gear + given.rod.mass
        yield _stage(name, "in air", given, mass * gravity, mass)
        if load.in_water is not None:
            density = (scenario.water or Water()).density
            buoyancy = density * displaced_volume(load.in_water, load) * gravity
            wet = mass + load.in_water.added_mass[2]
            yield _stage(name, "in the water", given, mass * gravity - buoyancy, wet)


def _stage(name: str, where: str, given: Compensator, pull: float, mass: float) -> Stage:
    law = given.law
    if pull <= law.rod_in:
        return Stage(name, where, pull, 0.0, None)
    if pull >= law.pull(given.stroke):
        return Stage(name, where, pull, given.stroke, None)
    return Stage(name, where, pull, law.out(pull), own_period(given, pull, mass))


def _gear_below(scenario: Scenario, rigging: Rigging, name: str) -> float | None:
    """Mass of slings and gear below a compensator [kg]; None if the load hangs elsewhere too."""
    slings = rigging.slings.values()
    below: set[str] = {name}
    while grown := {end.held for one in slings if one.above in below for end in one.ends} - {None} - below:
        below |= {held for held in grown if held is not None}
    own = [one for one in slings if one.above in below]
    if not any(one.lugs for one in own) or any(one.lugs and one not in own for one in slings):
        return None
    if any(end.held in below - {name} for one in slings if one not in own for end in one.ends):
        return None
    spreaders, compensators = scenario.spreaders or {}, scenario.compensators or {}
    masses = [spreaders[one].mass for one in below if one in spreaders]
    masses += [compensators[one].mass for one in below - {name} if one in compensators]
    masses += [rigging.extensions[one].mass for one in below if one in rigging.extensions]
    return math.fsum([*masses, *map(_mass, own)])


def _mass(sling: SlingRigging) -> float:
    return upper_lump(sling) + len(sling.ends) * lower_lump(sling)
