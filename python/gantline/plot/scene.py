"""The system at one sample, as points, lines and faces in space: what the drawings project."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gantline.results.loads.hinges import is_shut
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.results.surroundings import structures_of
from gantline.results.variable import FloatArray

_FACES = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
_CIRCLE = np.linspace(0.0, 2.0 * np.pi, 49)


@dataclass(frozen=True)
class Box:
    """A body with a shape.

    Attributes:
        name: Of the body.
        kind: Of the body.
        faces: The six faces of its box [m], shape (6, 4, 3).
        triangles: Of its mesh [m], shape (triangles, 3, 3); None of a body that is a box.
    """

    name: str
    kind: str
    faces: FloatArray
    triangles: FloatArray | None = None


@dataclass(frozen=True)
class Sheave:
    """A sheave: its body, whether it moves, and its circle [m], shape (49, 3)."""

    body: str
    moves: bool
    circle: FloatArray


@dataclass(frozen=True)
class RopePath:
    """A rope: name, kind, drawn path [m] of shape (points, 3), tension and the largest in the run [N]."""

    name: str
    kind: str
    path: FloatArray
    tension: float
    largest: float


@dataclass(frozen=True)
class Snapshot:
    """Everything that is drawn at one sample.

    Attributes:
        time: Of the sample [s].
        boxes: Bodies with a shape.
        surroundings: What stands in the world: supports and structures.
        sheaves: All sheaves.
        ropes: All ropes.
        points: Bodies without shape and sheave, by name [m]: hooks and plain bodies.
        hooks: Which of these points are hooks.
        hinges: Middles of the hinges that hold their loads then, by name [m].
        centres: Centres of gravity of the loads, by name [m].
        lugs: Lower ends of the slings, by the sling's name [m].
        frame_axes: Axes of every equalizer's frame, by name, as columns of a matrix (3, 3).
        frame_origin: Origin of every equalizer's frame, the bearing of its hook, by name [m].
    """

    time: float
    boxes: Sequence[Box]
    surroundings: Sequence[Box]
    sheaves: Sequence[Sheave]
    ropes: Sequence[RopePath]
    points: Mapping[str, FloatArray]
    hooks: frozenset[str]
    hinges: Mapping[str, FloatArray]
    centres: Mapping[str, FloatArray]
    lugs: Mapping[str, FloatArray]
    frame_axes: Mapping[str, FloatArray]
    frame_origin: Mapping[str, FloatArray]

    def extent(self) -> FloatArray:
        """All points that the drawing must hold [m], shape (points, 3).

        Structures may reach out of it, and mooring and tag lines, which go far beyond what is lifted.
        """
        parts = [box.faces.reshape(-1, 3) for box in self.boxes]
        parts += [box.faces.reshape(-1, 3) for box in self.surroundings if box.kind == "support"]
        parts += [sheave.circle for sheave in self.sheaves]
        parts += [rope.path for rope in self.ropes if rope.kind != "outer"]
        marks = (*self.points.values(), *self.hinges.values(), *self.frame_origin.values())
        parts += [point[None] for point in marks]
        return np.concatenate(parts)


def snapshot(recording: Recording, sample: int) -> Snapshot:
    """The system at one sample.

    Args:
        recording: A recording with the attribute `scene`.
        sample: Index of the sample.

    Returns:
        What is to be drawn, world axes.
    """
    scene: Mapping[str, Any] = recording.attributes.get("scene") or {}
    names = recording.coordinates.get("body", ())
    bodies = {entry["name"]: entry for entry in scene.get("bodies", ()) if entry["name"] in names}
    place = _Places(recording, sample, bodies)
    sheaves = [entry for entry in scene.get("sheaves", ()) if entry["body"] in bodies]
    plain = set(bodies) - {entry["body"] for entry in sheaves}
    boxes = [box for name, entry in bodies.items() for box in _boxes(place, name, entry)]
    hinges = [hinge for hinge in recording.rig.hinges if hinge.name in bodies]
    plain -= {box.name for box in boxes} | {hinge.name for hinge in hinges}
    plain -= recording.rig.seen_by_their_parts
    loads = {load.name: load.body for load in recording.rig.loads}
    frames = {e.name: e.body for e in recording.rig.equalizers if e.body in bodies}
    ropes = _ropes(recording, sample, scene)
    ends = {rope.name: rope.path[-1] for rope in ropes}
    time = float(recording.time[sample])
    return Snapshot(
        time,
        boxes,
        [
            Box(one.name, one.kind, _faces(corners))
            for one in structures_of(recording)
            if one.stands(time)
            for corners in one.boxes
        ],
        [
            Sheave(one["body"], one.get("kind") == "moving", place.world(one["body"], circle))
            for one, circle in zip(sheaves, _circles(recording, sheaves), strict=True)
        ],
        ropes,
        {name: place.origin(name) for name in bodies if name in plain},
        frozenset(name for name in plain if bodies[name].get("kind") == "hook"),
        {hinge.name: place.origin(hinge.name) for hinge in hinges if is_shut(recording, hinge)[sample]},
        {name: place.centre(body) for name, body in loads.items()},
        {sling.name: ends[sling.rope] for sling in recording.rig.slings if sling.rope in ends},
        {name: place.axes(body) for name, body in frames.items()},
        {name: place.origin(body) for name, body in frames.items()},
    )


class _Places:
    """Where bodies are at one sample."""

    def __init__(self, recording: Recording, sample: int, bodies: Mapping[str, Any]) -> None:
        self._bodies = bodies
        self._number = {name: number for number, name in enumerate(recording.coordinates.get("body", ()))}
        self._centres: FloatArray = recording["body_position"].values[sample]
        self._axes = axes(recording["body_orientation"].values[sample])

    def centre(self, body: str) -> FloatArray:
        place: FloatArray = self._centres[self._number[body]]
        return place

    def axes(self, body: str) -> FloatArray:
        turned: FloatArray = self._axes[self._number[body]]
        return turned

    def world(self, body: str, points: FloatArray) -> FloatArray:
        """Points of a body's frame in the world; the recorded position is that of the centre of gravity."""
        offset = points - np.asarray(self._bodies[body].get("centre_of_gravity") or (0.0, 0.0, 0.0))
        moved: FloatArray = self.centre(body) + offset @ self.axes(body).T
        return moved

    def origin(self, body: str) -> FloatArray:
        return self.world(body, np.zeros(3))


