"""Load, equalizer frames, cranes, hulls, structures and supports that are drawn in the same place.

What bodies of cranes and hulls are in the way of is no part of a simulation: a load goes through a boom as if
it were not there, and from beside through a support. Here boxes are held against boxes by
the separating axes of Gottschalk, Lin and Manocha 1996; what is drawn as triangles has its bounding box for
that, and goes through the other only where edges of one go through triangles of the other.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from gantline.results.loads.looks import looks_at
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.results.solids import box_faces, crossings, skin_of
from gantline.results.surroundings import SIGNS, Structure, structures_of
from gantline.results.variable import BoolArray, FloatArray, Indices

__all__ = ["Overlap", "overlaps"]

#: Of the samples at which bodies are looked at, at most, that what is drawn as triangles is looked at.
_EXACT_LOOKS = 60
#: What is drawn less deep in the other touches it [m].
_TOUCH = 0.01
#: A support that carries nothing may be as deep in a load, which tilts over its top [m].
_TILTS = 0.1
#: Half of what a hook takes up where nothing draws it [m]: it reaches that far below its bearing.
_HOOK = 0.1
#: Directions shorter than this are those of parallel edges [1].
_PARALLEL = 1e-6


@dataclass(frozen=True)
class Overlap:
    """Two bodies that are drawn in the same place.

    Attributes:
        between: Their names.
        time: When first, as far as it was looked at [s].
        depth: How far one is in the other at most, the shortest way out [m].
        is_past_middle: Whether one reaches past the middle of the other: no matter of how it is drawn.
        support: That of the two which is a support; None where none is.
        is_of_hulls: Whether they are two hulls, or a hull and a structure, of which nothing is drawn roughly.
    """

    between: tuple[str, str]
    time: float
    depth: float
    is_past_middle: bool
    support: str | None = None
    is_of_hulls: bool = False


@dataclass(frozen=True, eq=False)
class _Body:
    """Something that is drawn: boxes by the axes of its own, at each look.

    Attributes:
        name: Of the body.
        of: What it belongs to: a crane, itself.
        kind: `load`, `frame`, `hook`, `hull`, `boom`, `tracks`, `crane` of other parts of one, `structure`,
            `fixture` or `support`.
        sizes: Of its boxes, half, shape (boxes, 3) [m].
        centres: Of its boxes from its centre of gravity, its axes, shape (boxes, 3) [m].
        place: Of that centre of gravity, shape (looks, 3) [m].
        turn: World from body, shape (looks, 3, 3).
        skin: Triangles from there, its axes, shape (triangles, 3, 3) [m].
        is_mesh: Whether its one box is only about it.
        counts: When it is looked at, shape (looks,); at every look if not given.
    """

    name: str
    of: str
    kind: str
    sizes: FloatArray
    centres: FloatArray
    place: FloatArray
    turn: FloatArray
    skin: FloatArray
    is_mesh: bool
    counts: BoolArray | None = None


#: Kinds that are held against each other. A load touches structures in the simulation, and supports as
#: it comes down on them; what stands on a hull near a crane there may reach into how that is drawn.
_LOOKED_AT = {
    frozenset((one, other))
    for one, others in {
        "load": ("boom", "crane", "tracks", "hull", "frame", "hook", "support", "fixture"),
        "hook": ("hook", "boom", "crane", "tracks", "structure", "hull", "fixture"),
        "frame": ("frame", "boom", "crane", "tracks", "hull", "structure", "fixture"),
        "boom": ("boom", "crane", "tracks", "structure", "hull", "fixture"),
        "crane": ("crane", "tracks", "structure", "hull"),
        "tracks": ("tracks",),
        "hull": ("hull", "structure"),
    }.items()
    for other in others
}


def overlaps(recording: Recording) -> list[Overlap]:
    """Pairs of bodies that are drawn in the same place, with how deep they are at most.

    Pairs that the lift file watches are judged by that, and those that touch in the simulation stay apart.
    """
    count = len(recording.time)
    if not count:
        return []
    # Of a lift at rest only the last sample is where it rests.
    looks = np.array([count - 1]) if recording.is_equilibrium else looks_at(recording)
    found = []
    for one, other in combinations(_bodies(recording, looks), 2):
        if (
            not _is_apart(one, other)
            or _stands_on(recording, one, other)
            or _stands_on(recording, other, one)
            or frozenset({one.kind, other.kind}) not in _LOOKED_AT
            or _is_looked_after(recording, one, other)
        ):
            continue
        depth, is_past = _depths(one, other)
        for counts in (body.counts for body in (one, other) if body.counts is not None):
            depth, is_past = np.where(counts, depth, 0.0), is_past & counts
        support = next((body.name for body in (one, other) if body.kind == "support"), None)
        least = _TOUCH if support is None else _TILTS
        if "fixture" in (one.kind, other.kind):
            # What begins in it, as a foot in its bucket, is drawn so until it has come out.
            has_been_out = np.logical_or.accumulate(depth <= least)
            depth, is_past = np.where(has_been_out, depth, 0.0), is_past & has_been_out
        if one.of == other.of and {one.kind, other.kind} == {"hook", "boom"}:
            # A head is drawn as deep as all of its boom, and a hook block comes close to it.
            boom = one if one.kind == "boom" else other
            is_past &= depth > boom.sizes.min()
            depth = np.where(is_past, depth, 0.0)
        if depth.max() > least:
            since = float(recording.time[looks[int(np.argmax(depth > least))]])
            deep = float(depth.max())
            is_of_hulls = "hull" in (one.kind, other.kind) and {one.kind, other.kind} <= {"hull", "structure"}
            names = (one.name, other.name)
            found.append(Overlap(names, since, deep, bool(is_past.any()), support, is_of_hulls))
    return found


def _is_apart(one: _Body, other: _Body) -> bool:
    """Whether two belong to different things: to a crane all of it, but for its hook blocks beside its boom.

    Hook blocks of one crane are held against each other too. Fixed hooks are none: several may stand for one.
    """
    if one.kind == other.kind == "hook":
        return one.of != one.name and other.of != other.name
    return one.of != other.of or {one.kind, other.kind} == {"hook", "boom"}


def _stands_on(recording: Recording, one: _Body, other: _Body) -> bool:
    """Whether one is a part of a crane that stands on the other, a hull."""
    standing = {(boom.name, boom.vessel) for boom in recording.rig.booms}
    return one.kind in ("boom", "crane") and other.kind == "hull" and (one.of, other.name) in standing


def _is_looked_after(recording: Recording, one: _Body, other: _Body) -> bool:
    """Whether the lift file watches a pair over the whole lift, or lets it touch.

    The name of a crane stands for those of its parts that distances are of: of Goliath cranes the legs, of
    floating cranes the boom, of none the hook blocks, which have names of their own.
    """
    goliaths = {crane.name for crane in recording.rig.cranes}
    on_decks = {boom.name for boom in recording.rig.booms if boom.base == boom.name}

    def stands_for(watched: str, body: _Body) -> bool:
        if body.kind == "hook":
            return body.name == watched
        is_part = body.of in goliaths and body.name != body.of
        if is_part or body.name in on_decks:
            return False
        return body.name == watched or body.name.startswith(f"{watched}.")

    given = [
        *(watch.between for watch in recording.rig.watches if watch.is_whole_lift),
        *recording.rig.touching,
    ]
    pairs = [pair for first, second in given for pair in ((first, second), (second, first))]
    return any(stands_for(first, one) and stands_for(second, other) for first, second in pairs)


def _bodies(recording: Recording, looks: Indices) -> Iterator[_Body]:
    rig = recording.rig
    cranes = [boom.name for boom in rig.booms] + [crane.name for crane in rig.cranes]
    booms, tracks = {boom.boom for boom in rig.booms}, {crawler.tracks for crawler in rig.crawlers}
    scene = recording.attributes.get("scene") or {}
    names = set(recording.coordinates.get("body", ()))
    for body in scene.get("bodies") or ():
        name, kind = str(body["name"]), str(body["kind"])
        of = max(
            (crane for crane in cranes if name == crane or name.startswith(f"{crane}.")),
            default=name,
            key=len,
        )
        if kind == "body" and of not in cranes and name not in rig.fixtures:
            continue
        if kind == "body":
            kind = "boom" if name in booms else "crane" if of in cranes else "fixture"
            kind = "tracks" if name in tracks else kind
        if name in names and any(kind in pair for pair in _LOOKED_AT):
            yield from _drawn(recording, looks, body, (of, kind))
    drawn = {str(body["name"]) for body in scene.get("bodies") or () if body["shape"] is not None}
    # By an equalizer a frame hangs there, which is drawn; what `mechanics` has in a hook may be at its place.
    slung = {sling.from_body for sling in rig.slings}
    for hook in rig.hooks:
        if hook.name in slung & names - drawn and not hook.bears_mechanics:
            yield _hook(recording, looks, hook.name)
    for structure in structures_of(recording):
        if structure.kind == "support":
            yield _support(recording, looks, structure)
        elif structure.kind == "structure":
            yield _structure(looks, structure)


def _hook(recording: Recording, looks: Indices, name: str) -> _Body:
    """A hook without a hook block, in which slings hang: no larger than a hand's breadth or two."""
    half = np.full(3, _HOOK)
    place = recording.column("body_position", name)[looks]
    turn = np.broadcast_to(np.eye(3), (len(looks), 3, 3))
    skin = (SIGNS * half)[box_faces(1)]
    return _Body(name, name, "hook", half[None], np.zeros((1, 3)), place, turn, skin, False)


