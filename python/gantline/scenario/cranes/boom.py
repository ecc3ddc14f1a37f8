"""Booms, luffing and the hooks at a boom head, of every crane that has them; the floating crane.

A boom turns up and down about its heel pins. Its axes begin midway between them: x along the boom to its
head, y along the heel pins to port, z square to both. Its angle is that of x over the plane of its base.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.afloat.vessel import Vessel, VesselMass
from gantline.scenario.base import Element, Named
from gantline.scenario.cranes.hook_parts import CarriedHook
from gantline.scenario.cranes.luffing import Luffing, LuffingGear, Tackles, luffing_ropes
from gantline.scenario.cranes.rating import Rating
from gantline.scenario.cranes.slewing import Slewing, refuse_outside_of_range, upper_body
from gantline.scenario.errors import PathPart
from gantline.scenario.quantities import (
    Angle,
    Flag,
    Length,
    ListOf,
    Mass,
    Name,
    Position,
    PositiveAngle,
    PositiveInertia,
    PositiveLength,
    PositiveMass,
    PositiveSpeed,
    PositiveStiffness,
    Quantity,
    Ratio,
    refuse,
)

__all__ = [
    "Boom",
    "BoomHook",
    "BoomParts",
    "FloatingCrane",
    "HeelPins",
    "PlacedBoom",
    "boom_name",
    "placed_boom",
]


#: Depth of a boom that nobody gives, over its length [1]: long lattice booms have 2 to 3 %.
_THICK = 0.03

_Axis = Annotated[tuple[float, float], ListOf(Quantity("length"), 2)]


class HeelPins(Element):
    """The pins about which a boom turns."""

    what: ClassVar[str] = "the heel pins of a boom"

    at: Position = Field(description="Midway between them, in the axes of the vessel or of the crane's base.")
    apart: PositiveLength = Field(description="Distance of the two, across the boom.")


class BoomParts(Element):
    """All of a boom but where its heel pins are, which each type of crane says in its own way."""

    what: ClassVar[str] = "a boom"

    length: PositiveLength = Field(
        description="From the heel pins to the pin of the upper sheaves at its head."
    )
    angle: PositiveAngle = Field(description="Angle over the plane of its base at the start.")
    mass: PositiveMass = Field(description="Mass, without head gear and without what hangs at the head.")
    centre_of_gravity: Ratio = Field(
        0.5,
        description="Its centre of gravity as share of the length, from the heel pins; 50 % if not given.",
    )
    inertia: PositiveInertia | None = Field(
        None, description="Inertia about its centre of gravity, across; of a slender rod if not given."
    )
    head_gear: Mass = Field(
        0.0, description="Mass fixed at its head, without the sheave blocks that hang there."
    )
    depth: PositiveLength | None = Field(
        None,
        description="How deep it is where it is drawn and kept clear of; 3 % of its length if not given.",
    )
    width: PositiveLength | None = Field(
        None,
        description="How wide it is there, across; half of the distance of its heel pins if not given, and "
        "3 % of its length at least.",
    )
    vertical_stiffness: PositiveStiffness | None = Field(
        None,
        description="Stiffness of the crane, without its hoist ropes, against a force down at the head, with "
        "the boom at its angle at the start; rigid if not given.",
    )
    side_stiffness: PositiveStiffness | None = Field(
        None, description="Stiffness against a force across the boom at the head; rigid if not given."
    )
    damping: Ratio = Field(
        0.01, description="Damping where the boom gives, share of critical; 1 % if not given."
    )

    @model_validator(mode="after")
    def _gives_with_damping(self) -> BoomParts:
        if "damping" in self.model_fields_set and not self.gives:
            sentence = "a boom that is rigid has nothing to damp"
            raise refuse(f"{sentence}; give it a 'vertical_stiffness', or leave this out", "damping")
        if self.damping >= 1:
            raise refuse(f"{self.damping * 100:g} % of critical damping; below 100 % is right", "damping")
        return self

    @model_validator(mode="after")
    def _is_possible(self) -> BoomParts:
        if self.centre_of_gravity > 1:
            share = f"{self.centre_of_gravity * 100:g} %"
            raise refuse(
                f"{share} of the length is beyond the head; 100 % or less is right", "centre_of_gravity"
            )
        if self.angle >= math.pi / 2:
            raise refuse("a boom stands below 90 deg; an angle like '60 deg' is right", "angle")
        return self

    @property
    def gives(self) -> bool:
        """Whether it is not rigid, up and down or aside."""
        return self.vertical_stiffness is not None or self.side_stiffness is not None

    @property
    def section_depth(self) -> float:
        """How deep it is drawn and watched [m]."""
        return _THICK * self.length if self.depth is None else self.depth

    def section_width(self, apart: float) -> float:
        """How wide it is drawn and watched [m], of one with heel pins that are `apart` [m]."""
        return max(apart / 2, _THICK * self.length) if self.width is None else self.width

    @property
    def own_inertia(self) -> float:
        """Inertia about its centre of gravity, across [kg m^2]."""
        return self.mass * self.length**2 / 12 if self.inertia is None else self.inertia


class Boom(BoomParts):
    """A boom with heel pins in the axes of its base."""

    heel_pins: HeelPins = Field(description="The pins about which it turns.")


class BoomHook(CarriedHook):
    """A hook at a boom head."""

    what: ClassVar[str] = "a hook of a boom"

    across: Length = Field(0.0, description="Place across the boom head, from the boom's middle to port.")
    along: Length = Field(
        0.0,
        description="Place along the boom, from its head outwards: of a hook on a jib, or, negative, of one "
        "between heel pins and head.",
    )
    above: Length = Field(
        0.0, description="Place square to the boom, from its middle line upwards; negative below it."
    )
    rating: Rating | None = Field(
        None,
        description="Rating chart of this hook alone, in place of that of its crane: of an auxiliary hook, "
        "say. What it does not say of 'between', attitudes and leads is as in that of the crane.",
    )


class FloatingCrane(Element):
    """A floating crane: a boom on a vessel that luffs, and slews if it has an axis to slew about."""

    what: ClassVar[str] = "a floating crane"

    type: Literal["floating_crane"] = Field(description="Type of crane: 'floating_crane'.")
    vessel: Name | None = Field(None, description="The vessel that bears it, a name of 'vessels'.")
    position: Position | None = Field(
        None, description="Of a crane that stands still, without a vessel: where its axes begin in the world."
    )
    heading: Angle = Field(
        0.0, description="Of a crane that stands still: direction of its x axis, from world x towards y."
    )
    outreach_from: Length | None = Field(
        None,
        description="From which x of its axes outreach counts; from the bow of its vessel if not given, or "
        "from the heel pins without one.",
    )
    slewing_axis: _Axis | None = Field(
        None,
        description="Of a crane that slews: place of the slewing axis, x and y in the crane's axes. All "
        "places of the crane are said as they are with the boom ahead, along x.",
    )
    slew: Angle = Field(0.0, description="Direction of the boom at the start, from ahead to port.")
    slewing: Slewing | None = Field(None, description="What slews it; it keeps its angle if not given.")
    upper_masses: Named[VesselMass] | None = Field(
        None,
        description="What slews with the boom beside it, by name: machinery, A-frame, counterweight.",
    )
    rated_capacity: PositiveMass | None = Field(None, description="Rated capacity of all hooks together.")
    rating_includes_hook_block: Flag = Field(
        False,
        description="true: rated capacities are compared with hoist loads, false: with hook loads.",
    )
    boom: Boom = Field(description="The boom.")
    luffing: Luffing | None = Field(None, description="What luffs the boom; it keeps its angle if not given.")
    rating: Rating | None = Field(None, description="Rating chart.")
    wind_limit: PositiveSpeed | None = Field(None, description="Largest gust in which it may lift.")
    hooks: Named[BoomHook] = Field(
        description="Hooks in a row across the boom head, by name; each is called <crane>.<hook>."
    )

    @model_validator(mode="after")
    def _stands_somewhere(self) -> FloatingCrane:
        if (self.vessel is None) == (self.position is None):
            found = "none of them" if self.vessel is None else "both"
            right = "'vessel: <name>', or 'position' of one that stands still"
            raise refuse(f"has one of 'vessel' and 'position'; found {found}, and right is {right}")
        if self.vessel is not None and "heading" in self.model_fields_set:
            raise refuse("its vessel says where it points; leave 'heading' out", "heading")
        return self

    @model_validator(mode="after")
    def _slews_about_an_axis(self) -> FloatingCrane:
        if self.slewing_axis is None:
            for key in ("slew", "slewing", "upper_masses"):
                if key in self.model_fields_set:
                    right = "'slewing_axis: [60 m, 0 m]', say, in the axes of the vessel"
                    raise refuse(f"a crane that slews needs the place of its axis: {right}", key)
            return self
        if self.outreach_from is not None:
            sentence = "a crane that slews counts a radius from its 'slewing_axis'; leave this out"
            raise refuse(sentence, "outreach_from")
        refuse_outside_of_range(self.slew, self.slewing)
        return self


@dataclass(frozen=True)
class PlacedBoom:
    """A boom with what bears it.

    Attributes:
        crane: name of its crane.
        name: full name, of its body and joint.
        base: body that bears the heel pins.
        boom: the boom.
        heel: midway between the heel pins, axes of the base [m].
        apart: distance of the heel pins [m].
        luffing: what luffs it.
        hooks: hooks at its head by name.
        reach_from: from where outreach or radius counts, level and along the boom, axes of the base [m].
        path: where the lift file has the crane.
        slew: its direction at the start [rad] and what slews it, of a boom on an upper structure, which is
            its base then; None of another.
    """

    crane: str
    name: str
    base: str
    boom: BoomParts
    heel: tuple[float, float, float]
    apart: float
    luffing: Luffing | None
    hooks: Mapping[str, BoomHook]
    reach_from: tuple[float, float, float]
    path: tuple[PathPart, ...]
    slew: tuple[float, Slewing | None] | None = None

    @property
    def told(self) -> str:
        """Name of what turns exactly as the plan says: the boom itself, or what one that gives hangs on."""
        return f"{self.name}/told" if self.boom.gives else self.name

    @property
    def tackles(self) -> Tackles | None:
        """Its luffing tackles, if it hangs in any."""
        return None if self.luffing is None else self.luffing.tackles

    @property
    def tackles_across(self) -> list[float]:
        """Place of each of them across the boom, from midway between the heel pins [m]."""
        if self.tackles is None:
            return []
        side, count = self.tackles.from_[1] - self.heel[1], self.tackles.count
        return [side * (1 - 2 * place / max(count - 1, 1)) for place in range(count)]

    @property
    def ropes(self) -> list[str]:
        """Names of their ropes."""
        return [] if self.tackles is None else luffing_ropes(self.crane, self.tackles)

    @property
    def gear(self) -> LuffingGear | None:
        """Geometry of its luffing tackles; None without any."""
        if self.tackles is None:
            return None
        top = self.tackles.from_
        back, up = top[0] - self.heel[0], top[2] - self.heel[2]
        return LuffingGear(math.hypot(back, up), math.atan2(up, back), self.boom.length, self.boom.angle)


def boom_name(crane: str) -> str:
    """Full name of the boom of a crane."""
    return f"{crane}.boom"


def placed_boom(name: str, crane: FloatingCrane, vessels: Mapping[str, Vessel]) -> PlacedBoom:
    """The boom of a floating crane with what bears it."""
    if crane.slewing_axis is not None:
        return _slewing_boom(name, crane, crane.slewing_axis)
    pins = crane.boom.heel_pins
    vessel = vessels.get(crane.vessel or "")
    extent = None if vessel is None else vessel.hull.extent
    reach_from = pins.at[0] if extent is None else extent[1][0]
    return PlacedBoom(
        crane=name,
        name=boom_name(name),
        base=name,
        boom=crane.boom,
        heel=pins.at,
        apart=pins.apart,
        luffing=crane.luffing,
        hooks=crane.hooks,
        reach_from=(
            reach_from if crane.outreach_from is None else crane.outreach_from,
            pins.at[1],
            pins.at[2],
        ),
        path=("cranes", name),
    )


def _slewing_boom(name: str, crane: FloatingCrane, axis: tuple[float, float]) -> PlacedBoom:
    """The boom of a floating crane that slews; axes of its upper structure begin on the slewing axis."""
    pins, luffing = crane.boom.heel_pins, crane.luffing

    def from_axis(at: tuple[float, float, float]) -> tuple[float, float, float]:
        return at[0] - axis[0], at[1] - axis[1], at[2]

    if luffing is not None and luffing.tackles is not None:
        moved = luffing.tackles.model_copy(update={"from_": from_axis(luffing.tackles.from_)})
        luffing = luffing.model_copy(update={"tackles": moved})
    return PlacedBoom(
        crane=name,
        name=boom_name(name),
        base=upper_body(name),
        boom=crane.boom,
        heel=from_axis(pins.at),
        apart=pins.apart,
        luffing=luffing,
        hooks=crane.hooks,
        # At the height at which outreach counts too: of an axis that leans each height has another radius.
        reach_from=(0.0, 0.0, pins.at[2]),
        path=("cranes", name),
        slew=(crane.slew, crane.slewing),
    )
