"""Whether cranes can lead the load as steps say: who can, how far they reach, how fast they have to be."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gantline.scenario.consistency.travel import said
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import Beyond, LedHook, Pose, Way, led_hooks, pose_before, way_of
from gantline.scenario.plan.movers import Mover, mover
from gantline.scenario.plan.positions import Places, places_of_cranes
from gantline.units import format_quantity

__all__ = ["Drive", "check_lead", "drives_along", "fastest"]

_ROUNDING = 1 + 1e-9
#: So many parts of a way are looked at, each for the speed of every drive.
_PARTS = 200
#: Hooks that go less far go nowhere [m].
_NOWHERE = 1e-6
#: An upper structure turns by more than this between two looks only as its hook passes the axis [rad].
_LARGEST_TURN = 0.2
#: What drives do, in messages.
_NOUNS = {"boom": "luffing", "upper": "slewing", "hook": "hoisting", "crane": "travelling"}


@dataclass(frozen=True)
class Drive:
    """How a drive goes along the way of a step, at even shares of it.

    Attributes:
        of: what it moves.
        places: as `to` counts them, but of a hook how far its hoist has gone [m, rad].
        speeds: highest speed there, in the part before or after it [m/s, rad/s].
        accelerations: highest acceleration there [m/s^2, rad/s^2].
    """

    of: Mover
    places: Sequence[float]
    speeds: Sequence[float]
    accelerations: Sequence[float]


def check_lead(findings: Findings, place: int, step: LeadStep) -> set[str]:
    """Note what cranes cannot do in a step that leads the load.

    Returns:
        Names of what moves, or must not be moved beside it.
    """
    scenario = findings.scenario
    problems = len(findings.problems)
    for text in step.lead:
        _check_hook(findings, ("plan", place, "lead"), step, text)
    _check_travelling(findings, ("plan", place, "travelling"), step)
    hooks = led_hooks(scenario, step)
    cranes = [led.crane for led in hooks]
    for crane in dict.fromkeys(cranes):
        if cranes.count(crane) > 1:
            sentence = f"names two hooks of '{crane}', which cannot bring both to their places"
            findings.add(("plan", place, "lead"), f"{sentence}; one hook of each crane leads")
    if len(findings.problems) == problems:
        _check_way(findings, ("plan", place), step, hooks, places_of_cranes(scenario)[place])
    tracks = {led.track.name for led in hooks if led.track is not None}
    return {one.name for led in hooks for one in (*led.movers, led.boom)} | tracks


def _check_hook(findings: Findings, path: Path, step: LeadStep, text: str) -> None:
    scenario = findings.scenario
    name = full_name(text, scenario.hooks)
    if name is None:
        findings.add(path, f"'{text}' is not a hook; {nearest(text, scenario.hooks)}")
        return
    crane = scenario.hooks[name].crane
    if mover(scenario, "upper", crane) is None:
        sentence = f"'{crane}' does not slew, so that its hook '{name}' does not lead a load along any way"
        right = "cranes with 'slewing' do"
        findings.add(path, f"{sentence}; {right}: a 'floating_crane' with a 'slewing_axis', or a 'crawler'")
        return
    travels = any(full_name(one, scenario.cranes or {}) == crane for one in step.travelling)
    if mover(scenario, "boom", crane) is None and not travels:
        sentence = f"the boom of '{crane}' does not luff: it has no 'luffing'"
        findings.add(path, f"{sentence}; a crane that leads slews and luffs, or slews and is 'travelling'")
    hoist = mover(scenario, "hook", name)
    if hoist is not None and hoist.reel is not None:
        sentence = f"the rope of '{name}' lies on its drum in layers, which changes the speed of its hook"
        findings.add(path, f"{sentence} all at once; a hook with 'layers: 1' keeps a load level")


def _check_travelling(findings: Findings, path: Path, step: LeadStep) -> None:
    cranes = findings.scenario.cranes or {}
    leads = {findings.scenario.hooks[one].crane: one for one in _names(findings, step)}
    for text in step.travelling:
        name = full_name(text, cranes)
        if name not in leads:
            findings.add(path, f"'{text}' is not a crane whose hook leads here; {nearest(text, leads)}")
        elif not isinstance(cranes[name], Crawler) or mover(findings.scenario, "crane", name) is None:
            sentence = f"'{name}' has no 'travel'; give it one, such as "
            right = "'travel: {speed: 1 km/h, acceleration: 0.02 m/s^2, range: [0 m, 50 m]}'"
            findings.add(path, sentence + right)


def _names(findings: Findings, step: LeadStep) -> Iterator[str]:
    known = findings.scenario.hooks
    return (name for text in step.lead if (name := full_name(text, known)) is not None)


def _check_way(
    findings: Findings, path: Path, step: LeadStep, hooks: Sequence[LedHook], before: Places
) -> None:
    """Every crane reaches, within its ranges, and no drive is too fast; what fails first is told."""
    for led in hooks:
        tracks = [led.track.name] if led.track is not None else []
        for name in (led.boom.name, led.upper.name, *tracks):
            if not before[name][1]:
                sentence = (
                    f"where '{name}' is by then only the run can tell, and with it what this asks of it"
                )
                right = "let a step before it end by 'to'"
                findings.add((*path, "lead"), f"{sentence}; {right}")
                return
    way = way_of(step, hooks, before)
    if way.length < _NOWHERE:
        sentence = "takes no hook anywhere, or by less than a micrometre"
        right = "a longer way, or an axis 'about' aside of the hook, is right"
        findings.add((*path, "turn" if step.turn else "by"), f"{sentence}; {right}")
        return
    for index, led in enumerate(hooks):
        try:
            drives = drives_along(step, way, index, led, pose_before(led, before))
        except Beyond as error:
            findings.add((*path, "turn" if step.turn else "by"), f"'{led.name}' would come to {error}")
            return
        wrong = next((text for drive in drives for text in _wrong(step, drive)), None)
        if wrong is not None:
            key, sentence = wrong
            findings.add((*path, key), sentence)
            return


def drives_along(step: LeadStep, way: Way, index: int, led: LedHook, begin: Pose) -> list[Drive]:
    """How the drives of a crane go along the way of a step.

    Raises:
        Beyond: where it does not reach.
    """
    shares = [place / _PARTS for place in range(_PARTS + 1)]
    poses: list[Pose] = []
    try:
        poses.extend(way.poses(index, led, begin, shares))
    except Beyond as error:
        at = next(share for share in shares if not _reaches(way, index, led, begin, share))
        raise Beyond(f"{error}, at {100 * at:.3g} % of the way") from error
    turns = max(abs(after.slew - before.slew) for before, after in pairwise(poses))
    if turns > _LARGEST_TURN:
        nearest_ = min(math.dist(way.place(index, share), led.base) for share in shares)
        sentence = (
            f"{nearest_:.2f} m from the slewing axis of '{led.crane}', about which it cannot slew so fast"
        )
        raise Beyond(f"{sentence}; a way that leaves it aside is right")
    places = {
        led.upper: [pose.slew for pose in poses],
        (led.track if led.travels and led.track else led.boom): [
            pose.travel if led.travels else pose.angle for pose in poses
        ],
        led.hoist: [way.hoisted(led, begin, pose, share) for pose, share in zip(poses, shares, strict=True)],
    }
    return [_drive(step, way.length, one, at) for one, at in places.items()]


def _reaches(way: Way, index: int, led: LedHook, begin: Pose, share: float) -> bool:
    try:
        led.follow(way.place(index, share), begin)
    except Beyond:
        return False
    return True


def _drive(step: LeadStep, length: float, of: Mover, places: Sequence[float]) -> Drive:
    """(LD7): f' of the share's rate, f'' of its square and f' of its acceleration, by differences."""
    part, acceleration = 1.0 / (len(places) - 1), step.acceleration / length
    speeds, most = [], []
    for index in range(len(places)):
        middle = min(max(index, 1), len(places) - 2)
        before, here, after = places[middle - 1 : middle + 2]
        slope, bend = (after - before) / (2 * part), (after - 2 * here + before) / part**2
        slope += bend * (index - middle) * part
        # On ramps the rate is what the way so far, or to come, allows.
        left = min(index, len(places) - 1 - index) * part
        rate = min(step.speed / length, math.sqrt(2 * acceleration * left))
        ramps = acceleration if left <= 0.5 * (step.speed / length) ** 2 / acceleration + part else 0.0
        speeds.append(abs(slope) * rate)
        most.append(abs(bend) * rate**2 + abs(slope) * ramps)
    return Drive(of, places, speeds, most)


