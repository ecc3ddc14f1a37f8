"""Water around bodies and in them: hulls, added mass, damping, tanks."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from gantline.scenario.afloat.stream import CURRENT_SHOWN, WIND_SHOWN, StreamArea
from gantline.scenario.base import Element, Named
from gantline.scenario.file.tree import MapNode
from gantline.scenario.quantities import (
    Angle,
    Damping,
    Flag,
    Inertia,
    Length,
    Mass,
    Number,
    Position,
    PositiveLength,
    Quantity,
    Ratio,
    RotationalDamping,
    Sizes,
    SymmetricMatrix,
    Text,
    WordOr,
    refuse,
)

__all__ = [
    "MOTIONS",
    "SEA_WATER",
    "AddedMass",
    "Afloat",
    "BallastTank",
    "Extent",
    "Hole",
    "HullShape",
    "Radiation",
    "Water",
    "WaterDamping",
    "WaveForces",
]

#: Density of sea water [kg/m^3].
SEA_WATER = 1025.0
#: No water is lighter or heavier [kg/m^3]: boiling it has 958, that of salt lakes 1240.
LIGHTEST_WATER, HEAVIEST_WATER = 900.0, 1300.0
#: Motions of a body along and about its x, y, z.
MOTIONS = ("surge", "sway", "heave", "roll", "pitch", "yaw")
ORIGIN = (0.0, 0.0, 0.0)
#: Share of the ideal flow that passes a hole with sharp edges: the jet contracts to it.
SHARP_EDGED = 0.6

Density = Annotated[float, Quantity("density", "positive")]

Matrix = tuple[tuple[float, ...], ...]
#: Least and largest x, y, z.
Extent = tuple[tuple[float, float, float], tuple[float, float, float]]


class Water(Element):
    """Water with a level surface."""

    what: ClassVar[str] = "water"

    density: Density = Field(SEA_WATER, description="Density; that of sea water if not given.")
    level: Length = Field(0.0, description="Height of its surface; 0 if not given.")
    depth: PositiveLength | None = Field(
        None, description="Depth, which decides how long waves are; deep if not given."
    )

    @model_validator(mode="after")
    def _is_water(self) -> Water:
        if not LIGHTEST_WATER <= self.density <= HEAVIEST_WATER:
            found = f"{self.density:g} kg/m^3 is not the density of water"
            raise refuse(f"{found}; fresh water has 1000 kg/m^3, sea water 1025 kg/m^3", "density")
        return self


class HullShape(Element):
    """A hull: a box along the body's axes, or a mesh from a CAD file."""

    what: ClassVar[str] = "a hull"

    box: Sizes | None = Field(None, description="Length, breadth and depth: sizes along x, y, z of the body.")
    keel: Position | None = Field(
        None, description="Middle of the box's bottom in the body's axes; their origin if not given."
    )
    mesh: Text | None = Field(
        None, description="CAD file beside the lift file with the outside of the hull: STL, OBJ, GLB or STEP."
    )
    units: Literal["m", "mm", "cm"] | None = Field(
        None, description="Unit of length of that file; what it says itself, else m, if not given."
    )
    scale: Annotated[float, Number(least=1e-3, most=1e3)] = Field(
        1.0, description="Factor on all lengths of that file, of a model for instance."
    )
    up: Literal["y", "z"] | None = Field(
        None, description="Axis of that file that points up; y in glTF and z elsewhere if not given."
    )
    half: Flag = Field(
        False,
        description="true: the file has one side of the hull, up to its centre plane y = 0; it is mirrored.",
    )
    at: Position = Field(ORIGIN, description="Where the origin of that file is in the body's axes.")

    @property
    def bottom(self) -> tuple[float, float, float]:
        """Middle of the box's bottom in the body's axes [m]."""
        return ORIGIN if self.keel is None else self.keel

    @property
    def extent(self) -> Extent | None:
        """Least and largest x, y, z of a box in the body's axes [m]; None of a mesh, whose file knows."""
        if self.box is None:
            return None
        (length, breadth, depth), (x, y, z) = self.box, self.bottom
        return (x - length / 2, y - breadth / 2, z), (x + length / 2, y + breadth / 2, z + depth)

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """A hull is one thing."""
        if "box" in data and "mesh" in data:
            raise refuse("a hull is a 'box' or comes from a 'mesh', not both", "mesh")
        if "box" not in data and "mesh" not in data:
            raise refuse("a hull is 'box: [100 m, 30 m, 8 m]' or 'mesh: hull.obj'")
        for key in ("units", "scale", "up", "half", "at"):
            if key in data and "mesh" not in data:
                raise refuse(f"'{key}' is for a hull from a 'mesh'; a box has its 'keel'", key)
        if "keel" in data and "box" not in data:
            raise refuse("'keel' is for a hull that is a 'box'; a mesh has 'at'", "keel")


