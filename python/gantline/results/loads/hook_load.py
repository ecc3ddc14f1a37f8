"""What hangs on hooks: the force on their bearings, and what their hoists carry."""

from __future__ import annotations

import numpy as np

from gantline.results.gear import Hook
from gantline.results.rig import Rig
from gantline.results.variable import Columns, Derived, FloatArray, Names, Variable

__all__ = ["hook_loads", "hook_peaks"]


def hook_loads(columns: Columns, names: Names, rig: Rig) -> Derived:
    """Hook load and hoist load [N], shape (time, hook), and the names of the hooks; nothing of none."""
    if not rig.hooks:
        return {}, {}
    hook_load = np.stack([_hook_load(columns, names, hook) for hook in rig.hooks], axis=1)
    hoist_load = np.stack(
        [_hoist_load(columns, names, hook, load) for hook, load in zip(rig.hooks, hook_load.T, strict=True)],
        axis=1,
    )
    dims = ("time", "hook")
    return {
        "hook_load": Variable(dims, hook_load, "N", "vertical force on the bearing of a hook"),
        "hoist_load": Variable(dims, hoist_load, "N", "hook load with hook block and hanging falls"),
    }, {"hook": [hook.name for hook in rig.hooks]}


def hook_peaks(pulled: Columns, names: Names, rig: Rig) -> dict[str, Variable]:
    """Largest hook and hoist load [N] when the ropes of a hook pulled most, and when that was [s].

    Args:
        pulled: Columns of one moment for each hook, in their order, at which what hangs in it pulled most,
            then of one for each hook with falls at which these did, before those of others; of fewer before
            the first step.
        names: Names along their dimensions.
        rig: The lift.

    Returns:
        Variables by their names, shape (hook,); nothing without hooks or before the first step.
    """
    count = len(rig.hooks)
    own = [[place] for place in range(count)]
    for place, hook in enumerate(rig.hooks):
        if hook.falls:
            own[place].append(count)
            count += 1
    if not rig.hooks or len(pulled["time"]) < count:
        return {}
    loads, _ = hook_loads(pulled, names, rig)
    found = {}
    for name in ("hook", "hoist"):
        values = loads[f"{name}_load"].values
        most = [max(at, key=values[:, place].__getitem__) for place, at in enumerate(own)]
        load, time = values[most, np.arange(len(own))], pulled["time"][most]
        text = f"largest {name} load when ropes of the hook pulled most, over all steps"
        found[f"{name}_peak_load"] = Variable(("hook",), load, "N", text)
        found[f"{name}_peak_time"] = Variable(("hook",), time, "s", f"time of {name}_peak_load")
    return found


def _hoist_load(columns: Columns, names: Names, hook: Hook, hook_load: FloatArray) -> FloatArray:
    """What the upper sheaves see of a hook that hangs in ropes; else hook load, hook block and falls."""
    if not hook.falls:
        return hook_load + hook.hoist_weight_extra
    segments = list(names["segment"])
    at = [segments.index(fall) for fall in hook.falls]
    carried: FloatArray = columns["segment_tension"][:, at].sum(axis=1) + hook.falls_weight_above
    return carried


def _hook_load(columns: Columns, names: Names, hook: Hook) -> FloatArray:
    bodies, ropes = list(names["body"]), list(names["rope"])
    total = np.full(len(columns["time"]), hook.direct_weight)
    for body in hook.bearing_joints:
        total += columns["joint_force"][:, bodies.index(body), 2]
    slings = [sling if sling in ropes else f"sling.{sling}" for sling in hook.direct_slings]
    # The upper end of a sling comes first.
    for rope, end in [*((sling, "first") for sling in slings), *hook.direct_ropes]:
        total += _pulled_down(columns, names, rope, *((0, 0, 1) if end == "first" else (-1, -1, -2)))
    for over in hook.ropes_over:
        points = sum(of == over.rope for of in names["rope_point"])
        arcs = sum(over.arcs)
        # All arcs are drawn with as many points, everything else with one.
        each = (points - len(over.arcs) + arcs) // arcs if arcs else 1
        first, last = (
            sum(each if arc else 1 for arc in over.arcs[:end]) for end in (over.place, over.place + 1)
        )
        total += _pulled_down(columns, names, over.rope, over.place - 1, first, first - 1)
        total += _pulled_down(columns, names, over.rope, over.place, last - 1, last)
    return total


def _pulled_down(
    columns: Columns, names: Names, rope: str, segment: int, own: int, following: int
) -> FloatArray:
    """What a segment of a rope pulls down with at a drawn point, towards another [N], shape (time,)."""
    at = [place for place, of in enumerate(names["rope_point"]) if of == rope]
    own_segments = [place for place, of in enumerate(names["segment"]) if of.rpartition("/")[0] == rope]
    pull = columns["rope_point"][:, at[following]] - columns["rope_point"][:, at[own]]
    # A rope that has parted is drawn as one point at its upper end, and pulls no way.
    down = -pull[:, 2] / np.maximum(np.linalg.norm(pull, axis=1), np.finfo(np.float64).tiny)
    force: FloatArray = columns["segment_tension"][:, own_segments[segment]] * down
    return force
