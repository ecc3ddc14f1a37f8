"""The load: its shape, weight, centre of gravity and lugs."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal

from pydantic import Discriminator, Field, Tag

from gantline.scenario.base import Element, Named
from gantline.scenario.quantities import (
    Angle,
    Inertia,
    Margins,
    Name,
    Number,
    Position,
    PositiveInertia,
    PositiveMass,
    Sizes,
    refuse,
)
from gantline.scenario.tree import MapNode

__all__ = ["CentreOfGravity", "Load", "LoadInertia", "Lug", "LugType", "Shape", "Weight"]

#: Directions that span the main plate of a lug, and the normal to them on the load.
PLATE_NORMALS: dict[str, tuple[float, float, float]] = {
    "xz": (0.0, 1.0, 0.0),
    "yz": (1.0, 0.0, 0.0),
    "xy": (0.0, 0.0, 1.0),
}


class Shape(Element):
    """The shape of a load."""

    what: ClassVar[str] = "the shape of a load"

    box: Sizes = Field(description="Length x, breadth y, height z.")

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """A shape from CAD is known to the format but not to this version."""
        if "cad" in data:
            raise refuse(
                "a shape from CAD cannot be simulated yet; a box can: 'box: [10 m, 10 m, 5 m]'", "cad"
            )


class Weight(Element):
    """The weight of a load, as a mass."""

    what: ClassVar[str] = "the weight of a load"

    calculated: PositiveMass = Field(description="Calculated or weighed weight, without margin.")
    contingency: Annotated[float, Number(least=1.0, most=2.0)] = Field(
        1.0, description="Weight contingency factor, at least 1."
    )
    simulate: Literal["calculated", "design"] = Field(
        "calculated", description="Which weight is simulated: 'calculated', or 'design' (with contingency)."
    )

    @property
    def design(self) -> float:
        """Design weight as a mass [kg]."""
        return self.calculated * self.contingency

    @property
    def simulated(self) -> float:
        """Mass that is simulated [kg]."""
        return self.design if self.simulate == "design" else self.calculated


class LoadInertia(Element):
    """Inertia about the centre of gravity, along the load's own axes; products as off-diagonal terms."""

    what: ClassVar[str] = "the inertia of a load"

    xx: PositiveInertia = Field(description="About the axis along the length.")
    yy: PositiveInertia = Field(description="About the axis across.")
    zz: PositiveInertia = Field(description="About the vertical axis.")
    xy: Inertia = Field(0.0, description="Off-diagonal term xy.")
    xz: Inertia = Field(0.0, description="Off-diagonal term xz.")
    yz: Inertia = Field(0.0, description="Off-diagonal term yz.")


class CentreOfGravity(Element):
    """Where the centre of gravity of a load is."""

    what: ClassVar[str] = "centre_of_gravity"

    at: Position = Field(description="Position from the datum, along the load's axes.")
    envelope: Margins = Field((0.0, 0.0, 0.0), description="Plus and minus, along x, y, z.")


class LugType(Element):
    """What several lugs have in common."""

    what: ClassVar[str] = "a lug type"

    main_plate: Literal["xz", "yz", "xy"] | None = Field(
        None, description="Plane of the lug's main plate; xz if nothing says so."
    )
    capacity: PositiveMass | None = Field(None, description="Capacity in the plane of the main plate.")

    def or_of(self, kind: LugType | None) -> LugType:
        """The same, with what is not said here taken from a type."""
        plate = self.main_plate or (kind.main_plate if kind is not None else None)
        capacity = self.capacity
        if capacity is None and kind is not None:
            capacity = kind.capacity
        return LugType.model_construct(main_plate=plate or "xz", capacity=capacity)


class Lug(LugType):
    """A lifting lug."""

    what: ClassVar[str] = "a lug"

    type: Name | None = Field(None, description="A name of 'lug_types' that gives what is not said here.")
    at: Position = Field(description="Position of the hole from the datum, along the load's axes.")


def _inertia_kind(value: Any) -> str:
    return "some values" if isinstance(value, (dict, LoadInertia)) else "a word"


InertiaOfLoad = Annotated[
    Annotated[Literal["homogeneous"], Tag("a word")] | Annotated[LoadInertia, Tag("some values")],
    Discriminator(_inertia_kind),
]


class Load(Element):
    """The load that is lifted: a rigid body."""

    what: ClassVar[str] = "the load"

    name: Name = Field(description="Name of the load; lugs are called <name>.<lug>.")
    shape: Shape = Field(description="Shape: a box.")
    datum: Literal["bottom_centre"] = Field(
        "bottom_centre",
        description="Point from which positions on the load are measured, along its own axes.",
    )
    position: Position = Field((0.0, 0.0, 0.0), description="Position of the datum in the world.")
    heading: Angle = Field(0.0, description="Direction of the load's x axis, from world x towards y.")
    weight: Weight = Field(description="Weight, as a mass.")
    inertia: InertiaOfLoad = Field(
        "homogeneous", description="'homogeneous' (a solid box), or values about the centre of gravity."
    )
    centre_of_gravity: CentreOfGravity = Field(description="Centre of gravity.")
    stands_on: Name | None = Field(
        None, description="What the load stands on at the start: 'ground', or a group of 'supports'."
    )
    lugs: Named[Lug] = Field(description="Lifting lugs by name.")