def _structure(looks: Indices, structure: Structure) -> _Body:
    """What stands in the world: a box, maybe turned, walls along the axes of the world, something round."""
    name, boxes = structure.name, structure.boxes
    if len(boxes) == 1:
        return _Body(name, name, "structure", *_box(looks, boxes[0]), False)
    sides = np.abs(boxes[:, [4, 2, 1]] - boxes[:, :1])
    is_round = bool((sides > 0.0).sum() > 3 * len(boxes))  # some are turned
    still = np.zeros((len(looks), 3)), np.broadcast_to(np.eye(3), (len(looks), 3, 3))
    skin = boxes.reshape(-1, 3)[box_faces(len(boxes))]
    sizes = _sizes(boxes.reshape(1, -1, 3) if is_round else boxes)
    return _Body(name, name, "structure", *sizes, *still, skin, is_round)


def _support(recording: Recording, looks: Indices, support: Structure) -> _Body:
    """A support, which counts while it stands and carries nothing: what it carries sinks into it."""
    stands = np.array([support.stands(time) for time in recording.time[looks]])
    counts = stands & (recording.column("contact_force", support.name)[looks] == 0.0)
    name = support.name.removeprefix("support.")
    return _Body(name, name, "support", *_box(looks, support.boxes[0]), False, counts)