class _ByFile(Element):
    """What comes from a hydrodynamic database, or may; a base."""

    body: Text | None = Field(None, description="Body of the database, where it has several.")
    heading_in_file: Angle = Field(
        0.0,
        description="Direction of this body's x axis in the axes of the database, from its x towards y.",
    )


class _OfWater(_ByFile):
    """A matrix over the motions of a body: by axes, whole, or from a hydrodynamic database."""

    at: Position = Field(
        ORIGIN,
        description="Point that it is about, in the body's axes: for a 'database' its reference point.",
    )
    database: Text | None = Field(
        None, description="Hydrodynamic database beside the lift file: .nc, .h5, .dhyd or .hyd."
    )
    period: (
        Annotated[
            float | Literal["infinite_frequency"],
            WordOr(("infinite_frequency",), Quantity("time", "positive")),
        ]
        | None
    ) = Field(
        None, description="Period of the motion at which the database is read, or 'infinite_frequency'."
    )

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """It is given in one way."""
        given = [key for key in ("database", "matrix") if key in data]
        if len(given) == 2:
            raise refuse("it is a 'matrix' or comes from a 'database', not both", "matrix")
        for key in MOTIONS if given else ():
            if key in data:
                raise refuse(f"'{key}' is part of the '{given[0]}'; leave one of them out", key)
        if "database" in data:
            if "at" not in data:
                raise refuse("'at' is missing: where the database's reference point is in the body's axes")
            if "period" not in data:
                raise refuse("'period' is missing; it is written like '9 s', or 'infinite_frequency'")
        for key in ("body", "heading_in_file", "period"):
            if key in data and "database" not in data:
                right = f"without one each motion has its own number, {', '.join(MOTIONS)}"
                raise refuse(f"'{key}' is for a 'database'; {right}", key)

    @property
    def diagonal(self) -> list[float]:
        """What it is given by axes, in the order of `MOTIONS` [SI]."""
        return [getattr(self, motion) for motion in MOTIONS]


class AddedMass(_OfWater):
    """Water that moves along with a body, constant, along the body's axes."""

    what: ClassVar[str] = "added mass"

    surge: Mass = Field(0.0, description="Along x.")
    sway: Mass = Field(0.0, description="Along y.")
    heave: Mass = Field(0.0, description="Along z.")
    roll: Inertia = Field(0.0, description="About x.")
    pitch: Inertia = Field(0.0, description="About y.")
    yaw: Inertia = Field(0.0, description="About z.")
    matrix: Annotated[Matrix, SymmetricMatrix("mass", "mass_moment", "inertia")] | None = Field(
        None, description="All of it: six rows over surge, sway, heave, roll, pitch, yaw."
    )

    @model_validator(mode="after")
    def _not_negative(self) -> AddedMass:
        for key in ("roll", "pitch", "yaw"):
            if getattr(self, key) < 0:
                raise refuse("added inertia must be zero or more", key)
        return self


class WaterDamping(_OfWater):
    """What still water resists a body's motion with, linear, along the body's axes."""

    what: ClassVar[str] = "damping by water"

    surge: Damping = Field(0.0, description="Along x.")
    sway: Damping = Field(0.0, description="Along y.")
    heave: Damping = Field(0.0, description="Along z.")
    roll: RotationalDamping = Field(0.0, description="About x.")
    pitch: RotationalDamping = Field(0.0, description="About y.")
    yaw: RotationalDamping = Field(0.0, description="About z.")
    matrix: Annotated[Matrix, SymmetricMatrix("damping", "coupled_damping", "rotational_damping")] | None = (
        Field(None, description="All of it: six rows over surge, sway, heave, roll, pitch, yaw.")
    )

    @model_validator(mode="after")
    def _radiates(self) -> WaterDamping:
        if self.period == "infinite_frequency":
            raise refuse("at infinite frequency no waves are made and nothing damps; give a period", "period")
        return self


class Radiation(_ByFile):
    """Added mass and damping of all frequencies: waves that a body makes push it until they are gone."""

    what: ClassVar[str] = "radiation"

    database: Text = Field(
        description="Hydrodynamic database beside the lift file, of many periods: .nc, .h5, .dhyd or .hyd."
    )
    at: Position = Field(description="Where its reference point is in the body's axes.")


