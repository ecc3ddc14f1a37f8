"""How fast what keeps falls plumb has to go, by the angle of the line of lugs over level.

docs/concepts/plan_and_drives.md has the equations: of what goes straight along the line, of a boom that
luffs, which lifts its hooks or lets them down as it does, and of one that slews.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.scenario import Scenario
from gantline.scenario.consistency.travel import said
from gantline.scenario.cranes.boom import FloatingCrane, PlacedBoom
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.plan.movers import Mover
from gantline.units import format_quantity

__all__ = ["STEEPEST", "Along", "Luffing", "Slewing", "first_angle", "way_of"]

#: Upright lines of lugs have no length from above; short of this their angle is taken to be [rad].
STEEPEST = math.radians(89.9)
#: How closely an angle is looked for [rad].
_CLOSE = 1e-9


@dataclass(frozen=True)
class Along:
    """What goes straight along: a trolley, a crane that travels.

    Attributes:
        way: direction in which it goes, from world x [rad]; it goes back as well.
    """

    way: float

    def turned_by(self, sine: float) -> float:
        """Angle of the lugs [rad] whose ends hoists have brought apart by that share of their distance."""
        return min(math.asin(min(sine, 1.0)), STEEPEST)

    def reaches(self, angle: float) -> bool:
        """Whether it can be where falls are plumb at an angle of the lugs [rad]."""
        return True

    def needed(self, angle: float, hoisted: float) -> float:
        """How fast it has to go [m/s, rad/s] at an angle of the lugs [rad], one end hoisted so fast [m/s]."""
        return hoisted * math.tan(angle)

    def needed_in_words(self, angle: float, hoisted: float) -> str:
        """The same with how it comes about."""
        tangent = f"tan {math.degrees(angle):.1f} deg"
        needed = self.shown(self.needed(angle, hoisted))
        return f"{format_quantity(hoisted, 'm/min', 1)} x {tangent} = {needed}"

    def shown(self, speed: float) -> str:
        """A speed of its drive in words."""
        return format_quantity(speed, "m/min", 1)


class _Turning(Along):
    """What turns, with a speed that no one factor says."""

    def needed_in_words(self, angle: float, hoisted: float) -> str:
        """The same in words."""
        return self.shown(self.needed(angle, hoisted))

    def shown(self, speed: float) -> str:
        """An angular speed in words."""
        return format_quantity(speed, "deg/min", 1)


@dataclass(frozen=True)
class Slewing(_Turning):
    """An upper structure whose boom stands across the line of lugs, as it starts.

    Attributes:
        radius: of what it takes along, from its axis [m].
        askew: angle of its way to the line of lugs [rad].
    """

    radius: float
    askew: float

    def needed(self, angle: float, hoisted: float) -> float:
        """How fast it has to slew [rad/s]."""
        return hoisted * math.tan(angle) / (self.radius * math.cos(self.askew))


@dataclass(frozen=True)
class Luffing(_Turning):
    """A boom over one end of the line of lugs.

    Its angles are those of the line from the heel pins to where its hooks hang.

    Attributes:
        length: of that line [m].
        start: its angle as the lift begins [rad].
        line: distance of the lugs [m].
        level: angle of the lugs as the lift begins [rad].
        side: share of its way that is along the line of lugs; positive where it luffs out as they rise.
        range: least and largest angle of that line [rad].
        said_range: the same of the boom, as the lift file has it [rad].
    """

    length: float
    start: float
    line: float
    level: float
    side: float
    range: tuple[float, float]
    said_range: tuple[float, float]

    def boom(self, angle: float) -> float:
        """Angle of the boom at which falls are plumb at an angle of the lugs; NaN beyond its reach [rad]."""
        nearer = self.line * (math.cos(self.level) - math.cos(angle))
        cosine = math.cos(self.start) + nearer / self.side / self.length
        return math.acos(cosine) if abs(cosine) <= 1.0 else math.nan

    def turned_by(self, sine: float) -> float:
        """The same, with hooks that the boom lifts or lets down; the steepest where it cannot get there."""

        def is_beyond(angle: float) -> bool:
            rise = self.length * (math.sin(self.boom(angle)) - math.sin(self.start))
            return not self.line * math.sin(angle) + rise <= self.line * sine

        end = first_angle(lambda angle: not math.isfinite(self.needed(angle, 1.0)), self.level, STEEPEST)
        return first_angle(is_beyond, self.level, end) if is_beyond(end) else STEEPEST

    def reaches(self, angle: float) -> bool:
        """Whether it is within its range there, and short of where it would have to luff without end."""
        low, high = self.range
        return low - _CLOSE <= self.boom(angle) <= high + _CLOSE and math.isfinite(self.needed(angle, 1.0))

    def needed(self, angle: float, hoisted: float) -> float:
        """How fast it has to luff [rad/s]; infinite where no speed is enough."""
        boom, side = self.boom(angle), abs(self.side)
        up = math.copysign(math.cos(boom) * math.sin(angle), -self.side)
        lever = self.length * (side * math.sin(boom) * math.cos(angle) + up)
        return hoisted * math.sin(angle) / lever if lever > 0.0 else math.inf

    @property
    def range_in_words(self) -> str:
        """Its range."""
        return " to ".join(said("boom", end, "position") for end in self.said_range)


def first_angle(holds: Callable[[float], bool], low: float, high: float) -> float:
    """The least angle [rad] from `low` to `high` from which on something holds; `high` where it does not."""
    if not holds(high):
        return high
    while high - low > _CLOSE:
        middle = (low + high) / 2
        low, high = (low, middle) if holds(middle) else (middle, high)
    return high


def way_of(
    scenario: Scenario, one: Mover, hooks: Sequence[str], towards: float, line: tuple[float, float]
) -> Along | Luffing | Slewing:
    """How something goes along that keeps falls plumb, from where it is as the lift begins.

    Args:
        scenario: The lift.
        one: What goes along.
        hooks: Its hooks whose falls it keeps plumb.
        towards: Direction of the line of lugs from its own hooks to the others, from world x [rad].
        line: Length of that line [m], and how much of that its other end is higher at first [m].
    """
    placed = next((boom for boom in scenario.booms.values() if one.name in (boom.name, boom.base)), None)
    if one.kind == "trolley":
        return Along(0.0)
    if placed is None or one.kind == "crane":
        crane = (scenario.cranes or {}).get(one.name)
        return Along(crane.heading if isinstance(crane, Crawler) else math.pi / 2)
    boom, heading = placed.boom, _heading(scenario, placed)
    along, _, above = np.mean([scenario.hooks[hook].pin for hook in hooks], axis=0)
    length, turned = math.hypot(along, above), math.atan2(above, along)
    if one.kind == "upper":
        radius = placed.heel[0] + length * math.cos(boom.angle + turned)
        way = heading + math.pi / 2
        return Slewing(way, radius, math.remainder(towards - way, math.pi))
    assert one.range is not None  # what luffs has one
    level = math.asin(min(max(line[1] / line[0], -1.0), 1.0))
    side = math.cos(towards - heading)
    low, high = one.range
    ends = low + turned, high + turned
    return Luffing(heading, length, boom.angle + turned, line[0], level, side, ends, one.range)


def _heading(scenario: Scenario, placed: PlacedBoom) -> float:
    """To where a boom points from above as the lift begins, from world x [rad]."""
    crane = (scenario.cranes or {})[placed.crane]
    if isinstance(crane, Crawler):
        return crane.heading + crane.slew
    assert isinstance(crane, FloatingCrane)  # no other crane has a boom
    vessel = (scenario.vessels or {}).get(crane.vessel or "")
    return crane.slew + (crane.heading if vessel is None else vessel.heading)
