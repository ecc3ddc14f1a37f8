"""Rows of the first page for cranes with a boom: their charts, leads, ground pressure, tipping."""

from __future__ import annotations

import numpy as np

from gantline.checks import highest_pressure, highest_tipping, shown_places, values_of
from gantline.report.subject import ABSENT, Subject, number, typeset
from gantline.results.alike import first_peak
from gantline.results.cranes.boom import Boom
from gantline.results.cranes.crawler import Crawler
from gantline.results.cranes.rating import chart_load, chart_places, group_used, rated_groups, rated_load
from gantline.results.cranes.rating_chart import RatingChart
from gantline.results.variable import FloatArray

#: Use of a chart by one hook over that by its crane that tells nothing apart.
_ALIKE = 1.001


def boom_rows(subject: Subject) -> list[dict[str, str]]:
    """Each crane with a boom: its worst moment by the chart, its reach, what it stands on."""
    if not len(subject.recording.time):
        return []
    charts = {chart.crane: chart for chart in subject.rig.rating_charts}
    crawlers = {crane.name: crane for crane in subject.rig.crawlers}
    return [
        {
            "name": boom.name,
            **_reach(subject, boom),
            **_rated(subject, charts.get(boom.name)),
            **_ground(subject, crawlers.get(boom.name)),
        }
        for boom in subject.rig.booms
    ]


def _reach(subject: Subject, boom: Boom) -> dict[str, str]:
    recording = subject.recording

    def of_hooks(variable: str) -> list[FloatArray]:
        return [recording.column(variable, hook.name)[subject.counts] for hook in boom.hooks]

    leads = {
        name: number(max((float(np.abs(one).max()) for one in of_hooks(name)), default=None), "deg", 2)
        for name in ("off_lead", "side_lead")
    }
    return {
        "angle": _range([recording.column("boom_angle", boom.name)[subject.counts]], "deg", 1),
        "radius": _range(of_hooks("crane_radius"), "m", 1),
        **leads,
    }


def _range(values: list[FloatArray], unit: str, digits: int) -> str:
    if not values:
        return ABSENT
    ends = [number(float(end), unit, digits) for end in (np.min(values), np.max(values))]
    return ends[0] if ends[0] == ends[1] else " – ".join(ends)


def _rated(subject: Subject, chart: RatingChart | None) -> dict[str, str]:
    """What hangs and what may at the moment that uses most of the chart, and what the check makes of that."""
    nothing = {"hangs": ABSENT, "may": ABSENT, "place": ABSENT, "used": ABSENT, "checked": ABSENT}
    if chart is None:
        return nothing
    recording, gravity = subject.recording, subject.rig.gravity
    if not chart_load(recording, chart, chart.hooks)[subject.counts].any():
        return {**nothing, "hangs": "no load"}
    # One hook may carry a part of a row only: then it governs, and not the crane with all of the row.
    # Of hooks that share alike, to what nobody reads, the crane has the line.
    groups = rated_groups(chart)
    uses = {one: np.where(subject.counts, group_used(recording, chart, one), -np.inf) for one in groups}
    most = {one: float(used.max()) for one, used in uses.items()}
    group = max(groups, key=most.__getitem__)
    group = groups[0] if most[group] <= _ALIKE * most[groups[0]] else group
    used = uses[group]
    load = chart_load(recording, chart, group.hooks)
    at = first_peak(used)
    places = chart_places(recording, chart, group.hooks)[at]
    rated = float(rated_load(recording, chart, group)[at])
    values = values_of(recording, "hoist_load_of_rating")
    checked = [values[one.element] for one in groups if one.element in values]
    return {
        **({} if group is groups[0] else {"name": group.element}),
        "hangs": number(float(load[at]) / gravity, "t", 1),
        "may": number(rated / gravity, "t", 1),
        "place": typeset(shown_places(chart, group.hooks, places, 1)),
        "used": number(float(used[at]), "%", 1) if np.isfinite(used[at]) else "outside",
        "checked": number(max(checked, default=None), "%", 1),
    }


def _ground(subject: Subject, crane: Crawler | None) -> dict[str, str]:
    if crane is None:
        return {"pressure": ABSENT, "pressure_used": ABSENT, "tipping": ABSENT}
    pressure = highest_pressure(subject.recording, crane, subject.counts)
    used = pressure / crane.allowed_pressure if crane.allowed_pressure else None
    return {
        "pressure": number(pressure, "kPa", 0),
        "pressure_used": number(used, "%", 0),
        "tipping": number(highest_tipping(subject.recording, crane, subject.counts), "%", 0),
    }
