"""Vessels: bodies afloat in the words of a yard.

The axes of a vessel begin at stern, keel and centre plane: x forward, y to port, z up.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.afloat.water import MOTIONS, Afloat, HullShape, WaterDamping, WaveForces
from gantline.scenario.base import Element, Named
from gantline.scenario.mechanics import BodyInertia
from gantline.scenario.quantities import (
    Angle,
    ListOf,
    Name,
    Position,
    PositiveLength,
    PositiveMass,
    PositiveTime,
    Quantity,
    Ratio,
    Sizes,
    Text,
    refuse,
)

__all__ = [
    "CAPSIZED_BEYOND",
    "DECK_EDGE",
    "CriticalDamping",
    "Periods",
    "Vessel",
    "VesselDamping",
    "VesselHull",
    "VesselMass",
    "WaveMotion",
]

#: Angle of a vessel's own z axis from plumb beyond which it has capsized [rad]. By the 2008 IS Code, part A
#: 2.3, no righting arm beyond 50 deg counts; a little more is left for a swing that comes back.
CAPSIZED_BEYOND = math.radians(60.0)
#: What the edge of a vessel's deck is called beside its openings.
DECK_EDGE = "deck_edge"
_Place = Annotated[tuple[float, float], ListOf(Quantity("length"), 2)]


class VesselHull(HullShape):
    """The hull of a vessel: a box along its axes, or a mesh from a CAD file."""

    what: ClassVar[str] = "the hull of a vessel"

    keel: Position | None = Field(
        None, description="Middle of the box's bottom; half its length ahead of the stern if not given."
    )

    @property
    def bottom(self) -> tuple[float, float, float]:
        """Middle of the box's bottom in the vessel's axes [m]."""
        if self.keel is None and self.box is not None:
            return (self.box[0] / 2, 0.0, 0.0)
        return super().bottom


class VesselMass(Element):
    """Something of a vessel that has a weight."""

    what: ClassVar[str] = "a mass of a vessel"

    mass: PositiveMass = Field(description="Mass.")
    at: Position = Field(description="Its centre of gravity in the vessel's axes.")


class Periods(Element):
    """Natural periods of motions that the water does not restore."""

    what: ClassVar[str] = "periods"

    surge: PositiveTime | None = Field(None, description="Along x.")
    sway: PositiveTime | None = Field(None, description="Along y.")
    yaw: PositiveTime | None = Field(None, description="About z.")


#: Motions that the water restores.
_MOTIONS = ("heave", "roll", "pitch")


class CriticalDamping(Element):
    """Damping by what is critical for each motion by itself."""

    what: ClassVar[str] = "shares of critical damping"

    surge: Ratio | None = Field(None, description="Along x; needs its period.")
    sway: Ratio | None = Field(None, description="Along y; needs its period.")
    heave: Ratio | None = Field(None, description="Along z.")
    roll: Ratio | None = Field(None, description="About x.")
    pitch: Ratio | None = Field(None, description="About y.")
    yaw: Ratio | None = Field(None, description="About z; needs its period.")
    periods: Periods = Field(Periods(), description="Periods on the moorings of surge, sway and yaw.")

    @model_validator(mode="after")
    def _are_shares(self) -> CriticalDamping:
        for key in (*_MOTIONS, *Periods.model_fields):
            share = getattr(self, key)
            if share is not None and share > 1.0:
                sentence = f"{100.0 * share:g} % of critical damping; up to 100 % is right"
                raise refuse(f"{sentence}, and 2 % to 30 % usual, such as '{key}: 20 %'", key)
        return self

    @model_validator(mode="after")
    def _periods_where_needed(self) -> CriticalDamping:
        for key in Periods.model_fields:
            share, period = getattr(self, key), getattr(self.periods, key)
            if share and period is None:
                sentence = f"the water restores no {key}, so that no damping is critical by itself"
                raise refuse(f"{sentence}; give its period on the moorings: 'periods: {{{key}: 60 s}}'", key)
            if share is None and period is not None:
                raise refuse(f"a period of {key} without a share of its critical damping", "periods")
        return self


class VesselDamping(WaterDamping):
    """What still water resists a vessel's motion with."""

    critical: CriticalDamping | None = Field(
        None,
        description="Shares of critical damping, about the centre of gravity of all that is on the vessel.",
    )

    @model_validator(mode="after")
    def _once(self) -> VesselDamping:
        for key in MOTIONS:
            if (
                key in self.model_fields_set
                and self.critical is not None
                and getattr(self.critical, key) is not None
            ):
                raise refuse(f"'{key}' stands here and under 'critical'; leave one of them out", key)
        return self


