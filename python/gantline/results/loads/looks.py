"""Moments at which a recording is looked at by what takes too long for every sample of it."""

from __future__ import annotations

import numpy as np

from gantline.results.recording import Recording
from gantline.results.rotation import angle_between
from gantline.results.solids import skin_of
from gantline.results.variable import FloatArray, Indices

__all__ = ["looks_along", "looks_at"]

#: Of two moments which follow each other by time alone, and of two by how far bodies go, at most.
_LOOKS = 600
#: The same of one rope as its load sees it: a load that turns is seen every few degrees.
_OF_ROPE = 60
#: Towards faces, edges and corners of a box, shape (26, 3).
_SIDES = np.array([way for way in np.ndindex(3, 3, 3) if way != (1, 1, 1)], dtype=np.float64) - 1.0


def looks_at(recording: Recording) -> Indices:
    """Samples to look at, in order: half of them evenly apart in time, half so that bodies go equally far.

    A boom that slews for one minute of an hour has gone past what it strikes between two moments of the
    first kind; those of the second are as near to each other as if the lift had no holds.
    """
    gone = np.zeros(len(recording.time))
    names = set(recording.coordinates.get("body", ()))
    for body in (recording.attributes.get("scene") or {}).get("bodies") or ():
        skin = skin_of(body)
        if len(skin) and body["name"] in names:
            # The farthest point of a body goes no farther than its middle does and it turns.
            reach = float(np.linalg.norm(skin, axis=-1).max())
            place = recording.column("body_position", body["name"])
            turn = recording.column("body_orientation", body["name"])
            way = np.linalg.norm(np.diff(place, axis=0), axis=1) + reach * angle_between(turn[1:], turn[:-1])
            gone[1:] = np.maximum(gone[1:], way)
    return _evenly(gone, _LOOKS)


def looks_along(points: FloatArray) -> Indices:
    """Moments, in order, that show all of the way of a rope past its load, and where that turns back.

    Those of `looks_at`, fewer of either, and those at which a point of the rope is farthest to a side, edge
    or corner of the load: what a load does for a second in two hours of waves is next to nothing of its way.

    Args:
        points: Points of the rope in the axes of the load over time, shape (time, points, 3) [m].
    """
    gone = np.zeros(len(points))
    gone[1:] = np.linalg.norm(np.diff(points, axis=0), axis=2).max(axis=1, initial=0.0)
    farthest = [(points @ side).argmax(axis=0) for side in _SIDES if len(points)]
    return np.unique(np.concatenate([_evenly(gone, _OF_ROPE), *farthest]))


def _evenly(gone: FloatArray, looks: int) -> Indices:
    """So many moments evenly apart in time, as many by the way gone since the sample before [m]; in order."""
    count = len(gone)
    if not count:
        return np.zeros(0, dtype=np.intp)
    every = np.linspace(0, count - 1, min(count, looks)).astype(int)
    so_far = np.cumsum(gone)
    far = np.searchsorted(so_far, np.linspace(0.0, so_far[-1], looks))
    return np.unique(np.concatenate([every, np.minimum(far, count - 1)]))
