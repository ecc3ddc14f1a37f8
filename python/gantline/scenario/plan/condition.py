"""What a step of the plan waits for."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal, NamedTuple

from pydantic import Field, model_validator
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import PydanticCustomError

from gantline.scenario.base import Element
from gantline.scenario.quantities import (
    Angle,
    Name,
    Names,
    NotNegativeAngle,
    PositiveAngle,
    Quantity,
    Reader,
    refuse,
)

__all__ = [
    "AngleReached",
    "Condition",
    "HoistLoadReached",
    "MooringTensionReached",
    "TiltReached",
    "Weighing",
]


class Weighing(NamedTuple):
    """A force as load indicators show it: in newtons, or as the mass that weighs as much.

    Attributes:
        force: The force [N]; 0 where a mass is said.
        mass: The mass [kg]; 0 where a force is said.
    """

    force: float
    mass: float

    def newtons(self, gravity: float) -> float:
        """The force [N] under a gravity [m/s^2]."""
        return self.force + self.mass * gravity


@dataclass(frozen=True)
class WeighingReader(Reader):
    """Reads ``400 kN``, and ``40 t`` as what that weighs."""

    def read(self, value: object) -> Weighing:
        """The force or the mass, above zero."""
        force, mass = Quantity("force", "positive"), Quantity("mass", "positive")
        try:
            return Weighing(force.read(value), 0.0)
        except PydanticCustomError as error:
            refused = error.message()
        try:
            return Weighing(0.0, mass.read(value))
        except PydanticCustomError as error:
            if not error.message().endswith("'300 t' or '20 kg'"):
                raise  # a mass that is none, such as '-40 t'
        raise refuse(f"{refused}, or as the mass that weighs as much, like '40 t'")

    def shown(self) -> JsonSchemaValue:
        """A force or a mass."""
        return {"anyOf": [Quantity(dimension).shown() for dimension in ("force", "mass")]}


_Weighing = Annotated[Weighing, WeighingReader()]


class HoistLoadReached(Element):
    """A load in the falls of a hook."""

    what: ClassVar[str] = "hoist_load"

    hook: Name = Field(description="The hook.")
    above: _Weighing | None = Field(
        None,
        description="The step ends when the hoist load is above this: a force, or a mass, as its weight.",
    )
    below: _Weighing | None = Field(
        None,
        description="The step ends when the hoist load is below this: a force, or a mass, as its weight.",
    )

    @model_validator(mode="after")
    def _one_side(self) -> HoistLoadReached:
        if (self.above is None) == (self.below is None):
            raise refuse("it has one of 'above' and 'below', such as {hook: U1, above: 40 t}")
        return self


class TiltReached(Element):
    """A tilt of the load."""

    what: ClassVar[str] = "load_tilt"

    above: NotNegativeAngle | None = Field(None, description="The step ends when the tilt is above this.")
    below: PositiveAngle | None = Field(None, description="The step ends when the tilt is below this.")

    @model_validator(mode="after")
    def _one_side(self) -> TiltReached:
        if (self.above is None) == (self.below is None):
            raise refuse("it has one of 'above' and 'below', such as {above: 89 deg}")
        for key in ("above", "below"):
            if (getattr(self, key) or 0.0) >= math.pi:
                raise refuse("a load tilts by 180 deg at most, upside down; less than that is right", key)
        return self


class AngleReached(Element):
    """Heel or trim of something that floats."""

    what: ClassVar[str] = "heel or trim"

    vessel: Name = Field(description="The vessel, or body of 'mechanics' that floats freely.")
    above: Angle | None = Field(None, description="The step ends when the angle is above this.")
    below: Angle | None = Field(None, description="The step ends when the angle is below this.")

    @model_validator(mode="after")
    def _one_side(self) -> AngleReached:
        if (self.above is None) == (self.below is None):
            raise refuse("it has one of 'above' and 'below', such as {vessel: barge, below: 0.1 deg}")
        return self


class MooringTensionReached(Element):
    """A tension of a mooring line."""

    what: ClassVar[str] = "mooring_tension"

    line: Name = Field(description="The mooring line.")
    above: _Weighing | None = Field(None, description="The step ends when its tension is above this.")
    below: _Weighing | None = Field(None, description="The step ends when its tension is below this.")

    @model_validator(mode="after")
    def _one_side(self) -> MooringTensionReached:
        if (self.above is None) == (self.below is None):
            raise refuse("it has one of 'above' and 'below', such as {line: bow.ps, above: 200 kN}")
        return self


class Condition(Element):
    """What a step waits for."""

    what: ClassVar[str] = "until"

    load_transferred: Annotated[float, Quantity("ratio", "positive")] | None = Field(
        None,
        description="Share of the load's weight that has left its supports; lowering, what is left of it.",
    )
    supports: Literal["clear", "touched"] | None = Field(
        None, description="'clear': the load has left all its supports; 'touched': one bears again."
    )
    hoist_load: HoistLoadReached | None = Field(
        None, description="Hoist load of a hook that hangs in ropes: hook load, hook block and falls."
    )
    tension_spread: Annotated[float, Quantity("ratio", "positive")] | None = Field(
        None, description="(max - min)/mean of the slings of every equalizer is below this, and all carry."
    )
    load_tilt: TiltReached | None = Field(
        None,
        description="Tilt of the load, between its own z axis and plumb: 0 as it stands in the file, 90 deg "
        "on its side.",
    )
    slings: Literal["slack", "taut"] | None = Field(
        None, description="'slack': no sling of those under 'of' carries; 'taut': each of them does."
    )
    heel: AngleReached | None = Field(None, description="Heel of a vessel, to starboard positive.")
    trim: AngleReached | None = Field(None, description="Trim of a vessel, by the stern positive.")
    falls_out_of_plumb: PositiveAngle | None = Field(
        None, description="The falls of all hooks that hang from cranes in ropes are within this of plumb."
    )
    mooring_tension: MooringTensionReached | None = Field(None, description="Tension of a mooring line.")
    of: Names = Field(
        (),
        description="tension_spread: equalizers that count; falls_out_of_plumb: hooks that count; slings: "
        "slings that count, like 'sling.S1'; all if not given.",
    )

    @model_validator(mode="after")
    def _exactly_one(self) -> Condition:
        ways = tuple(key for key in type(self).model_fields if key != "of")
        if sum(getattr(self, way) is not None for way in ways) != 1:
            raise refuse(
                "a step waits for one thing: 'load_transferred: 50 %', 'supports: clear', "
                "'hoist_load: {hook: U1, above: 40 t}', 'load_tilt: {above: 89 deg}', 'slings: slack', "
                "'tension_spread: 5 %', 'trim: {vessel: barge, below: 0.1 deg}', "
                "'falls_out_of_plumb: 0.5 deg' or 'mooring_tension: {line: bow.ps, above: 200 kN}'"
            )
        if self.load_transferred is not None and self.load_transferred > 1:
            raise refuse(f"load_transferred is {self.load_transferred * 100:g} %; it can reach 100 % at most")
        if (
            self.of
            and self.tension_spread is None
            and self.falls_out_of_plumb is None
            and self.slings is None
        ):
            sentence = "'of' stands without 'tension_spread', whose equalizers it names"
            raise refuse(f"{sentence}, 'falls_out_of_plumb', whose hooks, or 'slings'", "of")
        return self
