"""Supports under the load: keel blocks, shoring, cribbing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.base import Element, Named
from gantline.scenario.quantities import (
    Angle,
    Damping,
    Length,
    Lengths,
    ListOf,
    Name,
    PositiveMass,
    PositiveStiffness,
    Quantity,
    Ratio,
    Time,
    WordOr,
    refuse,
)

__all__ = ["Grid", "OneSupport", "Place", "Support", "Supports", "supports_of"]

#: Sides of the top of a support, if the lift file does not say them [m].
USUAL_TOP = (0.6, 0.6)
#: Stiffness and damping of a support, if the lift file does not say them [N/m, N s/m].
USUAL_STIFFNESS, USUAL_DAMPING = 100e6, 1e6

#: A height, or the word that the load's underside gives it.
_Height = Annotated[float | Literal["to_load"], WordOr(("to_load",), Quantity("length", "positive"))]
_Plan = Annotated[tuple[float, float], ListOf(Quantity("length"), 2)]
_Top = Annotated[tuple[float, float], ListOf(Quantity("length", "positive"), 2)]


class Grid(Element):
    """Supports in rows and columns."""

    what: ClassVar[str] = "a grid of supports"

    x: Lengths = Field(description="Places along the length.")
    y: Lengths = Field(description="Places across.")


class _Words(Element):
    height: _Height | None = Field(
        None,
        description="Height of the top above the foot; or 'to_load': up to the underside of the load "
        "where it is at the start, before it sinks in, as if cut to it.",
    )
    stiffness: PositiveStiffness | None = Field(
        None, description="Stiffness; 100 MN/m if nothing says it, hardwood on concrete."
    )
    damping: Damping | None = Field(None, description="Damping; 1 MN s/m if nothing says it.")
    friction: Ratio | None = Field(
        None, description="Coefficient of friction under the load; 0 if nothing says it."
    )
    capacity: PositiveMass | None = Field(None, description="Capacity; not checked if nothing says it.")
    top: _Top | None = Field(
        None,
        description="Length and breadth of the flat top, along the axes of the grid; 0.6 m by 0.6 m if "
        "nothing says it. The load leaves the support at its edge.",
    )
    removed_at: Time | None = Field(None, description="Time at which it is taken away.")


class OneSupport(_Words):
    """What one support of a grid has of its own."""

    what: ClassVar[str] = "one support"


class Place(_Words):
    """A support at a place of its own."""

    what: ClassVar[str] = "a place of a support"

    at: _Plan = Field(description="Place of its middle: along the length, across.")


class Supports(_Words):
    """A group of supports under the load: a grid, or named places, or both."""

    what: ClassVar[str] = "a group of supports"

    under: Name = Field(description="What they stand under: the name of the load.")
    grid: Grid | None = Field(
        None, description="Supports in rows and columns, called <number along x>.<number along y>."
    )
    places: Named[Place] | None = Field(None, description="Supports at places of their own, by name.")
    each: Named[OneSupport] | None = Field(
        None, description="What single supports of the grid have of their own, by their names, such as '2.3'."
    )
    measured_from: Literal["load", "world"] = Field(
        "load",
        description="'load': places are on the load as it is at the start, from its datum along its axes; "
        "'world': they are in the world, along axes turned by 'heading'.",
    )
    heading: Angle = Field(0.0, description="Of places in the world: direction of x, from world x towards y.")
    foot: Length | None = Field(
        None, description="Level of what they stand on; that of the ground if not given, 0 without ground."
    )

    @model_validator(mode="after")
    def _somewhere(self) -> Supports:
        if self.grid is None and self.places is None:
            raise refuse("supports need places: 'grid: {x: [-6 m, 6 m], y: [-3 m, 3 m]}', or 'places'")
        if self.each is not None and self.grid is None:
            raise refuse("'each' is for supports of a grid, and there is no 'grid'")
        if "heading" in self.model_fields_set and self.measured_from == "load":
            raise refuse("'heading' is for places in the world; write 'measured_from: world'")
        return self


@dataclass(frozen=True)
class Support:
    """One support, with everything that its group says.

    Attributes:
        name: `<group>.<name>`.
        group: name of its group.
        at: place of its middle in the frame of its group [m].
        height: of its top above the foot [m]; 0 where that is up to the load, until its shape is known.
        is_cut: whether its top is up to the load.
        stiffness: [N/m].
        damping: [N s/m].
        friction: coefficient.
        capacity: as a mass [kg]; None if nothing says it.
        top: sides of its top [m].
        removed_at: when it is taken away [s]; None if not at a time.
    """

    name: str
    group: str
    at: tuple[float, float]
    height: float
    is_cut: bool
    stiffness: float
    damping: float
    friction: float
    capacity: float | None
    top: tuple[float, float]
    removed_at: float | None


def supports_of(name: str, group: Supports) -> list[Support]:
    """All supports of a group, in the order of the file, a grid along y first.

    Args:
        name: of the group.
        group: as the lift file has it.
    """
    found: list[tuple[str, tuple[float, float], _Words]] = []
    if group.grid is not None:
        each = group.each or {}
        for column, x in enumerate(group.grid.x, start=1):
            for row, y in enumerate(group.grid.y, start=1):
                own = f"{column}.{row}"
                found.append((own, (x, y), each.get(own, group)))
    found += [(own, place.at, place) for own, place in (group.places or {}).items()]
    return [_support(name, group, *one) for one in found]


def _support(name: str, group: Supports, own: str, at: tuple[float, float], words: _Words) -> Support:
    def either(key: str, usual: float) -> float:
        value = getattr(words, key)
        value = getattr(group, key) if value is None else value
        return usual if value is None else float(value)

    height = group.height if words.height is None else words.height
    removed_at = group.removed_at if words.removed_at is None else words.removed_at
    return Support(
        name=f"{name}.{own}",
        group=name,
        at=at,
        height=0.0 if height is None or height == "to_load" else height,
        is_cut=height == "to_load",
        stiffness=either("stiffness", USUAL_STIFFNESS),
        damping=either("damping", USUAL_DAMPING),
        friction=either("friction", 0.0),
        capacity=group.capacity if words.capacity is None else words.capacity,
        top=words.top or group.top or USUAL_TOP,
        removed_at=removed_at,
    )
