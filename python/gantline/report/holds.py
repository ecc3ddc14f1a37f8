"""What jacks pull at each hold point, and what hangs in several hooks or from cranes with a rating chart."""

from __future__ import annotations

from typing import Any

import numpy as np

from gantline.checks import HookReading, hold_points, hook_readings, winch_gauges
from gantline.checks.readings import OUTSIDE
from gantline.report.section import Section
from gantline.report.subject import Subject, number, show

#: Shares of hooks that the first page has room for at a hold point.
_MOST_SHARES = 3


class HoldPoints(Section):
    """Share of each hook at each hold point, its radius, and what that uses of the chart there."""

    anchor = "hold-points"
    title = "Hooks at hold points"
    template = "holds.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        gravity = subject.rig.gravity
        points = []
        for point in hold_points(subject.recording):
            readings = hook_readings(subject.recording, point.at)
            rows = [_row(one, gravity) for one in readings]
            if rows:
                points.append({"step": point.step.step, "time": show(point.time, "s", 1), "rows": rows})
        if not points:
            return None
        rig = subject.rig
        has_heights = "hook_height" in subject.recording
        return {
            "points": points,
            "by": " and ".join(rig.growing),
            "has_heights": has_heights,
            "has_booms": bool(rig.booms),
            "has_charts": bool(rig.rating_charts),
        }


class GaugesAtHoldPoints(Section):
    """What winches and strand jacks pull at each hold point."""

    anchor = "gauges-at-hold-points"
    title = "Winches and jacks at hold points"
    template = "gauge_holds.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        gauges = winch_gauges(subject.recording)
        points = []
        for point in hold_points(subject.recording) if gauges else ():
            sample = int(np.argmax(point.at))
            rows = [(one.name, number(one.reads[sample] / subject.rig.gravity, "t", 1)) for one in gauges]
            points.append({"step": point.step.step, "time": show(point.time, "s", 1), "rows": rows})
        return {"points": points, "by": " and ".join(subject.rig.growing)} if points else None


def _row(reading: HookReading, gravity: float) -> dict[str, str]:
    rated = None if reading.rated is None else reading.rated / gravity
    return {
        "name": reading.name,
        "share": number(reading.share, "%", 1),
        "hook_load": number(reading.hook_load / gravity, "t", 1),
        "hoist_load": number(reading.hoist_load / gravity, "t", 1),
        "height": number(reading.height, "m", 2),
        "radius": number(reading.radius, "m", 2),
        "rated": OUTSIDE if reading.is_outside else number(rated, "t", 1),
        "used_then": number(reading.used_then, "%", 1),
        "used": number(reading.used, "%", 1),
    }


def shares(subject: Subject) -> dict[str, str]:
    """By step that holds: how a few hooks share, and where most of a chart is used, in as few words."""
    names = [hook.name for hook in subject.rig.hooks]
    found = {}
    for point in hold_points(subject.recording):
        readings = hook_readings(subject.recording, point.at)
        parts = [one.share for one in readings if one.name in names and one.share is not None]
        used, then = (
            [share for share in shares if share is not None]
            for shares in ([one.used for one in readings], [one.used_then for one in readings])
        )
        texts = []
        if 1 < len(parts) <= _MOST_SHARES:
            texts.append(f"hooks {' / '.join(number(one, '%', 0) for one in parts)} %")
        if any(one.is_outside for one in readings):
            texts.append(OUTSIDE)
        elif used:
            checked, hangs = (show(max(shares), "%", 0) for shares in (used, then))
            texts.append(f"chart {hangs}" + (f", {checked} as checked" if checked != hangs else ""))
        found[point.step.step] = ", ".join(texts)
    return found