def _box(
    looks: Indices, corners: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray, FloatArray]:
    """Sizes, centres, place, turn and skin of a box of the world, by its corners, shape (8, 3) [m]."""
    sides = (corners[[4, 2, 1]] - corners[0]) / 2  # half, along its axes
    half = np.linalg.norm(sides, axis=1)
    place = np.broadcast_to(corners.mean(axis=0), (len(looks), 3))
    turn = np.broadcast_to((sides / half[:, None]).T, (len(looks), 3, 3))
    skin = (corners[box_faces(1)] - corners.mean(axis=0)) @ turn[0]
    return half[None], np.zeros((1, 3)), place, turn, skin


def _sizes(corners: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Half the sizes of boxes and their middles, shape (boxes, 3), of points in them, (boxes, n, 3) [m]."""
    least, most = corners.min(axis=1), corners.max(axis=1)
    return (most - least) / 2, (most + least) / 2


def _drawn(
    recording: Recording, looks: Indices, body: Mapping[str, Any], of: tuple[str, str]
) -> Iterator[_Body]:
    skin = skin_of(body)
    if not len(skin):
        return
    name, (whose, kind) = str(body["name"]), of
    is_mesh = body["shape"]["type"] == "mesh"
    # Boxes have twelve triangles each, which hold their corners.
    half, centres = _sizes(skin.reshape(1, -1, 3) if is_mesh else skin.reshape(-1, 36, 3))
    if kind == "tracks":
        # Mats lie in the ground as they are drawn, and cranes may stand on one and the same.
        above = centres[:, 2] + np.asarray(body["centre_of_gravity"])[2] > 0.0
        half, centres = half[above], centres[above]
    place = recording.column("body_position", name)[looks]
    turn = axes(recording.column("body_orientation", name)[looks])
    yield _Body(name, whose, kind, half, centres, place, turn, skin, is_mesh)


def _depths(one: _Body, other: _Body) -> tuple[FloatArray, BoolArray]:
    """How deep one body is in the other at each look [m], and where past the middle of a box."""
    looks = len(one.place)
    deepest, is_past = np.zeros(looks), np.zeros(looks, dtype=np.bool_)
    for half, centre in zip(one.sizes, one.centres, strict=True):
        at = one.place + np.einsum("tij,j->ti", one.turn, centre)
        for half_other, centre_other in zip(other.sizes, other.centres, strict=True):
            at_other = other.place + np.einsum("tij,j->ti", other.turn, centre_other)
            apart = at_other - at
            # Balls about both: most pairs are never near each other.
            near = np.linalg.norm(apart, axis=1) < np.linalg.norm(half) + np.linalg.norm(half_other)
            if not near.any():
                continue
            depth = np.zeros(looks)
            depth[near] = _boxes(apart[near], (one.turn[near], half), (other.turn[near], half_other))
            deepest = np.maximum(deepest, depth)
            is_past |= depth > min(half.min(), half_other.min())
    if one.is_mesh or other.is_mesh:
        near = np.flatnonzero(deepest > _TOUCH)
        looked_at = near[np.linspace(0, len(near) - 1, min(len(near), _EXACT_LOOKS)).astype(int)]
        exact = np.zeros(looks)
        for look in looked_at:
            exact[look] = min(float(deepest[look]), _through(one, other, int(look)))
        # Past the middle of a box, by what it is about, which a curved side over the top of a support is not.
        is_past &= exact > 0.0
        if "support" in (one.kind, other.kind):
            is_past &= exact == deepest
        deepest = exact
    return deepest, is_past


def _boxes(
    apart: FloatArray, one: tuple[FloatArray, FloatArray], other: tuple[FloatArray, FloatArray]
) -> FloatArray:
    """The shortest way by which boxes come apart, shape (looks,) [m]; 0 where they are.

    Args:
        apart: From the middle of one to that of the other, shape (looks, 3) [m].
        one: Its axes as columns, shape (looks, 3, 3), and half its sizes [m].
        other: The same of the other.
    """
    (turn, half), (turn_other, half_other) = one, other
    sides, sides_other = turn.transpose(0, 2, 1), turn_other.transpose(0, 2, 1)
    edges = np.cross(sides[:, :, None], sides_other[:, None]).reshape(-1, 9, 3)
    directions = np.concatenate([sides, sides_other, edges], axis=1)
    length = np.linalg.norm(directions, axis=2)
    unit = directions / np.maximum(length, _PARALLEL)[:, :, None]
    reach = np.abs(unit @ turn) @ half + np.abs(unit @ turn_other) @ half_other
    way = reach - np.abs(np.einsum("tki,ti->tk", unit, apart))
    depth = np.where(length > _PARALLEL, way, np.inf).min(axis=1)
    shortest: FloatArray = np.maximum(depth, 0.0)
    return shortest


def _through(one: _Body, other: _Body, look: int) -> float:
    """How deep skins go through each other at one look [m]; 0 if not at all.

    Into a support it is how far below its top, into others infinite, so that the boxes about both have it.
    Of two meshes one is its box.
    """
    skins = []
    for body in (one, other):
        own = body.skin
        if one.is_mesh and other.is_mesh and body is one:
            own = (body.centres[0] + SIGNS * body.sizes[0])[box_faces(1)]
        skins.append(body.place[look] + own @ body.turn[look].T)
    points = [
        crossings(edges.reshape(-1, 3), np.roll(edges, -1, axis=1).reshape(-1, 3), surface)[0]
        for edges, surface in (skins, skins[::-1])
    ]
    if not any(len(some) for some in points):
        return 0.0
    for support, skin in ((one, skins[1]), (other, skins[0])):
        if support.kind == "support":
            corners, half = skin.reshape(-1, 3), support.sizes[0]
            own = (corners - support.place[look]) @ support.turn[look]
            inside = corners[(np.abs(own) <= half).all(axis=1)]
            lowest = np.concatenate([*points, inside])[:, 2].min()
            return max(0.0, float(support.place[look, 2] + half[2] - lowest))
    return np.inf
