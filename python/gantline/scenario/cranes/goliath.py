"""The Goliath crane: a girder on two legs that travels along rails, trolleys that traverse along it.

An overhead crane is one without legs, whose girder stands on end carriages on the rails of a hall.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal, NamedTuple

from pydantic import Field, model_validator

from gantline.scenario.base import Element, Named
from gantline.scenario.cranes.hook_parts import CarriedHook
from gantline.scenario.quantities import (
    Flag,
    Length,
    ListOf,
    Mass,
    NotNegativeLength,
    PositiveAcceleration,
    PositiveLength,
    PositiveMass,
    PositiveSpeed,
    PositiveStiffness,
    Quantity,
    Ratio,
    refuse,
)

__all__ = [
    "EndCarriages",
    "Girder",
    "Goliath",
    "GoliathLegs",
    "Standing",
    "Traverse",
    "Trolley",
    "TrolleyHook",
]

_Range = Annotated[tuple[float, float], ListOf(Quantity("length"), 2)]


class TrolleyHook(CarriedHook):
    """A hook under a trolley."""

    what: ClassVar[str] = "a hook of a trolley"

    across: Length = Field(0.0, description="Place across the girder, from its centre line along y.")
    along: Length = Field(0.0, description="Place along the girder, from the trolley's position along x.")


class Traverse(Element):
    """What drives a trolley along the girder, or the crane along its rails."""

    what: ClassVar[str] = "a traverse or travel drive"

    speed: PositiveSpeed = Field(description="Highest speed.")
    acceleration: PositiveAcceleration = Field(
        description="Highest acceleration; also used where a step names none."
    )
    emergency_acceleration: PositiveAcceleration | None = Field(
        None, description="Deceleration of an emergency stop; the acceleration if not given."
    )
    range_: _Range = Field(alias="range", description="Least and largest position, between the end stops.")

    @model_validator(mode="after")
    def _range_is_one(self) -> Traverse:
        low, high = self.range_
        if low >= high:
            sentence = f"a range goes from its least to its largest position; found {low:g} m to {high:g} m"
            raise refuse(sentence, "range")
        return self


class Trolley(Element):
    """A trolley on the girder with its hooks."""

    what: ClassVar[str] = "a trolley"

    mass: PositiveMass = Field(description="Mass with winches, without hook blocks and hanging falls.")
    rated_capacity: PositiveMass | None = Field(
        None, description="Rated capacity of its hooks together; that of each hook alone if not given."
    )
    position: Length = Field(description="Position along the girder at the start, x.")
    traverse: Traverse = Field(description="Its drive along the girder.")
    hooks: Named[TrolleyHook] = Field(description="Its hooks by name; each is called <crane>.<hook>.")


class Girder(Element):
    """The girder between the legs, or the end carriages."""

    what: ClassVar[str] = "the girder of a Goliath crane"

    underside: Length = Field(description="Height of its underside above the rails.")
    mass: PositiveMass = Field(description="Mass.")
    vertical_stiffness: PositiveStiffness | None = Field(
        None, description="Stiffness against bending under a load at mid-span; rigid if not given."
    )
    damping: Ratio = Field(0.01, description="Damping of its bending, share of critical; 1 % if not given.")

    @model_validator(mode="after")
    def _damping_is_less_than_critical(self) -> Girder:
        if self.damping >= 1:
            raise refuse(f"{self.damping * 100:g} % of critical damping; below 100 % is right", "damping")
        return self


class GoliathLegs(Element):
    """Legs, sills and bogies."""

    what: ClassVar[str] = "the legs of a Goliath crane"

    fixed: Mass = Field(description="Mass of the fixed leg, rigid with the girder.")
    hinged: Mass = Field(description="Mass of the hinged leg.")
    bogies: Mass = Field(0.0, description="Mass of sills and bogies of both legs together.")
    fixed_leg_at: Length | None = Field(
        None,
        description="Place of the fixed leg along the girder, -span/2 or span/2; the first if not given.",
    )
    base: PositiveLength | None = Field(
        None, description="Distance of the two corners of each leg along its rail, for loads of the corners."
    )


class EndCarriages(Element):
    """The carriages on which the girder of an overhead crane stands, one at each end."""

    what: ClassVar[str] = "the end carriages of an overhead crane"

    mass: PositiveMass = Field(description="Mass of both together.")
    base: PositiveLength | None = Field(
        None,
        description="Distance of the two corners of each along its rail, for loads of the corners.",
    )


class Standing(NamedTuple):
    """What a girder stands on: legs, or end carriages as bogies under legs that weigh nothing.

    Attributes:
        fixed: Mass of the fixed leg [kg].
        hinged: Mass of the hinged leg [kg].
        bogies: Mass of what is at the height of the rails, both sides together [kg].
        base: Distance of the two corners of each side along its rail [m]; None if not given.
        at: Place of the fixed leg along the girder [m]; of end carriages that of the first, at the least x.
    """

    fixed: float = 0.0
    hinged: float = 0.0
    bogies: float = 0.0
    base: float | None = None
    at: float = 0.0


class Goliath(Element):
    """A Goliath crane: x along the girder from mid-span, y along the rails, z from that of the world.

    Either on legs, or on end carriages: an overhead crane, whose rails are at a height.
    """

    what: ClassVar[str] = "a Goliath crane"

    type: Literal["goliath"] = Field(description="Type of crane: 'goliath'.")
    rated_capacity: PositiveMass | None = Field(None, description="Rated capacity of all hooks together.")
    rating_includes_hook_block: Flag = Field(
        False,
        description="true: rated capacities are compared with hoist loads, false: with hook loads.",
    )
    span: PositiveLength = Field(description="Distance of the rails.")
    position: Length = Field(
        0.0, description="Place of the girder's centre line along the rails at the start, y."
    )
    girder: Girder = Field(description="The girder.")
    legs: GoliathLegs | None = Field(None, description="The legs; an overhead crane has none.")
    end_carriages: EndCarriages | None = Field(
        None, description="In place of legs the end carriages of an overhead crane."
    )
    rail_level: Length = Field(0.0, description="Height of the rails in the world; 0 if not given.")
    travel: Traverse | None = Field(None, description="Its drive along the rails; it stands if not given.")
    wind_limit: PositiveSpeed | None = Field(None, description="Largest gust in which it may lift.")
    hook_approach: NotNegativeLength | None = Field(
        None, description="Smallest distance of a hook from a rail, along the girder."
    )
    hook_distance: NotNegativeLength | None = Field(
        None, description="Smallest distance along the girder of hooks of different trolleys."
    )
    trolleys: Named[Trolley] = Field(description="Trolleys by name.")

    @model_validator(mode="after")
    def _stands_on_something(self) -> Goliath:
        if self.legs is None and self.end_carriages is None:
            legs, carriages = "'legs: {fixed: 700 t, hinged: 450 t}'", "'end_carriages: {mass: 8 t}'"
            right = f"{legs} is right, or {carriages} of an overhead crane"
            raise refuse(f"nothing says what the girder stands on; {right}")
        if self.legs is not None and self.end_carriages is not None:
            sentence = "a girder stands on 'legs', or on 'end_carriages' where it is an overhead crane"
            raise refuse(f"{sentence}; found both", "end_carriages")
        if self.legs is not None and self.girder.underside <= 0.0:
            sentence = (
                f"the underside of a girder on legs is above their rails; found {self.girder.underside:g} m"
            )
            raise refuse(sentence, "girder")
        return self

    @model_validator(mode="after")
    def _fits_its_span(self) -> Goliath:
        at = None if self.legs is None else self.legs.fixed_leg_at
        if at is not None and abs(abs(at) - self.span / 2) > 1e-6 * self.span:
            sentence = f"the fixed leg would be at {at:g} m"
            raise refuse(
                f"{sentence}; with this span it is at {-self.span / 2:g} m or {self.span / 2:g} m", "legs"
            )
        return self

    @property
    def standing(self) -> Standing:
        """What the girder stands on."""
        first, legs = -self.span / 2, self.legs
        if legs is not None:
            at = first if legs.fixed_leg_at is None else legs.fixed_leg_at
            return Standing(legs.fixed, legs.hinged, legs.bogies, legs.base, at)
        carriages = self.end_carriages
        mass, base = (0.0, None) if carriages is None else (carriages.mass, carriages.base)
        return Standing(bogies=mass, base=base, at=first)