class WaveMotion(Element):
    """How a vessel moves where that is known beforehand, whatever hangs from it: by RAOs, or by a record."""

    what: ClassVar[str] = "a wave motion"

    raos: Text | None = Field(None, description="Table of RAOs of displacement beside the lift file: .csv.")
    phases: Literal["lag", "lead"] | None = Field(
        None,
        description="Whether phases of the table say how late a motion is after the crest at 'at', or how "
        "early before it.",
    )
    record: Text | None = Field(
        None,
        description="In place of RAOs: how the point 'at' moved, over time, a .csv beside the lift file.",
    )
    at: Position = Field(
        description="Point of the vessel whose motion the table has and phases count from, vessel's axes."
    )

    @model_validator(mode="after")
    def _by_one_table(self) -> WaveMotion:
        if (self.raos is None) == (self.record is None):
            raise refuse("needs 'raos', a table of RAOs, or 'record', a motion over time, and not both")
        if self.raos is not None and self.phases is None:
            raise refuse("'phases' is missing; 'lag' or 'lead' says how the phases of the RAOs count")
        if self.record is not None and self.phases is not None:
            raise refuse("a record has no phases; leave this out", "phases")
        return self


#: Keys of what pushes a vessel, or is in it, which one with 'wave_motion' does not feel.
_UNFELT = (
    "wave_forces",
    "radiation",
    "added_mass",
    "water_damping",
    "wind_areas",
    "current_areas",
    "tanks",
)


class Vessel(Afloat):
    """A vessel: one body that floats."""

    what: ClassVar[str] = "a vessel"

    type: Name | None = Field(None, description="A name of 'vessel_types' that gives what is not said here.")
    position: _Place = Field(
        (0.0, 0.0), description="Where stern and centre plane are at the start, x and y of the world."
    )
    heading: Angle = Field(0.0, description="Direction of its x axis, from world x towards y.")
    draft: PositiveLength = Field(
        description="Draft at half length at the start, along its own z; with 'start: rest' a guess."
    )
    heel: Angle = Field(0.0, description="Heel at the start, to starboard positive.")
    trim: Angle = Field(0.0, description="Trim at the start, by the stern positive.")
    hull: VesselHull = Field(description="What of it displaces water.")
    water_damping: VesselDamping | None = Field(None, description="What water resists its motion with.")
    wave_forces: WaveForces | None = Field(None, description="What waves do to it; nothing if not given.")
    wave_motion: WaveMotion | None = Field(
        None, description="How it moves in waves where that is known beforehand; nothing else moves it then."
    )
    masses: Named[VesselMass] = Field(
        {},
        description="What it weighs by itself, by name: without cranes, hooks and contents of tanks. "
        "Not needed beside 'wave_motion'.",
    )
    radii_of_gyration: Sizes | None = Field(
        None, description="Of these masses together about their centre of gravity, axes x, y, z."
    )
    inertia: BodyInertia | None = Field(
        None, description="Inertia of these masses together, in place of 'radii_of_gyration'."
    )
    openings: Named[Position] | None = Field(
        None, description="Points that must stay above water beside the deck's edge, by name: vents, hatches."
    )
    remark: Text | None = Field(None, description="A remark for people.")

    @model_validator(mode="after")
    def _one_inertia(self) -> Vessel:
        if self.wave_motion is None and not self.masses:
            raise refuse("'masses' is missing; a vessel needs it unless it has a 'wave_motion'")
        known = [one for one in (self.radii_of_gyration, self.inertia) if one is not None]
        if len(known) > 1 or (self.wave_motion is None and not known):
            raise refuse("needs 'radii_of_gyration' or 'inertia', and not both")
        return self

    @model_validator(mode="after")
    def _moves_once(self) -> Vessel:
        for key in _UNFELT if self.wave_motion is not None else ():
            if getattr(self, key) is not None:
                sentence = "a vessel with 'wave_motion' moves by that and by nothing else"
                raise refuse(f"{sentence}: leave '{key}' or 'wave_motion' out", key)
        return self

    @property
    def is_carried(self) -> bool:
        """Whether it moves as its 'wave_motion' says."""
        return self.wave_motion is not None

    @property
    def mass(self) -> float:
        """Mass of the vessel by itself [kg]; 0 where it is not given."""
        return math.fsum(one.mass for one in self.masses.values())

    @property
    def centre_of_gravity(self) -> tuple[float, float, float]:
        """Centre of gravity of the vessel by itself, its axes [m]; without masses the point of its motion."""
        if not self.masses:
            assert self.wave_motion is not None  # validated
            return self.wave_motion.at
        parts = self.masses.values()
        x, y, z = (math.fsum(one.mass * one.at[axis] for one in parts) / self.mass for axis in range(3))
        return x, y, z

    @property
    def own_inertia(self) -> BodyInertia:
        """Inertia of the vessel by itself about its centre of gravity."""
        if self.radii_of_gyration is None:
            assert self.inertia is not None  # validated
            return self.inertia
        xx, yy, zz = (self.mass * radius**2 for radius in self.radii_of_gyration)
        return BodyInertia.model_construct(xx=xx, yy=yy, zz=zz)