class WaveForces(_ByFile):
    """What waves do to a vessel, by a hydrodynamic database."""

    what: ClassVar[str] = "wave forces"

    database: Text = Field(description="Hydrodynamic database beside the lift file: .nc, .h5 or .dhyd.")
    at: Position = Field(description="Where its reference point is in the vessel's axes.")
    drift: Flag | None = Field(
        None, description="Whether its drift forces push as well; if not given, where the database has any."
    )
    drift_damping: Flag = Field(
        True, description="Whether drift forces change with the slow way that it makes, which damps this."
    )


class Hole(Element):
    """A hole of a tank: liquid runs out, or water around in, by the difference of heads."""

    what: ClassVar[str] = "a hole of a tank"

    at: Position = Field(
        description="Its middle in the body's axes, in the tank or a side of it; of a load from its datum."
    )
    area: Annotated[float, Quantity("area", "positive")] = Field(description="Its clear area.")
    discharge: Ratio = Field(
        SHARP_EDGED, description="Share of the ideal flow that passes: 0.6 of sharp edges, as if not given."
    )
    closed: Flag = Field(
        False, description="Whether it is closed at the start, until a step opens it by 'open_holes'."
    )

    @model_validator(mode="after")
    def _lets_pass(self) -> Hole:
        if not 0.0 < self.discharge <= 1.0:
            found = f"a share of {self.discharge:g} of the ideal flow passes no hole"
            raise refuse(f"{found}; it is above 0 and at most 1: 0.6 of sharp edges", "discharge")
        return self


class BallastTank(Element):
    """A box-shaped tank, along the body's axes; its liquid stays level."""

    what: ClassVar[str] = "a tank"

    box: Sizes = Field(description="Length, breadth and depth inside: sizes along x, y, z of the body.")
    bottom: Position = Field(
        description="Middle of its bottom in the body's axes; of a load from its datum, as all on it."
    )
    content: Mass = Field(description="Mass of the liquid, beside the body's own mass.")
    density: Density = Field(SEA_WATER, description="Density of the liquid; sea water if not given.")
    holes: Named[Hole] | None = Field(
        None,
        description="Holes by name by which it drains or floods, open from the start on unless 'closed'.",
    )

    @model_validator(mode="after")
    def _holds_it(self) -> BallastTank:
        if self.content > self.capacity * (1 + 1e-9):
            found = f"{self.content / 1e3:g} t do not go into it"
            raise refuse(f"{found}; it holds {self.capacity / 1e3:.6g} t", "content")
        return self

    @property
    def capacity(self) -> float:
        """Mass of the liquid that goes into it [kg]."""
        return math.prod(self.box) * self.density

    @property
    def extents(self) -> tuple[tuple[float, float], ...]:
        """From where to where its inside goes along x, y, z of the body [m]."""
        (length, breadth, depth), (x, y, z) = self.box, self.bottom
        return (x - length / 2, x + length / 2), (y - breadth / 2, y + breadth / 2), (z, z + depth)

    @property
    def depth(self) -> float:
        """How deep it is filled, upright [m]."""
        return self.content / (self.density * self.box[0] * self.box[1])

    @property
    def is_slack(self) -> bool:
        """True where the liquid has a free surface."""
        return 0 < self.depth < self.box[2] * (1 - 1e-9)


class Afloat(Element):
    """What water does to a body, and what is in its tanks; a base of bodies that may float."""

    hull: HullShape | None = Field(None, description="What of it displaces water; nothing if not given.")
    added_mass: AddedMass | None = Field(None, description="Water that moves along with it.")
    water_damping: WaterDamping | None = Field(None, description="What water resists its motion with.")
    radiation: Radiation | None = Field(
        None, description="Added mass and damping of all frequencies, with memory, in place of 'added_mass'."
    )
    tanks: Named[BallastTank] | None = Field(None, description="Tanks with liquid in it, by name.")
    wind_areas: Named[StreamArea] | None = Field(None, description=WIND_SHOWN)
    current_areas: Named[StreamArea] | None = Field(None, description=CURRENT_SHOWN)

    @model_validator(mode="after")
    def _radiates_once(self) -> Self:
        if self.radiation is None:
            return self
        if self.added_mass is not None:
            raise refuse("'radiation' holds the added mass of all frequencies; leave one out", "added_mass")
        if self.water_damping is not None and self.water_damping.database is not None:
            sentence = "'radiation' holds the damping of all frequencies; leave the 'database' out"
            raise refuse(f"{sentence}: what stands here comes on top", "water_damping")
        return self

    @property
    def is_carried(self) -> bool:
        """Whether it moves as it is told, so that nothing that pushes it counts."""
        return False

    @property
    def floats_freely(self) -> bool:
        """Whether it has a hull, and nothing but forces hold it."""
        return self.hull is not None and not self.is_carried
