"""What stands in the yard: docks, boxes, upright cylinders."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.base import Element, with_a_type
from gantline.scenario.quantities import (
    Angle,
    Damping,
    Length,
    ListOf,
    PositiveLength,
    PositiveStiffness,
    Quantity,
    Ratio,
    refuse,
)

if TYPE_CHECKING:
    from gantline.scenario.model import Scenario

__all__ = ["BoxStructure", "CylinderStructure", "Dock", "Structure", "dock_of", "ground_at"]

_Extent = Annotated[tuple[float, float], ListOf(Quantity("length"), 2)]


class _Structure(Element):
    friction: Ratio | None = Field(
        None, description="Coefficient of friction; that of the ground if not given, 0 without ground."
    )
    stiffness: PositiveStiffness | None = Field(
        None, description="Stiffness at each place that touches; that of the ground if not given."
    )
    damping: Damping | None = Field(
        None, description="Damping at each place that touches; that of the ground if not given."
    )

    @abstractmethod
    def extents(self) -> dict[str, tuple[float, float]]:
        """Its extents by their keys, each from less to more [m]."""

    @model_validator(mode="after")
    def _in_order(self) -> _Structure:
        for key, (least, most) in self.extents().items():
            if least >= most:
                raise refuse(f"'{key}' goes from {least:g} m to {most:g} m; from less to more is right")
        return self


class Dock(_Structure):
    """A dock: a hole in the ground with upright walls and a level floor."""

    what: ClassVar[str] = "a dock"

    type: Literal["dock"] = Field(description="Kind of structure.")
    x: _Extent = Field(description="From wall to wall along world x.")
    y: _Extent = Field(description="From wall to wall along world y.")
    floor: Length = Field(description="Level of the floor.")

    def extents(self) -> dict[str, tuple[float, float]]:
        """Its extents in plan."""
        return {"x": self.x, "y": self.y}


class BoxStructure(_Structure):
    """A building, a wall, a stack: a box along the axes of the world, or turned about its middle."""

    what: ClassVar[str] = "a box"

    type: Literal["box"] = Field(description="Kind of structure.")
    x: _Extent = Field(description="Extent along world x.")
    y: _Extent = Field(description="Extent along world y.")
    z: _Extent = Field(description="Extent in height.")
    heading: Angle = Field(
        0.0, description="How far it is turned about its middle, from world x towards y; 0 if not given."
    )

    def extents(self) -> dict[str, tuple[float, float]]:
        """Its three extents."""
        return {"x": self.x, "y": self.y, "z": self.z}

    @property
    def size(self) -> tuple[float, float, float]:
        """Its sides along its own axes [m]."""
        return self.x[1] - self.x[0], self.y[1] - self.y[0], self.z[1] - self.z[0]

    @property
    def middle(self) -> tuple[float, float, float]:
        """Its middle in the world [m]."""
        return sum(self.x) / 2, sum(self.y) / 2, sum(self.z) / 2

    def depth(self, place: Sequence[float]) -> float:
        """How deep a place lies in it, from the nearest side [m]; below zero outside."""
        east, north, up = (one - middle for one, middle in zip(place, self.middle, strict=True))
        cosine, sine = math.cos(self.heading), math.sin(self.heading)
        own = (east * cosine + north * sine, north * cosine - east * sine, up)
        return min(side / 2 - abs(one) for one, side in zip(own, self.size, strict=True))


class CylinderStructure(_Structure):
    """A tower, a silo, a column, a leg: an upright cylinder."""

    what: ClassVar[str] = "an upright cylinder"

    type: Literal["cylinder"] = Field(description="Kind of structure.")
    at: Annotated[tuple[float, float], ListOf(Quantity("length"), 2)] = Field(
        description="Its middle, world x and y."
    )
    diameter: PositiveLength = Field(description="Diameter.")
    z: _Extent = Field(description="Extent in height.")

    def extents(self) -> dict[str, tuple[float, float]]:
        """Its extent in height."""
        return {"z": self.z}

    def depth(self, place: Sequence[float]) -> float:
        """How deep a place lies in it, from the nearest side [m]; below zero outside."""
        out = math.hypot(place[0] - self.at[0], place[1] - self.at[1])
        return min(self.diameter / 2 - out, place[2] - self.z[0], self.z[1] - place[2])


Structure = Annotated[
    Dock | BoxStructure | CylinderStructure,
    Field(discriminator="type"),
    with_a_type("dock", "box", "cylinder"),
]


def dock_of(scenario: Scenario) -> Dock | None:
    """The dock of a lift, if there is one."""
    return next((one for one in (scenario.structures or {}).values() if isinstance(one, Dock)), None)


def ground_at(scenario: Scenario, x: float, y: float) -> float | None:
    """Height of the ground at a place, or of the floor of the dock there [m]; None where there is none."""
    if scenario.ground is None:
        return None
    dock = dock_of(scenario)
    is_in_dock = dock is not None and dock.x[0] <= x <= dock.x[1] and dock.y[0] <= y <= dock.y[1]
    return dock.floor if dock is not None and is_in_dock else scenario.ground.level
