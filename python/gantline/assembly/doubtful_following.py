"""Steps that keep falls plumb and would have to go faster than they may, or askew, as far as the plan tells.

A line of lugs that comes to an angle a over level, one end hoisted at the speed v over the other, gets
shorter from above at v tan a, or longer beyond plumb: with both falls plumb so fast does one hook come nearer
to the other, or go away from it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from gantline.assembly.spatial import Array
from gantline.scenario import Rigging, Scenario
from gantline.scenario.crawler import Crawler
from gantline.scenario.hooks import full_name
from gantline.scenario.kept_plumb import hooks_beside, slings_under
from gantline.scenario.movers import Mover, mover
from gantline.scenario.plan import Step
from gantline.scenario.slinging import slings_on
from gantline.scenario.steps import AlongStep, HoldStep, HookStep
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
    if not any(isinstance(step, AlongStep) and step.keep_plumb for step in scenario.plan):
        return
    heights: dict[str, float | None] = {name: hook.height for name, hook in scenario.hooks.items()}
    turned, before = _Turned(), frozenset[str]()
    for stage, on in _stages(scenario):
        hoists = [step for step in stage if isinstance(step, HookStep)]
        speeds = {name: one.sign * one.speed for one in hoists for name in _named(scenario, one.moved)}
        for hook in scenario.hooks:
            if before and (before ^ on) & {sling.name for sling in slings_under(rigging, hook)}:
                heights[hook] = None  # what it holds is elsewhere
        for hoist in hoists:
            for name in _named(scenario, hoist.moved):
                heights[name] = _after(hoist, heights[name])
        lugs = {hook: _lugs(scenario, rigging, [hook], on) for hook in scenario.hooks}
        after = turned.after(hoists, speeds, {hook: at for hook, at in lugs.items() if at is not None})
        for step in stage:
            if not isinstance(step, AlongStep) or not step.keep_plumb:
                continue
            one = mover(scenario, step.kind, step.moved[0])
            assert one is not None  # checked with the file
            own = _named(scenario, step.keep_plumb)
            others = [hook for hook in hooks_beside(scenario, rigging, one) if lugs[hook] is not None]
            near, far = (_lugs(scenario, rigging, names, on) for names in (own, others))
            if near is None or far is None:
                continue
            yield from _askew(scenario, step, one, far - near)
            speed = abs(_mean(speeds, others) - _mean(speeds, own))
            lifted = _lifted(scenario, heights, others) - _lifted(scenario, heights, own)
            yield from _too_slow(step, speed, _steepest(far - near, turned, after, lifted))
        turned, before = after, on


@dataclass(frozen=True)
class _Turned:
    """How far a load is turned, as far as the plan tells.

    Attributes:
        tilt: Angle [rad].
        up: Way, level and in axes of the load, towards the end that is higher by that (2,).
        is_known: Whether the step before said so.
    """

    tilt: float = 0.0
    up: Array = field(default_factory=lambda: np.zeros(2))
    is_known: bool = False

    def after(
        self, hoists: Sequence[HookStep], speeds: Mapping[str, float], lugs: Mapping[str, Array]
    ) -> _Turned:
        """After steps that go on side by side, of hooks with slings to these means of lugs."""
        tilts = [one.until.load_tilt for one in hoists if one.until is not None and one.until.load_tilt]
        ends = [end for tilt in tilts for end in (tilt.above, tilt.below) if end is not None]
        if not ends or not lugs:
            return replace(self, is_known=False)
        mean = _mean(speeds, lugs)
        way = np.sum([(speeds.get(hook, 0.0) - mean) * at[:2] for hook, at in lugs.items()], axis=0)
        size = float(np.linalg.norm(way))
        is_level = self.tilt == 0.0 or not self.up.any()
        return _Turned(ends[0], way / size if is_level and size > 0.0 else self.up, is_known=True)

    def line(self, level: Array) -> tuple[float, float]:
        """Of a line, axes of the load (3,), how long it is along `up`, and how high, as turned so far [m]."""
        along, high = float(level[:2] @ self.up), float(level[2])
        cosine, sine = math.cos(self.tilt), math.sin(self.tilt)
        return along * cosine - high * sine, along * sine + high * cosine


def _steepest(line: Array, before: _Turned, after: _Turned, lifted: float) -> tuple[float, str] | None:
    """Steepest angle of a line of lugs over level on its way [rad], and when that is; None if not known.

    Args:
        line: The line, axes of the load (3,) [m].
        before: How the load was turned as the step began.
        after: The same as it ends.
        lifted: By how much more than the other its far end has been hoisted since the lift began [m], or NaN.
    """
    length = float(np.linalg.norm(line))
    if not length > 0.0:
        return None
    if not after.is_known:
        sine = abs(float(line[2]) + lifted) / length
        return None if math.isnan(sine) else (min(math.asin(min(sine, 1.0)), _STEEPEST), "in the end")
    ends = [one.line(line) for one in (replace(before, up=after.up), after)]
    if ends[0][0] * ends[1][0] < 0.0:
        return _STEEPEST, "on the way"
    first, last = (min(abs(math.atan2(high, abs(along))), _STEEPEST) for along, high in ends)
    return (first, "at first") if first > last else (last, "in the end")


def _stages(scenario: Scenario) -> list[tuple[list[Step], frozenset[str]]]:
    """Steps that go on side by side, and the slings that are on then."""
    stages: list[tuple[list[Step], frozenset[str]]] = []
    for step, on in zip(scenario.plan, slings_on(scenario), strict=True):
        if not isinstance(step, HoldStep) and step.starts == "with_previous":
            stages[-1] = ([*stages[-1][0], step], on)
        else:
            stages.append(([step], on))
    return stages


def _named(scenario: Scenario, texts: Iterable[str]) -> list[str]:
    return [name for text in texts if (name := full_name(text, scenario.hooks)) is not None]


def _after(step: HookStep, before: float | None) -> float | None:
    """Height of a hook after a step [m]; None where that is not known."""
    if step.to is not None:
        return step.to
    return None if step.by is None or before is None else before + step.sign * step.by


def _askew(scenario: Scenario, step: AlongStep, one: Mover, line: Array) -> Iterator[str]:
    """What goes across the line of lugs, axes of the load, does not follow along it."""
    assert scenario.load is not None  # it hangs between hooks
    crane = (scenario.cranes or {}).get(one.name)
    way = crane.heading if isinstance(crane, Crawler) else 0.0 if one.kind == "trolley" else math.pi / 2
    turned = scenario.load.heading + math.atan2(line[1], line[0]) - way
    askew = abs(math.remainder(turned, math.pi))
    if askew > _MOST_ASKEW and np.hypot(line[0], line[1]) > 0.0:
        goes = f"'{one.name}' goes at {math.degrees(askew):.0f} deg to the line between the lugs as it starts"
        yield f"step '{step.step}': {goes}; falls do not stay plumb across its way"


def _too_slow(step: AlongStep, speed: float, steepest: tuple[float, str] | None) -> Iterator[str]:
    if speed == 0.0 or steepest is None:
        return
    angle, when = steepest
    keeps_up = math.atan(step.speed / speed)
    if angle <= keeps_up:
        return
    where = "down to" if when == "at first" else "from"
    goes = f"falls behind {where} {math.degrees(keeps_up):.1f} deg of the lugs over level"
    goes = goes if when == "at first" else f"{goes} on"
    needed = f"{_shown(speed)} x tan {math.degrees(angle):.1f} deg = {_shown(speed * math.tan(angle))}"
    may = f"{when} it would have to go {needed}, and may go {_shown(step.speed)}"
    yield f"step '{step.step}' {goes}: {may}; hoist slower there, or let it go faster"


def _shown(speed: float) -> str:
    return format_quantity(speed, "m/min", 1)


def _lugs(scenario: Scenario, rigging: Rigging, hooks: Iterable[str], on: frozenset[str]) -> Array | None:
    """Mean of the lugs to which slings that are on lead from some hooks, axes of the load (3,) [m]."""
    assert scenario.load is not None  # slings have been checked to lead to its lugs
    known = scenario.load.lugs
    slings = [sling for hook in hooks for sling in slings_under(rigging, hook) if sling.name in on]
    places = [known[lug].at for sling in slings for lug in sling.lugs]
    return np.mean(places, axis=0) if places else None


def _mean(speeds: Mapping[str, float], hooks: Iterable[str]) -> float:
    return float(np.mean([speeds.get(hook, 0.0) for hook in hooks]))


def _lifted(scenario: Scenario, heights: Mapping[str, float | None], hooks: Iterable[str]) -> float:
    """Mean of how far hooks have been hoisted since the lift began [m]; NaN where that is not known."""
    known = [(heights[name], scenario.hooks[name].height) for name in hooks]
    return float(np.mean([math.nan if after is None else after - before for after, before in known]))
