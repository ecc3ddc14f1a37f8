"""What steps of the plan can move: hooks, drums, trolleys, cranes, booms, winches of lines, chain hoists."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import assert_never

from gantline.scenario.afloat.mooring import MooringLine
from gantline.scenario.cranes.boom import FloatingCrane
from gantline.scenario.cranes.crane import FixedHook
from gantline.scenario.cranes.crane_types import AnyCrane
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.cranes.goliath import Goliath, Traverse
from gantline.scenario.cranes.hooks import Hook, full_name, trolley_name
from gantline.scenario.cranes.luffing import Luffing, LuffingGear
from gantline.scenario.cranes.reel import Reel
from gantline.scenario.cranes.slewing import Slewing, upper_body
from gantline.scenario.model import Scenario
from gantline.scenario.plan.steps import Kind
from gantline.scenario.tag_line import TagLine, tag_rope

__all__ = ["Head", "Mover", "mover", "movers"]


@dataclass(frozen=True)
class Head:
    """Where a hook hangs at a boom: its drum stands there, and goes up and down with it.

    Attributes:
        boom: name of the boom.
        along: along the boom from its heel pins [m].
        above: square to that, upwards [m].
        start: angle of the boom at the start [rad].
    """

    boom: str
    along: float
    above: float
    start: float

    def rise(self, angle: float) -> float:
        """How much higher it is at an angle of the boom [rad] than at the start, on a level base [m]."""
        return self._height(angle) - self._height(self.start)

    def rate(self, angle: float) -> float:
        """How fast it rises at an angle of the boom, per turn of that [m/rad]."""
        return self.along * math.cos(angle) - self.above * math.sin(angle)

    def _height(self, angle: float) -> float:
        return self.along * math.sin(angle) + self.above * math.cos(angle)


@dataclass(frozen=True)
class Mover:
    """Something that a step of the plan can move.

    Attributes:
        name: its full name.
        kind: what it is.
        speed: highest speed [m/s, of a boom rad/s].
        acceleration: highest acceleration [m/s^2, rad/s^2].
        capacity: whether a motor with a limit drives it.
        brake: force that its brake holds, along what its drive counts [N]; None is that of the motor.
        emergency: deceleration of an emergency stop [m/s^2, rad/s^2]; None where nobody has said it.
        stops_as_usual: whether that is the usual deceleration, since the lift file says no other.
        start: position at the start, as `to` counts it [m, rad]; None for drums and winches, which have none.
            Of a sling the change of its length, 0 at the start.
        zero: what `to` counts where the drive is at 0 [m, rad].
        range: least and largest position as `to` counts it [m, rad]; None where there is no limit.
        gear: of a boom in tackles what its drive takes up of them [m] at an angle.
        head: of a hook at a boom that luffs: where `to` counts from goes up with it.
        reel: of a hook whose rope lies on its drum in layers how far it goes for what its drive counts.
    """

    name: str
    kind: Kind
    speed: float
    acceleration: float
    capacity: bool = False
    brake: float | None = None
    emergency: float | None = None
    stops_as_usual: bool = False
    start: float | None = None
    zero: float = 0.0
    range: tuple[float, float] | None = None
    gear: LuffingGear | None = None
    head: Head | None = None
    reel: Reel | None = None


def movers(scenario: Scenario, kind: Kind) -> dict[str, Mover | None]:
    """Everything of a kind by its full name; None for a drum or line that nothing drives.

    Steps that move lines move slings with chain hoists too, which are of the kind `sling`.
    """
    if kind == "hook":
        return dict(_hooks(scenario))
    if kind == "drum":
        return _drums(scenario)
    if kind == "line":
        return _winches(scenario) | _chain_hoists(scenario)
    if kind == "boom":
        return dict(_booms(scenario))
    cranes = (scenario.cranes or {}).items()
    return {of: one for name, crane in cranes for of, one in _of_crane(name, crane, kind)}


def mover(scenario: Scenario, kind: Kind, text: str) -> Mover | None:
    """What a word of the plan means; None where it means nothing, or a drum without a drive."""
    known = movers(scenario, kind)
    name = full_name(text, known)
    return None if name is None else known[name]


def _along(name: str, kind: Kind, drive: Traverse | Luffing | Slewing, start: float) -> Mover:
    said = drive.emergency_acceleration
    return Mover(
        name=name,
        kind=kind,
        speed=drive.speed,
        acceleration=drive.acceleration,
        emergency=said or drive.acceleration,
        stops_as_usual=said is None,
        start=start,
        range=drive.range_,
    )


def _hooks(scenario: Scenario) -> dict[str, Mover]:
    found = {}
    for name, hook in scenario.hooks.items():
        hoist, parts = hook.hoist, hook.reeving.parts if hook.reeving is not None else 1
        found[name] = Mover(
            name=name,
            kind="hook",
            speed=hoist.speed,
            acceleration=hoist.acceleration,
            capacity=hoist.capacity is not None,
            brake=None if hoist.brake is None else hoist.brake * parts,
            emergency=hoist.emergency_acceleration,
            start=hook.height,
            zero=hook.height,
            range=None if hook.highest is None else (-float("inf"), hook.highest),
            head=_head(scenario, hook),
            reel=_reel(scenario, hook),
        )
    return found


def _booms(scenario: Scenario) -> Iterator[tuple[str, Mover]]:
    for placed in scenario.booms.values():
        if placed.luffing is not None:
            along = _along(placed.name, "boom", placed.luffing, placed.boom.angle)
            yield placed.crane, replace(along, gear=placed.gear)


def _of_crane(name: str, crane: AnyCrane, kind: Kind) -> Iterator[tuple[str, Mover]]:
    """What of a crane travels, slews or traverses."""
    if isinstance(crane, Goliath):
        if kind == "crane" and crane.travel is not None:
            yield name, _along(name, kind, crane.travel, crane.position)
        for trolley, given in crane.trolleys.items() if kind == "trolley" else ():
            of = trolley_name(name, trolley)
            yield of, _along(of, kind, given.traverse, given.position)
    elif isinstance(crane, Crawler | FloatingCrane):
        if kind == "crane" and isinstance(crane, Crawler) and crane.travel is not None:
            yield name, _along(name, kind, crane.travel, 0.0)
        if kind == "upper" and crane.slewing is not None:
            yield name, _along(upper_body(name), kind, crane.slewing, crane.slew)
    elif not isinstance(crane, FixedHook):
        assert_never(crane)


def _head(scenario: Scenario, hook: Hook) -> Head | None:
    if hook.carrier is None or hook.carrier.kind != "boom":
        return None
    placed = scenario.booms[hook.crane]
    if placed.luffing is None:
        return None
    along, _, above = hook.pin
    return Head(placed.name, along, above, placed.boom.angle)


def _reel(scenario: Scenario, hook: Hook) -> Reel | None:
    drum, reeving = hook.drum, hook.reeving
    if drum is None or reeving is None or drum.wraps_per_layer is None or drum.wraps_at_start is None:
        return None
    rope = (scenario.ropes or {}).get(reeving.rope)
    step = 0.0 if rope is None else drum.step(rope.diameter)
    if step == 0.0:
        return None
    return Reel(reeving.parts_each, drum.diameter / 2, step, drum.wraps_per_layer, drum.wraps_at_start)


def _drums(scenario: Scenario) -> dict[str, Mover | None]:
    drums = scenario.mechanics.drums if scenario.mechanics is not None else None
    found: dict[str, Mover | None] = {}
    for name, drum in (drums or {}).items():
        drive = drum.drive
        if drive is None:
            found[name] = None
            continue
        found[name] = Mover(
            name=name,
            kind="drum",
            speed=drive.speed,
            acceleration=drive.acceleration,
            capacity=drive.capacity is not None,
            brake=drive.brake,
        )
    return found


def _winches(scenario: Scenario) -> dict[str, Mover | None]:
    found: dict[str, Mover | None] = {}
    lines: dict[str, MooringLine | TagLine] = dict(scenario.mooring_lines or {})
    lines |= {tag_rope(name): line for name, line in (scenario.tag_lines or {}).items()}
    for name, line in lines.items():
        winch = line.winch
        if winch is None:
            found[name] = None
            continue
        found[name] = Mover(
            name=name,
            kind="line",
            speed=winch.speed,
            acceleration=winch.acceleration,
            capacity=winch.capacity is not None,
            emergency=winch.acceleration,
        )
    return found


def _chain_hoists(scenario: Scenario) -> dict[str, Mover | None]:
    slings = (scenario.slings or {}).items()
    hoists = {f"sling.{name}": one.chain_hoist for name, one in slings if one.chain_hoist is not None}
    return {
        name: Mover(
            name=name,
            kind="sling",
            speed=hoist.speed,
            acceleration=hoist.acceleration,
            emergency=hoist.acceleration,
            start=0.0,
            range=hoist.range_,
        )
        for name, hoist in hoists.items()
    }