def fastest(drive: Drive) -> tuple[float, float]:
    """Share of its highest speed that a drive needs, and of its highest acceleration."""
    return max(drive.speeds) / drive.of.speed, max(drive.accelerations) / drive.of.acceleration


def _wrong(step: LeadStep, drive: Drive) -> Iterator[tuple[str, str]]:
    """What a drive cannot do, each with its key."""
    one, noun = drive.of, _NOUNS[drive.of.kind]
    for index, at in enumerate(drive.places):
        if one.kind != "hook" and one.range is not None and not _is_within(at, one.range):
            low, high = (said(one.kind, end, "position") for end in one.range)
            there = _rounded(one, at, "position")
            sentence = f"'{one.name}' would come to {there} at {_percent(index)} of the way"
            yield ("turn" if step.turn else "by"), f"{sentence}; its range is {low} to {high}"
            return
    speed, acceleration = fastest(drive)
    if speed > _ROUNDING:
        at = _first(drive.speeds)
        needed = _rounded(one, drive.speeds[at], "speed")
        sentence = f"{noun} of '{one.name}' would need {needed} at {_percent(at)} of the way"
        most, right = said(one.kind, one.speed, "speed"), _down(60 * step.speed / speed)
        yield "speed", f"{sentence}; its highest speed is {most}, and '{right:g} m/min' is right here"
    elif acceleration > _ROUNDING:
        at = _first(drive.accelerations)
        needed = _rounded(one, drive.accelerations[at], "acceleration")
        sentence = f"{noun} of '{one.name}' would need {needed} at {_percent(at)} of the way"
        most, right = (
            said(one.kind, one.acceleration, "acceleration"),
            _down(step.acceleration / acceleration),
        )
        yield "acceleration", f"{sentence}; its most is {most}: '{right:g} m/s^2' is right, or a lower speed"


def _first(values: Sequence[float]) -> int:
    """Where the largest of some values stands first, but for rounding."""
    most = max(values)
    return next(index for index, value in enumerate(values) if value >= most * (1 - 1e-6))


def _is_within(at: float, bounds: tuple[float, float]) -> bool:
    return bounds[0] - 1e-9 <= at <= bounds[1] + 1e-9


def _rounded(one: Mover, value: float, of: str) -> str:
    number, unit = said(one.kind, value, of).split(" ", 1)
    return f"{float(number):.3g} {unit}"


def _percent(index: int) -> str:
    return format_quantity(index / _PARTS, "%", 0)


def _down(value: float) -> float:
    """A number of two digits that is not above a value."""
    step = 10.0 ** (math.floor(math.log10(value)) - 1)
    return math.floor(value / step * _ROUNDING) * step