def _ropes(recording: Recording, sample: int, scene: Mapping[str, Any]) -> list[RopePath]:
    if "rope_point" not in recording:
        return []
    kinds = {entry["name"]: entry.get("kind", "rope") for entry in scene.get("ropes", ())}
    kinds |= dict.fromkeys(recording.rig.outer_ropes, "outer")
    places = recording.points_of_ropes
    points = recording["rope_point"].values[sample]
    tension = recording["rope_tension"].values
    now, largest = tension[sample], np.max(tension, axis=0, initial=0.0)
    return [
        RopePath(
            rope, kinds.get(rope, "rope"), points[places[rope]], float(now[index]), float(largest[index])
        )
        for index, rope in enumerate(recording.coordinates["rope"])
        if kinds.get(rope) != "gas"  # it is in its cylinder
        and rope in places
        and np.ptp(points[places[rope]], axis=0).any()  # else it is not there
    ]


def _boxes(place: _Places, name: str, entry: Mapping[str, Any]) -> list[Box]:
    """What is drawn of a body: its box, the boxes that it is made of, or its triangles in their box."""
    shape, kind = entry.get("shape") or {}, entry.get("kind", "body")
    if shape.get("type") == "mesh":
        vertices = np.asarray(shape["vertices"], dtype=np.float64)
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        around = _box_faces({"size": high - low, "centre": (low + high) / 2.0})
        triangles = place.world(name, vertices)[np.asarray(shape["triangles"], dtype=np.int64)]
        return [Box(name, kind, place.world(name, around), triangles)]
    alone = [shape] if shape.get("type") == "box" else []
    return [Box(name, kind, place.world(name, _box_faces(box))) for box in shape.get("boxes") or alone]


def _box_faces(shape: Mapping[str, Any]) -> FloatArray:
    half = np.asarray(shape["size"], dtype=np.float64) / 2.0
    signs = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=np.float64)
    return _faces(np.asarray(shape.get("centre", (0.0, 0.0, 0.0))) + signs * half)


def _faces(corners: FloatArray) -> FloatArray:
    """The six faces of a box with these corners, x slowest, z fastest."""
    return np.stack([corners[list(face)] for face in _FACES])


def _circles(recording: Recording, sheaves: Sequence[Mapping[str, Any]]) -> FloatArray:
    """Points around each of these sheaves, all those of the recording, on their bodies [m]."""
    return recording.kept("drawn circles", lambda: np.array([_circle(one) for one in sheaves]))


def _circle(sheave: Mapping[str, Any]) -> FloatArray:
    axis = np.asarray(sheave["axis"], dtype=np.float64)
    axis = axis / np.linalg.norm(axis)
    aside = np.cross(axis, (0.0, 0.0, 1.0) if abs(axis[2]) < 0.9 else (1.0, 0.0, 0.0))
    aside = aside / np.linalg.norm(aside)
    up = np.cross(aside, axis)
    around = np.outer(np.cos(_CIRCLE), aside) + np.outer(np.sin(_CIRCLE), up)
    circle: FloatArray = np.asarray(sheave["centre"], dtype=np.float64) + float(sheave["radius"]) * around
    return circle
