"""Slings that run through their load, over its edges, or from inside of it; ropes through what is there.

No simulation holds them off.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.loads.looks import looks_along, looks_at
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.rotation import axes
from gantline.results.solids import box_faces, crossings, skin_of
from gantline.results.surroundings import structures_of
from gantline.results.variable import BoolArray, FloatArray, Indices

__all__ = [
    "OverEdge",
    "Through",
    "lines_through",
    "slings_over_edges",
    "slings_through_loads",
    "slings_through_structures",
]

#: So far from its ends a sling is not looked at [m]: lugs stand in recesses, and shackles on the load's skin.
_NEAR_ENDS = 1.0
#: The sky [m]: how far up a load is looked for over the upper end of a sling.
_UP = np.array([0.0, 0.0, 1e4])
#: Moments that are looked at, at most, of those at which a rope meets what is about a structure or a body.
_LOOKS = 60
#: How deep a sling may cut an edge of its load as drawn, and how deep its lug may lie in it [m]: pins of lugs
#: stand off the plating, and boxes stand for what has chamfers. The same of baskets of `mechanics`.
_DEEP = 0.1
#: Looks at which that is measured, where a sling comes out farthest from its lug, and places along it.
_EXACT_LOOKS, _PLACES = 6, 20
#: Along the axes of a body, either way: whatever is inside meets its skin in all of them.
_SIX_WAYS = np.concatenate([np.eye(3), -np.eye(3)])


@dataclass(frozen=True)
class Through:
    """A sling or another rope that carries and runs through its load, a structure or a hull.

    Attributes:
        name: That of the sling; of another rope the name of the rope.
        thing: Name of what it runs through.
        time: When it does so for the first time, as far as it was looked at [s].
        at: Where it goes through the skin of that, from the nearer of its ends [m]; the farthest such place.
            None where its upper end lies within or below a load.
    """

    name: str
    thing: str
    time: float
    at: float | None


@dataclass(frozen=True)
class _Line:
    """A rope by what it is called, and the crane by which it hangs; empty of none.

    Falls end in a lead line, drawn plumb from their last sheave wherever it leads to the drum.
    """

    name: str
    rope: str
    crane: str = ""
    has_lead_line: bool = False


@dataclass(frozen=True, eq=False)
class _Thing:
    """What ropes may run through, as drawn.

    Attributes:
        name: Its name.
        body: The body that has the axes of its triangles; None for those of the world.
        skin: Triangles, shape (n, 3, 3) [m].
        crane: Of a boom, the crane whose own ropes run beside it; empty of anything else.
    """

    name: str
    body: str | None
    skin: FloatArray
    crane: str = ""


@dataclass(frozen=True)
class OverEdge:
    """A sling that carries, and goes over an edge of its load within 1 m of its lug.

    Attributes:
        name: Of the sling.
        load: Name of what it lifts.
        time: When it is as deep as `deep`, as far as it was looked at [s].
        deep: How deep it goes through the load as drawn [m].
        at: Where it comes out of that, from its lug [m].
    """

    name: str
    load: str
    time: float
    deep: float
    at: float


def slings_through_loads(recording: Recording) -> list[Through]:
    """Slings that go through the skin of a load, as drawn, more than 1 m from their ends, or start below it.

    A load that is not drawn as boxes or triangles has no skin. Slings that do not carry may lie anywhere, and
    those whose distance to the load the lift file watches are judged by that.
    """
    found = []
    for load, skin in _loads(recording):
        for sling in recording.rig.slings if len(skin) else ():
            if _is_watched(recording, load.name, sling.rope):
                continue
            seen = _first_seen(recording, load, sling.rope, skin)
            if seen is not None:
                found.append(Through(sling.name, load.name, *seen))
    return found


def slings_through_structures(recording: Recording) -> list[Through]:
    """Slings that carry and go through a structure, a hull or another crane's boom, as drawn.

    More than 1 m from their ends. Those whose distance to it the lift file watches are judged by that.
    """
    rig = recording.rig
    cranes = {hook.name: hook.crane for hook in rig.hooks}
    slings = [_Line(one.name, one.rope, cranes.get(rig.hook_of(one) or "", "")) for one in rig.slings]
    looks = looks_at(recording)
    return [one for thing in _things(recording) for one in _ropes_through(recording, slings, thing, looks)]


def lines_through(recording: Recording) -> list[Through]:
    """Falls and tag lines that carry and go through load, structure, hull or another crane's boom, as drawn.

    More than 1 m from their ends. Those whose distance to it the lift file watches are judged by that.
    Mooring lines lie over the edges of quays and decks as a rule, so nothing is said of these.
    """
    rig = recording.rig
    falls = {fall.rpartition("/")[0]: hook.crane for hook in rig.hooks for fall in hook.falls}
    lines = [_Line(rope, rope, crane, has_lead_line=True) for rope, crane in falls.items()]
    lines += [_Line(line.rope, line.rope) for line in rig.tag_lines]
    things = [*_things(recording), *(_Thing(load.name, load.body, skin) for load, skin in _loads(recording))]
    looks = looks_at(recording)
    return [one for thing in things for one in _ropes_through(recording, lines, thing, looks)]


def slings_over_edges(recording: Recording) -> list[OverEdge]:
    """Slings that carry and go over an edge of their load within 1 m of their lugs, at their deepest.

    A lug on the outside of a load from which a sling leads back through it: the rope bends about the edge
    that it meets. Of a lug that lies deeper there is a recess. Slings whose distance to the load the lift
    file watches are judged by that.
    """
    found = []
    for load, skin in _loads(recording):
        for sling in recording.rig.slings if len(skin) else ():
            if _is_watched(recording, load.name, sling.rope):
                continue
            cuts = [
                cut
                for end, of, _ in sling.at_lugs()
                if of == load.name
                for cut in _edges(recording, (sling.rope, end if sling.over else 1), load.body, skin)
            ]
            if cuts:
                found.append(OverEdge(sling.name, load.name, *max(cuts, key=lambda cut: cut[1])))
    return found


def _edges(
    recording: Recording, end: tuple[str, int], body: str, skin: FloatArray
) -> Iterator[tuple[float, float, float]]:
    """When a rope goes over an edge near its first end, 0, or last, 1 [s], how deep, how far off [m]."""
    rope, is_last = end
    picked = _looks(recording, rope, body)
    if not len(picked):
        return
    points, _ = _along(recording, rope, picked, body)
    points = points[:, ::-1] if is_last else points
    lugs, way = points[:, 0], points[:, 1] - points[:, 0]
    length = np.linalg.norm(way, axis=1)
    near = lugs + way * np.minimum(_NEAR_ENDS / length, 1.0)[:, None]
    through, line = crossings(lugs, near, skin)
    apart = np.linalg.norm(through - lugs[line], axis=1)
    comes_out = np.zeros(len(lugs))
    np.maximum.at(comes_out, line, apart)
    chosen = np.argsort(-comes_out, kind="stable")[:_EXACT_LOOKS]
    for look in chosen[comes_out[chosen] > _DEEP]:
        out = float(comes_out[look])
        places = lugs[look] + np.linspace(0.0, out / length[look], _PLACES)[:, None] * way[look]
        depths = _depths(places, skin)
        deep = float(depths.max())
        if depths[0] <= _DEEP < deep:
            yield float(recording.time[picked[look]]), deep, out


def _loads(recording: Recording) -> Iterator[tuple[Load, FloatArray]]:
    """Loads, and their skins as drawn from their centres of gravity; empty of one that has no solid."""
    bodies = {body["name"]: body for body in (recording.attributes.get("scene") or {}).get("bodies") or ()}
    for load in recording.rig.loads:
        yield load, skin_of(bodies.get(load.body))


def _things(recording: Recording) -> Iterator[_Thing]:
    """Structures, hulls, booms, and what stands fixed on the ground or on decks."""
    for one in structures_of(recording):
        if one.kind == "structure":
            yield _Thing(one.name, None, one.boxes.reshape(-1, 3)[box_faces(len(one.boxes))])
    booms = {boom.boom: boom.name for boom in recording.rig.booms}
    for body in (recording.attributes.get("scene") or {}).get("bodies") or ():
        if body["kind"] == "hull" or body["name"] in (*booms, *recording.rig.fixtures):
            yield _Thing(body["name"], body["name"], skin_of(body), booms.get(body["name"], ""))


def _ropes_through(
    recording: Recording, ropes: Sequence[_Line], thing: _Thing, looks: Indices
) -> Iterator[Through]:
    """Which ropes go through a thing while they carry; of a boom not those of its crane."""
    for line in ropes if len(thing.skin) else ():
        is_own = bool(thing.crane) and line.crane == thing.crane
        if is_own or _is_watched(recording, thing.name, line.rope):
            continue
        picked = looks[series.is_carrying(recording.column("rope_tension", line.rope))[looks]]
        points, _ = _along(recording, line.rope, picked, thing.body)
        points = points[:, :-1] if line.has_lead_line else points
        meets = np.flatnonzero(_meets_box_about(points, thing.skin))
        chosen = meets[np.linspace(0, len(meets) - 1, min(len(meets), _LOOKS)).astype(int)]
        picked, points = picked[chosen], points[chosen]
        look, apart = _through(points, thing.skin)
        if len(look):
            at = float(apart[look == look[0]].max())
            yield Through(line.name, thing.name, float(recording.time[picked[look[0]]]), at)


def _depths(places: FloatArray, skin: FloatArray) -> FloatArray:
    """How deep places lie in a closed skin, along its axes, shape (n,) [m]; 0 outside.

    Args:
        places: Shape (n, 3) [m].
        skin: Triangles, shape (triangles, 3, 3) [m].
    """
    reach = float(np.linalg.norm(np.ptp(skin.reshape(-1, 3), axis=0))) + 1.0
    ends = places[:, None] + reach * _SIX_WAYS
    starts = np.broadcast_to(places[:, None], ends.shape)
    through, line = crossings(starts.reshape(-1, 3), ends.reshape(-1, 3), skin)
    nearest = np.full(len(places) * len(_SIX_WAYS), np.inf)
    np.minimum.at(nearest, line, np.linalg.norm(through - starts.reshape(-1, 3)[line], axis=1))
    sides = nearest.reshape(-1, len(_SIX_WAYS))
    depths: FloatArray = np.where(np.isfinite(sides).all(axis=1), sides.min(axis=1), 0.0)
    return depths


def _is_watched(recording: Recording, thing: str, rope: str) -> bool:
    names = {rope, "slings", "ropes"}
    pairs = [set(watch.between) for watch in recording.rig.watches if watch.is_whole_lift]
    # A name stands for everything whose name goes on after it with a dot.
    is_thing = [any(thing == one or thing.startswith(f"{one}.") for one in pair) for pair in pairs]
    return any(is_it and not names.isdisjoint(pair) for is_it, pair in zip(is_thing, pairs, strict=True))


def _first_seen(
    recording: Recording, load: Load, rope: str, skin: FloatArray
) -> tuple[float, float | None] | None:
    """When a rope that carries goes through a skin for the first time [s], and `Through.at` [m]."""
    picked = _looks(recording, rope, load.body)
    if not len(picked):
        return None
    points, own = _along(recording, rope, picked, load.body)
    heights = recording["rope_point"].values[picked][:, recording.points_of_ropes[rope], 2]
    top = points[np.arange(len(picked)), heights.argmax(axis=1)]
    _, below = crossings(top, top + _UP @ own, skin)
    far, apart = _through(points, skin)
    if not len(below) and not len(far):
        return None
    first = min([*below[:1], *far[:1]])
    at = None if first in below else float(apart[far == first].max())
    return float(recording.time[picked[first]]), at


def _looks(recording: Recording, rope: str, body: str) -> Indices:
    """Samples at which a rope that carries is looked at as a body sees it."""
    carries = np.flatnonzero(series.is_carrying(recording.column("rope_tension", rope)))
    return carries[looks_along(_along(recording, rope, carries, body)[0])]


def _along(
    recording: Recording, rope: str, picked: Indices, body: str | None
) -> tuple[FloatArray, FloatArray]:
    """Points of a rope at some samples, shape (looks, points, 3) [m], and axes of what they are counted in.

    In those of a body from its centre of gravity, in those of the world if it is none.
    """
    places = recording["rope_point"].values[picked][:, recording.points_of_ropes[rope]]
    if body is None:
        return places, np.broadcast_to(np.eye(3), (len(picked), 3, 3))
    # World from body: rows times the matrix are components along the body's axes.
    own = axes(recording.column("body_orientation", body)[picked])
    return (places - recording.column("body_position", body)[picked, None]) @ own, own


def _meets_box_about(points: FloatArray, skin: FloatArray) -> BoolArray:
    """At which looks a rope meets the box about a skin, shape (looks,): by the slabs of that, in its axes."""
    low, high = skin.reshape(-1, 3).min(axis=0), skin.reshape(-1, 3).max(axis=0)
    starts, way = points[:, :-1], np.diff(points, axis=1)
    way = np.where(way == 0.0, np.finfo(float).tiny, way)
    with np.errstate(over="ignore"):  # a part along a face comes to the others at infinity
        one, other = (low - starts) / way, (high - starts) / way
    first, last = np.minimum(one, other).max(axis=2), np.maximum(one, other).min(axis=2)
    meets: BoolArray = (np.maximum(first, 0.0) <= np.minimum(last, 1.0)).any(axis=1)
    return meets


def _through(points: FloatArray, skin: FloatArray) -> tuple[Indices, FloatArray]:
    """At which looks a rope goes through a skin far from its ends, and how far from the nearer [m]."""
    if not len(points):
        return np.zeros(0, dtype=np.intp), np.zeros(0)
    starts, ends = (part.reshape(-1, 3) for part in (points[:, :-1], points[:, 1:]))
    through, line = crossings(starts, ends, skin)
    look = line // (points.shape[1] - 1)
    apart = np.linalg.norm(through[:, None] - points[look][:, [0, -1]], axis=-1).min(axis=1)
    is_far = apart > _NEAR_ENDS
    return look[is_far], apart[is_far]
