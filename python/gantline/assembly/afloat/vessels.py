"""Vessels as bodies: axes at stern, keel and centre plane, x forward, y to port, z up."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence

import numpy as np

from gantline.assembly.afloat.carriers import add_carried_vessel, wave_drive
from gantline.assembly.afloat.deck import bottom_edge, deck_edge, sunk_share
from gantline.assembly.afloat.hulls import HullMesh, hull_mesh, hull_shape
from gantline.assembly.afloat.water import hull_name
from gantline.assembly.joints import placed_at_start
from gantline.assembly.parts import Json, Parts, box_shape
from gantline.assembly.spatial import Array, about_axis, quaternion_product, rotation_matrix
from gantline.hydro import Attitude, Hull, Hydrostatics, hydrostatics
from gantline.hydro.database import AXES
from gantline.hydro.waves import wave_number
from gantline.scenario import Scenario
from gantline.scenario.afloat.vessel import CAPSIZED_BEYOND, DECK_EDGE, Vessel
from gantline.scenario.afloat.water import Water
from gantline.scenario.consistency.vessels import check_inside
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Findings
from gantline.scenario.plan.movers import movers
from gantline.scenario.plan.steps import LineStep

__all__ = [
    "add_vessels",
    "adrift",
    "drifted",
    "misplaced",
    "off_their_decks",
    "slid",
    "upright_hydrostatics",
    "vessel_hull",
    "vessel_hulls",
    "vessel_rig",
    "vessel_shape",
    "watch_vessels",
    "way_of",
]

#: More of a hull that looks up and is under water than this is told [of all that looks up].
_SUNK_SILENTLY = 0.02
#: A vessel or load that the way to rest takes farther than this was not meant to go there [m].
_ADRIFT = 1.0
#: A load that stands aboard this much higher or lower than the lift file has it is not where it stands [m].
_OFF_DECK = 0.25
#: What that makes of slings.
_SLINGS = {"higher": "slacker", "lower": "tighter"}
#: One whose heel and trim come out farther than this from those of the lift file was not meant so [rad]: the
#: head of a boom is 1 m elsewhere then.
_LEANS = math.radians(0.5)
#: Points of a deck's edge over the length of the waves; pieces over the length of the vessel, at most.
_PER_WAVE, _MOST_PIECES = 24, 200


def add_vessels(parts: Parts, scenario: Scenario) -> None:
    """Add a body for each vessel, with what it weighs by itself, where it is at the start.

    It is free, or carried by what waves do to it.

    Raises:
        ScenarioError: if the file of a hull cannot be used, or draft, tanks or openings do not fit it.
    """
    level = (scenario.water or Water()).level
    for name, vessel in (scenario.vessels or {}).items():
        start, centre = _start(scenario, name, vessel, level), vessel.centre_of_gravity
        if vessel.is_carried:
            add_carried_vessel(parts, name, vessel, start)
            continue
        own = vessel.own_inertia
        inertia = (own.xx, own.yy, own.zz, own.xy, own.xz, own.yz)
        parts.add_body(name, start, mass=vessel.mass, centre_of_gravity=centre, inertia=inertia)


def _start(scenario: Scenario, name: str, vessel: Vessel, level: float) -> Json:
    """The free joint: turned by its heading, then trimmed, then heeled about its own long axis.

    The water is `draft` from the keel, along the vessel's z at half length in the centre plane.
    """
    turned = quaternion_product(about_axis((0, 0, 1), vessel.heading), about_axis((0, -1, 0), vessel.trim))
    orientation = quaternion_product(turned, about_axis((1, 0, 0), vessel.heel))
    box = vessel_hull(scenario, name, vessel).box
    if vessel.hull.extent is None:  # that of a box was checked with the lift file
        findings = Findings(scenario)
        low, high = box.tolist()
        check_inside(findings, ("vessels", name), vessel, (tuple(low), tuple(high)))
        findings.raise_any()
    at_water = np.array([box[:, 0].mean(), 0.0, vessel.draft])
    height = level - float((rotation_matrix(orientation) @ at_water)[2])
    return {
        "type": "free",
        "position": [*vessel.position, height],
        "orientation": orientation,
        "velocity": [0.0, 0.0, 0.0],
        "angular_velocity": [0.0, 0.0, 0.0],
    }


def vessel_hull(scenario: Scenario, name: str, vessel: Vessel) -> HullMesh:
    """The hull of a vessel in its axes.

    Raises:
        ScenarioError: if its file cannot be read, or holds no hull.
    """
    hull = hull_mesh(scenario, name, vessel)
    assert hull is not None  # a vessel has one
    return hull


def upright_hydrostatics(
    scenario: Scenario, name: str, vessel: Vessel, draft: float | None = None
) -> Hydrostatics:
    """Hydrostatics upright at a draft [m], at that of the start if not given; no deeper than its hull.

    Raises:
        ScenarioError: if the file of its hull cannot be read, or holds no hull.
    """
    mesh = vessel_hull(scenario, name, vessel)
    hull = Hull(name, mesh.vertices, mesh.triangles)
    density = (scenario.water or Water()).density
    draft = min(vessel.draft if draft is None else draft, float(hull.box[1, 2]))
    return hydrostatics(hull, Attitude(draft, middle=float(np.mean(hull.box[:, 0]))), density)


def vessel_shape(scenario: Scenario, name: str) -> Json:
    """The hull of a vessel to draw, in its axes: a box, or a light mesh with the corners to touch it with."""
    vessel = (scenario.vessels or {})[name]
    hull = vessel_hull(scenario, name, vessel)
    if vessel.hull.mesh is not None:
        return hull_shape(hull)
    box = hull.box
    return box_shape(np.ptp(box, axis=0), box.mean(axis=0))


def watch_vessels(parts: Parts, scenario: Scenario) -> None:
    """Let the core look out for deck edges and openings that go under water, and for vessels that capsize."""
    level = (scenario.water or Water()).level
    for name in scenario.vessels or {}:
        points = _marks(scenario, name)
        parts.doubts += _sunk(scenario, name)
        marks = [{"name": f"{name}.{mark}", "points": places} for mark, places in points.items()]
        bottom = bottom_edge(vessel_hull(scenario, name, (scenario.vessels or {})[name]))
        watched = {"name": name, "body": name, "level": level, "capsized_beyond": CAPSIZED_BEYOND}
        parts.vessels.append({**watched, "bottom": bottom, "marks": marks})


def _sunk(scenario: Scenario, name: str) -> list[Doubt]:
    """Where much of what looks up is under water at the draft of the lift file."""
    vessel = (scenario.vessels or {})[name]
    share = sunk_share(vessel_hull(scenario, name, vessel), vessel.draft)
    if share <= _SUNK_SILENTLY:
        return []
    sunk = (
        f"{100.0 * share:.0f} % of what looks up on the hull of {name} is under water at {vessel.draft:g} m"
    )
    sentence = f"{sunk} of draft: pontoons, if that is right; the deck's edge is that of the rest"
    return [Doubt(("vessels", name, "draft"), sentence)]


def vessel_rig(scenario: Scenario, parts: Parts) -> list[Json]:
    """What results need to know of vessels."""
    water = scenario.water or Water()
    found = []
    for name, vessel in (scenario.vessels or {}).items():
        along = vessel_hull(scenario, name, vessel).box[:, 0].tolist()
        found.append(
            {
                "name": name,
                "body": name,
                "centre_of_gravity": list(parts.bodies[name]["centre_of_gravity"]),
                "ends": along,
                "level": water.level,
                "density": water.density,
                "hull": hull_name(name),
                "marks": _marks(scenario, name),
                **({"is_carried": True} if vessel.is_carried else {}),
                **_of_record(parts, name, vessel),
            }
        )
    return found


def _of_record(parts: Parts, name: str, vessel: Vessel) -> Json:
    """How long the record grows by which a vessel goes, if it goes by one."""
    if vessel.wave_motion is None or vessel.wave_motion.record is None:
        return {}
    return {"grows_over": parts.drives[wave_drive(name, AXES[0])]["waves"]["rise_time"]}


def _marks(scenario: Scenario, name: str) -> dict[str, list[list[float]]]:
    """Points of a vessel that should stay above the water, by what they belong to."""
    vessel = (scenario.vessels or {})[name]
    openings = {opening: [list(at)] for opening, at in (vessel.openings or {}).items()}
    mesh = vessel_hull(scenario, name, vessel)
    return {DECK_EDGE: deck_edge(mesh, _seen_by_waves(scenario, mesh), vessel.draft), **openings}


def _seen_by_waves(scenario: Scenario, mesh: HullMesh) -> float | None:
    """How far apart points of a deck's edge have to be that no crest passes between them [m]; None: any way.

    In still water the lowest point of a side is one of its ends. A wave of the length λ is higher between two
    points d apart than at both by up to 1 - cos(πd/λ) of its amplitude: 0.9 % of one as long as the peak's.
    """
    if not scenario.waves:
        return None
    fastest = max(2 * math.pi / train.main_period for train in scenario.waves.values())
    number = wave_number(np.array([fastest]), scenario.simulation.gravity, (scenario.water or Water()).depth)
    return max(
        2 * math.pi / float(number[0]) / _PER_WAVE, float(np.ptp(mesh.box, axis=0).max()) / _MOST_PIECES
    )


def adrift(
    document: Json,
    vessels: Collection[str],
    at_start: Mapping[str, Sequence[float]],
    turned: Mapping[str, Sequence[float]],
) -> list[str]:
    """A sentence for each vessel that a run begins with elsewhere than the lift file has it.

    Args:
        document: What has been assembled of the lift.
        vessels: Names of the bodies of its vessels.
        at_start: Centres of gravity of bodies at the start of the run by their names, world axes [m].
        turned: Quaternions world from body of bodies then.
    """
    sentences = []
    for body in _free(document, vessels):
        joint = body["joint"]
        moved = way_of({body["name"]: body}, body["name"], at_start)
        way, higher = float(np.hypot(*moved[:2])), float(moved[2])
        if abs(higher) > _ADRIFT:
            towards = "higher" if higher > 0 else "deeper"
            sentences.append(
                f"{body['name']} starts {abs(higher):.1f} m {towards} than by the draft of the lift file, "
                "and hooks, deck and fairleads with it: there it rests; see its draft, its masses and tanks"
            )
        if way > _ADRIFT:
            sentences.append(
                f"{body['name']} starts {way:.1f} m from where the lift file has it: there it rests; "
                "see what pulls or pushes it, its draft and its mooring lines"
            )
        upright = rotation_matrix(turned[body["name"]])[:, 2] @ rotation_matrix(joint["orientation"])[:, 2]
        leans = math.acos(min(1.0, float(upright)))
        if leans > _LEANS:
            sentences.append(
                f"{body['name']} starts {math.degrees(leans):.1f} deg from heel and trim of the lift file, "
                "and booms and hooks with it: there it rests; see heel, trim, its masses and tanks"
            )
    return sentences


def drifted(scenario: Scenario, document: Json, places: Mapping[str, Sequence[float]]) -> list[str]:
    """A sentence for each vessel that its mooring lines hold elsewhere at rest than the lift file has it.

    None where steps of the plan haul or veer mooring lines: they take vessels along.

    Args:
        scenario: The lift.
        document: What has been assembled of it.
        places: Centres of gravity of bodies at rest by their names, world axes [m].
    """
    lines, winches = scenario.mooring_lines or {}, movers(scenario, "line")
    hauled = (one for step in scenario.plan if isinstance(step, LineStep) for one in step.moved)
    if any(full_name(one, winches) in lines for one in hauled):
        return []
    moored = {line.vessel for line in lines.values()}
    sentences = []
    for body in _free(document, moored & set(scenario.vessels or {})):
        way = float(np.hypot(*way_of({body["name"]: body}, body["name"], places)[:2]))
        if way > _ADRIFT:
            sentences.append(
                f"{body['name']} rests {way:.1f} m from where the lift file has it: "
                "see its mooring lines, their ends and pretensions, and what pulls or pushes it"
            )
    return sentences


def _free(document: Json, vessels: Collection[str]) -> Iterator[Json]:
    """Bodies of vessels that nothing carries."""
    for body in document["bodies"]:
        if body["name"] in vessels and body["joint"]["type"] == "free":
            yield body


def misplaced(document: Json, loads: Collection[str], at_start: Mapping[str, Sequence[float]]) -> list[str]:
    """A sentence for each load that a run begins with elsewhere than the lift file has it.

    Args:
        document: What has been assembled of the lift.
        loads: Names of the bodies of its loads.
        at_start: Centres of gravity of bodies at the start of the run by their names, world axes [m].
    """
    sentences = []
    bodies = {body["name"]: body for body in document.get("bodies", ())}
    for name in (one for one in bodies if one in loads):
        moved = way_of(bodies, name, at_start)
        way, lower = float(np.linalg.norm(moved)), -float(moved[2])
        if way > _ADRIFT:
            of_that = f", {lower:.1f} m of that lower" if lower > 0.5 * way else ""
            sentences.append(
                f"{name} starts {way:.1f} m from where the lift file has it{of_that}: "
                "there it rests; see its position, what it shall stand on, hooks and slings"
            )
    return sentences


def off_their_decks(
    document: Json,
    decks: Mapping[str, Collection[str]],
    at_start: Mapping[str, Sequence[float]],
    turned: Mapping[str, Sequence[float]],
) -> list[str]:
    """A sentence for each load that stands aboard a vessel higher or lower there than the lift file has it.

    Places of loads count from the origin of the world, decks from the water: with another tide, or another
    draft, a load begins in its deck or above it, comes to stand all the same, and its slings fit no more.

    Args:
        document: What has been assembled of the lift.
        decks: Bodies that each load stands on at the start, by the name of its body; none ashore.
        at_start: Centres of gravity of bodies at the start of the run by their names, world axes [m].
        turned: Quaternions world from body of bodies then.
    """
    bodies = {body["name"]: body for body in document.get("bodies", ())}
    sentences = []
    for load, stands_on in decks.items():
        afloat = [vessel for under in stands_on if (vessel := _free_under(bodies, under)) is not None]
        if not afloat or way_of(bodies, load, at_start)[2] == 0.0:
            continue
        vessel = bodies[afloat[0]]
        given = rotation_matrix(vessel["joint"]["orientation"])
        turn = rotation_matrix(turned[vessel["name"]]) @ given.T
        there = np.asarray(at_start[vessel["name"]]) - way_of(bodies, vessel["name"], at_start)
        lever = np.asarray(at_start[load]) - way_of(bodies, load, at_start) - there
        along = np.asarray(at_start[vessel["name"]]) + turn @ lever
        higher = float(at_start[load][2] - along[2])
        if abs(higher) > _OFF_DECK:
            stood, way = ("in", "higher") if higher > 0.0 else ("above", "lower")
            sentences.append(
                f"{load} starts {abs(higher):.2f} m {way} than the lift file has it, {stood} what bears it "
                f"aboard {vessel['name']}: there it stands, and its slings are {_SLINGS[way]} by that; see "
                "its position, the level of the water and the draft"
            )
    return sentences


def _free_under(bodies: Mapping[str, Json], name: str) -> str | None:
    """The free body that another is fixed to, through all between; None where it is of the world."""
    while bodies[name].get("parent") in bodies:
        name = bodies[name]["parent"]
    return name if bodies[name]["joint"]["type"] == "free" else None


def slid(
    document: Json, load: str, stands_on: Collection[str], places: Mapping[str, Sequence[float]]
) -> float:
    """How far a load lies aside of where the lift file has it on what it stands on [m].

    What it has moved along with a vessel under it does not count.

    Args:
        document: What has been assembled of the lift.
        load: Name of its body.
        stands_on: Names of the bodies that it meets; none on ground and supports.
        places: Centres of gravity of bodies by their names, world axes [m].
    """
    bodies = {body["name"]: body for body in document["bodies"]}
    way = way_of(bodies, load, places)
    for under in stands_on:
        afloat = _free_under(bodies, under)
        if afloat is not None:
            way = way - way_of(bodies, afloat, places)
            break
    return float(np.hypot(way[0], way[1]))


def way_of(bodies: Mapping[str, Json], name: str, places: Mapping[str, Sequence[float]]) -> Array:
    """How far the centre of gravity of a body is from where the lift file has it (3,) [m].

    Args:
        bodies: Of a document, by their names: at least this one and what it hangs on.
        name: Of the body.
        places: Centres of gravity of bodies by their names, world axes [m].
    """
    position, rotation = placed_at_start(bodies, name)
    way: Array = np.asarray(places[name]) - (position + rotation @ bodies[name]["centre_of_gravity"])
    return way


def vessel_hulls(document: Json, vessels: Collection[str]) -> dict[str, Array]:
    """Vertices of the hulls of vessels by their names, vessel axes, shape (vertices, 3) [m].

    Args:
        document: What has been assembled of the lift.
        vessels: Names of the bodies of its vessels.
    """
    meshes = {force["name"]: force["vertices"] for force in document["forces"] if force["type"] == "buoyancy"}
    return {name: np.array(meshes[hull_name(name)]) for name in vessels}
