"""What hooks and slings carry at given tilts of a load that is turned as it hangs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.loads.upending import is_turned
from gantline.results.passing import passed
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.ropes import upper_end
from gantline.results.variable import BoolArray, FloatArray

__all__ = ["AtTilt", "at_tilts"]

#: Tilts at which hooks and slings are read [rad]; 0 and 180 deg are ends, which no tilt passes.
_TILTS = tuple(math.radians(angle) for angle in (30.0, 60.0, 90.0, 120.0, 150.0))
#: A load has not begun to turn, or has turned, where its tilt is within this of its end [rad].
_AT_END = math.radians(0.5)
#: Past the last of these tilts by less than this, the end of a turning has no reading of its own [rad].
_NO_FURTHER = math.radians(5.0)


@dataclass(frozen=True)
class AtTilt:
    """What is carried when a load has come to a tilt.

    Attributes:
        tilt: Of the load [rad].
        time: When that is [s].
        hook_loads: By hook [N].
        supported: What supports bear of the load [N].
        sling: The sling that uses most of its minimum breaking force then; where no strength is known that
            with the largest tension; empty where none carries.
        tension: Of that sling at its upper end [N].
        of_breaking_force: Share of its minimum breaking force [1]; None where that is not known.
    """

    tilt: float
    time: float
    hook_loads: Mapping[str, float]
    supported: float
    sling: str
    tension: float
    of_breaking_force: float | None


def at_tilts(recording: Recording, load: Load) -> list[AtTilt]:
    """Readings of a load that is turned: before it turns, every 30 deg, and as far as it turns.

    Each is of the first moment at which the tilt passes that angle, between samples on a line. Before it
    turns is when the last step begins while it hangs as it did before, within 0.5 deg; where none does, or
    it is turned about its foot, the last such moment. As far as it turns is when the first step ends within
    0.5 deg of that, or else the first such moment; less than 5 deg past the angle before, it is left out.

    Args:
        recording: The recording.
        load: One of its loads.

    Returns:
        In order of time; nothing of a load that is not turned, nor of a lift at rest: nobody looked at how it
        came there.
    """
    if recording.is_equilibrium or not is_turned(recording, load):
        return []
    tilt = recording.column("load_tilt", load.name)
    passings = _passings(recording.time, tilt)
    if not passings:
        return []
    times = [at for at, _ in sorted(passings)]
    (first, begins), (last, goes_on) = min(passings), max(passings)
    times.insert(0, _start(recording, load, tilt * begins, recording.time <= first))
    end = _end(recording, tilt * goes_on, recording.time >= last)
    if abs(float(np.diff(np.interp((last, end), recording.time, tilt))[0])) > _NO_FURTHER:
        times.append(end)
    return [_read(recording, load, time) for time in times]


def _passings(time: FloatArray, tilt: FloatArray) -> list[tuple[float, float]]:
    """When each of the tilts is passed first [s], and which way: 1 up, -1 down."""
    found = []
    for angle in _TILTS:
        ways = ((at, sign) for sign in (1.0, -1.0) for at in passed(time, sign * (tilt - angle)))
        # What begins past an angle has not passed it there.
        found += sorted(one for one in ways if one[0] > time[0])[:1]
    return found


def _start(recording: Recording, load: Load, tilt: FloatArray, before: BoolArray) -> float:
    """When a load begins to turn [s], up by `tilt`, in the samples `before` it has passed something."""
    hung = before & series.load_is_clear(recording, load)
    still = recording.time[_is_largest(-tilt, hung if hung.any() else before)]
    begun = [at for at, _, _ in recording.events("step_begin") if still[0] <= at <= still[-1]]
    return max(begun) if begun and hung.any() else float(still[-1])


def _end(recording: Recording, tilt: FloatArray, after: BoolArray) -> float:
    """When a load has turned as far as it does [s], up by `tilt`, in the samples `after` all it passed."""
    there = recording.time[_is_largest(tilt, after)]
    ended = [at for at, _, _ in recording.events("step_end") if there[0] <= at <= there[-1]]
    return min(ended, default=float(there[0]))


def _is_largest(tilt: FloatArray, during: BoolArray) -> BoolArray:
    """Samples of some at which a tilt is as large as it gets in them, but for swinging."""
    largest: BoolArray = during & (tilt >= np.nanmax(tilt[during]) - _AT_END)
    return largest


def _read(recording: Recording, load: Load, time: float) -> AtTilt:
    def at(values: FloatArray) -> float:
        return float(np.interp(time, recording.time, values))

    rig = recording.rig
    name, tension, share = "", 0.0, 0.0
    for sling in rig.slings:
        if at(series.sling_tension(recording, sling)) <= 0.0:
            continue
        tightest = series.tightest_tension(recording, sling.rope)
        force = at(tightest + upper_end.own_weight(recording, sling.rope))
        used = force / (rig.minimum_breaking_force(sling.rope) or np.inf)
        # Of two alike the first, whatever little their swinging adds.
        if series.is_more(used, share) or (used == share == 0.0 and series.is_more(force, tension)):
            name, tension, share = sling.name, force, used
    return AtTilt(
        tilt=at(recording.column("load_tilt", load.name)),
        time=time,
        hook_loads={hook.name: at(recording.column("hook_load", hook.name)) for hook in rig.hooks},
        supported=at(series.borne(recording, load)),
        sling=name,
        tension=tension,
        of_breaking_force=share or None,
    )
