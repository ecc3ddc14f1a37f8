"""Crawler cranes into mechanics: four corners on elastic ground, tracks, an upper structure that slews.

The tracks are carried by slider and hinges: along their heading (driven by the travel, or none), up and down,
about their heading, and across it. So they rock and tip as the ground lets them, and neither slide nor turn
aside. Under each of their ends is a point that the ground pushes and never pulls. The boom comes on the upper
structure like any other.
"""

from __future__ import annotations

import math

import numpy as np

from gantline.assembly.cranes.reeving import falls_on_upper_sheaves, reeved_hooks, upper_sheaves
from gantline.assembly.cranes.slewing import add_turned, add_upper
from gantline.assembly.loads.resting import TipsOver, rest_on_ground
from gantline.assembly.parts import Json, Parts, box_shape
from gantline.assembly.plan.operations import along_drive
from gantline.assembly.spatial import (
    about_axis,
    inertia_list,
    rotation_matrix,
    rotation_vector,
    solid_box,
)
from gantline.scenario import Scenario
from gantline.scenario.cranes.boom import boom_name
from gantline.scenario.cranes.crawler import (
    TRACK_CORNERS,
    Crawler,
    Tracks,
    along_body,
    tracks_body,
)
from gantline.scenario.cranes.slewing import upper_body

__all__ = ["add_crawlers", "crawler_rig", "crawler_shape", "crawlers", "track_contact"]

#: Tracks may sink into ground and mats by so much [m]: more is a unit that has slipped, and cranes go over.
_DEEPEST = 0.25
#: Parts of pictures that no mechanics depends on: height of tracks, thickness of mats, breadth of a carrier
#: on outriggers, sizes of machinery and counterweight [m].
_TRACK = 1.4
_MAT = 0.3
_CARRIER = 2.75
_MACHINE = (6.0, 4.0, 3.0)
_WEIGHT = (2.0, 6.0, 3.0)


def crawlers(scenario: Scenario) -> dict[str, Crawler]:
    """The crawler cranes of a lift by name."""
    cranes = scenario.cranes or {}
    return {name: crane for name, crane in cranes.items() if isinstance(crane, Crawler)}


def track_contact(crane: str, corner: str) -> str:
    """Name of the contact under an end of a track."""
    return f"{crane}.{corner}"


def add_crawlers(parts: Parts, scenario: Scenario) -> None:
    """Add the bodies of every crawler crane up to its upper structure, and what they stand on."""
    for name, crane in crawlers(scenario).items():
        _add_tracks(parts, scenario, name, crane)
        _add_corners(parts, scenario, name, crane.tracks)
        _add_upper(parts, name, crane)


def _add_tracks(parts: Parts, scenario: Scenario, name: str, crane: Crawler) -> None:
    assert scenario.ground is not None  # checked: it stands on the ground
    place = (*crane.position, scenario.ground.level)
    heading = about_axis((0.0, 0.0, 1.0), crane.heading)
    along: Json = {"type": "fixed"}
    if crane.travel is not None:
        parts.add_drive(along_drive(name))
        along = _axis("slider", (1.0, 0.0, 0.0), drive=along_drive(name))
    parts.add_body(along_body(name), along, position=place, orientation=heading)
    up, over, across = _stands(scenario, name, crane)
    parts.add_body(f"{name}/up", _axis("slider", (0.0, 0.0, 1.0), up), parent=along_body(name))
    parts.add_body(f"{name}/over", _axis("hinge", (1.0, 0.0, 0.0), over), parent=f"{name}/up")
    mass = crane.base_mass - crane.upper_mass + crane.central_ballast
    tracks = crane.tracks
    sizes = (tracks.length, tracks.gauge + tracks.width, tracks.height)
    parts.add_body(
        tracks_body(name),
        _axis("hinge", (0.0, 1.0, 0.0), across),
        parent=f"{name}/over",
        mass=mass,
        centre_of_gravity=(0.0, 0.0, tracks.height / 2),
        inertia=inertia_list(solid_box(mass, sizes)),
    )


