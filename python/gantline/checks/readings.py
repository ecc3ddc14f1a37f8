"""What hooks and cranes carry at the hold points of a plan, beside what the checks make of it there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from gantline.checks.ends import end_of_step
from gantline.checks.gauges import winch_gauges
from gantline.checks.run import values_of
from gantline.results.cranes.rating import RatedGroup, chart_load, rated_groups, rated_load
from gantline.results.cranes.rating_chart import RatingChart
from gantline.results.recording import Recording
from gantline.results.rig import Step
from gantline.results.variable import BoolArray

__all__ = ["OUTSIDE", "HoldPoint", "HookReading", "hold_points", "hook_readings"]

#: Share of a chart that shows in a table [1].
_SHOWS = 0.0005
#: In place of what is rated where no row of a chart is for.
OUTSIDE = "outside of the chart"


@dataclass(frozen=True)
class HoldPoint:
    """The end of a step that holds or reports.

    Attributes:
        step: The step.
        time: When its last sample was [s].
        at: Mask with that sample.
    """

    step: Step
    time: float
    at: BoolArray


@dataclass(frozen=True)
class HookReading:
    """What a hook, or a crane with all its hooks, carries at a moment.

    Attributes:
        name: Of the hook, or `crane` and the name of the crane.
        hook_load: As simulated [N].
        share: Of the hook loads of all hooks together [1]; None if nothing hangs in any, and of one hook
            beside winches or jacks that lift. A hook that hangs
            from its slings itself, since its falls have parted, carries none: the others have it.
        hoist_load: With hook block and hanging falls, as simulated [N].
        height: Of its bearing [m]; None of a crane of several hooks, and where nothing records it.
        radius: Outreach or radius of the hook, of several the one that counts [m]; None without a boom.
        rated: What the chart of the crane rates there [N], 0 outside of it; None without a chart.
        used_then: What hangs there, as simulated, over what is rated there [1]; None without a chart, outside
            of it, or if nothing hangs.
        used: What `hoist_load_of_rating` comes to there [1]: with the design weight and the factors of the
            rules, of a crane that lifts alone with the most that it bore while the loads hung still in the
            whole lift, against what is rated there. None as the one before.
        is_outside: Whether it bears something outside of the chart.
    """

    name: str
    hook_load: float
    share: float | None
    hoist_load: float
    height: float | None = None
    radius: float | None = None
    rated: float | None = None
    used_then: float | None = None
    used: float | None = None
    is_outside: bool = False

    @property
    def is_checked_for_more(self) -> bool:
        """Whether the checks have it use more of the chart than hangs there, by more than shows."""
        return self.used is not None and self.used_then is not None and self.used > self.used_then + _SHOWS


def hold_points(recording: Recording) -> Iterator[HoldPoint]:
    """Every step of the plan that holds or reports and has ended, in the order of the plan."""
    for step in recording.rig.plan:
        at = end_of_step(recording, step) if step.report or step.kind == "hold" else None
        if at is not None:
            yield HoldPoint(step, float(recording.time[int(np.argmax(at))]), at)


def hook_readings(recording: Recording, at: BoolArray) -> list[HookReading]:
    """What every hook carries, and every crane that a chart rates for several of them.

    Args:
        recording: Any recording.
        at: Mask with one sample.

    Returns:
        Hooks in the order of the rig, each crane of several hooks after its last one; none if there is but
        one hook, without a chart and without jacks beside it, of which hook loads tell all.
    """
    rig = recording.rig
    is_beside_jacks = len(rig.hooks) == 1 and bool(winch_gauges(recording))
    if len(rig.hooks) < 2 and not rig.rating_charts and not is_beside_jacks:
        return []
    used = values_of(recording, "hoist_load_of_rating", at)
    groups = {group.hooks: (chart, group) for chart in rig.rating_charts for group in rated_groups(chart)}
    readings = []
    for hook in rig.hooks:
        readings.append(_reading(recording, at, hook.name, (hook.name,), groups.get((hook.name,)), used))
        for hooks, found in groups.items():
            if len(hooks) > 1 and hooks[-1] == hook.name:
                readings.append(_reading(recording, at, found[1].element, hooks, found, used))
    # All of what hangs in hooks is a part of the load.
    return [replace(one, share=None) for one in readings] if is_beside_jacks else readings


def _reading(
    recording: Recording,
    at: BoolArray,
    name: str,
    hooks: tuple[str, ...],
    rating: tuple[RatingChart, RatedGroup] | None,
    used: dict[str, float],
) -> HookReading:
    sample = int(np.argmax(at))

    def summed(variable: str, names: tuple[str, ...]) -> float:
        return sum(float(recording.column(variable, one)[sample]) for one in names)

    load = summed("hook_load", hooks)
    carried = {hook.name: max(summed("hook_load", (hook.name,)), 0.0) for hook in recording.rig.hooks}
    every = sum(carried.values())
    reading = HookReading(
        name,
        load,
        sum(carried[one] for one in hooks) / every if every > 0.0 else None,
        summed("hoist_load", hooks),
        height=_height(recording, name, sample),
        radius=_radius(recording, hooks, sample, rating[0] if rating else None),
    )
    if rating is None:
        return reading
    chart, group = rating
    rated = float(rated_load(recording, chart, group)[sample])
    hangs = float(chart_load(recording, chart, group.hooks)[sample])
    checked = used.get(group.element)
    then = None if checked is None or rated == 0.0 else hangs / rated
    is_outside = rated == 0.0 and hangs > 0.0
    return replace(reading, rated=rated, used_then=then, used=checked, is_outside=is_outside)


def _height(recording: Recording, hook: str, sample: int) -> float | None:
    """Height of the bearing of a hook that a trolley or boom takes along [m]."""
    if hook not in recording.coordinates.get("crane_hook", ()):
        return None
    return float(recording.column("hook_height", hook)[sample])


def _radius(
    recording: Recording, hooks: tuple[str, ...], sample: int, chart: RatingChart | None
) -> float | None:
    """Outreach or radius [m] of a hook, of several that at which their charts rate least."""
    if "crane_radius" not in recording:
        return None
    reach = recording["crane_radius"]
    at_booms = recording.coordinates[reach.dims[1]]
    radii = {one: float(reach.values[sample, at_booms.index(one)]) for one in hooks if one in at_booms}
    if len(radii) < 2 or chart is None or any(chart.of(one).over == "angle" for one in radii):
        return max(radii.values(), default=None)
    return radii[min(radii, key=lambda one: float(chart.of(one).rated_at(np.array(radii[one]))))]
