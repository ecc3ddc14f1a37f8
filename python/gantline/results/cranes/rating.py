"""What hangs from cranes with a rating chart, and where, at every sample of a recording."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.results.cranes.rating_chart import RatingChart
from gantline.results.passing import passed
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.variable import BoolArray, FloatArray

__all__ = [
    "RatedGroup",
    "at_one_place",
    "bears",
    "chart_load",
    "chart_places",
    "chart_used",
    "counted_load",
    "counted_places",
    "group_used",
    "overloads",
    "place_of",
    "rated_at_places",
    "rated_groups",
    "rated_if_raised",
    "rated_load",
    "rows_at",
    "within_rows",
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


def at_one_place(chart: RatingChart, hooks: Sequence[str]) -> list[tuple[str, ...]]:
    """Hooks of a crane by where on its boom they hang, as far as its chart tells them apart, and by chart."""
    shared = [hook for hook in hooks if hook not in chart.own]
    places = (shared,) if chart.over == "angle" or not chart.apart else chart.apart
    apart = [tuple(one for one in shared if one in others) for others in places]
    return [*(one for one in apart if one), *((hook,) for hook in hooks if hook in chart.own)]


def rows_at(chart: RatingChart, hooks: Sequence[str], places: FloatArray) -> FloatArray:
    """What the chart of each of some hooks rates where it is, like places of shape (time, hooks) [N]."""
    return np.stack([chart.of(hook).rated_at(places[:, at]) for at, hook in enumerate(hooks)], axis=1)


def within_rows(chart: RatingChart, hooks: Sequence[str], places: FloatArray) -> BoolArray:
    """Where each of some hooks is within the rows of its chart, places and result of shape (time, hooks)."""
    return np.stack([chart.of(hook).holds(places[:, at]) for at, hook in enumerate(hooks)], axis=1)


def rated_load(recording: Recording, chart: RatingChart, group: RatedGroup) -> FloatArray:
    """What may hang where hooks are, shape (time,) [N]; 0 outside of the chart."""
    return rated_if_raised(recording, chart, group, 1.0)


def rated_if_raised(recording: Recording, chart: RatingChart, group: RatedGroup, by: float) -> FloatArray:
    """The same if what hangs in each hook, without hook block and falls, were so many times as much.

    Of hooks with rows of their own that is another number: their shares change.
    """
    places = chart_places(recording, chart, group.hooks)
    seen = _loads(recording, chart)
    more = {hook: (by - 1.0) * load for hook, load in seen["hook_load"].items()}
    raised = {name: {hook: load + more[hook] for hook, load in of.items()} for name, of in seen.items()}
    return rated_at_places(recording.rig, chart, group, places, raised)


def rated_at_places(
    rig: Rig,
    chart: RatingChart,
    group: RatedGroup,
    places: FloatArray,
    loads: Mapping[str, Mapping[str, FloatArray]],
) -> FloatArray:
    """The same of places as `chart_places` has them, and of loads as `counted_load` has them.

    Of hooks at several places of a boom, or with charts of their own, each uses up a share of the row where
    it is: what may hang in all is what hangs over the sum of these shares.
    """
    several = at_one_place(chart, group.hooks)
    rows = group.share * rows_at(chart, group.hooks, places)
    least: FloatArray = rows.min(axis=1)
    if len(several) < 2:
        return least
    total, used = np.zeros(len(places)), np.zeros(len(places))
    for hooks in several:
        rated = rows[:, [group.hooks.index(hook) for hook in hooks]].min(axis=1)
        load = counted_load(rig, chart, hooks, loads)
        total += load
        used += _over(load, rated)
    return np.where(used > 0, total / np.where(used > 0, used, 1.0), least)


def _over(load: FloatArray, rated: FloatArray) -> FloatArray:
    """A load over what is rated, infinite where that is nothing."""
    outside = np.where(load > 0, np.inf, 0.0)
    used: FloatArray = np.where(rated > 0, load / np.where(rated > 0, rated, 1.0), outside)
    return used


def _loads(recording: Recording, chart: RatingChart) -> dict[str, dict[str, FloatArray]]:
    return {name: {hook: recording.column(name, hook) for hook in chart.hooks} for name in _LOADS}


def chart_load(recording: Recording, chart: RatingChart, hooks: Sequence[str]) -> FloatArray:
    """What hangs in hooks of a crane together, as its chart counts it, shape (time,) [N]."""
    return counted_load(recording.rig, chart, hooks, _loads(recording, chart))


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
    return _bears(recording.rig, chart, hook, _loads(recording, chart))


def _bears(
    rig: Rig, chart: RatingChart, hook: str, loads: Mapping[str, Mapping[str, FloatArray]]
) -> BoolArray:
    found: BoolArray = _beyond_own(rig, chart, hook, loads[_seen(rig, chart)][hook]) > 0
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
    """Radii or outreaches of hooks [m], or the angle of their boom [rad], shape (time, hooks)."""
    places = {hook: recording.column(*place_of(chart, hook)) for hook in hooks}
    return counted_places(recording.rig, chart, places, _loads(recording, chart))


def place_of(chart: RatingChart, hook: str) -> tuple[str, str]:
    """The variable that says where a hook is, as its chart counts it, and its column there."""
    return ("boom_angle", chart.crane) if chart.of(hook).over == "angle" else ("crane_radius", hook)


def counted_places(
    rig: Rig,
    chart: RatingChart,
    places: Mapping[str, FloatArray],
    loads: Mapping[str, Mapping[str, FloatArray]],
) -> FloatArray:
    """Radii or outreaches [m], or angles [rad], by hook, as charts count them, shape (time, hooks).

    An empty hook that hangs elsewhere on the boom than others, or has another chart, may be outside of it: it
    counts at the nearest row.
    """
    counted = list(places.values())
    if chart.apart or chart.own:
        counted = [
            np.where(_bears(rig, chart, hook, loads), place, chart.of(hook).nearest(place))
            for hook, place in places.items()
        ]
    return np.stack(counted, axis=1)


def overloads(time: FloatArray, load: FloatArray, rated: FloatArray) -> list[float]:
    """Moments at which more hangs than may, of times [s], loads and rated loads [N] of shape (time,) [s]."""
    return passed(time, np.where(load > 0, load - rated, -1.0))


def chart_used(recording: Recording, chart: RatingChart) -> FloatArray:
    """What hangs over what a chart allows there, of crane or hook, whichever uses more, shape (time,) [1].

    Infinite outside of the chart.
    """
    every = [group_used(recording, chart, group) for group in rated_groups(chart)]
    used: FloatArray = np.max(every, axis=0)
    return used


def group_used(recording: Recording, chart: RatingChart, group: RatedGroup) -> FloatArray:
    """The same of hooks that a chart rates together, shape (time,) [1]."""
    return _over(chart_load(recording, chart, group.hooks), rated_load(recording, chart, group))
