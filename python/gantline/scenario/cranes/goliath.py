"""The Goliath crane: a girder on two legs that travels along rails, trolleys that traverse along it."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

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
    "Girder",
    "Goliath",
    "GoliathLegs",
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
    """The girder between the legs."""

    what: ClassVar[str] = "the girder of a Goliath crane"

    underside: PositiveLength = Field(description="Height of its underside above the rails.")
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


class Goliath(Element):
    """A Goliath crane: x along the girder from mid-span, y along the rails, z from rail level."""

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
    legs: GoliathLegs = Field(description="The legs.")
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
    def _fits_its_span(self) -> Goliath:
        at = self.legs.fixed_leg_at
        if at is not None and abs(abs(at) - self.span / 2) > 1e-6 * self.span:
            sentence = f"the fixed leg would be at {at:g} m"
            raise refuse(
                f"{sentence}; with this span it is at {-self.span / 2:g} m or {self.span / 2:g} m", "legs"
            )
        return self

    @property
    def fixed_leg_at(self) -> float:
        """Where the fixed leg stands along the girder [m]."""
        return -self.span / 2 if self.legs.fixed_leg_at is None else self.legs.fixed_leg_at
