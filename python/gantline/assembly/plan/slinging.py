"""Slings that steps of the plan put on: whether they are long enough, and meant to be off before; cuts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import islice

from gantline.assembly.parts import Json, Parts
from gantline.assembly.ropes.route import end_to_end
from gantline.scenario import Scenario
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.plan.parting import partings
from gantline.scenario.plan.plan_time import earliest_begins
from gantline.scenario.plan.slinging import first_put_on, slings_on, starts_off
from gantline.scenario.plan.steps import HoldStep, HookStep
from gantline.scenario.rigging import SlingRigging

__all__ = ["check_reach", "hangs_load", "warn_of_cuts", "warn_of_off"]

#: A load that hangs, hangs on slings that are taut; by this share of their lengths positions may be rough.
_ROUGH = 0.02
#: Supports give way under a load by less than this [m]: nothing is said of slings that are as much too short.
_GIVES_WAY = 0.01


def check_reach(parts: Parts, scenario: Scenario, sling: SlingRigging, route: Sequence[Json]) -> None:
    """Refuse a sling that is too short where it is put on, if that is certain.

    It is where the load has not moved by then, since it stands and no sling has been on, and where of all
    that the sling may hang on only hooks have moved: each is somewhere between bounds, as the plan says.

    Args:
        parts: the system with the bodies of both ends.
        scenario: the lift.
        sling: one that is not on at the start.
        route: its guides, from its upper end to its lug.

    Raises:
        ScenarioError: if it cannot be put on.
    """
    place = first_put_on(scenario)[sling.name]
    before = scenario.plan[:place]
    at_start = frozenset(scenario.slings or {}) - starts_off(scenario)
    was_held = any([at_start, *islice(slings_on(scenario), place)])
    others = scenario.vessels or scenario.mechanics or scenario.tag_lines
    only_hooks = all(isinstance(step, (HoldStep, HookStep)) for step in before)
    if not scenario.load_has_settled or was_held or others or not only_hooks:
        return
    low, high = _moved(scenario, sling.hook, [step for step in before if isinstance(step, HookStep)])
    across, along, down = (float(part) for part in end_to_end(parts, route))
    aside = math.hypot(across, along)
    # Of all heights of the upper end over the lug that nearest to its level.
    distance = math.hypot(aside, min(max(0.0, low - down), high - down))
    short = distance - sling.length
    if short <= _GIVES_WAY:
        return
    sentence = f"'sling.{sling.name}' is {sling.length:g} m and {short:.3f} m too short to be put on: from "
    sentence += (
        f"'{sling.upper_body}' to its lug it is {'' if low == high else 'at least '}{distance:.3f} m then"
    )
    right = "lower the hook before, or make the sling longer"
    if aside > sling.length:
        sentence += f", {aside:.3f} m of that sideways, which no height of the hook makes up"
        right = "put crane or load elsewhere"
    raise scenario.start_error(("plan", place, "attach"), f"{sentence}; {right}")


def hangs_load(scenario: Scenario, sling: SlingRigging, distance: float) -> bool:
    """Whether a sling that is off at the start looks as if the load should hang on it there.

    Args:
        scenario: the lift.
        sling: one that is not on at the start.
        distance: of its ends at the start [m].
    """
    assert scenario.load is not None  # slings have been checked to lead to its lugs
    return scenario.load.stands_on is None and distance >= (1.0 - _ROUGH) * sling.length


def warn_of_off(parts: Parts, scenario: Scenario, slings: Sequence[str]) -> None:
    """Warn of slings that the load seems to hang on at the start, and that a step puts on."""
    if not slings:
        return
    first = first_put_on(scenario)
    steps = dict.fromkeys(f"'{scenario.plan[first[name]].step}'" for name in slings)
    one = len(slings) == 1
    said = f"sling {slings[0]} is" if one else f"slings {', '.join(slings)} are"
    put = f"put{'s' if len(steps) == 1 else ''} {'it' if one else 'them'} on"
    parts.doubt(
        ("slings", slings[0]),
        f"{said} off until {' and '.join(steps)} {put}; the load stands on nothing at the start, and "
        f"{'it' if one else 'they'} would be taut there: a sling that is on from the start needs no 'attach'",
    )


def warn_of_cuts(parts: Parts, scenario: Scenario) -> None:
    """Warn of ropes with a time at which they are cut that steps cut too, or put on later."""
    begins = earliest_begins(scenario.plan)
    for rope, parting in partings(scenario).items():
        time = parting.cut_at
        if time is None:
            continue
        for place, (step, begin) in enumerate(zip(scenario.plan, begins, strict=True)):
            if rope in step.cut:
                has = f"{rope} has 'cut_at: {time:g} s'"
                parts.doubt(
                    ("plan", place, "cut"), f"{has}, and step '{step.step}' cuts it: the earlier counts"
                )
            if rope in step.attach and begin >= time:
                stays = "it stays cut, and is not put on"
                has = f"{rope} has 'cut_at: {time:g} s'"
                parts.doubt(
                    ("plan", place, "attach"), f"{has}, before step '{step.step}' puts it on: {stays}"
                )


def _moved(scenario: Scenario, hook: str, steps: Sequence[HookStep]) -> tuple[float, float]:
    """By how much some steps move a hook up, at least and at most [m]."""
    low = high = 0.0
    for step in steps:
        if hook not in (full_name(text, scenario.hooks) for text in step.moved):
            continue
        if step.to is not None:
            low = high = step.to - scenario.hooks[hook].height
        elif step.by is not None:
            low, high = low + step.sign * step.by, high + step.sign * step.by
        else:
            low, high = (low, math.inf) if step.sign > 0 else (-math.inf, high)
    return low, high
