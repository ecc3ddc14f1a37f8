"""How far what carries the loads turns about plumb: loads that hang from it turn with it as they should."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray

__all__ = ["carried_round"]

#: Hooks nearer to each other than this have no direction from one to the other [m].
_APART = 0.5


def carried_round(recording: Recording) -> float:
    """The largest turn of what carries the loads, to either side from the start [rad].

    It is that of an upper structure that slews, of a vessel, or of the line from hook to hook, where slings
    hang in them.

    Args:
        recording: Of any lift.
    """
    turns = [0.0]
    if "slew_angle" in recording:
        turns += [_turn(angle) for angle in recording["slew_angle"].values.T]
    for vessel in recording.rig.vessels:
        turns.append(_turn(series.body_heading(recording, vessel.body)))
    for one, other in combinations(_hooks(recording).values(), 2):
        across = (other - one)[:, :2]
        if np.linalg.norm(across, axis=1).min(initial=np.inf) > _APART:
            turns.append(_turn(np.unwrap(np.arctan2(across[:, 1], across[:, 0]))))
    return max(turns)


def _hooks(recording: Recording) -> dict[str, FloatArray]:
    """Where slings hang in each hook [m], shape (time, 3)."""
    rig = recording.rig
    names = {hook.name for hook in rig.hooks}
    drawn = [one for one in rig.slings if one.rope in recording.points_of_ropes and rig.hook_of(one) in names]
    ends: dict[str, list[FloatArray]] = {}
    for sling in drawn:
        ends.setdefault(rig.hook_of(sling), []).append(series.rope_ends(recording, sling.rope)[0])
    return {hook: np.mean(own, axis=0) for hook, own in ends.items()}


def _turn(angle: FloatArray) -> float:
    """The largest change from the start; none where that is no number."""
    return float(np.nanmax(np.abs(angle - angle[0]), initial=0.0)) if len(angle) else 0.0
