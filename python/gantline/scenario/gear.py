"""Ropes, shackles and slings."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.quantities import (
    Flag,
    Mass,
    Name,
    NotNegativeForce,
    PositiveForce,
    PositiveLength,
    PositiveMass,
    Quantity,
    Ratio,
    Text,
    Time,
    Word,
    WordOr,
    refuse,
)

__all__ = ["RopeMaterial", "Shackle", "Sling", "SlingDefaults", "SlingShackles"]

#: 6x36 IWRC: factors of EN 12385-4. Mass = 0.409 d²/100 kg/m, metallic area = 0.460 d² mm², breaking force =
#: 0.356 d² R/1000 kN with d in mm and the grade R in N/mm².
_MASS_FACTOR = 0.409e-2
_AREA_FACTOR = 0.460
_BREAKING_FACTOR = 0.356
#: Modulus of the rope over its metallic area; new ropes have 95 to 115 kN/mm².
_ROPE_MODULUS = 100e3

MassOfRope = Annotated[
    float | Literal["none"], WordOr(("none",), Quantity("mass_per_length", "not_negative"))
]


class RopeMaterial(Element):
    """A kind of rope: by its stiffness, by its construction, or inextensible in so many words."""

    what: ClassVar[str] = "a rope"

    axial_stiffness: PositiveForce | None = Field(None, description="Axial stiffness EA of the rope [N].")
    damping_time: Time = Field(0.0, description="Damping time t: T = k (e + t de/dt).")
    construction: Literal["6x36 IWRC"] | None = Field(None, description="Construction of a catalogue rope.")
    grade: Annotated[str, Word(("1960",))] | None = Field(
        None, description="Rope grade of a catalogue rope [N/mm^2]."
    )
    inextensible: Flag = Field(False, description="true: the rope does not stretch at all.")
    diameter: PositiveLength | None = Field(None, description="Nominal diameter.")
    mass: MassOfRope | None = Field(
        None, description="Mass per length, or 'none'; a catalogue rope has its own, any other rope none."
    )
    minimum_breaking_force: PositiveForce | None = Field(None, description="Minimum breaking force.")

    @model_validator(mode="after")
    def _one_way_to_say_it(self) -> RopeMaterial:
        ways = [self.axial_stiffness is not None, self.construction is not None, self.inextensible]
        if sum(ways) != 1:
            count = "several" if any(ways) else "none"
            sentence = f"{count} of 'axial_stiffness', 'construction' and 'inextensible: true' found"
            raise refuse(f"{sentence}; a rope has exactly one of them")
        if self.construction is not None and (self.grade is None or self.diameter is None):
            raise refuse("a rope of a construction needs 'grade' and 'diameter' too")
        if self.construction is None and self.grade is not None:
            raise refuse(
                "'grade' stands without 'construction'; write 'construction: 6x36 IWRC' or leave it out"
            )
        if self.inextensible and self.damping_time > 0:
            raise refuse("an inextensible rope has no damping; leave 'damping_time' out")
        return self

    @property
    def stiffness(self) -> float | None:
        """Axial stiffness EA [N], or None for an inextensible rope."""
        if self.construction is not None and self.diameter is not None:
            return _AREA_FACTOR * (self.diameter * 1e3) ** 2 * _ROPE_MODULUS
        return self.axial_stiffness

    @property
    def mass_per_length(self) -> float:
        """Mass per length that counts in the lift [kg/m]."""
        if isinstance(self.mass, float):
            return self.mass
        if self.mass is None and self.construction is not None and self.diameter is not None:
            return _MASS_FACTOR * (self.diameter * 1e3) ** 2
        return 0.0

    @property
    def breaking_force(self) -> float | None:
        """Minimum breaking force [N], or None if not known."""
        if self.minimum_breaking_force is not None:
            return self.minimum_breaking_force
        if self.construction is not None and self.grade is not None and self.diameter is not None:
            return _BREAKING_FACTOR * (self.diameter * 1e3) ** 2 * float(self.grade)
        return None


class Shackle(Element):
    """A kind of shackle."""

    what: ClassVar[str] = "a shackle"

    working_load_limit: PositiveMass = Field(description="Working load limit.")
    mass: Mass = Field(0.0, description="Mass of one shackle.")
    bow_diameter: PositiveLength | None = Field(
        None, description="Diameter of the bow where the sling eye lies."
    )
    pin_diameter: PositiveLength | None = Field(None, description="Diameter of the pin.")
    minimum_breaking_force: PositiveForce | None = Field(None, description="Minimum breaking force.")
    proof_load: NotNegativeForce | None = Field(None, description="Proof load.")


class SlingShackles(Element):
    """The shackles at the two ends of a sling."""

    what: ClassVar[str] = "the shackles of a sling"

    top: Name | None = Field(None, description="Shackle at the upper end, a name of 'shackles'.")
    bottom: Name | None = Field(None, description="Shackle at the lug, a name of 'shackles'.")


class SlingDefaults(Element):
    """What all slings have unless they say otherwise."""

    what: ClassVar[str] = "sling_defaults"

    length: PositiveLength | None = Field(
        None, description="Effective length: bearing to bearing, shackles included, unloaded."
    )
    rope: Name | None = Field(None, description="Kind of rope, a name of 'ropes'.")
    shackles: SlingShackles | None = Field(None, description="Shackles at both ends.")
    tolerance: Ratio | None = Field(None, description="Tolerance of the length, plus and minus.")


class Sling(SlingDefaults):
    """A sling from an equalizer's moving sheave, or from a hook, to a lug of the load."""

    what: ClassVar[str] = "a sling"

    from_: Name = Field(
        alias="from", description="Where its upper end is: a moving sheave like 'e1.3', or a hook."
    )
    to: Name = Field(description="The lug it holds, like 'block.L3'.")
    remark: Text | None = Field(None, description="A remark for people.")
