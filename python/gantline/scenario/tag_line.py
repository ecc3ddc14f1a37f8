"""Tag lines: thin ropes that keep the heading of a load, or turn it."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.afloat.mooring import Winch, body_of
from gantline.scenario.base import Element
from gantline.scenario.plan.parting import BREAKS_SHOWN, CUT_SHOWN, BreaksAt
from gantline.scenario.quantities import (
    Name,
    Position,
    PositiveForce,
    PositiveMass,
    PositiveSpeed,
    Quantity,
    Time,
    WordOr,
    refuse,
)

__all__ = ["TagLine", "tag_rope", "tag_tugger"]

#: Highest speed of a tugger where the lift file has none: 30 m/min [m/s].
TUGGER_SPEED = 0.5
#: What turns in a tugger, or moves with the rope where people hold it, where the lift file has nothing [kg].
TUGGER_MASS = 20.0


class TagLine(Element):
    """A rope from the load to people, a bollard or a tugger."""

    what: ClassVar[str] = "a tag line"

    at: Position = Field(
        description="Where it is made fast to the load, in the load's own axes, as lugs are."
    )
    to: Position = Field(
        description="Where it is held: in the world, or in the axes of what 'held_by' names."
    )
    held_by: Name | None = Field(
        None,
        description="What it leads to: a vessel, a part of a crane, a body of 'mechanics'; the world if not "
        "given.",
    )
    rope: Name = Field(description="Kind of rope, a name of 'ropes'.")
    pull: PositiveForce | None = Field(
        None, description="Tension that people or a tugger keep in it, hauling in and giving way."
    )
    speed: PositiveSpeed | None = Field(
        None,
        description="Highest speed at which they haul in, with 'pull'; 30 m/min if not given. A load that "
        "comes faster makes it slack.",
    )
    rotating_mass: PositiveMass | None = Field(
        None, description="Mass that moves with the rope at its end, with 'pull'; 20 kg if not given."
    )
    length: (
        Annotated[float | Literal["as_routed"], WordOr(("as_routed",), Quantity("length", "positive"))] | None
    ) = Field(None, description="Unstretched length of one made fast; 'as_routed': just taut at the start.")
    pretension: PositiveForce | None = Field(
        None, description="Tension of one made fast, the load where it is at the start; in place of 'length'."
    )
    winch: Winch | None = Field(
        None,
        description="Winch at its end, by which steps haul and veer one with a length; none if not given.",
    )
    breaks_at: BreaksAt | None = Field(None, description=f"{BREAKS_SHOWN} As its rope if not given.")
    cut_at: Time | None = Field(None, description=CUT_SHOWN)

    @model_validator(mode="after")
    def _one_way_to_hold_it(self) -> TagLine:
        ways = ("pull", "length", "pretension")
        given = [f"'{key}'" for key in ways if getattr(self, key) is not None]
        if len(given) != 1:
            sentence = "a tag line has one of 'pull', 'length' and 'pretension'"
            raise refuse(f"{sentence}; found {' and '.join(given) or 'none of them'}")
        for key in ("speed", "rotating_mass"):
            if self.pull is None and getattr(self, key) is not None:
                raise refuse(f"'{key}' is of a line whose 'pull' is kept; this one is made fast", key)
        if self.pull is not None and self.winch is not None:
            raise refuse("a line whose 'pull' is kept moves by itself; 'winch' goes with a length", "winch")
        if self.winch is not None:
            self.winch.refuse_weak(self.pretension)
        return self

    @property
    def holder(self) -> str | None:
        """The body that it leads to; None is the world."""
        return body_of(self.held_by)


def tag_rope(name: str) -> str:
    """Name of a tag line among the ropes of a recording."""
    return f"tag.{name}"


def tag_tugger(name: str) -> str:
    """Name of the rope that its tugger has paid out, among the joints of a recording."""
    return f"{tag_rope(name)}.tugger"
