"""What of how loads hang is worth a plot: tilt, and how far they come aside, where there is any of it.

The drift of a load that is turned as it hangs says little, since its hooks take it along; its *swing* is how
far they hang aside of their upper sheaves.
"""

from __future__ import annotations

import math

from gantline.results.loads.drift import load_drift
from gantline.results.loads.upending import is_turned
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.variable import FloatArray

__all__ = ["SMALLEST_TILT", "SMALLEST_WAY", "drift_of", "not_worth_a_plot", "swing_of", "tilt_of"]

#: Below these a curve shows rounding, or what nobody could see [rad], [m].
SMALLEST_TILT, SMALLEST_WAY = math.radians(0.01), 1e-3

#: By load [rad or m], shape (time,) each.
Curves = dict[str, FloatArray]


def tilt_of(recording: Recording) -> Curves:
    """Tilt of each load [rad]; empty where none tilts by as much as could be seen."""
    curves = {load.name: recording.column("load_tilt", load.name) for load in recording.rig.loads}
    return _seen(curves, SMALLEST_TILT)


def drift_of(recording: Recording) -> Curves:
    """Drift of each load, but of those that are turned [m]; empty where it is less than could be seen."""
    loads = [load for load in recording.rig.loads if not _swings(recording, load)]
    return _seen({load.name: load_drift(recording, load) for load in loads}, SMALLEST_WAY)


def swing_of(recording: Recording) -> Curves:
    """Swing of each load that is turned as it hangs [m]; empty where it is less than could be seen."""
    loads = [load for load in recording.rig.loads if _swings(recording, load)]
    return _seen({load.name: recording.column("load_swing", load.name) for load in loads}, SMALLEST_WAY)


def not_worth_a_plot(recording: Recording) -> str:
    """What there is too little of for a plot, in words: `no tilt, no drift`; empty where all is seen."""
    swings = {_swings(recording, load) for load in recording.rig.loads}
    missing = [
        *(["no tilt"] if not tilt_of(recording) else []),
        *(["no drift"] if False in swings and not drift_of(recording) else []),
        *(["no swing"] if True in swings and not swing_of(recording) else []),
    ]
    return ", ".join(missing)


def _swings(recording: Recording, load: Load) -> bool:
    known = "load_swing" in recording and load.name in recording.coordinates.get("load", ())
    return known and is_turned(recording, load)


def _seen(curves: Curves, smallest: float) -> Curves:
    return curves if any(curve.size and curve.max() >= smallest for curve in curves.values()) else {}
