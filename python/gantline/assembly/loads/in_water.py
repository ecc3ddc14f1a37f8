"""A load in water into the cells that the core lets get wet."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.assembly.loads.cells import displaced_volume, lattices
from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.parts import Parts
from gantline.assembly.spatial import Array
from gantline.cad.assumptions import STEEL
from gantline.scenario import Scenario
from gantline.scenario.afloat.water import Water
from gantline.scenario.consistency.in_water import Room, check_room_in_water
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Findings
from gantline.scenario.loads.in_water import InWater
from gantline.scenario.loads.load import Load
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.slinging import slings_on
from gantline.scenario.plan.steps import HoistStep
from gantline.units import format_by_size

__all__ = ["add_in_water", "in_water_name"]

#: Added mass along the axis along which it is largest, over the water that a load displaces, at least [1]: a
#: cylinder has 1 across its axis, a sphere 0.5, and all that is less round more.
_LEAST = 0.1
#: Density of a load over that of steel, at most [1]: lead has 1.44, and all that is lifted has less.
_DENSEST = 1.5


def in_water_name(load: str) -> str:
    """Name of the force of the water on a load, and of what it displaces in recordings."""
    return f"{load}.in_water"


def add_in_water(parts: Parts, scenario: Scenario, load: Load, lifted: LiftedLoad) -> None:
    """Add what water does to a load.

    Raises:
        ScenarioError: if the box of its CAD file has no room for it.
    """
    given = load.in_water
    if given is None:
        return
    water, box = scenario.water or Water(), lifted.body.box
    if load.shape.cad is not None:
        findings = Findings(scenario)
        length, breadth, height = (float(size) for size in np.ptp(box, axis=0))
        check_room_in_water(findings, Room.of_box((length, breadth, height)), given, water.density)
        findings.raise_any()
    current = scenario.current
    parts.forces.append(
        {
            "type": "submerged",
            "name": in_water_name(load.name),
            "body": load.name,
            "lattices": list(lattices(given, load, box, lifted.centre, water.density)),
            "density": water.density,
            "level": water.level,
            "stream": [0.0, 0.0, 0.0] if current is None else list(current.velocity),
        }
    )
    parts.doubts += _floats(scenario, given, load, water)
    parts.doubts += _dense(given, load)
    parts.doubts += _too_much(given, box, water.density)
    parts.doubts += _too_little(given, load, water.density)
    parts.doubts += _free_of_the_bed(scenario, load)


def _floats(scenario: Scenario, given: InWater, load: Load, water: Water) -> Iterator[Doubt]:
    """Of a load that water bears, unless that is what the plan lets it down to or begins with."""
    displaced, weight = water.density * displaced_volume(given, load), load.mass_at_start
    if displaced >= weight and not _is_let_float(scenario, water):
        carried, weighs = (format_by_size(mass, "mass", 4) for mass in (displaced, weight))
        beside = " with what is in its tanks at the start" if load.tanks else ""
        sentence = f"the load floats: it weighs {weighs}{beside} and displaces {carried} of water"
        yield Doubt(("load", "in_water"), f"{sentence}; ropes go slack where it has sunk in so far")


def _is_let_float(scenario: Scenario, water: Water) -> bool:
    """Whether water is all that a load can be left on, and the plan leaves it: no sling on, or all slack."""
    ground = scenario.ground
    may_stand = (
        scenario.supports or scenario.structures or (scenario.mechanics and scenario.mechanics.body_contacts)
    )
    if may_stand or (ground is not None and ground.level < water.level):
        return False
    slack = any(step.until is not None and step.until.slings == "slack" for step in scenario.plan)
    return slack or not all(slings_on(scenario))


def _free_of_the_bed(scenario: Scenario, load: Load) -> Iterator[Doubt]:
    """Of a load that is lifted off a bed under water, which nothing holds there."""
    ground, water = scenario.ground, scenario.water or Water()
    sunk = load.stands_on == "ground" and ground is not None and ground.level < water.level
    lifts = any(
        isinstance(step, HoistStep) or (isinstance(step, LeadStep) and step.by[2] > 0.0)
        for step in scenario.plan
    )
    if not sunk or not lifts:
        return
    ropes = {} if scenario.mechanics is None else scenario.mechanics.ropes or {}
    held = (
        rope.comes_free and {rope.route[0].body, rope.route[-1].body} == {"world", load.name}
        for rope in ropes.values()
    )
    if not any(held):
        sentence = (
            f"{load.name} comes off a bed under water, and no mud or suction holds it there: its hook load "
            "is that off clean rock; a rope of 'mechanics' from the world to it that 'breaks_at' a force, "
            "with 'comes_free: true', stands for what the bed holds with"
        )
        yield Doubt(("load", "stands_on"), sentence)


def _dense(given: InWater, load: Load) -> Iterator[Doubt]:
    """Of a load that displaces less water than one of lead."""
    volume, of_steel = displaced_volume(given, load), load.weight.simulated / STEEL
    if volume * _DENSEST < of_steel:
        weighs = format_by_size(load.weight.simulated, "mass", 4)
        sentence = f"it is {volume:.3g} m^3, and {weighs} of solid steel displace {of_steel:.3g} m^3"
        yield Doubt(("load", "in_water", "displaced_volume"), f"{sentence}; a unit or digit has slipped")


def _too_much(given: InWater, box: Array, density: float) -> Iterator[Doubt]:
    """Of added mass beyond the water in the load's box and that of a plate as large as its side.

    That of a round plate is 8/3 density radius^3, 0.48 density side^1.5 (Lamb, Hydrodynamics, 102); of
    others of that area it is less. Twice as much leaves room for what surface and bed make of it.
    """
    lengths = np.ptp(box, axis=0)
    for axis, mass in enumerate(given.added_mass):
        side = float(np.prod(np.delete(lengths, axis)))
        most = density * (float(np.prod(lengths)) + side**1.5)
        if mass > most:
            shown, room = (format_by_size(one, "mass", 3) for one in (mass, most))
            sentence = f"{shown} along {'xyz'[axis]} are more than the water in the load's box and about it"
            yield Doubt(("load", "in_water", "added_mass"), f"{sentence}, {room}; a unit has slipped")


def _too_little(given: InWater, load: Load, density: float) -> Iterator[Doubt]:
    """Of added mass that is next to none of what the load displaces."""
    water, most = density * displaced_volume(given, load), max(given.added_mass)
    if 0.0 < most < _LEAST * water:
        shown, displaced = (format_by_size(one, "mass", 3) for one in (most, water))
        sentence = f"it is {shown} along an axis at most, and the load displaces {displaced} of water"
        yield Doubt(("load", "in_water", "added_mass"), f"{sentence}; a unit has slipped")
