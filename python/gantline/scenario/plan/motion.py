"""Motions that are given in advance, as ramps."""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field

from gantline.scenario.base import Element
from gantline.scenario.quantities import AngularSpeed, PositiveTime, Speed, Time

__all__ = ["SpeedRamp", "TurnRamp"]


class SpeedRamp(Element):
    """A change of speed of a given motion."""

    what: ClassVar[str] = "a step of a motion"

    at: Time = Field(description="When it begins.")
    duration: PositiveTime = Field(description="How long it takes.")
    velocity: Speed = Field(description="Speed after it, along the axis.")
    shape: Literal["linear", "smooth"] = Field("smooth", description="How the speed changes.")


class TurnRamp(Element):
    """A change of angular speed of a given motion."""

    what: ClassVar[str] = "a step of a motion"

    at: Time = Field(description="When it begins.")
    duration: PositiveTime = Field(description="How long it takes.")
    velocity: AngularSpeed = Field(description="Angular speed after it, about the axis.")
    shape: Literal["linear", "smooth"] = Field("smooth", description="How the speed changes.")
