"""What luffs a boom: a drive that prescribes its angle, or tackles from the top of an A-frame to its head.

docs/concepts/booms.md has the equations.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, ClassVar

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.quantities import (
    ListOf,
    Name,
    Number,
    Position,
    PositiveAngularAcceleration,
    PositiveAngularSpeed,
    PositiveLength,
    PositiveRotationalStiffness,
    Quantity,
    Time,
    refuse,
)
from gantline.scenario.rope_weight import RopeWeightWord

__all__ = ["Luffing", "LuffingGear", "Tackles", "TurningDrive", "luffing_drum", "luffing_ropes"]

_Angles = Annotated[tuple[float, float], ListOf(Quantity("angle"), 2)]


class Tackles(Element):
    """Luffing tackles side by side, all on one winch."""

    what: ClassVar[str] = "a set of luffing tackles"

    count: Annotated[int, Number(least=1, most=16, whole=True)] = Field(
        1,
        description="Tackles side by side, evenly from 'from' to as far on the other side of the boom's "
        "middle.",
    )
    parts: Annotated[int, Number(least=1, most=60, whole=True)] = Field(
        description="Parts of line of each between top and boom head. The dead end is at the top where they "
        "are even, at the head where they are odd."
    )
    rope: Name = Field(description="Kind of rope, a name of 'ropes'.")
    sheave_diameter: PositiveLength | None = Field(
        None, description="Pitch diameter of the smallest sheave that they bend about, for checks alone."
    )
    from_: Position = Field(
        alias="from",
        description="Top from which they pull, in the axes of the vessel or of the crane's base; its y is "
        "that of the outermost one, and of the only one.",
    )
    lead_line: PositiveLength = Field(
        5.0, description="Rope from the last sheave at the top down to the drum."
    )
    rope_weight: RopeWeightWord | None = Field(
        None,
        description="How the weight of the ropes acts: 'none', or 'lumped' to top and boom head. If not "
        "given: 'lumped' where the mass per length of the rope is known, else 'none'.",
    )
    stop_stiffness: PositiveRotationalStiffness | None = Field(
        None,
        description="Stiffness of the stops at both ends of the range; one that gives way by 0.001 rad under "
        "the level boom if not given.",
    )
    stop_damping_time: Time = Field(0.01, description="Damping over stiffness of the stops.")


class TurningDrive(Element):
    """What turns a boom or an upper structure."""

    speed: PositiveAngularSpeed = Field(description="Highest speed.")
    acceleration: PositiveAngularAcceleration = Field(
        description="Highest acceleration; also used where a step names none."
    )
    emergency_acceleration: PositiveAngularAcceleration | None = Field(
        None, description="Deceleration of an emergency stop; the acceleration if not given."
    )


class Luffing(TurningDrive):
    """What luffs a boom."""

    what: ClassVar[str] = "luffing"

    range_: _Angles = Field(alias="range", description="Least and largest angle of the boom.")
    tackles: Tackles | None = Field(
        None, description="Ropes in which the boom hangs; without them its angle is as told."
    )

    @model_validator(mode="after")
    def _range_is_one(self) -> Luffing:
        low, high = self.range_
        if not 0 <= low < high:
            sentence = "a range goes from the least to the largest angle, from 0 deg on"
            least, most = (f"{math.degrees(one):g} deg" for one in (low, high))
            raise refuse(f"{sentence}; found {least} to {most}", "range")
        if high > math.pi / 2:
            sentence = f"{math.degrees(high):g} deg is past plumb, where a boom falls back onto its crane"
            raise refuse(f"{sentence}; a range ends at 90 deg at the most", "range")
        return self


@dataclass(frozen=True)
class LuffingGear:
    """How long tackles are at an angle of the boom, without stretch; the drum takes up what they get shorter.

    The law of cosines in the plane of boom and top, both at their distances from the heel pins.

    Attributes:
        reach: distance of the top from the heel pins [m].
        direction: angle of that line over the plane of the base [rad].
        length: length of the boom [m].
        start: angle of the boom at the start [rad].
    """

    reach: float
    direction: float
    length: float
    start: float

    def distance(self, angle: float) -> float:
        """From the top to the boom head at an angle [rad] of the boom [m]."""
        between = self.direction - angle
        square = self.reach**2 + self.length**2 - 2 * self.reach * self.length * math.cos(between)
        return math.sqrt(square)

    def taken_up(self, angle: float) -> float:
        """How much shorter each tackle is at an angle [rad] than at the start [m]: what its drive counts."""
        return self.distance(self.start) - self.distance(angle)

    def angle(self, taken_up: float) -> float:
        """The angle [rad] at which that is taken up [m]; at the ends of what can be, the angle there."""
        distance = self.distance(self.start) - taken_up
        cosine = (self.reach**2 + self.length**2 - distance**2) / (2 * self.reach * self.length)
        return self.direction - math.acos(min(max(cosine, -1.0), 1.0))

    def rate(self, first: float, second: float) -> float:
        """Mean of what is taken up per angle between two angles [rad], where they are one there [m/rad]."""
        if abs(second - first) < 1e-9:
            lever = self.reach * self.length * math.sin(self.direction - first)
            return lever / self.distance(first)
        return (self.taken_up(second) - self.taken_up(first)) / (second - first)


def luffing_drum(boom: str) -> str:
    """Name of the drum of luffing tackles in recordings."""
    return f"{boom}.drum"


def luffing_ropes(crane: str, tackles: Tackles) -> list[str]:
    """Names of the ropes of luffing tackles in recordings."""
    return [f"luff.{crane}.{place}" for place in range(1, tackles.count + 1)]