def _stands(scenario: Scenario, name: str, crane: Crawler) -> tuple[float, float, float]:
    """How the crane stands with empty hooks: height of its origin [m], turns about x and about y [rad].

    What hangs in its hooks leans it further; a lift that starts at rest finds how far from here.
    """
    tracks, boom, weight = crane.tracks, crane.boom, crane.counterweight
    level, rise = math.cos(boom.angle), math.sin(boom.angle)
    pins = boom.heel_pins
    along = boom.centre_of_gravity * boom.length
    lumps = [  # mass, ahead of the slewing axis, height
        (crane.base_mass + crane.central_ballast, 0.0, tracks.height / 2),
        (weight.mass, -weight.behind, weight.height),
        (boom.mass, pins.ahead + along * level, pins.height + along * rise),
        (boom.head_gear, pins.ahead + boom.length * level, pins.height + boom.length * rise),
    ]
    for hook in scenario.hooks.values():
        if hook.crane == name and hook.hook_block is not None:
            out, _, above = hook.pin
            at = pins.ahead + out * level - above * rise, pins.height + out * rise + above * level
            lumps.append((hook.hook_block.mass, *at))
    mass = math.fsum(lump for lump, _, _ in lumps)
    ahead = math.fsum(lump * at for lump, at, _ in lumps) / mass
    high = math.fsum(lump * at for lump, _, at in lumps) / mass
    centre = np.array((ahead * math.cos(crane.slew), ahead * math.sin(crane.slew), high))
    feet = np.array(list(_corners(tracks).values()))
    levels = np.array([(tracks.levels or {}).get(corner, 0.0) for corner in TRACK_CORNERS])
    # From the plane that fits the ground best: over hard ground the way to it is steep.
    fits = np.linalg.lstsq(np.column_stack((feet[:, :2], np.ones(4))), levels, rcond=None)[0]
    leans = rotation_matrix(rotation_vector((math.atan(fits[1]), -math.atan(fits[0]), 0.0)))
    corners = (feet - centre) @ leans.T
    corners[:, 2] -= levels  # ground that is lower is a foot that is shorter
    depth = mass * scenario.simulation.gravity / (4 * tracks.stiffness)
    if depth > _DEEPEST:
        sentence = f"'{name}' of {mass / 1e3:.4g} t would sink {depth:.3g} m into this ground"
        right = "a greater stiffness is right, such as 200 MN/m"
        raise scenario.start_error(("cranes", name, "tracks", "stiffness"), f"{sentence}; {right}")
    try:
        resting = rest_on_ground(corners, mass * scenario.simulation.gravity, tracks.stiffness)
    except TipsOver:
        x, y = centre[:2]
        sentence = f"'{name}' would tip over as it stands: its centre of gravity is {x:z.2f} m ahead of and"
        sentence += f" {y:z.2f} m to the left of the middle of its tracks"
        raise scenario.start_error(
            ("cranes", name),
            f"{sentence}; move it to within {tracks.length / 2:g} m and {tracks.gauge / 2:g} m",
        ) from None
    turned = rotation_matrix(rotation_vector(resting.turn)) @ leans
    up = resting.height - float((turned @ centre)[2])
    return up, math.atan2(turned[2, 1], turned[1, 1]), math.atan2(turned[0, 2], turned[0, 0])


def _add_corners(parts: Parts, scenario: Scenario, name: str, tracks: Tracks) -> None:
    """The ground under each end of a track; one that settles is drawn away from under it."""
    assert scenario.ground is not None
    settling = tracks.settling
    for corner, at in _corners(tracks).items():
        body = tracks_body(name)
        if settling is not None and corner in settling.corners:
            # A foot that is drawn up into the track lets it down as ground that goes down would.
            foot = _foot(name, corner)
            speed = 2 * settling.by / settling.over
            ramps = [
                {"at": settling.at, "duration": settling.over / 2, "velocity": speed, "shape": "smooth"},
                {
                    "at": settling.at + settling.over / 2,
                    "duration": settling.over / 2,
                    "velocity": 0.0,
                    "shape": "smooth",
                },
            ]
            parts.add_drive(f"{foot}.settling", ramps)
            joint = _axis("slider", (0.0, 0.0, 1.0), drive=f"{foot}.settling")
            parts.add_body(foot, joint, parent=body, position=at)
            body, at = foot, (0.0, 0.0, 0.0)
        level = scenario.ground.level + (tracks.levels or {}).get(corner, 0.0)
        parts.contacts.append(
            {
                "name": track_contact(name, corner),
                "group": track_contact(name, corner),
                "body": body,
                "at": list(at),
                "plane_point": [0.0, 0.0, level],
                "plane_normal": [0.0, 0.0, 1.0],
                "stiffness": tracks.stiffness,
                "damping_time": tracks.damping / tracks.stiffness,
                "friction": 0.0,  # the joints of the tracks hold what friction would
            }
        )


def _foot(crane: str, corner: str) -> str:
    """Name of the body between an end of a track and ground that settles, and of its joint."""
    return f"{tracks_body(crane)}/{corner}"


def _corners(tracks: Tracks) -> dict[str, tuple[float, float, float]]:
    """Where the ends of the tracks are from their middle [m]."""
    along, aside = tracks.length / 2, tracks.gauge / 2
    places = ((along, aside), (-along, aside), (along, -aside), (-along, -aside))
    return {corner: (x, y, 0.0) for corner, (x, y) in zip(TRACK_CORNERS, places, strict=True)}


def _add_upper(parts: Parts, name: str, crane: Crawler) -> None:
    """Machinery on the slewing axis and counterweight, a point mass each."""
    weight = crane.counterweight
    lumps = [
        (crane.upper_mass, (0.0, 0.0, crane.tracks.height)),
        (weight.mass, (-weight.behind, 0.0, weight.height)),
    ]
    slew = (crane.slew, crane.slewing)
    add_upper(parts, name, tracks_body(name), (0.0, 0.0, 0.0), lumps, slew)
    add_turned(parts, name, (*crane.position, 0.0), crane.heading, slew)


