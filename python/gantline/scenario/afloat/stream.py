"""Wind and current, and the areas that they push on."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Discriminator, Field, Tag, model_validator

from gantline.hydro.wind import WindProfile
from gantline.scenario.base import Element
from gantline.scenario.file.tree import MapNode
from gantline.scenario.quantities import (
    Angle,
    Components,
    Number,
    Position,
    PositiveLength,
    PositiveSpeed,
    Quantity,
    Seed,
    WordOr,
    refuse,
)

__all__ = [
    "AIR",
    "CURRENT_SHOWN",
    "ORIGIN",
    "WIND_SHOWN",
    "Current",
    "Gusts",
    "LoadArea",
    "Stream",
    "StreamArea",
    "Wind",
    "WindGrowth",
    "WindOfLift",
]

#: Density of air at 15 °C and 101.325 kPa [kg/m^3], ISO 2533.
AIR = 1.225

WIND_SHOWN = "Areas that air resists and wind pushes, by name."
CURRENT_SHOWN = "Areas under water that water resists and current pushes, by name."
#: Where an area pushes that says nothing of it: the origin of its body, the datum of a load.
ORIGIN = (0.0, 0.0, 0.0)


class StreamArea(Element):
    """An area across one axis of a body, with a force along that axis.

    It is ½ density × coefficient × area × speed × the part of the speed that is along the axis, of the fluid
    against the body.
    """

    what: ClassVar[str] = "an area"

    area: Annotated[float, Quantity("area", "positive")] = Field(description="Area, seen along its axis.")
    coefficient: Annotated[float, Number(least=0.0, most=10.0)] = Field(
        description="Shape coefficient, about 1.2 for a box in wind."
    )
    along: Literal["x", "y", "z"] = Field(
        description="Axis of the body across which it stands, and along which the force acts."
    )
    at: Position = Field(
        ORIGIN, description="Where the force acts: in the body's axes, of a load from its datum."
    )


class LoadArea(Element):
    """The same of a load, which may say by its shape how large it is."""

    what: ClassVar[str] = "an area"

    area: Annotated[float, Quantity("area", "positive")] | None = Field(
        None, description="Area, seen along its axis; all that a box or cylinder shows there if not given."
    )
    coefficient: Annotated[float, Number(least=0.0, most=10.0)] = Field(
        description="Shape coefficient, about 1.2 for a box in wind, 0.7 for a smooth cylinder."
    )
    along: Literal["x", "y", "z"] = Field(
        description="Axis of the load across which it stands, and along which the force acts."
    )
    at: Position | None = Field(
        None,
        description="Where the force acts, from the datum of the load; if not given, the datum itself, and "
        "without an 'area' the middle of what it shows.",
    )


class Stream(Element):
    """A fluid that moves level."""

    speed: Annotated[float, Quantity("speed", "not_negative")] = Field(description="Speed.")
    direction: Angle = Field(description="Direction in which it moves, from world x towards y.")

    @property
    def velocity(self) -> tuple[float, float, float]:
        """Velocity (3,), world axes [m/s]."""
        x, y = math.cos(self.direction), math.sin(self.direction)
        return self.speed * x, self.speed * y, 0.0


class Gusts(Element):
    """What makes wind unsteady: its speed along its direction, with a spectrum of Kaimal's form."""

    what: ClassVar[str] = "gusts"

    speed: PositiveSpeed | None = Field(
        None, description="Speed of gusts: the highest mean over 3 s to be expected in ten minutes."
    )
    turbulence: Annotated[float, Quantity("ratio", "positive")] | None = Field(
        None, description="Instead: standard deviation of the speed over its mean, up to 50 %."
    )
    length: PositiveLength = Field(150.0, description="Of the eddies along the wind; 150 m if not given.")
    components: Components = Field(100, description="Regular gusts that they are made of.")
    seed: Seed = Field(1, description="Another number is another record of the same wind.")

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """One of speed and turbulence says how strong they are."""
        given = [key for key in ("speed", "turbulence") if key in data]
        if len(given) == 2:
            raise refuse("'speed' says already how strong gusts are; leave one out", "turbulence")
        if not given:
            raise refuse("needs 'speed: 16 m/s', the speed of gusts, or 'turbulence: 15 %'")


