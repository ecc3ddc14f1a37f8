"""What hangs from cranes with a rating chart, and where, at every sample of a recording."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.results.rating_chart import RatingChart
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.variable import BoolArray, FloatArray

__all__ = [
    "RatedGroup",
    "bears",
    "chart_load",
    "chart_places",
    "chart_used",
    "counted_load",
    "group_used",
    "rated_groups",
    "rated_load",
]

#: What may count.
_LOADS = ("hook_load", "hoist_load")
#: Rounding of what hangs in a hook over what always does.
_ROUNDED_UP = 1.0 + 1e-9


@dataclass(frozen=True)
class RatedGroup:
    """Hooks that a chart rates together: all of a crane, or one of several.

    Attributes:
        element: What checks call it.
        hooks: The hooks.
        share: What they may carry of a row of the chart [1].
    """

    element: str
    hooks: tuple[str, ...]
    share: float = 1.0


def rated_groups(chart: RatingChart) -> list[RatedGroup]:
    """The crane with all its hooks; each alone too, of several hooks or where its share is said."""
    groups = [RatedGroup(f"crane {chart.crane}", tuple(chart.hooks))]
    if len(chart.hooks) > 1 or chart.hooks_share is not None:
        groups += [RatedGroup(hook, (hook,), chart.share_of(hook)) for hook in chart.hooks]
    return groups


def rated_load(recording: Recording, chart: RatingChart, group: RatedGroup) -> FloatArray:
    """What may hang where hooks are, shape (time,) [N]; 0 outside of the chart."""
    rated: FloatArray = chart.rated_at(chart_places(recording, chart, group.hooks)).min(axis=1)
    return group.share * rated


def chart_load(recording: Recording, chart: RatingChart, hooks: Sequence[str]) -> FloatArray:
    """What hangs in hooks of a crane together, as its chart counts it, shape (time,) [N]."""
    loads = {name: {hook: recording.column(name, hook) for hook in chart.hooks} for name in _LOADS}
    return counted_load(recording.rig, chart, hooks, loads)


def counted_load(
    rig: Rig, chart: RatingChart, hooks: Sequence[str], loads: Mapping[str, Mapping[str, FloatArray]]
) -> FloatArray:
    """The same of hook and hoist loads by name of the variable and of the hook [N].

    What the hooks bear counts from when it does: a hoist load of hook block and falls alone, with slings that
    have been taken off the load, is no lift. Where nothing is known to hang in them but what `mechanics`
    hangs there, it always does.
    """
    variable = "hoist_load" if chart.includes_hook_block else "hook_load"
    seen = loads[_seen(rig, chart)]
    borne = np.sum([_beyond_own(rig, chart, hook, seen[hook]) for hook in chart.hooks], axis=0)
    total = np.sum([loads[variable][hook] for hook in hooks], axis=0)
    load: FloatArray = np.where(borne > 0, total, 0.0)
    return load


def bears(recording: Recording, chart: RatingChart, hook: str) -> BoolArray:
    """Where one hook of a crane bears something, as its chart counts it, shape (time,)."""
    seen = recording.column(_seen(recording.rig, chart), hook)
    found: BoolArray = _beyond_own(recording.rig, chart, hook, seen) > 0
    return found


def _beyond_own(rig: Rig, chart: RatingChart, name: str, load: FloatArray) -> FloatArray:
    """What a hook bears beside its own end of slings and ropes, which hangs in it whatever it lifts [N]."""
    own = next((hook.direct_weight for hook in rig.hooks if hook.name == name), 0.0)
    if not own or _seen(rig, chart) != "hook_load":
        return load
    beyond: FloatArray = np.where(load > own * _ROUNDED_UP, load - own, 0.0)
    return beyond


def _seen(rig: Rig, chart: RatingChart) -> str:
    """Which load tells whether a crane bears something: that of its hooks, where that is known."""
    known = any(
        hook.bearing_joints or hook.direct_slings or hook.direct_ropes or hook.ropes_over
        for hook in rig.hooks
        if hook.name in chart.hooks
    )
    return "hook_load" if known else "hoist_load"


def chart_places(recording: Recording, chart: RatingChart, hooks: Sequence[str]) -> FloatArray:
    """Radii or outreaches of hooks [m], or the angle of the boom [rad], shape (time, hooks or 1)."""
    if chart.over == "angle":
        return recording.column("boom_angle", chart.crane)[:, None]
    return np.stack([recording.column("crane_radius", hook) for hook in hooks], axis=1)


def chart_used(recording: Recording, chart: RatingChart) -> FloatArray:
    """What hangs over what a chart allows there, of crane or hook, whichever uses more, shape (time,) [1].

    Infinite outside of the chart.
    """
    every = [group_used(recording, chart, group) for group in rated_groups(chart)]
    used: FloatArray = np.max(every, axis=0)
    return used


def group_used(recording: Recording, chart: RatingChart, group: RatedGroup) -> FloatArray:
    """The same of hooks that a chart rates together, shape (time,) [1]."""
    load = chart_load(recording, chart, group.hooks)
    rated = rated_load(recording, chart, group)
    outside = np.where(load > 0, np.inf, 0.0)
    used: FloatArray = np.where(rated > 0, load / np.where(rated > 0, rated, 1.0), outside)
    return used
