"""Fewer samples that look the same: peaks stay."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

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
    extremes = _extremes(values, edges), _extremes(-values, edges)
    return _needed(values, _in_order(count, edges[:-1], edges[1:] - 1, *extremes))


def faithful(time: FloatArray, values: FloatArray, kept: Places, off: float, most: int) -> Places:
    """Samples between which straight lines come near every sample, so that a curve can be read at any time.

    Where the line between two that are kept is furthest off, that sample is kept too, until none is too far.

    Args:
        time: Shape (time,) [s].
        values: Shape (time,); where one is no number, there is nothing to come near to.
        kept: Those to begin with, increasing.
        off: How far from the lines a sample may be, of the range of the curve [1].
        most: How many may be kept; where that is too few, those that are furthest off come first.

    Returns:
        Increasing indices into `values`, `kept` among them; without those that are no number.
    """
    known = np.isfinite(values)
    kept = kept[known[kept]]
    if len(kept) < 2:
        return kept
    allowed = off * np.ptp(values[kept])
    while len(kept) < most:
        distance = np.abs(np.interp(time, time[kept], values[kept]) - values)
        distance = np.where(known, distance, 0.0)[kept[0] : kept[-1]]
        edges = kept[:-1] - kept[0]
        largest = np.maximum.reduceat(distance, edges)
        far = np.flatnonzero(largest > allowed)
        far = far[np.argsort(-largest[far], kind="stable")[: most - len(kept)]]
        grown = _in_order(len(values), kept, kept[0] + _first_of(distance, largest, edges)[far])
        if len(grown) == len(kept):  # near enough; or two samples have one time
            break
        kept = grown
    return kept


def with_gaps(values: FloatArray, kept: Places, *, goes_on: bool = False) -> Places:
    """Samples of a curve with those at which it ends and begins again, so that no line leads over a gap.

    Args:
        values: Shape (time,); where one is no number, the curve has no value.
        kept: Those of its samples that are kept, increasing, each with a value.
        goes_on: Whether there were values before, of a curve that is packed in parts.

    Returns:
        Increasing indices into `values`: of each gap the first sample, and those with values on both sides.
    """
    known = np.isfinite(values)
    edges = np.flatnonzero(known[1:] != known[:-1])
    ends = edges[known[edges]]
    gaps = ends + 1
    if goes_on and len(known) and not known[0]:
        gaps = np.append(gaps, 0)
    return _in_order(len(values), kept, ends, gaps, edges[~known[edges]] + 1)


def _in_order(count: int, *places: Places) -> Places:
    """Each of these samples once, in order, of so many: marks take a tenth of the time of `unique`."""
    is_one = np.zeros(count, dtype=np.bool_)
    for some in places:
        is_one[some] = True
    return np.flatnonzero(is_one)


def _extremes(values: FloatArray, edges: Places) -> Places:
    known = np.where(np.isnan(values), -np.inf, values)
    begins = edges[:-1]
    return _first_of(known, np.maximum.reduceat(known, begins), begins)


def _first_of(values: FloatArray, largest: FloatArray, begins: Places) -> Places:
    """Of stretches that begin at these indices the first place of the largest value of each."""
    counts = np.diff(np.append(begins, len(values)))
    places = np.flatnonzero(values == np.repeat(largest, counts))
    return places[np.searchsorted(places, begins)]


def _needed(values: FloatArray, places: Places) -> Places:
    """Without samples that are equal to both neighbours: a straight line needs its ends alone."""
    kept = values[places]
    same = np.zeros(len(places), dtype=np.bool_)
    same[1:-1] = (kept[1:-1] == kept[:-2]) & (kept[1:-1] == kept[2:])
    return places[~same]
