"""Drums that pay rope out and haul it in."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Final

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.plan.motion import SpeedRamp
from gantline.scenario.quantities import (
    Damping,
    NotNegativeForce,
    NotNegativeLength,
    Number,
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

__all__ = ["Drum", "DrumDrive", "RopeOnDrum"]

#: Turns that stay on a drum where the lift file names none: two, 29 CFR 1910.179(h)(2)(iii)(a).
SPARE_TURNS: Final = 2.0
#: Radius that a layer adds, over the rope's diameter: rope in the grooves of the layer below, sin 60 deg.
_NESTING: Final = math.sin(math.radians(60.0))
#: Turns in the examples of a message, of a drum that begins on its first layer.
_TURNS: Final = {"wraps_per_layer": 30, "wraps_at_start": 20}


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
    brake: PositiveForce | None = Field(
        None,
        description="Pull of the rope that the brake holds, once an emergency stop has thrown it in; the "
        "capacity if not given.",
    )

    @model_validator(mode="after")
    def _power_needs_a_capacity(self) -> DrumDrive:
        for key in ("power", "brake"):
            if getattr(self, key) is not None and self.capacity is None:
                raise refuse(f"'{key}' is given without 'capacity', the largest pull at low speed", key)
        return self


class RopeOnDrum(Element):
    """What drums of all kinds have: what turns, what lies on it, and the tension that wound it."""

    moment_of_inertia: PositiveInertia | None = Field(
        None, description="Moment of inertia of what turns, drive train included, about the drum's axis."
    )
    rotating_mass: PositiveMass | None = Field(
        None, description="The same as mass that moves with the rope: moment of inertia over radius squared."
    )
    layers: Annotated[int, Number(least=1, most=20, whole=True)] = Field(
        1, description="Layers that fit on it."
    )
    wraps_per_layer: Annotated[float, Number(least=1.0, most=1000.0)] | None = Field(
        None, description="Turns of each rope in a full layer."
    )
    wraps_at_start: Annotated[float, Number(least=0.0, most=20000.0)] | None = Field(
        None, description="Turns of each rope on it at the start, those that stay included."
    )
    layer_step: NotNegativeLength | None = Field(
        None,
        description="Radius that each further layer adds; 0.87 times the diameter of the rope, which lies in "
        "the grooves of the layer below, if not given.",
    )
    first_sheave: PositiveLength | None = Field(
        None,
        description="Distance of the sheave that a rope comes from, before the middle of its full layer; "
        "its fleet angle onto the drum is known then.",
    )
    spare_turns: Annotated[float, Number(least=0.0, most=100.0)] = Field(
        SPARE_TURNS,
        description="Turns that have to stay on it; fewer fail, where nothing is said fewer than 2 are a "
        "warning.",
    )
    wound_under: NotNegativeForce | None = Field(
        None,
        description="Tension with which the rope on it was wound before the lift; that of the start if not "
        "given.",
    )

    @model_validator(mode="after")
    def _turns_are_known(self) -> RopeOnDrum:
        given = {"wraps_per_layer": self.wraps_per_layer, "wraps_at_start": self.wraps_at_start}
        missing = [key for key, value in given.items() if value is None]
        if self.layers > 1 and missing:
            needed = " and ".join(f"'{key}'" for key in missing)
            example = ", ".join(f"{key}: {_TURNS[key]}" for key in missing)
            sentence = f"a drum of {self.layers} layers needs {needed} to know the layer"
            raise refuse(f"{sentence}, such as '{example}'", "layers")
        if self.first_sheave is not None and missing:
            sentence = "the fleet angle onto a drum depends on where its rope lies across it: 'first_sheave'"
            raise refuse(f"{sentence} needs '{missing[0]}' beside it", "first_sheave")
        if self.wraps_per_layer is not None and self.wraps_at_start is None:
            raise refuse("'wraps_per_layer' is given without 'wraps_at_start'", "wraps_per_layer")
        if self.wraps_at_start is not None and self.wraps_per_layer is not None:
            room = self.layers * self.wraps_per_layer
            if self.wraps_at_start > room:
                sentence = f"{self.wraps_at_start:g} wraps do not go on a drum that has room for {room:g}"
                raise refuse(f"{sentence}; more 'layers' or 'wraps_per_layer' are right", "wraps_at_start")
        is_asked = "spare_turns" in self.model_fields_set
        if is_asked and self.wraps_at_start is not None and self.wraps_at_start < self.spare_turns:
            sentence = (
                f"{self.wraps_at_start:g} turns are on it at the start, and {self.spare_turns:g} have to stay"
            )
            raise refuse(f"{sentence} ('spare_turns'); those that stay are counted too", "wraps_at_start")
        return self

    def mass_on(self, diameter: float) -> float | None:
        """Mass that moves with the rope on this diameter [kg]; None where nothing says what turns."""
        if self.rotating_mass is not None or self.moment_of_inertia is None:
            return self.rotating_mass
        return self.moment_of_inertia / (diameter / 2) ** 2

    def step(self, rope_diameter: float | None) -> float:
        """Radius that each further layer adds [m]; 0 of one layer, or where nothing says it."""
        if self.layers == 1:
            return 0.0
        if self.layer_step is not None:
            return self.layer_step
        return _NESTING * rope_diameter if rope_diameter is not None else 0.0


class Drum(RopeOnDrum):
    """A drum, or several on one shaft; what has passed is counted as rope on its diameter."""

    what: ClassVar[str] = "a drum"

    diameter: PositiveLength = Field(description="Pitch diameter, to the centre line of the rope on it.")
    velocity: Speed = Field(0.0, description="Rope paid out per time at the start.")
    damping: Damping = Field(0.0, description="Damping of the turning, by speed of the rope.")
    brake: NotNegativeForce | None = Field(
        None, description="Largest pull of the rope on its diameter that brake or dry friction hold."
    )
    rated_capacity: PositiveMass | None = Field(
        None,
        description="Working load limit of a winch or strand jack, for each rope on it; what the drive can "
        "pull is its 'capacity'.",
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
        mass = self.mass_on(self.diameter)
        assert mass is not None  # one way to say it is given
        return mass
