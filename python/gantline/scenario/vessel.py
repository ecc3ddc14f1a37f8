"""Vessels: bodies afloat in the words of a yard.

The axes of a vessel begin at stern, keel and centre plane: x forward, y to port, z up.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

from pydantic import Field, model_validator

from gantline.scenario.base import Element, Named
from gantline.scenario.mechanics import BodyInertia
from gantline.scenario.quantities import (
    Angle,
    ListOf,
    Position,
    PositiveLength,
    PositiveMass,
    Quantity,
    Sizes,
    Text,
    refuse,
)
from gantline.scenario.water import Afloat, HullShape

__all__ = ["Vessel", "VesselHull", "VesselMass"]

_Place = Annotated[tuple[float, float], ListOf(Quantity("length"), 2)]


class VesselHull(HullShape):
    """The hull of a vessel: a box along its axes, or a mesh from a CAD file."""

    what: ClassVar[str] = "the hull of a vessel"

    keel: Position | None = Field(
        None, description="Middle of the box's bottom; half its length ahead of the stern if not given."
    )

    @property
    def bottom(self) -> tuple[float, float, float]:
        """Middle of the box's bottom in the vessel's axes [m]."""
        if self.keel is None and self.box is not None:
            return (self.box[0] / 2, 0.0, 0.0)
        return super().bottom


class VesselMass(Element):
    """Something of a vessel that has a weight."""

    what: ClassVar[str] = "a mass of a vessel"

    mass: PositiveMass = Field(description="Mass.")
    at: Position = Field(description="Its centre of gravity in the vessel's axes.")


class Vessel(Afloat):
    """A vessel: one body that floats."""

    what: ClassVar[str] = "a vessel"

    position: _Place = Field(
        (0.0, 0.0), description="Where stern and centre plane are at the start, x and y of the world."
    )
    heading: Angle = Field(0.0, description="Direction of its x axis, from world x towards y.")
    draft: PositiveLength = Field(
        description="Draft at half length at the start, along its own z; with 'start: rest' a guess."
    )
    heel: Angle = Field(0.0, description="Heel at the start, to starboard positive.")
    trim: Angle = Field(0.0, description="Trim at the start, by the stern positive.")
    hull: VesselHull = Field(description="What of it displaces water.")
    masses: Named[VesselMass] = Field(
        description="What it weighs by itself, by name: without cranes, hooks and contents of tanks."
    )
    radii_of_gyration: Sizes | None = Field(
        None, description="Of these masses together about their centre of gravity, axes x, y, z."
    )
    inertia: BodyInertia | None = Field(
        None, description="Inertia of these masses together, in place of 'radii_of_gyration'."
    )
    remark: Text | None = Field(None, description="A remark for people.")

    @model_validator(mode="after")
    def _one_inertia(self) -> Vessel:
        if (self.radii_of_gyration is None) == (self.inertia is None):
            raise refuse("needs 'radii_of_gyration' or 'inertia', and not both")
        return self

    @property
    def mass(self) -> float:
        """Mass of the vessel by itself [kg]."""
        return math.fsum(one.mass for one in self.masses.values())

    @property
    def centre_of_gravity(self) -> tuple[float, float, float]:
        """Centre of gravity of the vessel by itself, its axes [m]."""
        parts = self.masses.values()
        x, y, z = (math.fsum(one.mass * one.at[axis] for one in parts) / self.mass for axis in range(3))
        return x, y, z

    @property
    def own_inertia(self) -> BodyInertia:
        """Inertia of the vessel by itself about its centre of gravity."""
        if self.radii_of_gyration is None:
            assert self.inertia is not None  # validated
            return self.inertia
        xx, yy, zz = (self.mass * radius**2 for radius in self.radii_of_gyration)
        return BodyInertia.model_construct(xx=xx, yy=yy, zz=zz)
