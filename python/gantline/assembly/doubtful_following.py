"""Steps that keep falls plumb and would have to go faster than they may, or askew, as far as the plan tells.

A line of lugs that comes from level to an angle a, one end hoisted at the speed v over the other, gets
shorter from above at v tan a: with both falls plumb so fast does one hook come nearer to the other.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from gantline.assembly.spatial import Array
from gantline.scenario import Rigging, Scenario
from gantline.scenario.crawler import Crawler
from gantline.scenario.hooks import full_name
from gantline.scenario.kept_plumb import hooks_beside, slings_under
from gantline.scenario.movers import Mover, mover
from gantline.scenario.plan import Step
from gantline.scenario.steps import FollowingStep, HoldStep, HookStep
from gantline.units import format_quantity

__all__ = ["doubtful_following"]

#: Upright lines of lugs have no length from above; short of this their angle is taken to be [rad].
_STEEPEST = math.radians(89.9)
#: Angle of the way of a drive to the line of lugs beyond which more than half of that lies across it [rad].
_MOST_ASKEW = math.radians(30.0)


def doubtful_following(scenario: Scenario, rigging: Rigging) -> Iterator[str]:
    """A sentence for each step that would have to follow faster than it may, from which angle on, or askew.

    Of loads whose hooks have taken up their slings evenly as the lift begins, and as far as the plan says to
    which height, or to which tilt, a step hoists.

    Args:
        scenario: The lift.
        rigging: Who carries whom.
    """
    heights: dict[str, float | None] = {name: hook.height for name, hook in scenario.hooks.items()}
    for stage in _stages(scenario.plan):
        hoists = [step for step in stage if isinstance(step, HookStep)]
        for hoist in hoists:
            for name in _named(scenario, hoist.moved):
                heights[name] = _after(hoist, heights[name])
        for step in stage:
            if not isinstance(step, FollowingStep) or not step.keep_plumb:
                continue
            one = mover(scenario, step.kind, step.moved[0])
            assert one is not None  # checked with the file
            hooks = _named(scenario, step.keep_plumb), hooks_beside(scenario, rigging, one)
            own, others = (_lugs(scenario, rigging, names) for names in hooks)
            yield from _askew(scenario, step, one, others - own)
            yield from _too_slow(scenario, step, others - own, hooks, hoists, heights)


def _stages(plan: Iterable[Step]) -> list[list[Step]]:
    """Steps that go on side by side."""
    stages: list[list[Step]] = []
    for step in plan:
        if not isinstance(step, HoldStep) and step.starts == "with_previous":
            stages[-1].append(step)
        else:
            stages.append([step])
    return stages


def _named(scenario: Scenario, texts: Iterable[str]) -> list[str]:
    return [name for text in texts if (name := full_name(text, scenario.hooks)) is not None]


def _after(step: HookStep, before: float | None) -> float | None:
    """Height of a hook after a step [m]; None where that is not known."""
    if step.to is not None:
        return step.to
    return None if step.by is None or before is None else before + step.sign * step.by


def _askew(scenario: Scenario, step: FollowingStep, one: Mover, line: Array) -> Iterator[str]:
    """What goes across the line of lugs, axes of the load, does not follow along it."""
    assert scenario.load is not None  # it hangs between hooks
    crane = (scenario.cranes or {}).get(one.name)
    way = crane.heading if isinstance(crane, Crawler) else 0.0 if one.kind == "trolley" else math.pi / 2
    turned = scenario.load.heading + math.atan2(line[1], line[0]) - way
    askew = abs(math.remainder(turned, math.pi))
    if askew > _MOST_ASKEW and np.hypot(line[0], line[1]) > 0.0:
        goes = f"'{one.name}' goes at {math.degrees(askew):.0f} deg to the line between the lugs as it starts"
        yield f"step '{step.step}': {goes}; falls do not stay plumb across its way"


def _too_slow(
    scenario: Scenario,
    step: FollowingStep,
    line: Array,
    hooks: tuple[list[str], list[str]],
    hoists: Sequence[HookStep],
    heights: dict[str, float | None],
) -> Iterator[str]:
    own, others = hooks
    length = float(np.linalg.norm(line))
    speeds = {name: hoist.sign * hoist.speed for hoist in hoists for name in _named(scenario, hoist.moved)}
    speed = abs(
        _mean(speeds.get(name, 0.0) for name in others) - _mean(speeds.get(name, 0.0) for name in own)
    )
    if speed == 0.0 or not length > 0.0:
        return
    steepest = _angle_after(scenario, hoists, float(line[2]), length, hooks, heights)
    keeps_up = math.atan(step.speed / speed)
    if steepest is None or steepest <= keeps_up:
        return
    needed = f"{_shown(speed)} x tan {math.degrees(steepest):.1f} deg = {_shown(speed * math.tan(steepest))}"
    goes = f"falls behind from {math.degrees(keeps_up):.1f} deg of the lugs over level on"
    may = f"in the end it would have to go {needed}, and may go {_shown(step.speed)}"
    yield f"step '{step.step}' {goes}: {may}; hoist slower there, or let it go faster"


def _shown(speed: float) -> str:
    return format_quantity(speed, "m/min", 1)


def _lugs(scenario: Scenario, rigging: Rigging, hooks: Iterable[str]) -> Array:
    """Mean of the lugs that lead to some hooks, axes of the load (3,) [m]."""
    assert scenario.load is not None  # slings have been checked to lead to its lugs
    known = scenario.load.lugs
    slings = [sling for hook in hooks for sling in slings_under(rigging, hook)]
    places = [known[lug].at for sling in slings for lug in sling.lugs]
    return np.mean(places, axis=0) if places else np.full(3, math.nan)


def _mean(values: Iterable[float]) -> float:
    return float(np.mean(list(values)))


def _angle_after(
    scenario: Scenario,
    hoists: Sequence[HookStep],
    rise: float,
    length: float,
    hooks: tuple[list[str], list[str]],
    heights: dict[str, float | None],
) -> float | None:
    """Angle of the line of lugs over level at the end of a step [rad]; None where that is not known."""
    for hoist in hoists:
        tilt = hoist.until.load_tilt if hoist.until is not None else None
        if tilt is not None and tilt.above is not None:
            return min(tilt.above + math.asin(rise / length), _STEEPEST)
    lifted = []
    for names in hooks:
        known = [(heights[name], scenario.hooks[name].height) for name in names]
        lifted.append(_mean(math.nan if after is None else after - before for after, before in known))
    sine = abs(rise + lifted[1] - lifted[0]) / length
    if math.isnan(sine):
        return None
    return min(math.asin(min(sine, 1.0)), _STEEPEST)
