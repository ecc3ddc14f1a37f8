"""Drums that pay rope out and haul it in."""

from __future__ import annotations

from typing import ClassVar

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.motion import SpeedRamp
from gantline.scenario.quantities import (
    Damping,
    NotNegativeForce,
    PositiveAcceleration,
    PositiveForce,
    PositiveInertia,
    PositiveLength,
    PositiveMass,
    PositivePower,
    PositiveSpeed,
    Speed,
    refuse,
)

__all__ = ["Drum", "DrumDrive"]


class DrumDrive(Element):
    """What the drive of a drum can do; between the steps of the plan it holds the drum."""

    what: ClassVar[str] = "the drive of a drum"

    speed: PositiveSpeed = Field(description="Highest speed of the rope.")
    acceleration: PositiveAcceleration = Field(
        description="Highest acceleration of the rope; also used where a step names none."
    )
    capacity: PositiveForce | None = Field(
        None, description="Largest pull of the rope on its diameter; whatever it takes where it is left out."
    )
    power: PositivePower | None = Field(None, description="Largest power for hauling in, beside a capacity.")

    @model_validator(mode="after")
    def _power_needs_a_capacity(self) -> DrumDrive:
        if self.power is not None and self.capacity is None:
            raise refuse("'power' is given without 'capacity', the largest pull at low speed", "power")
        return self


class Drum(Element):
    """A drum, or several on one shaft; what has passed is counted as rope on its diameter."""

    what: ClassVar[str] = "a drum"

    diameter: PositiveLength = Field(description="Pitch diameter, to the centre line of the rope on it.")
    moment_of_inertia: PositiveInertia | None = Field(
        None, description="Moment of inertia of what turns, drive train included, about the drum's axis."
    )
    rotating_mass: PositiveMass | None = Field(
        None, description="The same as mass that moves with the rope: moment of inertia over radius squared."
    )
    velocity: Speed = Field(0.0, description="Rope paid out per time at the start.")
    damping: Damping = Field(0.0, description="Damping of the turning, by speed of the rope.")
    brake: NotNegativeForce | None = Field(
        None, description="Largest pull of the rope on its diameter that brake or dry friction hold."
    )
    motion: list[SpeedRamp] | None = Field(
        None, description="Motion given in advance, at rest at first; paying out is positive."
    )
    drive: DrumDrive | None = Field(
        None, description="Drive by which steps of the plan haul in and pay out; it holds otherwise."
    )

    @model_validator(mode="after")
    def _one_way_to_say_it(self) -> Drum:
        if (self.moment_of_inertia is None) == (self.rotating_mass is None):
            found = "none of them" if self.rotating_mass is None else "both"
            raise refuse(f"a drum has one of 'moment_of_inertia' and 'rotating_mass'; found {found}")
        if self.motion is not None and self.drive is not None:
            sentence = "'motion' and 'drive' are given together"
            raise refuse(f"{sentence}; a drum moves as given, or as the plan says", "drive")
        if self.is_driven and self.velocity != 0:
            raise refuse("a drum with a motion or drive starts at rest; leave 'velocity' out", "velocity")
        if self.is_driven and self.brake is not None:
            raise refuse("a drum with a motion or drive is held by that; leave 'brake' out", "brake")
        return self

    @property
    def is_driven(self) -> bool:
        """Whether its motion is prescribed."""
        return self.motion is not None or self.drive is not None

    @property
    def inertia(self) -> float:
        """Mass that moves with the rope on its diameter [kg]."""
        if self.rotating_mass is not None:
            return self.rotating_mass
        assert self.moment_of_inertia is not None  # one of them is given
        return self.moment_of_inertia / (self.diameter / 2) ** 2
