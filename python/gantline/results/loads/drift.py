"""How far loads come off the way that the plan takes them.

The *drift* of a load is the horizontal distance of its centre of gravity from its start, less the way that
the upper sheaves of its hooks go while the load is clear and a step takes loads along: one that
traverses, travels, slews, luffs, leads, or moves mooring lines; not one that moves chain hoists of slings. Of
several hooks it is their mean, weighted by hook load, under which a load hangs whose falls are plumb. What
the upper sheaves do at any other time, as when a vessel trims or its moorings give, is in no plan and counts.
"""

from __future__ import annotations

import numpy as np

from gantline.results import series
from gantline.results.cranes.crane import CraneHook
from gantline.results.progress import spans
from gantline.results.recording import Recording
from gantline.results.rig import Load, Rig, Step
from gantline.results.rotation import axes
from gantline.results.variable import BoolArray, FloatArray

__all__ = ["is_taken_along", "load_drift"]

_TAKE_ALONG = ("traverse", "travel", "slew", "luff", "lead", "haul", "veer")


def load_drift(recording: Recording, load: Load) -> FloatArray:
    """Drift of a load [m], shape (time,)."""
    place = recording.column("body_position", load.body)[:, :2]
    drift: FloatArray = np.linalg.norm(place - place[0] - _taken_along(recording, load), axis=1)
    return drift


def is_taken_along(rig: Rig) -> bool:
    """Whether the plan takes a load anywhere."""
    return bool(rig.carried_hooks) and any(_takes_along(rig, step) for step in rig.plan)


def _takes_along(rig: Rig, step: Step) -> bool:
    """Whether a step does: what only makes slings longer or shorter moves loads below their hooks."""
    chains = {f"{one.joint}.drive" for one in rig.chain_hoists}
    return step.kind in _TAKE_ALONG and not (step.drives and chains.issuperset(step.drives))


def _taken_along(recording: Recording, load: Load) -> FloatArray:
    """How far the plan has taken a load along, shape (time, 2) [m]."""
    hooks = [hook for hook in recording.rig.carried_hooks if hook.top in recording.coordinates["body"]]
    way = np.zeros((len(recording.time), 2))
    if not hooks or not is_taken_along(recording.rig):
        return way
    clear = series.load_is_clear(recording, load)
    during = _under_way(recording) & clear[1:] & clear[:-1]
    force = np.stack([recording.column("hook_load", hook.name) for hook in hooks], axis=1).clip(min=0.0)
    carried = force[1:] + force[:-1]
    total = carried.sum(axis=1, keepdims=True)
    shares = np.divide(carried, total, out=np.zeros_like(carried), where=total > 0.0)
    steps = np.diff([_upper_sheaves(recording, hook) for hook in hooks], axis=1)
    way[1:] = np.cumsum(np.einsum("th,hti->ti", shares * during[:, None], steps), axis=0)
    return way


def _under_way(recording: Recording) -> BoolArray:
    """Intervals between samples in which a step that takes loads along is under way, shape (time - 1,)."""
    goes = {step.step for step in recording.rig.plan if _takes_along(recording.rig, step)}
    during = np.zeros(len(recording.time) - 1, dtype=np.bool_)
    for name, (begin, end) in spans(recording).items():
        if name in goes:
            during |= (recording.time[1:] > begin) & (recording.time[:-1] < end)
    return during


def _upper_sheaves(recording: Recording, hook: CraneHook) -> FloatArray:
    """Where the upper sheaves of a hook are, from above, shape (time, 2) [m]."""
    turned = axes(recording.column("body_orientation", hook.top)) @ np.asarray(hook.top_from)
    place: FloatArray = (recording.column("body_position", hook.top) + turned)[:, :2]
    return place
