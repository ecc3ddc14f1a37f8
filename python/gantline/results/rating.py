"""What hangs from cranes with a rating chart, and where, at every sample of a recording."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gantline.results.rating_chart import RatingChart
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray

__all__ = ["chart_load", "chart_places", "chart_used"]


def chart_load(recording: Recording, chart: RatingChart, hooks: Sequence[str]) -> FloatArray:
    """What hangs in hooks of a crane together, as its chart counts it, shape (time,) [N].

    What the hooks bear counts from when it does: a hoist load of hook block and falls alone is no lift. Where
    nothing is known to hang in them but what `mechanics` hangs there, it always does.
    """
    variable = "hoist_load" if chart.includes_hook_block else "hook_load"
    bears = any(
        hook.bearing_joints or hook.direct_slings for hook in recording.rig.hooks if hook.name in chart.hooks
    )
    seen = "hook_load" if bears else "hoist_load"
    borne = np.sum([recording.column(seen, hook) for hook in chart.hooks], axis=0)
    total = np.sum([recording.column(variable, hook) for hook in hooks], axis=0)
    load: FloatArray = np.where(borne > 0, total, 0.0)
    return load


def chart_places(recording: Recording, chart: RatingChart, hooks: Sequence[str]) -> FloatArray:
    """Radii or outreaches of hooks [m], or the angle of the boom [rad], shape (time, hooks or 1)."""
    if chart.over == "angle":
        return recording.column("boom_angle", chart.crane)[:, None]
    return np.stack([recording.column("crane_radius", hook) for hook in hooks], axis=1)


def chart_used(recording: Recording, chart: RatingChart) -> FloatArray:
    """What hangs from a crane over what its chart allows there, shape (time,) [1]; infinite outside of it."""
    load = chart_load(recording, chart, chart.hooks)
    rated = chart.rated_at(chart_places(recording, chart, chart.hooks)).min(axis=1)
    outside = np.where(load > 0, np.inf, 0.0)
    used: FloatArray = np.where(rated > 0, load / np.where(rated > 0, rated, 1.0), outside)
    return used
