"""What a program asks of a drive, in the words of the plan, into orders for the core."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from gantline.assembly.parts import Json
from gantline.assembly.plan.operations import drives_of, stop_of
from gantline.scenario import Scenario
from gantline.scenario.consistency.travel import said
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import nearest
from gantline.scenario.plan.movers import Mover, movers
from gantline.scenario.plan.steps import (
    HoistStep,
    Kind,
    LuffStep,
    MovingStep,
    PayOutStep,
    SlewStep,
    TravelStep,
    TraverseStep,
    VeerStep,
)

__all__ = ["CommandError", "Commanded", "command_of", "commanded"]

#: The verb of the plan that makes what a drive counts larger, and what it moves.
MOTIONS: dict[str, Kind] = {
    step.verb: step.kind
    for step in (HoistStep, PayOutStep, TraverseStep, TravelStep, LuffStep, SlewStep, VeerStep)
    if issubclass(step, MovingStep)
}
_ROUNDING = 1 + 1e-9
#: Position and velocity of what a drive of the core moves [m or rad, and per s].
Drive = Callable[[str], tuple[float, float]]


class CommandError(ValueError):
    """A drive cannot be commanded like this; the message says why."""


@dataclass(frozen=True)
class Commanded:
    """What a program moves.

    Attributes:
        name: as the plan says it, in full.
        motion: verb of the plan.
        mover: its limits.
        boom: the boom that takes a hook up and down, if one that luffs does.
    """

    name: str
    motion: str
    mover: Mover
    boom: Mover | None = None

    def state(self, drive: Drive) -> tuple[float, float]:
        """Where it is, as `to` counts it, and how fast it moves there [m or rad, and per s]."""
        position, velocity = drive(drives_of(self.mover)[0])
        gear, reel = self.mover.gear, self.mover.reel
        if reel is not None:
            position, velocity = reel.gone(position), velocity * reel.rate(position)
        if gear is None:
            head, rising = self.head(drive)
            return position + self.mover.zero + head, velocity + rising
        angle = gear.angle(position)
        return angle, velocity / gear.rate(angle, angle)

    def head(self, drive: Drive) -> tuple[float, float]:
        """How far the boom head of a hook has gone up since the start, and how fast it does [m, m/s]."""
        head = self.mover.head
        if head is None or self.boom is None:
            return 0.0, 0.0
        angle, turning = Commanded(self.boom.name, "luff", self.boom).state(drive)
        return head.rise(angle), head.rate(angle) * turning


def commanded(scenario: Scenario, text: str, motion: str | None) -> Commanded:
    """What a name means, and a verb of the plan where the name alone does not say it.

    Raises:
        CommandError: If it means nothing, or several things, or something that nothing drives.
    """
    text = str(text)  # what is no name is refused as one that means nothing
    if motion is not None and motion not in tuple(MOTIONS):
        raise CommandError(f"motion: {motion!r} is none; {nearest(str(motion), MOTIONS)}")
    known = {verb: movers(scenario, kind) for verb, kind in MOTIONS.items() if motion in (None, verb)}
    found = {verb: full_name(text, of) for verb, of in known.items()}
    fitting = [(verb, name) for verb, name in found.items() if name is not None]
    if not fitting:
        names = dict.fromkeys(name for of in known.values() for name in of)
        if scenario.mechanics is not None and text in scenario.mechanics.bodies:
            takes = "commands are for hooks, trolleys, cranes, booms, drums, winches and chain hoists"
            which = f"known here: {', '.join(map(repr, names))}" if names else "this lift has none"
            sentence = f"'{text}' is a body of 'mechanics', and moves as its joint lets it"
            raise CommandError(f"{sentence}; {takes}; {which}")
        can = "can move" if motion is None else f"can {motion}"
        raise CommandError(f"'{text}' is nothing in this lift that {can}; {nearest(str(text), names)}")
    if len(fitting) > 1:
        verbs = ", ".join(verb for verb, _ in fitting)
        sentence = f"'{text}' can move in several ways: {verbs}"
        raise CommandError(f"{sentence}; say which, such as motion='{fitting[0][0]}'")
    verb, name = fitting[0]
    mover = known[verb][name]
    if mover is None:
        raise CommandError(f"'{name}' has nothing that drives it; give it a drive or winch in the lift file")
    boom = next((one for one in movers(scenario, "boom").values() if _bears(one, mover)), None)
    return Commanded(name, verb, mover, boom)


def _bears(boom: Mover | None, mover: Mover) -> bool:
    return boom is not None and mover.head is not None and boom.name == mover.head.boom


def command_of(one: Commanded, speed: object, acceleration: object, drive: Drive) -> Json:
    """The document of a command for the core.

    Args:
        one: what moves.
        speed: signed speed [m/s or rad/s].
        acceleration: limit of it [m/s^2 or rad/s^2]; None for that of the lift file.
        drive: where drives of the core are.

    Raises:
        CommandError: If it is no speed that this can have, or no acceleration.
    """
    mover, name = one.mover, one.name
    speed = _number("speed", speed, "a speed")
    if abs(speed) > mover.speed * _ROUNDING:
        sentence = f"{said(mover.kind, abs(speed), 'speed')} is faster than '{name}' can {one.motion}"
        raise CommandError(f"{sentence}; its highest speed is {said(mover.kind, mover.speed, 'speed')}")
    limit = mover.acceleration if acceleration is None else _number("acceleration", acceleration, "one")
    if limit <= 0.0:
        raise CommandError(f"acceleration: {limit:g} is not above zero; without one its own limit holds")
    if limit > mover.acceleration * _ROUNDING:
        sentence = f"{said(mover.kind, limit, 'acceleration')} is more than '{name}' can do"
        most = said(mover.kind, mover.acceleration, "acceleration")
        raise CommandError(f"{sentence}; its most is {most}")
    limit = min(limit, mover.acceleration)
    up = mover.zero + one.head(drive)[0]
    rate, bounds = 1.0, [end - up for end in mover.range or (-math.inf, math.inf)]
    ends = [_end(end if mover.reel is None else mover.reel.counted(end)) for end in bounds]
    if mover.gear is not None:
        angle, _ = one.state(drive)
        rate = mover.gear.rate(angle, angle)
        ends = [None if mover.range is None else mover.gear.taken_up(end) for end in mover.range or (0, 0)]
    order = {
        "velocity": speed * rate,
        "acceleration": limit * rate,
        "braking": mover.acceleration * rate,
        "range": ends,
        "emergency": stop_of(mover, mover.speed, rate),
    }
    return {
        "name": name,
        "motion": one.motion,
        "speed": speed,
        "acceleration": limit,
        "orders": [{"drive": of, **order} for of in drives_of(mover)],
    }


def _end(position: float) -> float | None:
    return position if math.isfinite(position) else None


def _number(of: str, value: object, what: str) -> float:
    try:
        number = math.nan if isinstance(value, str | bool) else float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not math.isfinite(number):
        raise CommandError(f"{of}: {value!r} is not {what} in m and s, or rad and s")
    return number
