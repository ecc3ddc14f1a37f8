"""Compensators: gas springs in line with slings, a rod that a cylinder's gas pulls in."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, ClassVar

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.cranes.gas_law import GasLaw
from gantline.scenario.quantities import (
    Damping,
    Flag,
    Name,
    NotNegativeForce,
    NotNegativeLength,
    PositiveForce,
    PositiveLength,
    PositiveMass,
    PositiveStiffness,
    PositiveStress,
    Quantity,
    Ratio,
    Time,
    refuse,
)
from gantline.units import format_quantity

if TYPE_CHECKING:
    from gantline.scenario.model import Scenario

__all__ = ["Compensator", "gas_rope", "own_period", "rod_of", "rods"]

#: Pressure of the air outside of a cylinder, which gauges leave out [Pa].
_AIR = 101_325.0
#: Share by which gas pulls more with the rod out at least: less would be a column without end [1].
_LEAST_RISE = 1e-6
#: Exponents that gases have: of an isotherm, of nitrogen under some hundred bar that is pressed fast [1].
_LEAST_EXPONENT, _LARGEST_EXPONENT = 1.0, 2.0


class Cylinder(Element):
    """The cylinder of a compensator."""

    what: ClassVar[str] = "the cylinder of a compensator"

    mass: PositiveMass = Field(description="Mass of all that does not move with the rod.")
    length: PositiveLength = Field(description="Length, from its bearing down.")
    diameter: PositiveLength = Field(description="Diameter outside, for inertia and pictures.")


class Rod(Element):
    """The rod of a compensator."""

    what: ClassVar[str] = "the rod of a compensator"

    mass: PositiveMass = Field(description="Mass, with its piston and the eye at its end.")
    diameter: PositiveLength = Field(description="Diameter, for inertia and pictures.")


class GasPull(Element):
    """What the gas pulls with at both ends of the stroke, its seals aside."""

    what: ClassVar[str] = "the pull of a compensator"

    rod_in: PositiveForce = Field(description="Pull with the rod in: below that it stays there.")
    rod_out: PositiveForce = Field(description="Pull with the rod out by the whole stroke.")

    @model_validator(mode="after")
    def _rises(self) -> GasPull:
        if self.rod_out <= self.rod_in * (1.0 + _LEAST_RISE):
            pulls = [format_quantity(one, "kN", 1) for one in (self.rod_out, self.rod_in)]
            sentence = f"{pulls[0]} is not more than {pulls[1]} with the rod in"
            raise refuse(f"{sentence}; the gas is compressed as the rod comes out", "rod_out")
        return self


class Gas(Element):
    """The gas itself, in place of its pull."""

    what: ClassVar[str] = "the gas of a compensator"

    charge_pressure: PositiveStress = Field(
        description="Pressure with the rod in, over that of the air outside."
    )
    piston_area: Annotated[float, Quantity("area", "positive")] = Field(
        description="Area that the gas presses on: of the piston, less that of the rod where it goes through."
    )
    volume: Annotated[float, Quantity("volume", "positive")] = Field(
        description="Volume of the gas with the rod in, accumulators included."
    )


class Compensator(Element):
    """A gas spring in line with slings: one sling holds its cylinder, others hang from its rod."""

    what: ClassVar[str] = "a compensator"

    type: Name | None = Field(
        None, description="A name of 'compensator_types' that gives what is not said here."
    )
    length: PositiveLength = Field(description="From the bearing of its cylinder to that of its rod, rod in.")
    stroke: PositiveLength = Field(description="How far the rod comes out, between its stops.")
    cylinder: Cylinder = Field(description="Its cylinder, which hangs above.")
    rod: Rod = Field(description="Its rod, which is below.")
    pull: GasPull | None = Field(None, description="What the gas pulls with; this or 'gas'.")
    gas: Gas | None = Field(None, description="Pressure, area and volume of the gas; this or 'pull'.")
    gas_exponent: Ratio = Field(
        description="n of p V^n: 1 of motion so slow that the gas keeps its temperature, 1.4 and more of "
        "fast motion; from its maker."
    )
    seal_friction: NotNegativeForce = Field(0.0, description="Dry friction of its seals.")
    damping: Damping = Field(0.0, description="Damping of the rod, force over speed.")
    stop_stiffness: PositiveStiffness = Field(100e6, description="Stiffness of the stops at both ends.")
    stop_damping_time: Time = Field(2e-3, description="Damping over stiffness of the stops.")
    out_at_start: NotNegativeLength = Field(
        0.0, description="How far the rod is out where the lift file has the load, before anything moves."
    )
    locked: Flag = Field(
        False,
        description="true: a pin holds the rod where it is at the start; 'pull_pins' of a step frees it.",
    )
    rated_capacity: PositiveMass | None = Field(None, description="Working load limit, of all below it.")

    @model_validator(mode="after")
    def _can_be_built(self) -> Compensator:
        if (self.pull is None) == (self.gas is None):
            if self.pull is None:
                right = "'pull: {rod_in: 600 kN, rod_out: 900 kN}' says what it pulls with"
                raise refuse(f"neither 'pull' nor 'gas' found; {right}")
            raise refuse("'pull' and 'gas' stand together; a compensator has one of them", "gas")
        if not _LEAST_EXPONENT <= self.gas_exponent <= _LARGEST_EXPONENT:
            sentence = f"{self.gas_exponent:g} is no exponent of a gas"
            right = "from 1 of slow motion to 1.4 of fast motion is right, under high pressure up to 2"
            raise refuse(f"{sentence}; {right}", "gas_exponent")
        if self.cylinder.length < self.stroke:
            own, stroke = (f"{one:g} m" for one in (self.cylinder.length, self.stroke))
            sentence = f"a cylinder of {own} has no room for a stroke of {stroke}"
            raise refuse(f"{sentence}; 'length' of the cylinder is at least its stroke", "cylinder")
        if self.length < self.cylinder.length:
            own, whole = (f"{one:g} m" for one in (self.cylinder.length, self.length))
            sentence = f"{whole} from bearing to bearing is less than the {own} of its cylinder"
            raise refuse(f"{sentence}; the rod's bearing is below the cylinder, rod in", "length")
        if self.rod.diameter >= self.cylinder.diameter:
            own, other = (f"{one:g} m" for one in (self.rod.diameter, self.cylinder.diameter))
            sentence = f"a rod of {own} does not go into a cylinder of {other}"
            raise refuse(f"{sentence}; the diameter of the rod is the smaller one", "rod")
        if self.out_at_start > self.stroke:
            sentence = f"{self.out_at_start:g} m is more than the stroke of {self.stroke:g} m"
            raise refuse(f"{sentence}; the rod starts between its stops", "out_at_start")
        if self.gas is not None and self.gas.volume <= self.gas.piston_area * self.stroke:
            swept = self.gas.piston_area * self.stroke
            sentence = (
                f"{self.gas.volume:g} m^3 of gas are no more than the {swept:.3g} m^3 that the stroke takes"
            )
            raise refuse(f"{sentence}; its volume is that with the rod in, with accumulators", "gas")
        return self

    @property
    def law(self) -> GasLaw:
        """What its gas pulls with."""
        if self.pull is not None:
            return GasLaw.between(self.pull.rod_in, self.pull.rod_out, self.stroke, self.gas_exponent)
        assert self.gas is not None  # one of the two has been checked to be there
        area = self.gas.piston_area
        column = self.gas.volume / area
        return GasLaw(self.gas.charge_pressure * area, column, self.gas_exponent, _AIR * area)

    @property
    def mass(self) -> float:
        """Mass of cylinder and rod [kg]."""
        return self.cylinder.mass + self.rod.mass

    @property
    def rod_length(self) -> float:
        """Length of the rod: with all of its stroke out it is still in the cylinder's end [m]."""
        return self.length - self.cylinder.length + self.stroke

    def reach(self, out: float) -> float:
        """From the cylinder's bearing to the rod's with the rod out by a way [m]."""
        return self.length + out


def rod_of(name: str) -> str:
    """Name of the rod of a compensator, as of a body and of the joint on which it slides."""
    return f"{name}.rod"


def rods(scenario: Scenario) -> dict[str, str]:
    """Names of all rods, each with that of its compensator."""
    return {rod_of(name): name for name in scenario.compensators or {}}


def gas_rope(name: str) -> str:
    """Name of what stands for the gas of a compensator among ropes."""
    return f"{name}.gas"


def own_period(given: Compensator, pull: float, mass: float) -> float:
    """Period of a mass [kg] on its gas, about where that pulls with a force [N]: (PC5) [s]."""
    return 2.0 * math.pi * math.sqrt(mass / given.law.stiffness(given.law.out(pull)))