class WindGrowth(Element):
    """How wind grows with height; its speed is that at one height."""

    what: ClassVar[str] = "the profile of the wind"
    lone: ClassVar[tuple[str, ...]] = ("terrain",)

    height: PositiveLength = Field(
        10.0,
        description="Height over ground or water, the lower of both, at which the wind has its 'speed'; "
        "10 m if not given, as of forecasts.",
    )
    terrain: Literal["sea", "flat", "fields", "suburbs", "town"] | None = Field(
        None, description="What it blows over, by EN 1991-1-4, table 4.1: categories 0, I, II, III and IV."
    )
    roughness: Annotated[float, Quantity("length", "positive")] | None = Field(
        None, description="Instead: roughness of that, in the logarithm of the height."
    )
    exponent: Annotated[float, Number(least=0.0, most=1.0)] | None = Field(
        None, description="Instead: power of the height by which it grows, such as 0.14."
    )

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """One of terrain, roughness and exponent says how it grows."""
        given = [key for key in ("terrain", "roughness", "exponent") if key in data]
        if len(given) > 1:
            raise refuse(f"'{given[0]}' says already how wind grows; leave one out", given[1])
        if not given and set(data) <= {"height"}:  # a word of another crew is answered as such
            raise refuse("needs 'terrain: sea', or 'roughness: 3 mm' or 'exponent: 0.14' instead")

    def above(self, level: float) -> WindProfile:
        """The profile over ground or water at a level [m]."""
        if self.terrain is not None:
            return WindProfile.over_terrain(self.terrain, level, self.height)
        if self.roughness is not None:
            return WindProfile.over(self.roughness, level, self.height)
        assert self.exponent is not None  # validated
        return WindProfile.by_power(self.exponent, level, self.height)

    @model_validator(mode="after")
    def _height_is_above_what_it_blows_over(self) -> WindGrowth:
        lowest = self.above(0.0).lowest
        if self.height < lowest:
            sentence = f"below {lowest:g} m wind does not grow over that; measured at {self.height:g} m"
            raise refuse(f"{sentence} it says nothing of what blows above", "height")
        return self


class Wind(Stream):
    """Wind, steady or in gusts."""

    what: ClassVar[str] = "wind"

    density: Annotated[float, Quantity("density", "positive")] = Field(
        AIR, description="Density of the air; 1.225 kg/m^3 if not given."
    )
    gusts: Gusts | None = Field(
        None, description="Gusts about 'speed', which is the mean over ten minutes then. None if not given."
    )

    profile: WindGrowth | None = Field(
        None, description="How it grows with height; the same at any height if not given."
    )

    def push(self, areas: Mapping[str, StreamArea], heading: float, share: float = 1.0) -> float:
        """Level force of its mean on areas of a body that stands level and still, by (WC1) [N].

        Args:
            areas: The areas by name.
            heading: Of the body's x axis, from world x towards y [rad].
            share: Of its speed that it has there.
        """
        aside = self.direction - heading
        along = {"x": math.cos(aside), "y": math.sin(aside), "z": 0.0}
        forces = {axis: 0.0 for axis in along}
        for area in areas.values():
            pressure = 0.5 * self.density * (share * self.speed) ** 2
            forces[area.along] += pressure * area.coefficient * area.area * along[area.along]
        return math.hypot(*forces.values())


class Current(Stream):
    """Steady current."""

    what: ClassVar[str] = "current"


def _wind_kind(value: Any) -> str:
    return "a stream" if isinstance(value, (dict, Wind)) else "a speed"


_Gust = Annotated[float | Literal["none"], WordOr(("none",), Quantity("speed", "not_negative"))]

#: A speed that is held against limits, or wind that pushes as well.
WindOfLift = Annotated[
    Annotated[_Gust, Tag("a speed")] | Annotated[Wind, Tag("a stream")], Discriminator(_wind_kind)
]
