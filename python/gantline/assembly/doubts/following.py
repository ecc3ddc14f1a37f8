"""Steps that keep falls plumb and would have to go faster than they may, or askew, as far as the plan tells.

A line of lugs that comes to an angle a over level, one end hoisted at the speed v over the other, gets
shorter from above at v tan a, or longer beyond plumb: with both falls plumb so fast does one hook come nearer
to the other, or go away from it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import takewhile

import numpy as np

from gantline.assembly.doubts.tilts import balance, lugs_under
from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.plan.followed_ways import STEEPEST, Along, Luffing, Slewing, first_angle, way_of
from gantline.assembly.spatial import Array
from gantline.scenario import Rigging, Scenario
from gantline.scenario.base import Element
from gantline.scenario.cranes.hooks import full_names
from gantline.scenario.cranes.kept_plumb import hooks_beside, slings_under
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import led_hooks
from gantline.scenario.plan.movers import Mover, mover
from gantline.scenario.plan.plan import Step
from gantline.scenario.plan.slinging import slings_on
from gantline.scenario.plan.steps import AlongStep, HoldStep, HookStep
from gantline.units import format_quantity

__all__ = ["doubtful_following"]

#: Angle of the way of a drive to the line of lugs beyond which more than half of that lies across it [rad].
_MOST_ASKEW = math.radians(30.0)
#: By how much a range may be short of the way of a step that follows before that is told [m].
_SHORT = 0.2


def doubtful_following(scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None) -> Iterator[Doubt]:
    """Each step that would have to follow faster than it may, from which angle on, or askew.

    Of loads whose hooks have taken up their slings evenly as the lift begins, and as far as the plan says to
    which height, or to which tilt, a step hoists.

    Args:
        scenario: The lift.
        rigging: Who carries whom.
        lifted: The load.
    """
    is_followed = any(isinstance(step, AlongStep) and step.keep_plumb for step in scenario.plan)
    if lifted is None or not is_followed:
        return
    heights: dict[str, float | None] = {name: hook.height for name, hook in scenario.hooks.items()}
    turned, before = _Turned(), frozenset[str]()
    for stage, on in _stages(scenario):
        hoists = [step for step in stage if isinstance(step, HookStep)]
        speeds = {
            name: one.sign * one.speed for one in hoists for name in full_names(one.moved, scenario.hooks)
        }
        for hook in scenario.hooks:
            if before and (before ^ on) & {sling.name for sling in slings_under(rigging, hook)}:
                heights[hook] = None  # what it holds is elsewhere
        for hoist in hoists:
            for name in full_names(hoist.moved, scenario.hooks):
                heights[name] = _after(hoist, heights[name])
        lugs = {hook: _lugs(scenario, rigging, [hook], on) for hook in scenario.hooks}
        held = {hook: at for hook, at in lugs.items() if at is not None}
        alone = _hung_alone(scenario, rigging, lifted, hoists, on)
        is_let_go = alone is not None and turned.up.any()  # a level load has been set down
        after = alone if alone is not None and is_let_go else turned.after(hoists, speeds, held)
        now = _Stage(scenario, rigging, tuple(stage), on, speeds, heights, turned, after)
        for step in stage:
            if isinstance(step, AlongStep) and step.keep_plumb:
                yield from _doubts_of(now, step)
        turned, before = after, on


def _doubts_of(stage: _Stage, step: AlongStep) -> Iterator[Doubt]:
    """Doubts of one step that follows, among those that go on beside it."""
    scenario = stage.scenario
    one = mover(scenario, step.kind, step.moved[0])
    assert one is not None and step.keep_plumb is not None  # checked with the file; it follows
    own = full_names(step.keep_plumb, scenario.hooks)
    others = [
        hook for hook in hooks_beside(scenario, stage.rigging, one) if stage.lugs_of([hook]) is not None
    ]
    near, far = stage.lugs_of(own), stage.lugs_of(others)
    if near is None or far is None:
        return
    line = far - near
    assert scenario.load is not None  # it hangs between hooks
    towards = scenario.load.heading + math.atan2(line[1], line[0])
    way = way_of(scenario, one, own, towards, (float(np.linalg.norm(line)), float(line[2])))
    if _others_beside(scenario, stage.steps, step):
        return
    path = ("plan", [other is step for other in scenario.plan].index(True))
    yield from (Doubt(path, said) for said in _askew(step, one, way, towards, line))
    speed = _mean(stage.speeds, others) - _mean(stage.speeds, own)
    if isinstance(way, Luffing | Slewing) and (speed < 0.0 or _is_elsewhere(scenario, step)):
        return  # equations of both are for an end that stays low, and from where they start
    lifted = _lifted(scenario, stage.heights, others) - _lifted(scenario, stage.heights, own)
    steepest = _steepest(line, stage.before, stage.after, lifted, way)
    yield from (Doubt(path, said) for said in _out_of_reach(step, one, way, steepest))
    if not _is_elsewhere(scenario, step) and not _follow_beside(stage.steps, step):
        yield from (Doubt(path, said) for said in _out_of_range(step, one, way, towards, line, steepest))
    yield from (Doubt(path, said) for said in _too_slow(step, abs(speed), steepest, way))


@dataclass(frozen=True)
class _Stage:
    """Steps that go on side by side, and what the plan tells of hooks and load by then.

    Attributes:
        scenario: The lift.
        rigging: Who carries whom.
        steps: The steps.
        on: Names of the slings that are on.
        speeds: Of hooks that are hoisted or lowered [m/s].
        heights: Of hooks as the steps end [m]; None where that is not known.
        before: How the load was turned as they began.
        after: The same as they end.
    """

    scenario: Scenario
    rigging: Rigging
    steps: tuple[Step, ...]
    on: frozenset[str]
    speeds: Mapping[str, float]
    heights: Mapping[str, float | None]
    before: _Turned
    after: _Turned

    def lugs_of(self, hooks: Iterable[str]) -> Array | None:
        """Mean of the lugs to which slings lead from some hooks, axes of the load (3,) [m]; or None."""
        return _lugs(self.scenario, self.rigging, hooks, self.on)


@dataclass(frozen=True)
class _Turned:
    """How far a load is turned, as far as the plan tells.

    Attributes:
        tilt: Angle [rad]; NaN since a step that turns it by an angle of which the plan says nothing.
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
            is_even = len({speeds.get(hook, 0.0) for hook in lugs}) < 2
            return replace(self, tilt=self.tilt if is_even else math.nan, is_known=False)
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


