"""Fewer samples that look the same: peaks stay."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gantline.results.recording import Recording
from gantline.results.variable import FloatArray

Places = npt.NDArray[np.int64]


def peaks(values: FloatArray, buckets: int) -> Places:
    """Samples that keep the shape of a curve: first, least, largest and last of each bucket of samples.

    Drawn at one bucket per pixel or finer, the lines through all samples and through these cover the same
    pixels (Jugel et al. 2014, "M4: a visualization-oriented time series data aggregation"). The largest and
    the least value of the whole curve are always among them.

    Args:
        values: Shape (time,).
        buckets: How many.

    Returns:
        Increasing indices into `values`.
    """
    count = len(values)
    if count <= 4 * buckets:
        return _needed(values, np.arange(count))
    edges = np.linspace(0, count, buckets + 1).astype(np.int64)
    found = [edges[:-1], edges[1:] - 1]
    found.append(_extremes(values, edges))
    found.append(_extremes(-values, edges))
    return _needed(values, np.unique(np.concatenate(found)))


def _extremes(values: FloatArray, edges: Places) -> Places:
    known = np.where(np.isnan(values), -np.inf, values)
    return np.array([begin + int(np.argmax(known[begin:end])) for begin, end in pairwise(edges)])


def _needed(values: FloatArray, places: Places) -> Places:
    """Without samples that are equal to both neighbours: a straight line needs its ends alone."""
    kept = values[places]
    same = np.zeros(len(places), dtype=np.bool_)
    same[1:-1] = (kept[1:-1] == kept[:-2]) & (kept[1:-1] == kept[2:])
    return places[~same]


def frames(recording: Recording, most: int) -> Places:
    """Samples at which the lift is drawn: evenly spread, with the ones just before and after each event.

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
    even = np.linspace(0, count - 1, max(2, most)).round().astype(np.int64)
    events = np.array([when for when, _, _ in recording.events()])
    after = np.clip(np.searchsorted(time, events), 1, count - 1)
    around = np.unique(np.concatenate([after - 1, after])) if len(events) else after
    if len(around) > most:
        around = around[:0]
    return np.unique(np.concatenate([even, around]))
