"""Slings that run through what they lift, hang from inside of it, or run through what stands in their way.

No simulation holds them off.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.rotation import axes
from gantline.results.solids import box_faces, crossings, skin_of
from gantline.results.surroundings import structures_of
from gantline.results.variable import FloatArray, Indices

__all__ = ["Through", "slings_through_loads", "slings_through_structures"]

#: So far from its ends a sling is not looked at [m]: lugs stand in recesses, and shackles on the load's skin.
_NEAR_ENDS = 1.0
#: The sky [m]: how far up a load is looked for over the upper end of a sling.
_UP = np.array([0.0, 0.0, 1e4])
#: Samples at which a sling is looked at, at most: a load that turns is seen every few degrees.
_LOOKS = 60


@dataclass(frozen=True)
class Through:
    """A sling that carries and runs through its load, a structure or a hull.

    Attributes:
        sling: Its name.
        thing: Name of what it runs through.
        time: When it does so for the first time, as far as it was looked at [s].
        at: Where it goes through the skin of that, from the nearer of its ends [m]; the farthest such place.
            None where its upper end lies within or below a load.
    """

    sling: str
    thing: str
    time: float
    at: float | None


def slings_through_loads(recording: Recording) -> list[Through]:
    """Slings that go through the skin of a load, as drawn, more than 1 m from their ends, or start below it.

    A load that is not drawn as boxes or triangles has no skin. Slings that do not carry may lie anywhere, and
    those whose distance to the load the lift file watches are judged by that.
    """
    bodies = {body["name"]: body for body in (recording.attributes.get("scene") or {}).get("bodies") or ()}
    found = []
    for load in recording.rig.loads:
        skin = skin_of(bodies.get(load.body))
        for sling in recording.rig.slings if len(skin) else ():
            if _is_watched(recording, load.name, sling.rope):
                continue
            seen = _first_seen(recording, load, sling.rope, skin)
            if seen is not None:
                found.append(Through(sling.name, load.name, *seen))
    return found


def slings_through_structures(recording: Recording) -> list[Through]:
    """Slings that carry and go through a structure or a hull, as drawn, more than 1 m from their ends.

    Those whose distance to it the lift file watches are judged by that.
    """
    scene = recording.attributes.get("scene") or {}
    skins = {
        one.name: (None, one.boxes.reshape(-1, 3)[box_faces(len(one.boxes))])
        for one in structures_of(recording)
        if one.kind == "structure"
    }
    hulls = [body for body in scene.get("bodies") or () if body["kind"] == "hull"]
    skins |= {body["name"]: (body["name"], skin_of(body)) for body in hulls}
    found = []
    for name, (body, skin) in skins.items():
        for sling in recording.rig.slings if len(skin) else ():
            if _is_watched(recording, name, sling.rope):
                continue
            picked = _looks(recording, sling.rope)
            points, _ = _along(recording, sling.rope, picked, body)
            look, apart = _through(points, skin)
            if len(look):
                at = float(apart[look == look[0]].max())
                found.append(Through(sling.name, name, float(recording.time[picked[look[0]]]), at))
    return found


def _is_watched(recording: Recording, thing: str, rope: str) -> bool:
    names = {rope, "slings", "ropes"}
    pairs = [set(watch.between) for watch in recording.rig.watches if watch.is_whole_lift]
    return any(thing in pair and not names.isdisjoint(pair) for pair in pairs)


def _first_seen(
    recording: Recording, load: Load, rope: str, skin: FloatArray
) -> tuple[float, float | None] | None:
    """When a rope that carries goes through a skin for the first time [s], and `Through.at` [m]."""
    picked = _looks(recording, rope)
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


def _looks(recording: Recording, rope: str) -> Indices:
    """Samples at which a rope that carries is looked at."""
    carries = np.flatnonzero(series.is_carrying(recording.column("rope_tension", rope)))
    if not len(carries):
        return carries
    return np.unique(carries[np.linspace(0, len(carries) - 1, _LOOKS).astype(int)])


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