def _hung_alone(
    scenario: Scenario,
    rigging: Rigging,
    lifted: LiftedLoad,
    hoists: Sequence[HookStep],
    on: frozenset[str],
) -> _Turned | None:
    """How a load is turned that hangs from one end alone, as the slings of the other end hang slack; or None.

    So does a step end that lets go of those slings: `until` they are slack.
    """
    waits = [one.until for one in hoists if one.until is not None and one.until.slings == "slack"]
    slack = {rope.removeprefix("sling.") for until in waits for rope in until.of}
    if not slack:
        return None
    lugs = lugs_under(scenario, rigging, scenario.hooks, on - slack)
    tilt = balance(lugs, lifted.body.centre) if lugs else None
    if tilt is None:
        return None
    up = (np.mean(lugs, axis=0) - lifted.body.centre)[:2]
    size = float(np.linalg.norm(up))
    return _Turned(tilt, up / size, is_known=True) if size > 0.0 else None


def _steepest(
    line: Array, before: _Turned, after: _Turned, lifted: float, way: Along
) -> tuple[float, str] | None:
    """Steepest angle of a line of lugs over level on its way [rad], and when that is; None if not known.

    Args:
        line: The line, axes of the load (3,) [m].
        before: How the load was turned as the step began.
        after: The same as it ends.
        lifted: By how much more than the other its far end has been hoisted since the lift began [m], or NaN.
        way: How its near end goes along.
    """
    length = float(np.linalg.norm(line))
    if not length > 0.0:
        return None
    if not after.is_known:
        sine = abs(float(line[2]) + lifted) / length
        return None if math.isnan(sine) else (way.turned_by(sine), "in the end")
    ends = [one.line(line) for one in (replace(before, up=after.up), after)]
    if ends[0][0] * ends[1][0] < 0.0:
        return STEEPEST, "on the way"
    first, last = (min(abs(math.atan2(high, abs(along))), STEEPEST) for along, high in ends)
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


def _after(step: HookStep, before: float | None) -> float | None:
    """Height of a hook after a step [m]; None where that is not known."""
    if step.to is not None:
        return step.to
    return None if step.by is None or before is None else before + step.sign * step.by


def _followers(scenario: Scenario, step: Element) -> set[str]:
    """Cranes whose hooks a step takes along to keep falls plumb."""
    if not isinstance(step, AlongStep) or not step.keep_plumb:
        return set()
    return {scenario.hooks[name].crane for name in full_names(step.keep_plumb, scenario.hooks)}


