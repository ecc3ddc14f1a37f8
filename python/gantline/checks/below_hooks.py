"""What hooks bear more with the design weight than was simulated: of loads, and of no gear below a hook."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from gantline.checks.design_weight import design_ratio, largest_ratios
from gantline.results import series
from gantline.results.gear import Compensator, Sling, Spreader
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.variable import BoolArray, FloatArray

__all__ = ["hoist_ratios", "to_design_weight"]


def to_design_weight(recording: Recording, hooks: Sequence[str], window: BoolArray) -> float:
    """What hooks together bear more with the design weight, while the load hangs still [N]."""
    # Each segment of each rope of a hook asks, as a rule of the same window.
    asked = ("to_design_weight", *hooks, window.tobytes())
    return recording.kept(asked, lambda: _to_design_weight(recording, hooks, window))


def _to_design_weight(recording: Recording, hooks: Sequence[str], window: BoolArray) -> float:
    rig = recording.rig
    more = by_slings = 0.0
    for sling in (one for one in rig.slings if rig.hook_of(one) in hooks):
        share = series.static_value(recording, series.sling_upright(recording, sling), window) or 0.0
        gear = _gear_below(recording, sling, window)
        more += (design_ratio(recording, sling.to_load, window) - 1.0) * max(share - gear, 0.0)
        by_slings += share
    for load in rig.loads:
        more -= (design_ratio(recording, load.name) - 1.0) * _liquid(recording, load, hooks, window)
    if any(hook.bears_mechanics for hook in rig.hooks if hook.name in hooks):
        hook_load = np.sum([recording.column("hook_load", name) for name in hooks], axis=0)
        static = series.static_value(recording, hook_load, window) or 0.0
        # What hangs there by other ropes is not known: all of it is raised, gear too.
        more += (design_ratio(recording, window=window) - 1.0) * (static - by_slings)
    return more


def hoist_ratios(recording: Recording, hooks: Iterable[str]) -> FloatArray:
    """By what the hoist load of hooks together is raised to the design weight, shape (time,) [1].

    Of spreaders and compensators, hook block and falls it has what they weigh. What is in tanks of a load is
    raised with it, as in slings.
    """
    total, more = np.zeros(len(recording.time)), np.zeros(len(recording.time))
    for name in hooks:
        total += recording.column("hoist_load", name)
        hook_load = recording.column("hook_load", name)
        _, window = series.greatest_static(recording, hook_load)
        by_slings = np.zeros(len(recording.time))
        for sling in (one for one in recording.rig.slings if recording.rig.hook_of(one) == name):
            share = series.sling_upright(recording, sling)
            gear = _gear_below(recording, sling, window)
            more += (largest_ratios(recording, [sling.to_load]) - 1.0) * np.maximum(share - gear, 0.0)
            by_slings += share
        if any(hook.bears_mechanics for hook in recording.rig.hooks if hook.name == name):
            left = np.maximum(hook_load - by_slings, 0.0)
            more += (largest_ratios(recording, [None]) - 1.0) * left
    return 1.0 + np.divide(more, total, out=np.zeros_like(more), where=total > 0.0)


def _liquid(recording: Recording, load: Load, hooks: Sequence[str], window: BoolArray | None) -> float:
    """What weighs in tanks of a load that hangs still in some hooks alone, in air [N]; nothing of others."""
    rig = recording.rig
    others = {rig.hook_of(one) for one in rig.slings} & {hook.name for hook in rig.hooks} - set(hooks)
    if window is None or not load.tanks or others or load.other_ropes or rig.hinges:
        return 0.0
    if series.is_wet(recording)[window].any():
        return 0.0
    liquid = series.load_weight(recording, load) - load.weight
    return series.static_value(recording, liquid, window) or 0.0


def _gear_below(recording: Recording, sling: Sling, window: BoolArray | None) -> float:
    """What a sling bears of spreaders and compensators, by vertical forces while the load hangs still [N]."""
    below = 0.0
    every: list[Spreader | Compensator] = [*recording.rig.spreaders, *recording.rig.compensators]
    for gear in every:
        if gear.name in sling.lugs_of:
            upright = {
                one.name: series.static_value(recording, series.sling_upright(recording, one), window) or 0.0
                for one in recording.rig.slings
                if gear.name in one.lugs_of
            }
            hanging = [one for one in recording.rig.slings if recording.rig.gear_above(one) == gear]
            weight = gear.weight + sum(_gear_below(recording, one, window) for one in hanging)
            below += weight * upright[sling.name] / (sum(upright.values()) or 1.0)
    return below
