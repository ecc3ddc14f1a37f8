"""A load in water into the cells that the core lets get wet."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gantline.assembly.lifted import LiftedLoad
from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import Array
from gantline.cad.assumptions import STEEL
from gantline.scenario import Scenario
from gantline.scenario.check_in_water import check_box_in_water
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Findings
from gantline.scenario.in_water import InWater
from gantline.scenario.load import Load
from gantline.scenario.slinging import slings_on
from gantline.scenario.steps import HoistStep
from gantline.scenario.water import Water
from gantline.units import format_by_size

__all__ = ["add_in_water", "displaced_volume", "in_water_name"]

#: Layers of cells over a height.
_LAYERS = 8
#: Of the two places of Gauss on each side of the middle, in halves of a length: exact for cubics.
_GAUSS = 1.0 / np.sqrt(3.0)
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
    if load.shape.box is None:
        findings = Findings(scenario)
        length, breadth, height = (float(size) for size in np.ptp(box, axis=0))
        check_box_in_water(findings, (length, breadth, height), given, water.density)
        findings.raise_any()
    current = scenario.current
    parts.forces.append(
        {
            "type": "submerged",
            "name": in_water_name(load.name),
            "body": load.name,
            "lattices": list(_lattices(given, load, box, lifted.centre, water.density)),
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


def displaced_volume(given: InWater, load: Load) -> float:
    """What it displaces, wholly wet, with the inside of its tanks [m^3]."""
    of_steel = load.weight.simulated / STEEL + load.room_volume
    return of_steel if given.displaced_volume is None else given.displaced_volume


def _lattices(given: InWater, load: Load, box: Array, centre: Array, density: float) -> Iterator[Json]:
    """Its cells, from its centre of gravity: layers of four, of tanks too, and of what slams where it does.

    What a tank displaces is where the tank is: full of the water around it weighs nothing there.

    Args:
        given: What water does to it.
        load: The load.
        box: Its least and largest x, y, z from its datum (2, 3) [m].
        centre: Of gravity, from its datum (3,) [m].
        density: Of the water [kg/m^3].
    """
    length, breadth, height = np.ptp(box, axis=0)
    sides = np.array([breadth * height, length * height, length * breadth])
    drag = 0.5 * density * np.array(given.drag_coefficients) * sides
    added = np.array(given.added_mass)
    depth = given.slamming_depth(float(sides[2]), density)
    slamming = np.zeros(3) if depth is None else added * [0.0, 0.0, 1.0]
    members = displaced_volume(given, load) - load.room_volume
    yield _lattice(box - centre, height, members, added - slamming, drag)
    for tank in (load.tanks or {}).values():
        (x, y, z), sizes = tank.bottom, np.array(tank.box)
        least = np.array([x - sizes[0] / 2, y - sizes[1] / 2, z])
        inside = np.array([least, least + sizes]) - centre
        yield _lattice(inside, tank.box[2], math.prod(tank.box), np.zeros(3), np.zeros(3))
    if depth is not None:
        yield _lattice(box - centre, depth, 0.0, slamming, np.zeros(3))


def _lattice(box: Array, height: float, volume: float, added: Array, drag: Array) -> Json:
    """Cells that share out what a load has, in layers over a height above its underside.

    Args:
        box: Its least and largest x, y, z (2, 3) [m].
        height: Of all layers [m].
        volume: That it displaces [m^3].
        added: Added mass along x, y, z (3,) [kg].
        drag: Force over speed squared along them (3,) [N s^2/m^2].
    """
    thick, count = height / _LAYERS, 4 * _LAYERS
    middle = box.mean(axis=0)
    return {
        "at": [float(middle[0]), float(middle[1]), float(box[0, 2] + thick / 2)],
        "half": (_GAUSS * np.ptp(box, axis=0)[:2] / 2).tolist(),
        "height": float(thick),
        "layers": _LAYERS,
        "volume": volume / count,
        "added_mass": (added / count).tolist(),
        "quadratic": (drag / count).tolist(),
    }


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
    if not sunk or not any(isinstance(step, HoistStep) for step in scenario.plan):
        return
    ropes = {} if scenario.mechanics is None else scenario.mechanics.ropes or {}
    held = (
        rope.breaks_at is not None and {rope.route[0].body, rope.route[-1].body} == {"world", load.name}
        for rope in ropes.values()
    )
    if not any(held):
        sentence = (
            f"{load.name} comes off a bed under water, and no mud or suction holds it there: its hook load "
            "is that off clean rock; a rope of 'mechanics' from the world to it that 'breaks_at' a force "
            "stands for what the bed holds with"
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
