"""Lugs: where slings take hold of a load or a spreader, and how their main plates stand."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar

from pydantic import Discriminator, Field, Tag, model_validator

from gantline.scenario.base import Element
from gantline.scenario.file.tree import MapNode
from gantline.scenario.quantities import Angle, Direction, Name, Position, PositiveMass, Word, refuse

__all__ = ["Lug", "LugType", "MainPlate"]

#: Directions that span the main plate of a lug, and the normal to them on the load.
PLATE_NORMALS: dict[str, tuple[float, float, float]] = {
    "xz": (0.0, 1.0, 0.0),
    "yz": (1.0, 0.0, 0.0),
    "xy": (0.0, 0.0, 1.0),
}


class MainPlate(Element):
    """How a main plate stands that lies along no two axes."""

    what: ClassVar[str] = "a main plate"

    turned: Angle | None = Field(
        None, description="Upright, and turned from the plane xz about the load's z, from x towards y."
    )
    normal: Direction | None = Field(
        None, description="Direction across the plate along the load's axes, three plain numbers."
    )

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """A plate is turned or has a normal."""
        if ("turned" in data) == ("normal" in data):
            right = "right is 'turned: 30 deg' of an upright plate, or 'normal: [0.5, -0.5, 0.7]' across any"
            said = " and ".join(f"'{key}'" for key in data) or "nothing"
            raise refuse(f"found {said}; {right}")

    @model_validator(mode="after")
    def _has_a_direction(self) -> MainPlate:
        if self.normal is not None and not any(self.normal):
            raise refuse("three zeros are no direction; [0, 1, 0] is the normal of 'xz'", "normal")
        return self

    @property
    def across(self) -> tuple[float, float, float]:
        """Unit vector across the plate, the load's axes."""
        if self.normal is None:
            turned = self.turned or 0.0
            return (-math.sin(turned), math.cos(turned), 0.0)
        length = math.hypot(*self.normal)
        x, y, z = (part / length for part in self.normal)
        return (x, y, z)


def _plate_kind(value: Any) -> str:
    return "a direction" if isinstance(value, (dict, MainPlate)) else "a word"


PlateOfLug = Annotated[
    Annotated[
        str,
        Word(
            tuple(PLATE_NORMALS),
            ("{turned: 30 deg} of an upright plate", "{normal: [0.5, -0.5, 0.7]} of any"),
        ),
        Tag("a word"),
    ]
    | Annotated[MainPlate, Tag("a direction")],
    Discriminator(_plate_kind),
]


class LugType(Element):
    """What several lugs have in common."""

    what: ClassVar[str] = "a lug type"

    main_plate: PlateOfLug | None = Field(
        None, description="Plane of the lug's main plate, or how it stands; xz if nothing says so."
    )
    capacity: PositiveMass | None = Field(None, description="Capacity in the plane of the main plate.")

    def or_of(self, kind: LugType | None) -> LugType:
        """The same, with what is not said here taken from a type."""
        plate = self.main_plate or (kind.main_plate if kind is not None else None)
        capacity = self.capacity
        if capacity is None and kind is not None:
            capacity = kind.capacity
        return LugType.model_construct(main_plate=plate, capacity=capacity)

    @property
    def main_plate_normal(self) -> tuple[float, float, float]:
        """Unit vector across the main plate, the load's axes."""
        plate = self.main_plate or "xz"
        return plate.across if isinstance(plate, MainPlate) else PLATE_NORMALS[plate]


class Lug(LugType):
    """A lifting lug."""

    what: ClassVar[str] = "a lug"

    type: Name | None = Field(None, description="A name of 'lug_types' that gives what is not said here.")
    at: Position = Field(description="Position of the hole from the datum, along the load's axes.")
