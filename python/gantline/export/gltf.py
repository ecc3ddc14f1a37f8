"""A recorded lift as animated glTF (`.glb`), which Blender, Windows and the viewers of browsers open.

A node below the root `lift` stands for each body, its frame at the centre of gravity, its poses those of the
recording in metres and in the recording's axes; the root turns z up into the y up of glTF. Sheaves are nodes
below their bodies. What stands in the world, ground and water are nodes below `surroundings`; a support that
is taken away shrinks to nothing. Each straight piece of a rope is a node with a rod of length 1 along z,
placed at its beginning, turned and stretched.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from gantline.export.glb import Document
from gantline.export.surroundings import surroundings
from gantline.results.recording import Recording, recorded
from gantline.results.solids import solid_of
from gantline.results.variable import FloatArray, Indices
from gantline.viewer.decimate import Places
from gantline.viewer.frames import frames
from gantline.viewer.shapes import vector
from gantline.viewer.turning import sheave_angles

#: Numbers that all poses together may have, and times.
_NUMBERS = 6_000_000
_MOST_FRAMES = 1500
_SHORTEST = 1e-3  # s between two times: float32 tells them apart for two hours
_THINNEST = 0.02  # m, radius in which ropes of unknown or small diameter are drawn
_UP = [-0.7071067811865476, 0.0, 0.0, 0.7071067811865476]  # a quarter turn about x: z becomes y

_COLOURS = {
    "load": (0.68, 0.74, 0.80),
    "frame": (0.87, 0.53, 0.08),
    "hook": (0.72, 0.37, 0.03),
    "sheave": (0.25, 0.31, 0.37),
    "other": (0.45, 0.51, 0.57),
    "rope": (0.06, 0.18, 0.40),
    "hull": (0.30, 0.42, 0.52),
    "support": (0.62, 0.56, 0.47),
    "structure": (0.70, 0.71, 0.72),
    "ground": (0.78, 0.79, 0.75),
    "quay": (0.78, 0.79, 0.75),
    "water": (0.16, 0.42, 0.60),
}
_OPACITY = {
    "frame": 0.6,
    "quay": 0.35,
    "water": 0.45,
}  # ropes and sheaves run inside of frames, hulls lie in water


def gltf_binary(recording: Recording) -> bytes:
    """A recording as the bytes of a `.glb` file.

    Args:
        recording: A recording with at least one sample and the attribute `scene`.

    Raises:
        ValueError: If it has nothing that can be shown.
    """
    scene: Mapping[str, Any] = recorded(recording).attributes.get("scene") or {}
    names = recording.coordinates.get("body", ())
    bodies = [entry for entry in scene.get("bodies") or () if entry["name"] in names]
    if not bodies or not len(recording.time):
        raise ValueError("this recording has no bodies to show")
    document = Document()
    materials = _Materials(document)
    at = _samples(recording, len(bodies))
    times = document.accessor(recording.time[at], "SCALAR", bounds=True)
    root = document.node("lift", rotation=_UP)
    nodes = {entry["name"]: _body(document, recording, entry, root, materials, at, times) for entry in bodies}
    _sheaves(document, recording, scene, nodes, materials, at, times)
    _ropes(document, recording, root, materials.of("rope"), at, times)
    if at_rest := surroundings(recording, at):
        world = document.node("surroundings", root)
        for one in at_rest:
            node = document.node(
                one.name, world, mesh=document.mesh(one.name, one.vertices, one.faces, materials.of(one.kind))
            )
            if one.size is not None and len(at) > 1:
                document.animate(node, "scale", times, np.repeat(one.size[:, None], 3, axis=1))
    return document.binary(recording.rig.title, str(recording.attributes.get("gantline_version", "")))


class _Materials:
    """Materials by the kind of what they are for, each made when it is first needed."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._made: dict[str, int] = {}

    def of(self, kind: str) -> int:
        name = kind if kind in _COLOURS else "other"
        if name not in self._made:
            self._made[name] = self._document.material(name, _COLOURS[name], _OPACITY.get(name, 1.0))
        return self._made[name]


