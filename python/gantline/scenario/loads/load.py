"""The load: its shape, weight, centre of gravity and lugs."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Discriminator, Field, Tag

from gantline.scenario.afloat.stream import CURRENT_SHOWN, ORIGIN, WIND_SHOWN, LoadArea, StreamArea
from gantline.scenario.afloat.water import BallastTank
from gantline.scenario.base import Element, Named
from gantline.scenario.errors import shorten
from gantline.scenario.file.tree import MapNode
from gantline.scenario.loads.cylinder import Cylinder
from gantline.scenario.loads.in_water import InWater
from gantline.scenario.loads.lug import Lug
from gantline.scenario.quantities import (
    Angle,
    Inertia,
    ListOf,
    Margins,
    Name,
    Number,
    Position,
    PositiveInertia,
    PositiveLength,
    PositiveMass,
    Quantity,
    Sizes,
    Text,
    Word,
    WordOr,
    refuse,
)

__all__ = ["CentreOfGravity", "Load", "LoadInertia", "Outfitting", "Shape", "Weight"]


class Shape(Element):
    """The shape of a load."""

    what: ClassVar[str] = "the shape of a load"

    box: Sizes | None = Field(None, description="Length x, breadth y, height z.")
    cylinder: Cylinder | None = Field(None, description="A cylinder, tube or cone.")
    cad: Text | None = Field(
        None, description="CAD file beside the lift file: OCX, STEP, IGES, STL, OBJ, glTF or GLB."
    )
    units: Literal["m", "mm", "cm"] | None = Field(
        None, description="Unit of length of the CAD file; what it says itself, or a guess, if not given."
    )
    thickness: PositiveLength | None = Field(
        None, description="Plate thickness of open surfaces of the CAD file, which say none."
    )
    up: Literal["y", "z"] | None = Field(
        None, description="Axis of the CAD file that points up; y in glTF and z elsewhere if not given."
    )

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """A shape is one thing."""
        kinds = [key for key in ("box", "cylinder", "cad") if key in data]
        if len(kinds) > 1:
            raise refuse("a shape is a 'box', a 'cylinder' or comes from 'cad', one of them", kinds[1])
        if not kinds:
            given = ", ".join(f"'{shorten(key)}'" for key in data)
            says = f"found {given}; " if given else ""
            if {"pipe", "tube"} & set(data):
                says += "a tube is a 'cylinder' with a 'wall'; "
            raise refuse(
                f"{says}a shape is 'box: [10 m, 10 m, 5 m]', 'cylinder: {{diameter: 6 m, length: 40 m}}' or "
                "'cad: load.3docx'"
            )
        for key in ("units", "thickness", "up"):
            if key in data and "cad" not in data:
                wall = "; a tube has a 'wall'" if key == "thickness" and "cylinder" in data else ""
                right = f"a {kinds[0]} says its units{wall}"
                raise refuse(f"'{key}' is for a shape from 'cad'; {right}", key)

    @property
    def sizes(self) -> tuple[float, float, float] | None:
        """The box about it along the load's x, y, z [m]; None of a CAD file, which says it later."""
        return self.box if self.cylinder is None else self.cylinder.sizes

    @property
    def seen(self) -> tuple[float, float, float] | None:
        """Areas that it shows along the load's x, y, z [m^2]; None of a CAD file."""
        if self.cylinder is not None:
            return self.cylinder.seen
        if self.box is None:
            return None
        length, breadth, height = self.box
        return breadth * height, length * height, length * breadth

    @property
    def middle(self) -> tuple[float, float, float] | None:
        """Middle of what it shows from any side, from the bottom centre [m]; None of a CAD file."""
        if self.cylinder is not None:
            return self.cylinder.middle
        return None if self.box is None else (0.0, 0.0, self.box[2] / 2.0)


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


#: A position, or the word that CAD file and outfitting give it.
PositionOrCad = Annotated[
    tuple[float, float, float] | Literal["from_cad"], WordOr(("from_cad",), ListOf(Quantity("length"), 3))
]


class LoadInertia(Element):
    """Inertia about the centre of gravity, along the load's own axes; products as off-diagonal terms."""

    what: ClassVar[str] = "the inertia of a load"

    xx: PositiveInertia = Field(description="About the axis along the length.")
    yy: PositiveInertia = Field(description="About the axis across.")
    zz: PositiveInertia = Field(description="About the vertical axis.")
    xy: Inertia = Field(0.0, description="Off-diagonal term xy, minus the integral of x y over the mass.")
    xz: Inertia = Field(0.0, description="Off-diagonal term xz, minus the integral of x z over the mass.")
    yz: Inertia = Field(0.0, description="Off-diagonal term yz, minus the integral of y z over the mass.")