def _others_beside(scenario: Scenario, stage: Sequence[Step], step: AlongStep) -> bool:
    """Whether another step takes the same hooks along beside it, across its own way."""
    own = _followers(scenario, step)
    return any(own & _followers(scenario, other) for other in stage if other is not step)


def _follow_beside(stage: Sequence[Step], step: AlongStep) -> bool:
    """Whether another step that goes on beside it follows too, and makes good a part of the way."""
    return any(isinstance(other, AlongStep) and other.keep_plumb for other in stage if other is not step)


def _is_elsewhere(scenario: Scenario, step: AlongStep) -> bool:
    """Whether a step before has brought the crane to another place, or its boom, than that of the start."""
    own = _followers(scenario, step)
    for before in takewhile(lambda other: other is not step, scenario.plan):
        if isinstance(before, LeadStep) and own & {one.crane for one in led_hooks(scenario, before)}:
            return True
        if not isinstance(before, AlongStep) or before.verb == "traverse":
            continue
        is_alike = before.verb == step.verb and before.keep_plumb is not None
        if own & set(before.moved) and not is_alike:
            return True
    return False


def _askew(step: AlongStep, one: Mover, way: Along, towards: float, line: Array) -> Iterator[str]:
    """What goes across the line of lugs, axes of the load, does not follow along it."""
    askew = abs(math.remainder(towards - way.way, math.pi))
    if askew > _MOST_ASKEW and np.hypot(line[0], line[1]) > 0.0:
        goes = f"'{one.name}' goes at {math.degrees(askew):.0f} deg to the line between the lugs as it starts"
        yield f"step '{step.step}': {goes}; falls do not stay plumb across its way"


def _out_of_reach(
    step: AlongStep, one: Mover, way: Along, steepest: tuple[float, str] | None
) -> Iterator[str]:
    if steepest is None or not isinstance(way, Luffing) or way.reaches(steepest[0]):
        return
    angle = first_angle(lambda angle: not way.reaches(angle), way.level, steepest[0])
    goes = f"falls do not stay plumb from {math.degrees(angle):.1f} deg of the lugs over level on"
    reach = f"there '{one.name}' comes to the end of its reach, or of its range, {way.range_in_words}"
    right = "begin with it steeper" if way.side > 0.0 else "begin with it less steep"
    yield f"step '{step.step}': {goes}: {reach}; {right}, or let the crane travel"


def _out_of_range(
    step: AlongStep, one: Mover, way: Along, towards: float, line: Array, steepest: tuple[float, str] | None
) -> Iterator[str]:
    """A trolley or crane that would have to go on past the end of its range, from where it starts."""
    if steepest is None or isinstance(way, Luffing | Slewing) or one.range is None or one.start is None:
        return
    length, level = float(np.linalg.norm(line)), float(np.hypot(line[0], line[1]))
    nearer = level - length * math.cos(steepest[0])
    low, high = one.range
    room = high - one.start if math.cos(towards - way.way) > 0.0 else one.start - low
    if nearer <= room + _SHORT:
        return
    angle = math.acos(max(-1.0, min((level - room) / length, 1.0)))
    goes = f"falls do not stay plumb from {math.degrees(angle):.1f} deg of the lugs over level on"
    ends = " to ".join(format_quantity(end, "m", 2) for end in one.range)
    has_to = f"{format_quantity(nearer, 'm', 1)} nearer, and has {format_quantity(room, 'm', 1)} that way"
    yield f"step '{step.step}': {goes}: '{one.name}' has to go {has_to} in its range, {ends}; widen it"


def _too_slow(step: AlongStep, speed: float, steepest: tuple[float, str] | None, way: Along) -> Iterator[str]:
    if speed == 0.0 or steepest is None:
        return
    angle, when = steepest
    if way.needed(angle, speed) <= step.speed or not way.reaches(angle):
        return
    keeps_up = first_angle(lambda angle: way.needed(angle, speed) > step.speed, 0.0, angle)
    where = "down to" if when == "at first" else "from"
    goes = f"falls behind {where} {math.degrees(keeps_up):.1f} deg of the lugs over level"
    goes = goes if when == "at first" else f"{goes} on"
    may = (
        f"{when} it would have to go {way.needed_in_words(angle, speed)}, and may go {way.shown(step.speed)}"
    )
    yield f"step '{step.step}' {goes}: {may}; hoist slower there, or let it go faster"


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
