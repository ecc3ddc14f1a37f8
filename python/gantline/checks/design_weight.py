"""From the weight that was simulated to the design weight, in air and in water.

What contingency adds to a load weighs all that it weighs wherever the load is: water that bears nine tenths
of the load bears nothing more of it. A force that goes with the load is raised in air by the ratio c of both
weights, and in water, which leaves slings, supports and hinges N of the weight W that was simulated, by

    1 + (c - 1) W/N .

In air N is W, and that is c. A load with liquid in its tanks may leave them more than W; what they bear is
then raised by c as a whole, as in air.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from gantline.results import series
from gantline.results.loads.hung_so import left_by_water
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.variable import BoolArray, FloatArray

__all__ = ["design_ratio", "largest_ratios"]


def design_ratio(recording: Recording, load: str | None = None, window: BoolArray | None = None) -> float:
    """By what a force that goes with a load is raised to its design weight [1], at least 1.

    Recordings that do not tell the weight of the load alone have that with its slings and shackles.

    Args:
        recording: The recording.
        load: Its name; the largest of all if none is named.
        window: Time that the loads hung still, of which the force is; in air if not given.
    """
    ratios = [1.0]
    for one in _loads(recording, load):
        more = _in_air(recording, one) - 1.0
        if window is not None and more > 0.0 and one.in_water is not None:
            # Sums of means: the larger of two series that swing about one mean would be more than that.
            left = [series.static_value(recording, part, window) or 0.0 for part in _left(recording, one)]
            more *= max(1.0, one.weight / max(left)) if max(left) > 0.0 else 1.0
        ratios.append(1.0 + more)
    return max(ratios)


def largest_ratios(recording: Recording, loads: Iterable[str | None]) -> FloatArray:
    """By what a force is raised at every sample that goes with any of some loads, shape (time,) [1].

    Args:
        recording: The recording.
        loads: Their names; None stands for all of them.
    """
    ratios = np.ones(len(recording.time))
    for one in (load for name in loads for load in _loads(recording, name)):
        more = np.full(len(recording.time), _in_air(recording, one) - 1.0)
        if one.in_water is not None:
            left = np.max(_left(recording, one), axis=0)
            share = np.divide(one.weight, left, out=np.ones_like(left), where=left > 0.0)
            more *= np.maximum(1.0, share)
        ratios = np.maximum(ratios, 1.0 + more)
    return ratios


def _loads(recording: Recording, name: str | None) -> list[Load]:
    return [one for one in recording.rig.loads if name in (None, one.name)]


def _in_air(recording: Recording, load: Load) -> float:
    """Design weight over the simulated one, at least 1."""
    simulated = load.simulated_mass or load.weight / recording.rig.gravity
    known = load.design_mass is not None and simulated > 0.0
    return max(1.0, load.design_mass / simulated) if known and load.design_mass is not None else 1.0


def _left(recording: Recording, load: Load) -> tuple[FloatArray, FloatArray]:
    """What water leaves of a load to bear, by its weight and by what bears it, each of shape (time,) [N].

    Both are the same of a load at rest. Where next to nothing is left, of one that floats, the first is the
    difference of two large numbers, and the second still no less than what any sling or support bears.
    """
    borne = series.borne(recording, load).copy()
    for sling in recording.rig.slings:
        if sling.to_load == load.name:
            borne += np.maximum(series.sling_upright(recording, sling), 0.0)
    return left_by_water(recording, load), borne
