"""Slings that run through what they lift, or hang from inside of it; no simulation holds them off."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.rotation import axes
from gantline.results.solids import crossings, skin_of
from gantline.results.variable import FloatArray

__all__ = ["Through", "slings_through_loads"]

#: So far from its ends a sling is not looked at [m]: lugs stand in recesses, and shackles on the load's skin.
_NEAR_ENDS = 1.0
#: The sky [m]: how far up a load is looked for over the upper end of a sling.
_UP = np.array([0.0, 0.0, 1e4])
#: Samples at which a sling is looked at, at most: a load that turns is seen every few degrees.
_LOOKS = 60


@dataclass(frozen=True)
class Through:
    """A sling that carries and runs through its load.

    Attributes:
        sling: Its name.
        load: Name of the load.
        time: When it does so for the first time, as far as it was looked at [s].
        at: Where it goes through the load's skin, from the nearer of its ends [m]; the farthest such place.
            None where its upper end lies within or below the load.
    """

    sling: str
    load: str
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


def _is_watched(recording: Recording, load: str, rope: str) -> bool:
    names = {rope, "slings", "ropes"}
    pairs = [set(watch.between) for watch in recording.rig.watches if watch.is_whole_lift]
    return any(load in pair and not names.isdisjoint(pair) for pair in pairs)


def _first_seen(
    recording: Recording, load: Load, rope: str, skin: FloatArray
) -> tuple[float, float | None] | None:
    """When a rope that carries goes through a skin for the first time [s], and `Through.at` [m]."""
    carries = np.flatnonzero(series.is_carrying(recording.column("rope_tension", rope)))
    if not len(carries):
        return None
    picked = np.unique(carries[np.linspace(0, len(carries) - 1, _LOOKS).astype(int)])
    # World from body: rows times the matrix are components along the body's axes.
    own = axes(recording.column("body_orientation", load.body)[picked])
    places = recording["rope_point"].values[picked][:, recording.points_of_ropes[rope]]
    points = (places - recording.column("body_position", load.body)[picked, None]) @ own
    top = points[np.arange(len(picked)), places[:, :, 2].argmax(axis=1)]
    _, below = crossings(top, top + _UP @ own, skin)
    starts, ends = (part.reshape(-1, 3) for part in (points[:, :-1], points[:, 1:]))
    through, line = crossings(starts, ends, skin)
    look = line // (points.shape[1] - 1)
    apart = np.linalg.norm(through[:, None] - points[look][:, [0, -1]], axis=-1).min(axis=1)
    far = look[apart > _NEAR_ENDS]
    if not len(below) and not len(far):
        return None
    first = min([*below[:1], *far[:1]])
    at = None if first in below else float(apart[look == first].max())
    return float(recording.time[picked[first]]), at
