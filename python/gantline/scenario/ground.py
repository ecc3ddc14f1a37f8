"""The ground, and the plain head of a lift file."""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.quantities import (
    Acceleration,
    Damping,
    Flag,
    Length,
    PositiveForce,
    PositiveLength,
    PositiveStiffness,
    PositiveTime,
    Ratio,
    Text,
    refuse,
)

__all__ = ["Axes", "Ground", "LiftHead", "SimulationSettings"]


class LiftHead(Element):
    """What the lift is called."""

    what: ClassVar[str] = "lift"

    title: Text = Field(description="Title of the lift.")
    number: Text | None = Field(None, description="Number of the lift plan.")
    revision: Text | None = Field(None, description="Revision of the lift plan.")
    remark: Text | None = Field(None, description="A remark for people.")


class Axes(Element):
    """Where the axes of the world point, for people who read the file or its pictures."""

    what: ClassVar[str] = "axes"

    x: Text | None = Field(None, description="Direction of x.")
    y: Text | None = Field(None, description="Direction of y.")
    z: Text | None = Field(None, description="Direction of z.")
    origin: Text | None = Field(None, description="Where the origin is.")


class Ground(Element):
    """Level ground under the load."""

    what: ClassVar[str] = "ground"

    level: Length = Field(0.0, description="Height of the ground.")
    friction: Ratio = Field(0.0, description="Coefficient of friction between load and ground.")
    stiffness: PositiveStiffness = Field(
        200e6, description="Stiffness under each corner; 200 MN/m if not given."
    )
    damping: Damping = Field(2e6, description="Damping under each corner; 2 MN s/m if not given.")
    acts_at: Literal["corners"] = Field("corners", description="Where the ground acts on the load.")


#: Keys of `simulation:` that belong to one integrator.
INTEGRATOR_KEYS = {
    "adaptive": ("tension_tolerance", "position_tolerance"),
    "del": ("step", "paper", "geometric_stiffness"),
    "explicit": ("step",),
}


class SimulationSettings(Element):
    """How the lift is simulated; every key has a default."""

    what: ClassVar[str] = "simulation"

    integrator: Literal["adaptive", "del", "explicit"] = Field(
        "adaptive",
        description="The method: 'adaptive' controls its error, 'del' is the paper's, with a fixed step, "
        "'explicit' a baseline that is stable for short steps only.",
    )
    tension_tolerance: PositiveForce | None = Field(
        None,
        description="adaptive: error of tensions in a step; a ten-thousandth of the mean load of a rope "
        "if not given.",
    )
    position_tolerance: PositiveLength | None = Field(
        None, description="adaptive: error of positions in a step; 0.1 mm if not given."
    )
    step: PositiveTime = Field(1e-3, description="del and explicit: time step; 1 ms if not given.")
    paper: Flag = Field(
        False,
        description="del: true is the paper's eq. (15), without geometric stiffness; 'geometric_stiffness: "
        "false' by another name.",
    )
    geometric_stiffness: Flag = Field(
        True, description="del: false leaves the geometric stiffness of taut ropes out."
    )
    sample_interval: PositiveTime | None = Field(
        None,
        description="Time between recorded samples, the last of which is at the end; 20 ms if not given, of "
        "a lift of more than 10 min the least of 50 ms, 0.1 s, 0.2 s and so on with 30,000 samples at most.",
    )
    gravity: Acceleration = Field(9.81, description="Gravity; 9.81 m/s^2 if not given.")

    @model_validator(mode="after")
    def _paper_has_none(self) -> SimulationSettings:
        if self.paper and self.geometric_stiffness and "geometric_stiffness" in self.model_fields_set:
            sentence = "'paper: true' is without geometric stiffness"
            raise refuse(f"{sentence}; leave one of both out", "geometric_stiffness")
        return self
