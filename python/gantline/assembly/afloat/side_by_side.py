"""Vessels whose wave forces come from one computation of them all, side by side as its file has them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from gantline.assembly.afloat.by_itself import about_point, mass_aboard, pumped_content, stiffness_by_water
from gantline.assembly.afloat.databases import from_database
from gantline.assembly.afloat.radiation import memory_of
from gantline.assembly.afloat.vessels import upright_hydrostatics, vessel_hull
from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import Array
from gantline.hydro.database import DatabaseError, ForcesAround, HydrodynamicDatabase
from gantline.hydro.database.model import turn_about_z
from gantline.hydro.side_by_side import ELSEWHERE, Neighbour, asymmetries, forces_side_by_side
from gantline.scenario import Scenario
from gantline.scenario.afloat.vessel import Vessel
from gantline.scenario.afloat.water import Water, WaveForces
from gantline.scenario.errors import Doubt, PathPart
from gantline.units import format_quantity

__all__ = ["SideBySide", "shared_files", "vessels_side_by_side"]

#: A vessel that lies farther than this from where a file has it beside another one is told [m], and so is one
#: with another heading [rad]; past `ELSEWHERE` it is refused.
_APART, _TURNED = 0.2, math.radians(0.5)
#: What bodies do to each other is alike there and back; differences from which on they are told, and refused.
_UNLIKE, _CONTRADICTS = 0.05, 0.25
#: A load stands aboard where more than this share of it is missing to what the hull displaces.
_STANDS = 0.5


@dataclass(frozen=True, eq=False)
class SideBySide:
    """All vessels of one file, in the order in which the lift file has them.

    Attributes:
        names: of vessels.
        bodies: what each is.
        density: of the water [kg/m^3].
    """

    names: tuple[str, ...]
    bodies: tuple[Neighbour, ...]
    density: float

    def forces(self, name: str, frequency: Array) -> ForcesAround:
        """What waves do to one of them while the others float, per metre; ω (n,) [rad/s]."""
        return forces_side_by_side(self.bodies, self.names.index(name), frequency, self.density)

    @property
    def extent(self) -> Array:
        """How far apart their middles lie, along and across the axes of the file (2,) [m]."""
        extent: Array = np.ptp([body.middle for body in self.bodies], axis=0)
        return extent


def shared_files(scenario: Scenario) -> list[set[str]]:
    """Names of vessels whose `wave_forces` are by bodies of one file, for each file with several of them."""
    by_file: dict[Path, set[str]] = {}
    for name, vessel in (scenario.vessels or {}).items():
        if vessel.wave_forces is not None and _database(scenario, name, vessel).others:
            by_file.setdefault(_file(scenario, vessel.wave_forces), set()).add(name)
    return [names for names in by_file.values() if len(names) > 1]


def vessels_side_by_side(parts: Parts, scenario: Scenario) -> dict[str, SideBySide]:
    """What each vessel with `wave_forces` of a body beside others lies among, by its name.

    All masses and dampings of vessels are there.

    Raises:
        ScenarioError: if a body of the file is no vessel of the lift, or vessels lie elsewhere than there.
    """
    files: dict[Path, dict[str, str]] = {}
    for name, vessel in (scenario.vessels or {}).items():
        given = vessel.wave_forces
        if given is None:
            continue
        database = _database(scenario, name, vessel)
        if not database.others:
            continue
        vessels = files.setdefault(_file(scenario, given), {})
        if database.name in vessels:
            sentence = f"'{database.name}' of {given.database} is {vessels[database.name]} already"
            raise scenario.error(_path(name, "body"), f"{sentence}; name another body of the file")
        vessels[database.name] = name
    found: dict[str, SideBySide] = {}
    for vessels in files.values():
        together = _together(parts, scenario, vessels)
        found |= dict.fromkeys(together.names, together)
    return found


def _file(scenario: Scenario, given: WaveForces) -> Path:
    """Its database, by whatever path the lift file names it."""
    return (Path(scenario.source).parent / given.database).resolve()


def _path(name: str, *keys: str) -> tuple[PathPart, ...]:
    return ("vessels", name, "wave_forces", *keys)


def _database(scenario: Scenario, name: str, vessel: Vessel) -> HydrodynamicDatabase:
    given = vessel.wave_forces
    assert given is not None  # asked of those that have them

    def itself(database: HydrodynamicDatabase) -> HydrodynamicDatabase:
        if database.others and database.reference is None:
            counts = "of several bodies each counts phases from one origin"
            sentence = f"does not say where the reference point of {database.name} is ('rotation_center')"
            raise DatabaseError(f"{database.source}: {sentence}; {counts}")
        return database

    return from_database(scenario, _path(name), (given.database, given.body, 0.0), itself)


def _together(parts: Parts, scenario: Scenario, vessels: dict[str, str]) -> SideBySide:
    """Vessels of one file by its bodies."""
    first = next(iter(vessels.values()))
    listed = scenario.vessels or {}
    missing = [one for one in _database(scenario, first, listed[first]).others if one not in vessels]
    given = listed[first].wave_forces
    assert given is not None
    if missing:
        sentence = f"{given.database} has {', '.join(missing)} beside {next(iter(vessels))}"
        right = "a vessel of its own for each by 'body', or a file of one that lies alone"
        found = f"no vessel of the lift has its wave forces by {missing[0]}: waves would be those beside it"
        raise scenario.error(_path(first, "database"), f"{sentence}, and {found}; right is {right}")
    names = tuple(vessels.values())
    bodies = tuple(_neighbour(parts, scenario, name) for name in names)
    for place, name in enumerate(names):
        parts.doubts += _doubts_of_waves(scenario, name)
        for other in range(place):
            parts.doubts += _placed(parts, scenario, (names[other], name), (bodies[other], bodies[place]))
    return SideBySide(names, bodies, (scenario.water or Water()).density)


def _neighbour(parts: Parts, scenario: Scenario, name: str) -> Neighbour:
    """A vessel by itself about the reference point of its file, as it floats at the start."""
    vessel = (scenario.vessels or {})[name]
    database, given = _database(scenario, name, vessel), vessel.wave_forces
    assert given is not None and database.reference is not None
    at = np.array(given.at)
    pumped = pumped_content(scenario, name, vessel)
    mass, centre, own = mass_aboard(parts, name, pumped, _standing(parts, scenario, name))
    inertia = np.zeros((6, 6))
    inertia[:3, :3], inertia[3:, 3:] = mass * np.eye(3), own
    stiffness, _ = stiffness_by_water(scenario, name, vessel, centre)
    damping = np.zeros((6, 6))
    if vessel.radiation is not None:
        for force in _dampings(parts, name):
            damping += about_point({**force, "matrix": force["damping"]}, at)
    box = vessel_hull(scenario, name, vessel).box
    to_middle = np.array([box[:, 0].mean(), 0.0]) - at[:2]
    return Neighbour(
        database,
        given.heading_in_file,
        database.reference[:2] + turn_about_z(given.heading_in_file)[:2, :2].T @ to_middle,
        about_point({"at": centre, "matrix": inertia}, at),
        damping,
        about_point({"at": centre, "matrix": stiffness}, at),
        _water(parts, scenario, name, at),
    )


def _water(parts: Parts, scenario: Scenario, name: str, at: Array) -> Callable[[Array], tuple[Array, Array]]:
    """Added mass and damping that a vessel has in a run, about a point of it [m], by frequency [rad/s]."""
    vessel = (scenario.vessels or {})[name]
    memory = memory_of(scenario, name, vessel)
    if memory is not None and vessel.radiation is not None:
        place, remembered = list(vessel.radiation.at), memory

        def remembers(frequency: Array) -> tuple[Array, Array]:
            added, damping = (
                about_point({"at": place, "matrix": matrix}, at)
                for matrix in (remembered.added_mass(frequency), remembered.damping(frequency))
            )
            return added, damping

        return remembers
    constant = [np.zeros((6, 6)), np.zeros((6, 6))]
    for force in parts.forces:
        if force["name"] == f"{name}.added_mass":
            constant[0] += about_point(force, at)
    for force in _dampings(parts, name):
        constant[1] += about_point({**force, "matrix": force["damping"]}, at)

    def stays(frequency: Array) -> tuple[Array, Array]:
        added, damping = (np.repeat(one[np.newaxis], len(frequency), axis=0) for one in constant)
        return added, damping

    return stays


def _dampings(parts: Parts, name: str) -> list[Json]:
    """What `water_damping` makes of a vessel: it comes on top of `radiation`, or is all there is."""
    names = (f"{name}.water_damping", f"{name}.critical_damping")
    return [force for force in parts.forces if force["type"] == "drag" and force["name"] in names]


def _standing(parts: Parts, scenario: Scenario, name: str) -> list[str]:
    """Load that stands aboard at the start: what is to touch, and without which the hull would lie higher."""
    load = scenario.load
    touching = (scenario.mechanics and scenario.mechanics.body_contacts) or {}
    if load is None or load.name not in parts.bodies:
        return []
    pairs = [contact.between for contact in touching.values() if load.name in contact.between]
    if not any(_is_aboard(parts, other, name) for pair in pairs for other in pair):
        return []
    vessel = (scenario.vessels or {})[name]
    mass, _, _ = mass_aboard(parts, name, pumped_content(scenario, name, vessel))
    missing = upright_hydrostatics(scenario, name, vessel).mass - mass
    return [load.name] if missing > _STANDS * parts.bodies[load.name]["mass"] else []


def _is_aboard(parts: Parts, body: str, vessel: str) -> bool:
    above: str | None = body
    while above in parts.bodies and above != vessel:
        above = parts.bodies[above]["parent"]
    return above == vessel


def _doubts_of_waves(scenario: Scenario, name: str) -> Iterator[Doubt]:
    """Damping that does not count, and added mass that stands alone where nothing else tells."""
    vessel = (scenario.vessels or {})[name]
    forces, damping = vessel.wave_forces, vessel.water_damping
    assert forces is not None
    if vessel.radiation is None and damping is not None and damping.database is None:
        sentence = (
            f"side by side {name} has in waves the damping of {forces.database} and none of 'water_damping'"
        )
        yield Doubt(("vessels", name, "water_damping"), f"{sentence}; beside 'radiation' that comes on top")
    others = (vessel.radiation, vessel.added_mass)
    if not any(one and (one.database, one.body) == (forces.database, forces.body) for one in others):
        for sentence in _database(scenario, name, vessel).outlying(None):
            yield Doubt(_path(name), f"wave forces of {name}: {sentence}")


def _placed(
    parts: Parts, scenario: Scenario, names: tuple[str, str], bodies: tuple[Neighbour, Neighbour]
) -> Iterator[Doubt]:
    """How a vessel lies beside another, and what they do to each other, against the file.

    Raises:
        ScenarioError: if that is another arrangement.
    """
    listed = scenario.vessels or {}
    (one, other), (vessel, beside) = names, (listed[names[0]], listed[names[1]])
    file = beside.wave_forces.database if beside.wave_forces else ""
    yield from _turned(scenario, names, bodies)
    places = []
    for name, of in zip(names, (vessel, beside), strict=True):
        assert of.wave_forces is not None
        places.append(parts.place(name, of.wave_forces.at)[:2])
    lies = turn_about_z(vessel.heading - bodies[0].heading)[:2, :2] @ (places[1] - places[0])
    references = [body.database.reference for body in bodies]
    assert references[0] is not None and references[1] is not None
    by_file = (references[1] - references[0])[:2]
    apart = float(np.hypot(*(lies - by_file)))
    narrow = min(float(np.ptp(vessel_hull(scenario, name, listed[name]).box[:, 1])) for name in names)
    if apart > _APART:
        here, there = (f"({x + 0.0:.2f}, {y + 0.0:.2f}) m" for x, y in (lies, by_file))
        sentence = f"the reference point of {other} lies {here} from that of {one}, along the axes of {file}"
        said = f"{sentence}; there it is {there}, {format_quantity(apart, 'm', 2)} from there"
        path = ("vessels", other, "position")
        if apart > ELSEWHERE.of_breadth * narrow:
            raise scenario.error(path, f"{said}: see 'position' and 'at', or compute the file as they lie")
        yield Doubt(path, said)
    unlike, where = asymmetries(bodies[0].database, bodies[1].database)
    if unlike > _UNLIKE:
        share = f"{100 * unlike:.2g} % of the diagonal"
        sentence = f"{file}: {where}, the same there and back by nature, differ by {share}"
        if unlike > _CONTRADICTS:
            raise scenario.error(_path(other, "database"), f"{sentence}; finer panels agree better")
        yield Doubt(_path(other, "database"), f"{sentence}; their mean is taken")


def _turned(
    scenario: Scenario, names: tuple[str, str], bodies: tuple[Neighbour, Neighbour]
) -> Iterator[Doubt]:
    """A vessel with another heading than the one beside it.

    Raises:
        ScenarioError: if it is another by far.
    """
    one, other = names
    listed = scenario.vessels or {}
    lies, by_file = (
        math.remainder(values[1] - values[0], math.tau)
        for values in (
            [listed[name].heading for name in names],
            [body.heading for body in bodies],
        )
    )
    if abs(math.remainder(lies - by_file, math.tau)) <= _TURNED:
        return
    by_lift, there = (f"{math.degrees(angle):.3g} deg" for angle in (lies, by_file))
    said = f"{other} has a heading of {by_lift} from that of {one}, and by their 'heading_in_file' {there}"
    if abs(math.remainder(lies - by_file, math.tau)) > ELSEWHERE.askew:
        raise scenario.error(("vessels", other, "heading"), f"{said}; they have to be the same")
    yield Doubt(("vessels", other, "heading"), said)
