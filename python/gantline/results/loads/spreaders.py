"""Spreaders: what their slings push them together with."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from gantline.results import series
from gantline.results.gear import Spreader
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.results.variable import FloatArray

__all__ = ["thrust"]

#: Lugs this near to each other along a spreader are at one place [m].
_ONE_PLACE = 1e-6


def thrust(recording: Recording, spreader: Spreader) -> FloatArray:
    """Largest force that pushes a spreader together along length or breadth [N], shape (time,); at least 0.

    That of a section between lugs is what all slings on one side of it pull across it. Both sides differ by
    its own weight and inertia, as far as these lie along it; the side that pushes more counts.
    """
    largest: FloatArray = np.max([_thrust_along(recording, spreader, axis) for axis in (0, 1)], axis=0)
    return largest


def _thrust_along(recording: Recording, spreader: Spreader, along: int) -> FloatArray:
    """The same along x or y of its box."""
    attitude = axes(recording.column("body_orientation", spreader.body))[:, :, along]
    pulls = []
    for sling in recording.rig.slings:
        tension = series.sling_tension(recording, sling)
        for end, of, lug in sling.at_lugs():
            if of == spreader.name:
                up = series.sling_direction(recording, sling, end)
                # Below a lug a sling pulls down.
                sign = -1.0 if (of, lug) == (sling.from_body, sling.from_lug) else 1.0
                pull = sign * tension * np.sum(up * attitude, axis=1)
                pulls.append((float(spreader.lugs[lug].at[along]), pull))
    pulls.sort(key=lambda one: one[0])
    largest = before = np.zeros(len(recording.time))
    after = sum((pull for _, pull in pulls), start=before)
    for (place, pull), (following, _) in pairwise(pulls):
        before, after = before + pull, after - pull
        if following > place + _ONE_PLACE:
            largest = np.max([largest, before, -after], axis=0)
    return largest
