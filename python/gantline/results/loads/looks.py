"""Moments at which a recording is looked at by what takes too long for every sample of it."""

from __future__ import annotations

import numpy as np

from gantline.results.recording import Recording
from gantline.results.rotation import angle_between
from gantline.results.solids import skin_of
from gantline.results.variable import Indices

__all__ = ["looks_at"]

#: Of two moments which follow each other by time alone, and of two by how far bodies go, at most.
_LOOKS = 600


def looks_at(recording: Recording) -> Indices:
    """Samples to look at, in order: half of them evenly apart in time, half so that bodies go equally far.

    A boom that slews for one minute of an hour has gone past what it strikes between two moments of the
    first kind; those of the second are as near to each other as if the lift had no holds.
    """
    count = len(recording.time)
    every = np.linspace(0, count - 1, min(count, _LOOKS)).astype(int)
    gone = np.zeros(count)
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
    way_so_far = np.cumsum(gone)
    far = np.searchsorted(way_so_far, np.linspace(0.0, way_so_far[-1], _LOOKS)) if count else every
    return np.unique(np.concatenate([every, np.minimum(far, count - 1)]))
