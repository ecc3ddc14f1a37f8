"""Loads that are led past their chart, hang in a hook left behind, or are led from a hauled vessel."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.charts import Chart, boom_charts
from gantline.scenario.cranes.hooks import full_names
from gantline.scenario.cranes.kept_plumb import slings_under
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import LedHook, led_hooks, pose_before, way_of
from gantline.scenario.plan.plan import Step
from gantline.scenario.plan.positions import places_of_cranes
from gantline.scenario.plan.slinging import slings_on
from gantline.scenario.plan.steps import LineStep
from gantline.units import format_quantity

__all__ = ["doubtful_lead", "row_of"]

#: So many parts of a way are looked at.
_PARTS = 64
#: What a crane may be past its last row [m], and [rad]: rounding of what a lift file says in millimetres.
_ROUNDING = 2e-3


def row_of(scenario: Scenario, led: LedHook) -> Chart | None:
    """The chart that rates a hook that leads; None where nothing does, or one by outreach."""
    hook = led.name.removeprefix(f"{led.crane}.")
    charts = [one for one in boom_charts(scenario) if one.crane == led.crane]
    own = next((one for one in charts if one.hook == led.name), None)
    shared = next((one for one in charts if one.hook is None), None)
    found = own or (shared if hook in scenario.booms[led.crane].hooks else None)
    return None if found is None or found.rating.outreach is not None else found


def doubtful_lead(scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """Each hook that a step leaves behind, or takes out of its chart, on a level crane."""
    before = places_of_cranes(scenario)
    for place, (step, on) in enumerate(zip(scenario.plan, slings_on(scenario), strict=True)):
        if not isinstance(step, LeadStep):
            continue
        yield from _left_behind(scenario, rigging, place, step, on)
        yield from _hauled(scenario, place, step)
        hooks = led_hooks(scenario, step)
        way = way_of(step, hooks, before[place])
        for index, led in enumerate(hooks):
            chart = row_of(scenario, led)
            if chart is None:
                continue
            shares = [part / _PARTS for part in range(_PARTS + 1)]
            poses = list(way.poses(index, led, pose_before(led, before[place]), shares))
            over_radius = chart.rating.radius is not None
            at = [led.radius(pose.angle) if over_radius else pose.angle for pose in poses]
            rows = chart.rating.radius or chart.rating.angle or ()
            out = [max(min(rows) - one, one - max(rows)) for one in at]
            if max(out) > _ROUNDING:
                worst = out.index(max(out))
                unit = "m" if over_radius else "deg"
                there = format_quantity(at[worst], unit, 1)
                ends = " to ".join(format_quantity(end, unit, 1) for end in (min(rows), max(rows)))
                what = "radius" if over_radius else "angle of the boom"
                share = f"{math.floor(100.0 * shares[worst]):.0f} % of the way"
                sentence = f"at {share} '{led.name}' is at a {what} of {there}, and its chart has {ends}"
                yield Doubt(("plan", place, "lead"), f"{sentence}: outside of it nothing may hang")


def _left_behind(
    scenario: Scenario, rigging: Rigging, place: int, step: LeadStep, on: frozenset[str]
) -> Iterator[Doubt]:
    """Hooks in which the load hangs as well, and which neither the step nor one beside it leads."""
    beside = (one for one in _beside(scenario, place) if isinstance(one, LeadStep))
    elsewhere = {name for one in beside for name in full_names(one.lead, scenario.hooks)}
    named = full_names(step.lead, scenario.hooks)
    holds = [name for name in scenario.hooks if any(one.name in on for one in slings_under(rigging, name))]
    left = [f"'{name}'" for name in holds if name not in named and name not in elsewhere]
    if left and set(holds) & set(named):
        hangs = f"the load hangs in {' and '.join(left)} as well, which stays behind and pulls at it"
        yield Doubt(("plan", place, "lead"), f"{hangs}; lead all hooks that have slings on")


def _hauled(scenario: Scenario, place: int, step: LeadStep) -> Iterator[Doubt]:
    """Vessels that lines haul before the step ends: ways are those of cranes where the lift file has them.

    A way that goes with its one vessel does so wherever she is; an axis of the world, or a crane on another
    base, does not go along.
    """
    cranes = scenario.cranes or {}
    bases = {getattr(cranes[led.crane], "vessel", None) for led in led_hooks(scenario, step)}
    lines = scenario.mooring_lines or {}
    upto = [*scenario.plan[:place], *_beside(scenario, place)]
    for one in upto:
        moved = full_names(one.moved, lines) if isinstance(one, LineStep) else []
        for vessel in dict.fromkeys(lines[name].vessel for name in moved):
            if vessel not in bases:
                continue
            as_if = "cranes lead as if she lay where the lift file has her"
            hauls = f"step '{one.step}' moves lines of {vessel}, and {as_if}"
            if len(bases) > 1:
                yield Doubt(("plan", place, "lead"), f"{hauls}: hooks come apart from those on another base")
                return
            if step.about is not None:
                off = "this axis is off by as far as she has gone"
                yield Doubt(
                    ("plan", place, "about"), f"{hauls}: {off}; say where it is from there, or leave it out"
                )
                return


def _beside(scenario: Scenario, place: int) -> Sequence[Step]:
    """Steps that begin together with that at a place of the plan, and this itself."""
    plan = scenario.plan
    starts = [at for at, step in enumerate(plan) if getattr(step, "starts", "") != "with_previous"]
    first = max((at for at in starts if at <= place), default=0)
    return plan[first : min((at for at in starts if at > place), default=len(plan))]
