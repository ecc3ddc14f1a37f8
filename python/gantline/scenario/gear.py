"""Ropes, shackles and slings."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator
from pydantic.json_schema import JsonSchemaValue

from gantline.rope_data import GRADES, RopeClass, rope_class, rope_classes
from gantline.scenario.base import Element
from gantline.scenario.cranes.chain_hoist import ChainHoist
from gantline.scenario.curve import RopeCurve
from gantline.scenario.plan.parting import BREAKS_SHOWN, CUT_SHOWN, BreaksAt
from gantline.scenario.quantities import (
    Flag,
    Mass,
    Name,
    Names,
    NotNegativeForce,
    PositiveForce,
    PositiveLength,
    PositiveMass,
    PositiveStress,
    Quantity,
    Reader,
    Share,
    Text,
    Time,
    Word,
    WordOr,
    found,
    refuse,
)
from gantline.scenario.rope_weight import NODES_SHOWN, WEIGHT_SHOWN, RopeNodes, RopeWeightWord
from gantline.scenario.tolerance import LengthTolerance
from gantline.units import format_quantity, quantity

__all__ = ["RopeMaterial", "Shackle", "Sling", "SlingDefaults", "SlingShackles"]

#: Diameters that a stranded rope can have [m]; beyond them a unit has slipped.
_SMALLEST_DIAMETER = 1e-3
_LARGEST_DIAMETER = 0.3
#: Highest tensile grade of steel for ropes [Pa], EN 10264-2: no rope holds more over all of its circle.
_STRONGEST_STEEL = 2160e6
#: Torque factor that no rope has [1], three times that of six strands in ordinary lay; plausible.
_LARGEST_TORQUE_FACTOR = 0.3
#: Diameters of bows and pins of shackles [m]; those of shackles of 1550 t are 0.34 m.
_SMALLEST_SHACKLE = 4e-3
_LARGEST_SHACKLE = 0.5
#: Trunnions of the largest columns have 2 to 3 m [m]; plausible.
_LARGEST_IN_AN_EYE = 5.0
#: By which a limit in tonnes is held against forces [m/s^2].
_GRAVITY = 9.81
#: Modulus of solid steel [Pa], EN 1993-1-1, 3.2.6: no rope is stiffer over its metallic area.
_STEEL_MODULUS = 210e9

_WAYS = "'axial_stiffness', 'curve', 'construction' and 'inextensible: true'"

#: Prestressing strand by name, or by its designation in EN 10138-3, such as Y1860S7-15.7.
_PRESTRESSING = re.compile(r"(prestressing |pc |7-?)?strands?|y[0-9]{4}s[0-9].*", re.IGNORECASE)
#: Prestressing strand of 150 mm^2, 195 kN/mm^2 and 1860 N/mm^2, as EN 10138-3 has it: 15.7 mm, 1.17 kg/m.
_OF_STRANDS = (
    "strands by their EA and breaking force, of n times 150 mm^2 n times 'axial_stiffness: 29.3 MN', "
    "'minimum_breaking_force: 279 kN' and 'mass: 1.17 kg/m', without 'grade'"
)

MassOfRope = Annotated[
    float | Literal["none"], WordOr(("none",), Quantity("mass_per_length", "not_negative"))
]


@dataclass(frozen=True)
class _Construction(Reader):
    """Reads the name of a rope class, or the designation of one of its constructions."""

    def read(self, value: object) -> str:
        """The name as written."""
        try:
            rope_class(str(value))
        except KeyError:
            sentence = f"{found(value)} is not a construction that is known here"
            is_strand = _PRESTRESSING.fullmatch(str(value).strip())
            raise refuse(f"{sentence}; {_OF_STRANDS if is_strand else _likely(str(value))}") from None
        return str(value)

    def shown(self) -> JsonSchemaValue:
        """The names of all classes; or their designations."""
        classes = rope_classes()
        designations = [word for one in classes.values() for word in one.designations]
        return {"anyOf": [{"enum": list(classes)}, {"enum": designations}]}


def _likely(text: str) -> str:
    """Constructions that may be meant; several, for a class or core guessed wrong is another rope."""
    classes = rope_classes()
    known = [word for one in classes.values() for word in (one.name, *one.designations)]
    text = text[:40].strip()
    begun = [word for word in known if word.startswith(text)] if text else []
    # Of strands that are known with other cores all of these: no other letters are nearer to what is meant.
    strands = re.split(r"[ -]", text, maxsplit=1)[0].lower()
    cores = [name for name in classes if strands and name.partition(" ")[0].lower() == strands]
    likely = begun[:3] or cores or get_close_matches(text, known, n=3, cutoff=0.7)
    if likely:
        return f"did you mean {' or '.join(repr(word) for word in likely)}?"
    all_strands = ", ".join(dict.fromkeys(name.partition(" ")[0] for name in classes))
    sentence = f"right is one of {all_strands} with its core, such as '6x36 IWRC'"
    return f"{sentence}; any other rope by 'axial_stiffness'"


class RopeMaterial(Element):
    """A kind of rope: by its stiffness, a curve, its construction, or inextensible in so many words."""

    what: ClassVar[str] = "a rope"

    axial_stiffness: PositiveForce | None = Field(None, description="Axial stiffness EA of the rope [N].")
    curve: RopeCurve | None = Field(
        None,
        description="Tension over strain, in place of one stiffness: of fibre slings, which get stiffer as "
        "they are loaded, and lines of nylon and polyester. For slings, mooring lines of type 'spring', tag "
        "lines and ropes that run straight from end to end, without sheave, winch or nodes.",
    )
    damping_time: Time = Field(0.0, description="Damping time t: T = k (e + t de/dt).")
    construction: Annotated[str, _Construction()] | None = Field(
        None,
        description="Rope class of EN 12385-4 and its core, or a construction of the class, such as "
        "'6x36WS-IWRC'; gives stiffness, mass and minimum breaking force by diameter and grade.",
    )
    grade: Annotated[str, Word(GRADES)] | None = Field(
        None, description="Rope grade of a construction [N/mm^2]; the minimum breaking force comes from it."
    )
    modulus: PositiveStress | None = Field(
        None, description="Modulus over the metallic area of a construction, in place of that of its class."
    )
    inextensible: Flag = Field(False, description="true: the rope does not stretch at all.")
    diameter: PositiveLength | None = Field(None, description="Nominal diameter.")
    torque_factor: Annotated[float, Share()] | None = Field(
        None,
        description="Torque by which the rope under tension turns at its ends, over tension times diameter, "
        "as its maker says: 9 % of six strands in ordinary lay, 1 % of a good rotation-resistant rope. It "
        "decides whether falls twist.",
    )
    mass: MassOfRope | None = Field(
        None, description="Mass per length, or 'none'; a construction has its own, any other rope none."
    )
    minimum_breaking_force: PositiveForce | None = Field(
        None, description="Minimum breaking force, such as that of a certificate; before that of the grade."
    )
    breaks_at: BreaksAt = Field("never", description=f"{BREAKS_SHOWN} For all ropes of this kind.")

    @model_validator(mode="after")
    def _one_way_to_say_it(self) -> RopeMaterial:
        stiffness = {
            "axial_stiffness": self.axial_stiffness is not None,
            "curve": self.curve is not None,
            "construction": self.construction is not None,
            "inextensible": self.inextensible,
        }
        ways = [key for key, is_given in stiffness.items() if is_given]
        if not ways:
            raise refuse(f"none of {_WAYS} found; a rope has exactly one of them")
        if len(ways) > 1:
            both = " and ".join(f"'{key}'" for key in ways)
            raise refuse(f"{both} are given together; a rope has exactly one of {_WAYS}", ways[-1])
        if self.construction is None:
            self._refuse_without_construction()
        else:
            self._refuse_incomplete_construction(self.construction)
        self._refuse_beyond_steel()
        self._refuse_torque()
        if self.breaks_at == "minimum_breaking_force" and self.breaking_force is None:
            sentence = "the minimum breaking force of this rope is not known"
            raise refuse(f"{sentence}; give it, or a force here, such as '600 kN'", "breaks_at")
        if self.inextensible and self.damping_time > 0:
            raise refuse("an inextensible rope has no damping; leave 'damping_time' out", "damping_time")
        return self

    def _refuse_beyond_steel(self) -> None:
        if self.diameter is None or self.minimum_breaking_force is None:
            return
        stress = self.minimum_breaking_force / (math.pi / 4 * self.diameter**2)
        if stress > _STRONGEST_STEEL:
            force, thick = f"{self.minimum_breaking_force / 1e3:g} kN", f"{self.diameter / 1e-3:g} mm"
            sentence = (
                f"{force} are {stress / 1e9:.3g} kN/mm^2 of a rope of {thick}, and solid steel holds 2.16"
            )
            raise refuse(f"{sentence}; one of both is wrong", "minimum_breaking_force")

    def _refuse_torque(self) -> None:
        if self.torque_factor is None:
            return
        if self.diameter is None:
            sentence = "'torque_factor' stands without 'diameter', by which a torque comes of it"
            raise refuse(f"{sentence}; give it, such as 'diameter: 44 mm'", "torque_factor")
        if self.torque_factor > _LARGEST_TORQUE_FACTOR:
            sentence = f"{100.0 * self.torque_factor:g} % is no torque factor of a rope"
            raise refuse(f"{sentence}; 9 % is usual of six strands, 1 % of the best others", "torque_factor")

    def _refuse_without_construction(self) -> None:
        for key in ("grade", "modulus"):
            if getattr(self, key) is not None:
                sentence = f"'{key}' stands without 'construction'"
                raise refuse(f"{sentence}; write 'construction: 6x36 IWRC' or leave it out", key)

    def _refuse_incomplete_construction(self, construction: str) -> None:
        if self.diameter is None:
            sentence = f"'diameter' is missing; a rope of construction '{construction}' needs it"
            raise refuse(f"{sentence}, such as 'diameter: 44 mm'")
        if not _SMALLEST_DIAMETER <= self.diameter <= _LARGEST_DIAMETER:
            sentence = f"{self.diameter / 1e-3:g} mm is no diameter of a rope"
            raise refuse(f"{sentence}; from 1 mm to 300 mm is right, such as 'diameter: 44 mm'", "diameter")
        if self.grade is None and self.minimum_breaking_force is None:
            sentence = f"'grade' is missing; a rope of construction '{construction}' needs it"
            raise refuse(f"{sentence}, such as 'grade: 1960', or its 'minimum_breaking_force'")
        if self.modulus is not None and self.modulus > _STEEL_MODULUS:
            sentence = f"{self.modulus / 1e9:g} kN/mm^2 is more than the 210 kN/mm^2 of solid steel"
            raise refuse(f"{sentence}; 80 to 115 kN/mm^2 is usual for a rope", "modulus")

    @property
    def catalogue(self) -> RopeClass | None:
        """Rope class of the construction, or None for a rope that is given otherwise."""
        return None if self.construction is None else rope_class(self.construction)

    @property
    def stiffness(self) -> float | None:
        """Axial stiffness EA [N], of a curve that of the same energy; None for an inextensible rope."""
        if self.curve is not None:
            return self.curve.axial_stiffness
        if self.catalogue is not None and self.diameter is not None:
            return self.catalogue.axial_stiffness(self.diameter, self.modulus)
        return self.axial_stiffness

    def bent(self, name: str, what: str) -> str | None:
        """Why a rope of this kind cannot be `what`, if its stiffness is a curve."""
        if self.curve is None:
            return None
        sentence = f"rope '{name}' has a curve, and {what} needs one stiffness"
        return f"{sentence}; give it an 'axial_stiffness', such as the slope about its working load"

    def pull(self, strain: float) -> tuple[float, float, float]:
        """Tension [N], its slope over the strain [N] and energy per length [N], of a rope that stretches.

        Args:
            strain: Not below 0.
        """
        if self.curve is not None:
            return self.curve.pull(strain)
        assert self.stiffness is not None  # has been checked to stretch
        return self.stiffness * strain, self.stiffness, 0.5 * self.stiffness * strain**2

    def strain_under(self, tension: float) -> float:
        """Strain at rest under a tension [N], not below 0, of a rope that stretches."""
        if self.curve is not None:
            return self.curve.strain_under(tension)
        assert self.stiffness is not None  # has been checked to stretch
        return tension / self.stiffness

    @property
    def mass_per_length(self) -> float:
        """Mass per length that counts in the lift [kg/m]."""
        if isinstance(self.mass, float):
            return self.mass
        if self.mass is None and self.catalogue is not None and self.diameter is not None:
            return self.catalogue.mass_per_length(self.diameter)
        return 0.0

    @property
    def breaking_force(self) -> float | None:
        """Minimum breaking force [N], or None if not known."""
        if self.minimum_breaking_force is not None:
            return self.minimum_breaking_force
        if self.catalogue is not None and self.diameter is not None and self.grade is not None:
            grade = quantity(f"{self.grade} N/mm^2", "stress")
            return self.catalogue.minimum_breaking_force(self.diameter, grade)
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

    @model_validator(mode="after")
    def _holds_its_limit(self) -> Shackle:
        force, limit = self.minimum_breaking_force, self.working_load_limit * _GRAVITY
        if force is not None and force < limit:
            breaks, holds = (format_quantity(one, "kN", 0) for one in (force, limit))
            sentence = f"this shackle would break at {breaks}, below its working load limit of {holds}"
            right = "4 to 6 times the limit is usual, and one of both is wrong"
            raise refuse(f"{sentence}; {right}", "minimum_breaking_force")
        return self

    @model_validator(mode="after")
    def _diameters_are_those_of_shackles(self) -> Shackle:
        for key in ("bow_diameter", "pin_diameter"):
            diameter = getattr(self, key)
            if diameter is not None and not _SMALLEST_SHACKLE <= diameter <= _LARGEST_SHACKLE:
                sentence = f"{diameter / 1e-3:g} mm is no diameter of a shackle"
                raise refuse(f"{sentence}; from 4 mm to 500 mm is right, such as '{key}: 97 mm'", key)
        return self


class SlingShackles(Element):
    """The shackles at the two ends of a sling."""

    what: ClassVar[str] = "the shackles of a sling"
    lone: ClassVar[tuple[str, ...]] = ("top", "bottom")

    top: Name | None = Field(None, description="Shackle at the upper end, a name of 'shackles'.")
    bottom: Name | None = Field(None, description="Shackle at the lug, a name of 'shackles'.")


class SlingBends(Element):
    """What the eyes of a sling lie on where they have no shackle."""

    what: ClassVar[str] = "what the eyes of a sling lie on"
    lone: ClassVar[tuple[str, ...]] = ("top",)

    top: PositiveLength | None = Field(
        None, description="Diameter of a hook's prong, pin or trunnion in its upper eye."
    )
    bottom: PositiveLength | None = Field(None, description="Diameter of a pin or trunnion in its lower eye.")

    @model_validator(mode="after")
    def _diameters_fit_into_eyes(self) -> SlingBends:
        for key in ("top", "bottom"):
            diameter = getattr(self, key)
            if diameter is not None and not _SMALLEST_SHACKLE <= diameter <= _LARGEST_IN_AN_EYE:
                sentence = f"{diameter / 1e-3:g} mm is no diameter for the eye of a sling"
                raise refuse(f"{sentence}; from 4 mm to 5 m is right, such as '{key}: 300 mm'", key)
        return self


class SlingDefaults(Element):
    """What all slings have unless they say otherwise."""

    what: ClassVar[str] = "sling_defaults"

    length: PositiveLength | None = Field(
        None, description="Effective length: bearing to bearing, shackles included, unloaded."
    )
    rope: Name | None = Field(None, description="Kind of rope, a name of 'ropes'.")
    rope_weight: RopeWeightWord | None = Field(None, description=WEIGHT_SHOWN)
    rope_nodes: RopeNodes | None = Field(None, description=NODES_SHOWN)
    breaks_at: BreaksAt | None = Field(None, description=f"{BREAKS_SHOWN} As its rope if not given.")
    shackles: SlingShackles | None = Field(None, description="Shackles at both ends.")
    bends_about: SlingBends | None = Field(
        None,
        description="Diameters of what its eyes lie on where there is no shackle, such as {top: 300 mm} on "
        "the prong of a hook.",
    )
    tolerance: LengthTolerance | None = Field(
        None, description="Tolerance of the length, plus and minus: a share of it, or a length."
    )


class Sling(SlingDefaults):
    """A sling from a hook, moving sheave or other gear to a lug, or over an extension sheave to two lugs."""

    what: ClassVar[str] = "a sling"

    from_: Name | None = Field(
        None,
        alias="from",
        description="Where its upper end is: a moving sheave like 'e1.3', a hook by its name as steps of the "
        "plan have it, a lug of a spreader like 'bar.B1', or a compensator, from whose rod it hangs.",
    )
    over: Name | None = Field(
        None, description="In place of 'from': the extension sheave that it runs over, from end to end."
    )
    to: Names = Field(
        description="The lug it holds, of the load like 'block.L3' or of a spreader, or the extension sheave "
        "or compensator that hangs on it; with 'over' the two of them."
    )
    chain_hoist: ChainHoist | None = Field(
        None,
        description="Chain hoist, hydraulic cylinder or turnbuckle in it, by which steps shorten it ('haul') "
        "or lengthen it ('veer'); none if not given.",
    )
    cut_at: Time | None = Field(None, description=CUT_SHOWN)
    remark: Text | None = Field(None, description="A remark for people.")

    @model_validator(mode="after")
    def _one_top(self) -> Sling:
        if self.from_ is None and self.over is None:
            raise refuse("'from' is missing; a sling hangs 'from' something or runs 'over' a sheave")
        if self.from_ is not None and self.over is not None:
            raise refuse("'from' and 'over' stand together; a sling has one of them", "over")
        return self