def _samples(recording: Recording, bodies: int) -> Places:
    """Samples that become times of the animation: as many as fit, far enough apart for float32."""
    numbers = 10 * recording.sizes.get("rope_point", 0) + 11 * bodies
    at = frames(recording, int(np.clip(_NUMBERS // max(numbers, 1), 50, _MOST_FRAMES)))
    times = recording.time[at]
    kept = [0]
    # A sample a millisecond after another may be less than that by rounding.
    while (following := int(np.searchsorted(times, times[kept[-1]] + _SHORTEST * (1 - 1e-6)))) < len(times):
        kept.append(following)
    apart: Places = at[kept]
    return apart


def _body(
    document: Document,
    recording: Recording,
    entry: Mapping[str, Any],
    root: int,
    materials: _Materials,
    at: Places,
    times: int,
) -> int:
    name, kind = str(entry["name"]), str(entry.get("kind", "body"))
    place = recording.column("body_position", name)[at]
    turn = _continuous(recording.column("body_orientation", name)[at][:, [1, 2, 3, 0]])
    node = document.node(name, root, translation=place[0].tolist(), rotation=turn[0].tolist())
    solid = solid_of(entry.get("shape"))
    if solid is not None:
        vertices = solid[0] - np.asarray(vector(entry.get("centre_of_gravity")))
        document.nodes[node]["mesh"] = document.mesh(name, vertices, solid[1], materials.of(kind))
    if len(at) > 1:
        document.animate(node, "translation", times, place)
        document.animate(node, "rotation", times, turn)
    return node


def _continuous(turns: FloatArray) -> FloatArray:
    """Unit quaternions whose signs do not jump, so that what lies between goes the short way."""
    along = np.sum(turns[1:] * turns[:-1], axis=1)
    signs = np.concatenate([[1.0], np.cumprod(np.where(along < 0.0, -1.0, 1.0))])
    unit: FloatArray = turns * signs[:, None] / np.linalg.norm(turns, axis=1, keepdims=True)
    return unit


def _sheaves(
    document: Document,
    recording: Recording,
    scene: Mapping[str, Any],
    nodes: Mapping[str, int],
    materials: _Materials,
    at: Places,
    times: int,
) -> None:
    sheaves = [entry for entry in scene.get("sheaves") or () if entry["body"] in nodes]
    if not sheaves:
        return
    centres = {one["name"]: np.asarray(vector(one.get("centre_of_gravity"))) for one in scene["bodies"]}
    disc = document.mesh("sheave", *_disc(), materials.of("sheave"))
    angles = sheave_angles(recording, list(at), sheaves, centres)
    for place, (entry, angle) in enumerate(zip(sheaves, angles.T, strict=True)):
        body = str(entry["body"])
        axis = np.asarray(vector(entry["axis"]))
        spin = np.column_stack([0 * angle, 0 * angle, np.sin(angle / 2), np.cos(angle / 2)])
        turn = _continuous(_product(_from_z(axis[None] / np.linalg.norm(axis)), spin))
        radius = float(entry["radius"])
        node = document.node(
            f"{body} sheave {place + 1}",
            nodes[body],
            mesh=disc,
            translation=(np.asarray(vector(entry["centre"])) - centres[body]).tolist(),
            rotation=turn[0].tolist(),
            scale=[radius, radius, radius],
        )
        if len(at) > 1:
            document.animate(node, "rotation", times, turn)


def _ropes(
    document: Document, recording: Recording, root: int, material: int, at: Places, times: int
) -> None:
    if "rope_point" not in recording:
        return
    rod = document.mesh("rope", *_rod(), material)
    for name in recording.coordinates["rope"]:
        known = recording.rig.rope(name)
        radius = max(_THINNEST, ((known.diameter if known is not None else None) or 0.0) / 2)
        rope = document.node(name, root)
        path = recording["rope_point"].values[np.ix_(at, recording.points_of_ropes.get(name, []))]
        for piece in range(path.shape[1] - 1):
            _piece(document, rope, rod, f"{name} {piece + 1}", path[:, piece : piece + 2], radius, times)


def _piece(
    document: Document, rope: int, rod: int, name: str, ends: FloatArray, radius: float, times: int
) -> None:
    along = ends[:, 1] - ends[:, 0]
    length = np.linalg.norm(along, axis=1)
    upwards = np.tile([0.0, 0.0, 1.0], (len(along), 1))  # of pieces without length, which have no way
    way = np.divide(along, length[:, None], out=upwards, where=length[:, None] > 0.0)
    turn = _continuous(_from_z(way))
    across = np.full_like(length, radius)
    size = np.column_stack([across, across, np.maximum(length, 1e-6)])
    parts = {"translation": ends[:, 0], "rotation": turn, "scale": size}
    first = {path: values[0].tolist() for path, values in parts.items()}
    node = document.node(name, rope, mesh=rod, **first)
    if len(ends) > 1:
        for path, values in parts.items():
            document.animate(node, path, times, values)


def _from_z(ways: FloatArray) -> FloatArray:
    """Shortest turns of z into unit vectors, quaternions x y z w, shape (n, 4)."""
    x, y, z = ways.T
    turns = np.column_stack([-y, x, np.zeros_like(x), 1.0 + z])
    turns[z < -1.0 + 1e-12] = [1.0, 0.0, 0.0, 0.0]  # straight down: half a turn about x
    unit: FloatArray = turns / np.linalg.norm(turns, axis=1, keepdims=True)
    return unit


def _product(one: FloatArray, other: FloatArray) -> FloatArray:
    """Quaternions x y z w: first the other turn, then the one."""
    (ax, ay, az, aw), (bx, by, bz, bw) = one.T, other.T
    return np.column_stack(
        [
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz,
        ]
    )


def _rod(sides: int = 8) -> tuple[FloatArray, Indices]:
    """A rod of radius 1 along z from 0 to 1, without ends."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = np.column_stack([np.cos(angle), np.sin(angle)])
    vertices = np.concatenate([np.column_stack([ring, np.full(sides, z)]) for z in (0.0, 1.0)])
    here, there = np.arange(sides), (np.arange(sides) + 1) % sides
    faces = np.concatenate(
        [np.column_stack([here, there, there + sides]), np.column_stack([here, there + sides, here + sides])]
    )
    return vertices, faces


def _disc(sides: int = 24, thick: float = 0.22) -> tuple[FloatArray, Indices]:
    """A sheave of radius 1 about z: a rim that is cut square, so that one sees it turn."""
    angle = 2 * np.pi * np.arange(sides) / sides
    radius = np.where(np.arange(sides) % 6 == 0, 0.86, 1.0)
    ring = np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])
    middle = [[0.0, 0.0, -thick / 2], [0.0, 0.0, thick / 2]]
    rings = [np.column_stack([ring, np.full(sides, z)]) for z in (-thick / 2, thick / 2)]
    vertices = np.concatenate([*rings, middle])
    here, there = np.arange(sides), (np.arange(sides) + 1) % sides
    low, high = np.full(sides, 2 * sides), np.full(sides, 2 * sides + 1)
    faces = np.concatenate(
        [
            np.column_stack([here, there, there + sides]),
            np.column_stack([here, there + sides, here + sides]),
            np.column_stack([low, there, here]),
            np.column_stack([high, here + sides, there + sides]),
        ]
    )
    return vertices, faces
