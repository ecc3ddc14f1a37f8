"""Reeving of a hook: hook block, ropes between upper sheaves and hook block, their drum."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Final

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.cranes.drum import RopeOnDrum
from gantline.scenario.quantities import (
    Length,
    Name,
    Number,
    PositiveLength,
    PositiveMass,
    Ratio,
    Word,
    refuse,
)
from gantline.scenario.rope_weight import RopeWeightWord
from gantline.scenario.sheave import (
    SheaveLosses,
    SheaveWords,
    refuse_efficiency,
    sheave_losses,
    taken_together,
)

__all__ = ["HoistDrum", "HookBlock", "Reeving", "hoist_drum", "hoist_ropes"]

#: Lays of the ropes of a hook, one against another.
LAYS: Final = ("alike", "left_and_right")
#: Steel [kg/m^3], for the mass of a sheave that is not given.
_STEEL: Final = 7850.0


class HookBlock(Element):
    """A hook block: it hangs in the ropes, and the hook under it."""

    what: ClassVar[str] = "a hook block"

    mass: PositiveMass = Field(description="Mass with hook and sheaves.")
    height: PositiveLength = Field(
        description="From the bearing point of the hook up to its sheaves' centres."
    )


class Reeving(Element):
    """Ropes between the upper sheaves and the hook block."""

    what: ClassVar[str] = "reeving"

    ropes: Annotated[int, Number(least=1, most=8, whole=True)] = Field(
        1, description="Ropes side by side, all on one drum."
    )
    parts_each: Annotated[int, Number(least=1, most=40, whole=True)] = Field(
        description="Parts of line of each rope. Its dead end is above where they are even, on the "
        "hook block where they are odd."
    )
    rope: Name = Field(description="Kind of rope, a name of 'ropes'.")
    sheave_diameter: PositiveLength | None = Field(
        None, description="Pitch diameter of the sheaves above and below, to the centre line of the rope."
    )
    sheave_diameter_ratio: Annotated[float, Number(least=5.0, most=100.0)] | None = Field(
        None, description="The same over the diameter of the rope, D/d, in place of 'sheave_diameter'."
    )
    sheave_spacing: PositiveLength | None = Field(
        None,
        description="Distance of neighbouring sheaves of the hook block along their axle; the farther falls "
        "stand apart the less they twist. Two diameters of the rope count for that if not given, the least "
        "that there can be.",
    )
    lay: Annotated[str, Word(LAYS)] = Field(
        "alike",
        description="'left_and_right': as many ropes of left-hand lay as of right-hand lay, which hold each "
        "other from twisting the falls; 'alike' if not given.",
    )
    sheave_efficiency: Ratio | None = Field(
        None, description="Efficiency of one sheave; ideal sheaves if neither this nor 'sheaves' says it."
    )
    sheaves: SheaveWords | None = Field(
        None,
        description="Losses and inertia of each sheave. Inertia if none is given: of a disc of steel as "
        "thick as the rope.",
    )
    upper_sheaves_at: Length | None = Field(
        None, description="Height of the upper sheaves' centres; of a hook that does not hang at a boom."
    )
    below_head: PositiveLength | None = Field(
        None,
        description="Of a hook at a boom: depth of the upper sheaves' centres below their pin at its head.",
    )
    sheave_block_mass: PositiveMass | None = Field(
        None,
        description="Of a hook at a boom: mass of the sheave block that hangs at its head; of its sheaves "
        "as discs of steel as thick as the rope if not given.",
    )
    lead_line: PositiveLength = Field(5.0, description="Rope from the last upper sheave down to the drum.")
    rope_weight: RopeWeightWord | None = Field(
        None,
        description="How the weight of the ropes acts: 'none', or 'lumped' to hook block and upper sheaves. "
        "If not given: 'lumped' where the mass per length of the rope is known, else 'none'.",
    )

    @model_validator(mode="after")
    def _one_way_to_say_it(self) -> Reeving:
        ways = (self.sheave_diameter, self.sheave_diameter_ratio)
        if (ways[0] is None) == (ways[1] is None):
            found = "none of them" if ways[0] is None else "both"
            raise refuse(f"has one of 'sheave_diameter' and 'sheave_diameter_ratio'; found {found}")
        if self.lay == "left_and_right" and self.ropes % 2:
            sentence = f"'lay: left_and_right' takes an even number of 'ropes'; found {self.ropes}"
            raise refuse(f"{sentence}, and one of them has no other against it", "lay")
        if self.sheave_efficiency is not None:
            refuse_efficiency(self.sheave_efficiency, "sheave_efficiency", "sheaves: {loss: 2 %}")
        if self.sheave_efficiency is not None and self.sheaves is not None:
            said = [
                key for key in ("bearing", "efficiency", "loss") if getattr(self.sheaves, key) is not None
            ]
            if said:
                sentence = f"'sheave_efficiency' and 'sheaves.{said[0]}' are given together"
                raise refuse(f"{sentence}; one of them says it", "sheave_efficiency")
        return self

    @property
    def parts(self) -> int:
        """Parts of line of all ropes."""
        return self.ropes * self.parts_each

    def diameter(self, rope_diameter: float | None) -> float:
        """Pitch diameter of the sheaves [m]; `rope_diameter` [m] where it is known."""
        if self.sheave_diameter is not None:
            return self.sheave_diameter
        assert self.sheave_diameter_ratio is not None and rope_diameter is not None  # checked with the file
        return self.sheave_diameter_ratio * rope_diameter

    @property
    def words(self) -> SheaveWords:
        """Losses and inertia of a sheave, as said."""
        own = None
        if self.sheave_efficiency is not None:
            own = SheaveWords().model_copy(update={"efficiency": self.sheave_efficiency})
        return taken_together([own, self.sheaves])

    def losses(self, rope_diameter: float | None, rope_mass: float) -> SheaveLosses:
        """What each sheave does to the rope, of the diameter [m] and mass [kg/m] that are known of it."""
        own = self._disc(rope_diameter)
        return sheave_losses(self.words, self.diameter(rope_diameter) / 2, rope_mass, own)

    def sheave_block_at_head(self, rope_diameter: float | None) -> float | None:
        """Mass of the sheave block at a boom head [kg]; None where nothing says it."""
        disc = self._disc(rope_diameter)
        if self.sheave_block_mass is not None or disc is None:
            return self.sheave_block_mass
        return disc * self.ropes * ((self.parts_each + 1) // 2)

    def _disc(self, rope_diameter: float | None) -> float | None:
        if rope_diameter is None:
            return None
        return _STEEL * math.pi / 4 * self.diameter(rope_diameter) ** 2 * rope_diameter


def hoist_drum(hook: str) -> str:
    """Name of the drum of a hook in recordings."""
    return f"{hook}.drum"


def hoist_ropes(hook: str, reeving: Reeving) -> list[str]:
    """Names of the ropes of a hook in recordings."""
    return [f"hoist.{hook}.{place}" for place in range(1, reeving.ropes + 1)]


class HoistDrum(RopeOnDrum):
    """The drum of a hoist; all ropes of the hook wind on it alike."""

    what: ClassVar[str] = "the drum of a hoist"

    diameter: PositiveLength = Field(description="Pitch diameter of the first layer.")

    @model_validator(mode="after")
    def _one_way_to_say_it(self) -> HoistDrum:
        if self.moment_of_inertia is not None and self.rotating_mass is not None:
            raise refuse("has one of 'moment_of_inertia' and 'rotating_mass'; found both", "rotating_mass")
        return self

    @property
    def inertia(self) -> float | None:
        """Mass that moves with the rope of the first layer [kg]; None where it is not known."""
        return self.mass_on(self.diameter)