class CentreOfGravity(Element):
    """Where the centre of gravity of a load is."""

    what: ClassVar[str] = "centre_of_gravity"

    at: PositionOrCad = Field(description="Position from the datum, along the load's axes; or 'from_cad'.")
    envelope: Margins = Field((0.0, 0.0, 0.0), description="Plus and minus, along x, y, z.")


class Outfitting(Element):
    """What stands on a load and is not in its CAD file: a point mass."""

    what: ClassVar[str] = "a piece of outfitting"

    name: Text = Field(description="What it is.")
    mass: PositiveMass = Field(description="Mass.")
    at: Position = Field(
        description="Position of its centre of gravity from the datum, along the load's axes."
    )


def _inertia_kind(value: Any) -> str:
    return "some values" if isinstance(value, (dict, LoadInertia)) else "a word"


InertiaOfLoad = Annotated[
    Annotated[
        str,
        Word(("homogeneous", "from_cad"), ("values about the centre of gravity, {xx: 900 t m^2, ...}",)),
        Tag("a word"),
    ]
    | Annotated[LoadInertia, Tag("some values")],
    Discriminator(_inertia_kind),
]


class Load(Element):
    """The load that is lifted: a rigid body."""

    what: ClassVar[str] = "the load"

    name: Name = Field(description="Name of the load; lugs are called <name>.<lug>.")
    shape: Shape = Field(description="Shape: a box, a cylinder, or a CAD file.")
    datum: Literal["bottom_centre", "origin"] | None = Field(
        None,
        description="Point from which positions on the load are measured, along its own axes: "
        "'bottom_centre' of its box, or 'origin' of its CAD file. If not given: the origin of a CAD file, "
        "else the bottom centre.",
    )
    position: Position = Field((0.0, 0.0, 0.0), description="Position of the datum in the world.")
    heading: Angle = Field(0.0, description="Direction of the load's x axis, from world x towards y.")
    weight: Weight = Field(description="Weight, as a mass.")
    inertia: InertiaOfLoad | None = Field(
        None,
        description="'homogeneous' (a solid box, a cylinder or a tube of its wall), 'from_cad' (of its CAD "
        "file and the outfitting, scaled to the weight), or values about the centre of gravity. If not "
        "given: 'from_cad' for a shape from CAD, else 'homogeneous'.",
    )
    outfitting: list[Outfitting] = Field(
        default_factory=list, description="Part of the weight that is not in the CAD file, as point masses."
    )
    centre_of_gravity: CentreOfGravity = Field(description="Centre of gravity.")
    stands_on: Name | None = Field(
        None, description="What the load stands on at the start: 'ground', or a group of 'supports'."
    )
    lugs: Named[Lug] = Field(
        default_factory=dict,
        description="Lifting lugs by name; a load in baskets of `mechanics` may have none.",
    )
    wind_areas: Named[LoadArea] | None = Field(None, description=WIND_SHOWN)
    current_areas: Named[LoadArea] | None = Field(None, description=CURRENT_SHOWN)
    in_water: InWater | None = Field(
        None, description="What water does to it where it is lowered into it; nothing if not given."
    )
    tanks: Named[BallastTank] | None = Field(
        None, description="Tanks with liquid in it, by name; it comes on top of the weight."
    )

    @property
    def is_at_origin(self) -> bool:
        """Whether positions are measured from the origin of the CAD file."""
        return self.shape.cad is not None and self.datum != "bottom_centre"

    def areas_in(self, stream: Literal["wind", "current"]) -> dict[str, StreamArea]:
        """What wind or current pushes on, each with its area."""
        given = self.wind_areas if stream == "wind" else self.current_areas
        found = {}
        for name, one in (given or {}).items():
            area, at = one.area, ORIGIN
            if area is None:
                assert self.shape.seen is not None  # checked
                assert self.shape.middle is not None
                area, at = self.shape.seen["xyz".index(one.along)], self.shape.middle
            found[name] = StreamArea.model_construct(
                area=area, coefficient=one.coefficient, along=one.along, at=one.at or at
            )
        return found

    @property
    def contents(self) -> float:
        """Mass of the liquid in its tanks at the start [kg]."""
        return math.fsum(tank.content for tank in (self.tanks or {}).values())

    @property
    def room(self) -> float:
        """Mass of the liquid that goes into all of its tanks [kg]."""
        return math.fsum(tank.capacity for tank in (self.tanks or {}).values())

    @property
    def room_volume(self) -> float:
        """Volume of the inside of all of its tanks [m^3]."""
        return math.fsum(math.prod(tank.box) for tank in (self.tanks or {}).values())

    @property
    def mass_at_start(self) -> float:
        """Simulated weight with what is in its tanks at the start, as a mass [kg]."""
        return self.weight.simulated + self.contents