def _axis(
    kind: str, axis: tuple[float, float, float], position: float = 0.0, drive: str | None = None
) -> Json:
    joint = {"type": kind, "axis": list(axis), "position": position, "velocity": 0.0, "damping": 0.0}
    return joint | {"friction": 0.0, "drive": drive}


def crawler_shape(scenario: Scenario, body: str, *, mats: bool = True) -> Json | None:
    """Boxes: tracks or outriggers, with their mats or without, or machinery and counterweight."""
    for name, crane in crawlers(scenario).items():
        tracks = crane.tracks
        if body == tracks_body(name):
            boxes = _track_boxes(tracks, mats) if tracks.outrigger_mats is None else _outriggers(tracks, mats)
            return {"type": "boxes", "boxes": boxes}
        if body == upper_body(name):
            behind = crane.counterweight.behind
            machine = (0.0, 0.0, tracks.height + _MACHINE[2] / 2)
            slabs = (-behind, 0.0, max(crane.counterweight.height, tracks.height + _WEIGHT[2] / 2))
            long = (behind, 2.0, 1.0)
            frame = (-behind / 2, 0.0, tracks.height + 0.5)
            return {
                "type": "boxes",
                "boxes": [box_shape(_MACHINE, machine), box_shape(_WEIGHT, slabs), box_shape(long, frame)],
            }
    return None


def _track_boxes(tracks: Tracks, mats: bool) -> list[Json]:
    sides = (tracks.gauge / 2, -tracks.gauge / 2)
    boxes = [box_shape((tracks.length, tracks.width, _TRACK), (0.0, y, _TRACK / 2)) for y in sides]
    across = tracks.gauge - tracks.width
    middle = box_shape((tracks.length / 3, across, _TRACK / 2), (0.0, 0.0, tracks.height - _TRACK / 4))
    size = (tracks.length, tracks.mats or 0.0, _MAT)
    flat = [box_shape(size, (0.0, y, -_MAT / 2)) for y in sides if mats and tracks.mats]
    return [*boxes, middle, *flat]


def _outriggers(tracks: Tracks, mats: bool) -> list[Json]:
    """A carrier on two beams across, with a leg at each of their ends and a square mat under each leg."""
    assert tracks.outrigger_mats is not None
    thick = min(tracks.width, tracks.height)
    beam = (thick, tracks.gauge, thick)
    under = tracks.height - thick / 2
    beams = [box_shape(beam, (x, 0.0, under)) for x in (tracks.length / 2, -tracks.length / 2)]
    carrier = box_shape((tracks.length, _CARRIER, tracks.height / 2), (0.0, 0.0, 0.75 * tracks.height))
    foot, side = (tracks.width, tracks.width, tracks.height), math.sqrt(tracks.outrigger_mats)
    places = _corners(tracks).values()
    legs = [box_shape(foot, (x, y, tracks.height / 2)) for x, y, _ in places]
    flat = [box_shape((side, side, _MAT), (x, y, -_MAT / 2)) for x, y, _ in places if mats]
    return [*beams, carrier, *legs, *flat]


def crawler_rig(scenario: Scenario, parts: Parts) -> list[Json]:
    """What results need to know of crawler cranes [SI]."""
    gravity = scenario.simulation.gravity
    found = []
    for name, crane in crawlers(scenario).items():
        tracks = crane.tracks
        settles = () if tracks.settling is None else tracks.settling.corners
        own = {
            body: parts.bodies[body]["mass"]
            for body in (tracks_body(name), upper_body(name), boom_name(name))
        }
        for hook in (one for one in reeved_hooks(scenario) if one.hook.crane == name):
            falls = falls_on_upper_sheaves(parts, scenario, hook)
            own[upper_sheaves(hook.name)] = parts.bodies[upper_sheaves(hook.name)]["mass"] - falls
        found.append(
            {
                "name": name,
                "tracks": tracks_body(name),
                "length": tracks.length,
                "width": tracks.width,
                "gauge": tracks.gauge,
                "mats": tracks.mats,
                "outrigger_mats": tracks.outrigger_mats,
                "allowed_pressure": tracks.allowed_pressure,
                "centre": parts.bodies[tracks_body(name)]["centre_of_gravity"],
                "corners": [track_contact(name, corner) for corner in TRACK_CORNERS],
                "stiffness": tracks.stiffness,
                "levels": [(tracks.levels or {}).get(corner, 0.0) for corner in TRACK_CORNERS],
                "feet": [_foot(name, corner) if corner in settles else None for corner in TRACK_CORNERS],
                "weights": {body: mass * gravity for body, mass in own.items()},
                "hooks": [hook.name for hook in scenario.hooks.values() if hook.crane == name],
            }
        )
    return found
