"""Moments at which a recorded series passes a limit."""

from __future__ import annotations

import numpy as np

from gantline.results.variable import FloatArray

__all__ = ["passed"]


def passed(time: FloatArray, beyond: FloatArray) -> list[float]:
    """Times [s] at which a series rises above 0, between samples on a line; the first if it starts there.

    Args:
        time: Shape (time,) [s].
        beyond: How far the series is beyond its limit, shape (time,).
    """
    after = np.flatnonzero((beyond[:-1] <= 0) & (beyond[1:] > 0))
    share = -beyond[after] / (beyond[after + 1] - beyond[after])
    times = time[after] + share * (time[after + 1] - time[after])
    first = [float(time[0])] if len(beyond) and beyond[0] > 0 else []
    return first + [float(one) for one in times]
