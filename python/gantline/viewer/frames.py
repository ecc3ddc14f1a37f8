"""Samples at which a lift is drawn: more of them where its motion bends."""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from gantline.results.recording import Recording
from gantline.results.solids import solid_of
from gantline.results.variable import FloatArray
from gantline.viewer.decimate import Places

__all__ = ["DRAWN_OFF", "frames"]

#: How far from its recorded place anything may be drawn between frames [m], a hundredth of a pixel of a lift
#: of 100 m. Where that takes more frames than there may be, the worst places come first.
DRAWN_OFF = 1e-3
#: Of the frames there may be, those that are spread evenly: for all that bends by less, and for forces.
_EVEN = 0.5


class _Motion(NamedTuple):
    """Something that moves, as it is drawn between frames: by straight lines.

    Attributes:
        values: Shape (time, things, parts).
        reach: Distance that a change of one makes, of each thing; shape (things,).
    """

    values: FloatArray
    reach: FloatArray


def frames(recording: Recording, most: int) -> Places:
    """Samples at which the lift is drawn, so that straight lines between them come near all others.

    Half of them are spread evenly, with the ones just before and after each event. Where what is drawn is
    furthest from the lines between those there are, one is added, until none is further than `DRAWN_OFF`.

    Args:
        recording: Any recording.
        most: How many there may be, about.

    Returns:
        Increasing indices of samples.
    """
    time = recording.time
    count = len(time)
    if count <= most:
        return np.arange(count)
    even = np.linspace(0, count - 1, max(2, round(_EVEN * most))).round().astype(np.int64)
    events = np.array([when for when, _, _ in recording.events()])
    after = np.clip(np.searchsorted(time, events), 1, count - 1)
    around = np.unique(np.concatenate([after - 1, after])) if len(events) else after
    if len(around) > most:
        around = around[:0]
    kept = np.unique(np.concatenate([even, around]))
    # Those around events come on top, as far as there may be more.
    return _bent(time, list(_motions(recording)), kept, most + len(around))


def _motions(recording: Recording) -> Iterator[_Motion]:
    """Paths of ropes, and the places and turns of bodies, as far as they are recorded."""
    if "rope_point" in recording:
        points = recording["rope_point"].values
        yield _Motion(points, np.ones(points.shape[1]))
    if "body_position" not in recording:
        return
    places = recording["body_position"].values
    yield _Motion(places, np.ones(places.shape[1]))
    if "body_orientation" in recording:
        turns = recording["body_orientation"].values
        # A quaternion and its opposite are one attitude, between which the drawing does not turn.
        along = np.sum(turns[1:] * turns[:-1], axis=2)
        signs = np.ones(turns.shape[:2])
        np.cumprod(np.where(along < 0.0, -1.0, 1.0), axis=0, out=signs[1:])
        # A turn by a small angle changes a unit quaternion by half of it.
        yield _Motion(turns * signs[:, :, None], 2.0 * _reach(recording))


def _reach(recording: Recording) -> FloatArray:
    """Of each body how far from its centre of gravity it is drawn [m]; 0 of one without a shape."""
    scene: Mapping[str, Any] = recording.attributes.get("scene") or {}
    drawn = {entry["name"]: entry for entry in scene.get("bodies") or ()}
    names = recording.coordinates.get("body", ())
    return np.array([_size(drawn[name]) if name in drawn else 0.0 for name in names])


def _size(body: Mapping[str, Any]) -> float:
    solid = solid_of(body.get("shape"))
    if solid is None or not len(solid[0]):
        return 0.0
    centre = np.asarray(body.get("centre_of_gravity") or np.zeros(3), dtype=np.float64)
    return float(np.linalg.norm(solid[0] - centre, axis=1).max())


def _bent(time: FloatArray, motions: Sequence[_Motion], kept: Places, most: int) -> Places:
    """Samples with those that are furthest from the lines between them, the worst first."""
    waiting = [one for begin, end in pairwise(kept) if (one := _worst(time, motions, begin, end))]
    heapq.heapify(waiting)
    more: list[int] = []
    while waiting and len(kept) + len(more) < most:
        _, place, begin, end = heapq.heappop(waiting)
        more.append(place)
        for one in (_worst(time, motions, begin, place), _worst(time, motions, place, end)):
            if one:
                heapq.heappush(waiting, one)
    return np.union1d(kept, np.array(more, dtype=np.int64))


def _worst(
    time: FloatArray, motions: Sequence[_Motion], begin: int, end: int
) -> tuple[float, int, int, int] | None:
    """Of the samples between two the furthest from the line between these, with both; None if all are near.

    The distance [m] comes first, and less than zero, so that the largest is the least.
    """
    if end - begin < 2:
        return None
    inside = slice(begin + 1, end)
    span = time[end] - time[begin]
    share = ((time[inside] - time[begin]) / span if span > 0.0 else np.zeros(end - begin - 1))[:, None, None]
    furthest = np.zeros(end - begin - 1)
    for values, reach in motions:
        line = values[begin] + share * (values[end] - values[begin])
        distance = reach * np.linalg.norm(values[inside] - line, axis=2)
        # What is no number in one sample has nothing to come near to.
        furthest = np.fmax(furthest, np.fmax.reduce(distance, axis=1, initial=0.0))
    most = int(furthest.argmax())
    if furthest[most] <= DRAWN_OFF:
        return None
    return -float(furthest[most]), int(begin) + 1 + most, int(begin), int(end)
