"""Vessels as free bodies: axes at stern, keel and centre plane, x forward, y to port, z up."""

from __future__ import annotations

from collections import defaultdict

import numpy as np

from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import about_axis, quaternion_product, rotation_matrix
from gantline.assembly.water import hull_mesh, hull_name
from gantline.scenario import Scenario
from gantline.scenario.vessel import CAPSIZED_BEYOND, DECK_EDGE, Vessel
from gantline.scenario.water import Water

__all__ = ["add_vessels", "deck_edge", "hull_shape", "vessel_rig", "watch_vessels", "water_surface"]

#: A triangle of a hull is part of its deck where the cosine of its slope is more than this.
_DECK = 0.5
#: How much longer and broader than vessels the drawn water is, of their length, and how thick [m].
_WATER_AROUND, _WATER_THICK = 0.6, 0.02


def add_vessels(parts: Parts, scenario: Scenario) -> None:
    """Add a free body for each vessel, with what it weighs by itself, where it is at the start."""
    level = (scenario.water or Water()).level
    for name, vessel in (scenario.vessels or {}).items():
        own = vessel.own_inertia
        parts.add_body(
            name,
            _start(vessel, level),
            mass=vessel.mass,
            centre_of_gravity=vessel.centre_of_gravity,
            inertia=(own.xx, own.yy, own.zz, own.xy, own.xz, own.yz),
        )


def _start(vessel: Vessel, level: float) -> Json:
    """The free joint: turned by its heading, then trimmed, then heeled about its own long axis.

    The water is `draft` from the keel, along the vessel's z at half length in the centre plane.
    """
    turned = quaternion_product(about_axis((0, 0, 1), vessel.heading), about_axis((0, -1, 0), vessel.trim))
    orientation = quaternion_product(turned, about_axis((1, 0, 0), vessel.heel))
    at_water = np.array([vessel.hull.bottom[0], 0.0, vessel.draft])
    height = level - float((rotation_matrix(orientation) @ at_water)[2])
    return {
        "type": "free",
        "position": [*vessel.position, height],
        "orientation": orientation,
        "velocity": [0.0, 0.0, 0.0],
        "angular_velocity": [0.0, 0.0, 0.0],
    }


def hull_shape(vessel: Vessel) -> Json:
    """The hull to draw and to touch, in the vessel's axes; see `gantline.assembly.shapes`."""
    (x, y, z), size = vessel.hull.bottom, vessel.hull.box
    return {"type": "box", "size": list(size), "centre": [x, y, z + size[2] / 2]}


def watch_vessels(parts: Parts, scenario: Scenario) -> None:
    """Let the core look out for deck edges and openings that go under water, and for vessels that capsize."""
    level = (scenario.water or Water()).level
    for name, vessel in (scenario.vessels or {}).items():
        marks = [{"name": f"{name}.{mark}", "points": points} for mark, points in _marks(vessel).items()]
        watched = {"name": name, "body": name, "level": level, "capsized_beyond": CAPSIZED_BEYOND}
        parts.vessels.append({**watched, "marks": marks})


def vessel_rig(scenario: Scenario, parts: Parts) -> list[Json]:
    """What results need to know of vessels."""
    water = scenario.water or Water()
    found = []
    for name, vessel in (scenario.vessels or {}).items():
        along = [vertex[0] for vertex in hull_mesh(vessel.hull)["vertices"]]
        found.append(
            {
                "name": name,
                "body": name,
                "centre_of_gravity": list(parts.bodies[name]["centre_of_gravity"]),
                "ends": [min(along), max(along)],
                "level": water.level,
                "density": water.density,
                "hull": hull_name(name),
                "marks": _marks(vessel),
            }
        )
    return found


def water_surface(scenario: Scenario, parts: Parts) -> Json | None:
    """The water around all vessels where they start, as a thin box to draw; None without vessels."""
    corners = [
        parts.place(name, corner)[:2]
        for name, vessel in (scenario.vessels or {}).items()
        for corner in hull_mesh(vessel.hull)["vertices"]
    ]
    if not corners:
        return None
    low, high = np.min(corners, axis=0), np.max(corners, axis=0)
    size = [*(high - low + _WATER_AROUND * np.max(high - low)).tolist(), _WATER_THICK]
    level = (scenario.water or Water()).level
    return {"size": size, "centre": [*((low + high) / 2).tolist(), level - _WATER_THICK / 2]}


def _marks(vessel: Vessel) -> dict[str, list[list[float]]]:
    """Points that should stay above the water, by what they belong to."""
    openings = {opening: [list(at)] for opening, at in (vessel.openings or {}).items()}
    return {DECK_EDGE: deck_edge(hull_mesh(vessel.hull)), **openings}


def deck_edge(mesh: Json) -> list[list[float]]:
    """Corners of a deck's edge: where its triangles meet others that are no deck, or end.

    Args:
        mesh: vertices and triangles, counter-clockwise from outside.
    """
    vertices = np.array(mesh["vertices"])
    corners = vertices[np.array(mesh["triangles"])]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    is_deck = across[:, 2] > _DECK * np.linalg.norm(across, axis=1)
    sides: dict[frozenset[int], list[bool]] = defaultdict(list)
    for triangle, deck in zip(mesh["triangles"], is_deck, strict=True):
        for place in range(3):
            sides[frozenset((triangle[place - 1], triangle[place]))].append(bool(deck))
    ends = [side for side, decks in sides.items() if set(decks) == {True, False} or len(decks) == 1]
    edge = {at for side in ends for at in side}
    return [[float(part) for part in vertices[at]] for at in sorted(edge)]
