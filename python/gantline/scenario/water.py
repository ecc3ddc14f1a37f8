"""Water around bodies and in them: hulls, added mass, damping, tanks."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

from pydantic import Field, model_validator

from gantline.scenario.base import Element, Named
from gantline.scenario.quantities import (
    Damping,
    Inertia,
    Length,
    Mass,
    Position,
    Quantity,
    RotationalDamping,
    Sizes,
    refuse,
)

__all__ = ["MOTIONS", "SEA_WATER", "AddedMass", "Afloat", "BallastTank", "HullShape", "Water", "WaterDamping"]

#: Density of sea water [kg/m^3].
SEA_WATER = 1025.0
#: Motions of a body along and about its x, y, z.
MOTIONS = ("surge", "sway", "heave", "roll", "pitch", "yaw")
ORIGIN = (0.0, 0.0, 0.0)

Density = Annotated[float, Quantity("density", "positive")]
_POINT = "Point that they are about, in the body's axes."


class Water(Element):
    """Still water."""

    what: ClassVar[str] = "water"

    density: Density = Field(SEA_WATER, description="Density; that of sea water if not given.")
    level: Length = Field(0.0, description="Height of its surface; 0 if not given.")


class HullShape(Element):
    """A box-shaped hull, along the body's axes."""

    what: ClassVar[str] = "a hull"

    box: Sizes = Field(description="Length, breadth and depth: sizes along x, y, z of the body.")
    keel: Position | None = Field(
        None, description="Middle of its bottom in the body's axes; their origin if not given."
    )

    @property
    def bottom(self) -> tuple[float, float, float]:
        """Middle of its bottom in the body's axes [m]."""
        return ORIGIN if self.keel is None else self.keel

    @property
    def extent(self) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """Its least and largest x, y, z in the body's axes [m]."""
        (length, breadth, depth), (x, y, z) = self.box, self.bottom
        return (x - length / 2, y - breadth / 2, z), (x + length / 2, y + breadth / 2, z + depth)


class AddedMass(Element):
    """Water that moves along with a body, constant, along the body's axes."""

    what: ClassVar[str] = "added mass"

    at: Position = Field(ORIGIN, description=_POINT)
    surge: Mass = Field(0.0, description="Along x.")
    sway: Mass = Field(0.0, description="Along y.")
    heave: Mass = Field(0.0, description="Along z.")
    roll: Inertia = Field(0.0, description="About x.")
    pitch: Inertia = Field(0.0, description="About y.")
    yaw: Inertia = Field(0.0, description="About z.")

    @model_validator(mode="after")
    def _not_negative(self) -> AddedMass:
        for key in ("roll", "pitch", "yaw"):
            if getattr(self, key) < 0:
                raise refuse("added inertia must be zero or more", key)
        return self

    @property
    def diagonal(self) -> list[float]:
        """Surge, sway, heave [kg], roll, pitch, yaw [kg m^2]."""
        return [getattr(self, motion) for motion in MOTIONS]


class WaterDamping(Element):
    """What still water resists a body's motion with, linear, along the body's axes."""

    what: ClassVar[str] = "damping by water"

    at: Position = Field(ORIGIN, description=_POINT)
    surge: Damping = Field(0.0, description="Along x.")
    sway: Damping = Field(0.0, description="Along y.")
    heave: Damping = Field(0.0, description="Along z.")
    roll: RotationalDamping = Field(0.0, description="About x.")
    pitch: RotationalDamping = Field(0.0, description="About y.")
    yaw: RotationalDamping = Field(0.0, description="About z.")

    @property
    def diagonal(self) -> list[float]:
        """Surge, sway, heave [N s/m], roll, pitch, yaw [N m s]."""
        return [getattr(self, motion) for motion in MOTIONS]


class BallastTank(Element):
    """A box-shaped tank, along the body's axes; its liquid stays level."""

    what: ClassVar[str] = "a tank"

    box: Sizes = Field(description="Length, breadth and depth inside: sizes along x, y, z of the body.")
    bottom: Position = Field(description="Middle of its bottom in the body's axes.")
    content: Mass = Field(description="Mass of the liquid, beside the body's own mass.")
    density: Density = Field(SEA_WATER, description="Density of the liquid; sea water if not given.")

    @model_validator(mode="after")
    def _holds_it(self) -> BallastTank:
        capacity = math.prod(self.box) * self.density
        if self.content > capacity * (1 + 1e-9):
            found = f"{self.content / 1e3:g} t do not go into it"
            raise refuse(f"{found}; it holds {capacity / 1e3:.6g} t", "content")
        return self

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
    tanks: Named[BallastTank] | None = Field(None, description="Tanks with liquid in it, by name.")
