"""Cranes and equalizers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator
from pydantic.json_schema import JsonSchemaValue

from gantline.scenario.base import Element
from gantline.scenario.cranes.heave import HeaveCompensation
from gantline.scenario.cranes.reeving import HoistDrum, HookBlock, Reeving
from gantline.scenario.errors import closest, shorten
from gantline.scenario.file.other_words import MEANT
from gantline.scenario.file.tree import MapNode
from gantline.scenario.quantities import (
    Angle,
    Flag,
    Lengths,
    Mass,
    Name,
    NotNegativeLength,
    Position,
    PositiveAcceleration,
    PositiveForce,
    PositiveInertia,
    PositiveLength,
    PositiveMass,
    PositivePower,
    PositiveSpeed,
    PositiveStiffness,
    Ratio,
    Reader,
    RotationalDamping,
    Time,
    Torque,
    found,
    refuse,
)
from gantline.scenario.rope_weight import RopeWeightWord
from gantline.scenario.sheave import SheaveWords

__all__ = [
    "CRANE_TYPES",
    "Equalizer",
    "EqualizerFrame",
    "EqualizerParts",
    "EqualizerType",
    "FixedHook",
    "FixedSheaves",
    "Hinge",
    "Hoist",
    "MovingSheaves",
    "RopeEnds",
    "Travel",
]

#: Crane types that this version can simulate; the first refuses what is none of them.
CRANE_TYPES = ("fixed_hook", "goliath", "floating_crane", "crawler")
#: What other words for a type of crane mean.
_MEANT = {
    **dict.fromkeys(("sheerleg", "sheerlegs", "pedestal_crane"), "'type: floating_crane'"),
    **dict.fromkeys(
        ("double_trolley_crane", "gantry", "gantry_crane", "portal_crane"),
        "'type: goliath'",
    ),
    **dict.fromkeys(
        (
            "bridge_crane",
            "eot",
            "eot_crane",
            "hall_crane",
            "overhead",
            "overhead_crane",
            "overhead_travelling_crane",
        ),
        "'type: goliath' with 'end_carriages' in place of legs, and the 'rail_level' that these run at,",
    ),
    **dict.fromkeys(("crawler_crane", "mobile_crane"), "'type: crawler'"),
}
#: Tower cranes whose boom luffs have a type here, those with a trolley on a level jib have none.
_TOWERS = ("tower_crane", "tower", "luffing_tower_crane", "luffing_crane")
#: A strand jack is no crane: what stands for it.
_JACKS = ("strand_jack", "strand_jacks")


class Hoist(Element):
    """What the hoist of a hook can do."""

    what: ClassVar[str] = "a hoist"

    speed: PositiveSpeed = Field(
        description="Highest hoisting speed; on a drum with layers that on the first."
    )
    creep: PositiveSpeed | None = Field(None, description="Creep speed.")
    acceleration: PositiveAcceleration = Field(
        description="Highest acceleration; also used where a step names none."
    )
    capacity: PositiveForce | None = Field(
        None,
        description="Largest pull of each rope on the first layer of the drum that motor and brake hold; "
        "whatever it takes where it is left out.",
    )
    power: PositivePower | None = Field(
        None, description="Largest power of the motor for hoisting, all ropes together, beside a capacity."
    )
    brake: PositiveForce | None = Field(
        None,
        description="Pull of each rope on the first layer that the brake holds, once an emergency stop has "
        "thrown it in; the capacity if not given.",
    )
    emergency_acceleration: PositiveAcceleration | None = Field(
        None,
        description="Deceleration of the hook in an emergency stop, of a hoist without a capacity.",
    )
    heave_compensation: HeaveCompensation | None = Field(
        None, description="What it can do against the heave of its boom head, on a vessel."
    )

    @model_validator(mode="after")
    def _creeps_slower(self) -> Hoist:
        if self.creep is not None and self.creep > self.speed:
            sentence = f"creep of {self.creep * 60:g} m/min is faster than the highest speed"
            raise refuse(f"{sentence} of {self.speed * 60:g} m/min; they may be the wrong way round", "creep")
        return self

    @model_validator(mode="after")
    def _power_needs_a_capacity(self) -> Hoist:
        for key in ("power", "brake"):
            if getattr(self, key) is not None and self.capacity is None:
                raise refuse(f"'{key}' is given without 'capacity', the largest pull at low speed", key)
        if self.emergency_acceleration is not None and self.capacity is not None:
            sentence = "'emergency_acceleration' and 'capacity' are given together"
            raise refuse(
                f"{sentence}; a hoist with a capacity is stopped by its brake", "emergency_acceleration"
            )
        return self


class FixedHook(Element):
    """A hook that moves up and down as told, with no crane behind it."""

    what: ClassVar[str] = "a crane"

    type: Literal["fixed_hook"] = Field(description="Type of crane: 'fixed_hook'.")
    at: Position = Field(description="Bearing point of the hook at the start.")
    rated_capacity: PositiveMass | None = Field(None, description="Rated capacity.")
    rating_includes_hook_block: Flag = Field(
        False,
        description="true: the rated capacity is compared with the hoist load, false: with the hook load.",
    )
    wind_limit: PositiveSpeed | None = Field(
        None, description="Largest gust in which the crane may lift whose hook this is."
    )
    hook_block_mass: Mass = Field(
        0.0, description="Mass of hook block and hanging falls; counts in the hoist load."
    )
    hook_block: HookBlock | None = Field(
        None, alias="block", description="Hook block; of a hook with 'reeving'."
    )
    reeving: Reeving | None = Field(
        None, description="Ropes that the hook hangs in; without it the hook moves up and down as told."
    )
    drum: HoistDrum | None = Field(None, description="Drum of the hoist; of a hook with 'reeving'.")
    hoist: Hoist = Field(description="Speed and acceleration of the hoist, of the hook.")

    @model_validator(mode="after")
    def _reeving_is_whole(self) -> FixedHook:
        parts = {"block": self.hook_block, "drum": self.drum}
        if self.reeving is None:
            for key, given in parts.items():
                if given is not None:
                    mass = "; 'hook_block_mass' says what it weighs" if key == "block" else ""
                    without = f"'{key}' is given without 'reeving', the ropes that the hook hangs in"
                    raise refuse(f"{without}{mass}", key)
            if self.hoist.capacity is not None:
                sentence = (
                    "'hoist.capacity' is given without 'reeving'; a hook that moves as told has no limit"
                )
                raise refuse(sentence, "hoist")
            return self
        for key, given in parts.items():
            if given is None:
                right = {"block": "{mass: 12 t, height: 3 m}", "drum": "{diameter: 1.6 m}"}[key]
                raise refuse(f"'{key}' is missing; reeving needs it, such as '{key}: {right}'", "reeving")
        if self.hook_block_mass > 0:
            sentence = "'hook_block_mass' and 'block' are given together; 'block.mass' says it"
            raise refuse(sentence, "hook_block_mass")
        assert self.drum is not None
        if self.hoist.capacity is not None and self.drum.inertia is None:
            sentence = "a hoist with a capacity needs the inertia of its drum"
            raise refuse(f"{sentence}; give 'moment_of_inertia' or 'rotating_mass'", "drum")
        return self

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """A crane of another type has other keys: say only that the type is not there."""
        kind = data.get("type")
        if kind == "fixed_hook":
            return
        known = ", ".join(f"'{name}'" for name in CRANE_TYPES)
        if "type" not in data:
            own = cls.keys()
            others = [key for key in data if key not in own]
            misspelt = next((key for key in others if "type" in MEANT.get(key, ())), closest("type", others))
            hint = "" if misspelt is None else f" (is '{shorten(misspelt)}' meant for 'type'?)"
            raise refuse(f"'type' is missing; a crane is one of {known}{hint}")
        if isinstance(kind, str) and kind in _MEANT:
            raise refuse(f"a {found(kind)} is written as {_MEANT[str(kind)]} here", "type")
        if kind in _TOWERS:
            luffs = "a tower crane that luffs is written as 'type: floating_crane', ashore with 'position'"
            raise refuse(f"{luffs} and 'heading' in place of a 'vessel'; none here has a level jib", "type")
        if kind in _JACKS:
            drum = "a drum of 'mechanics' with a 'drive', its bundle a rope from there to the load"
            hook = "or 'type: fixed_hook' with a sling, where the load goes straight up"
            raise refuse(f"a strand jack is {drum}; {hook}", "type")
        right = f"known here: {known}, and names of 'crane_types'"
        raise refuse(f"{found(kind)} is not a type of crane; {right}", "type")


class EqualizerFrame(Element):
    """The frame of an equalizer."""

    what: ClassVar[str] = "the frame of an equalizer"

    mass: PositiveMass = Field(description="Mass without moving sheaves.")
    length: PositiveLength = Field(description="Length, along the row of sheaves.")
    width: PositiveLength = Field(description="Width.")
    height: PositiveLength = Field(description="Height.")
    centre_of_gravity_below_hook: NotNegativeLength = Field(
        description="Depth of the frame's centre of gravity below the bearing of the hook."
    )
    inertia_about_vertical: PositiveInertia | None = Field(
        None, description="Inertia about the vertical through its centre; of a solid box if not given."
    )
    inertia_about_length: PositiveInertia | None = Field(
        None, description="Inertia about its length axis; of a solid box if not given."
    )
    inertia_about_width: PositiveInertia | None = Field(
        None, description="Inertia about its width axis; of a solid box if not given."
    )


class Hinge(Element):
    """The hinge of an equalizer under its hook."""

    what: ClassVar[str] = "the hinge of an equalizer"

    axis: Literal["vertical"] = Field("vertical", description="Axis of the hinge.")
    friction: Torque = Field(0.0, description="Friction torque of the turning.")
    damping: RotationalDamping = Field(0.0, description="Damping of the turning.")
    tilts: Flag = Field(
        False,
        description="true: below the hinge the frame tilts too, about its length and about its width; false: "
        "the hook holds it upright, whatever moment that takes.",
    )
    tilt_friction: Torque = Field(
        0.0, description="Friction torque of the tilting about either axis; with 'tilts: true'."
    )
    tilt_damping: RotationalDamping = Field(
        0.0, description="Damping of the tilting about either axis; with 'tilts: true'."
    )

    @model_validator(mode="after")
    def _only_what_tilts_rubs(self) -> Hinge:
        for key in ("tilt_friction", "tilt_damping"):
            if getattr(self, key) > 0.0 and not self.tilts:
                raise refuse(f"'{key}' is given without 'tilts: true'; the frame is held upright", key)
        return self


class RopeEnds(Element):
    """The two dead ends of the equalizing rope on the frame."""

    what: ClassVar[str] = "rope_ends"

    along: Lengths = Field(description="The two positions along the frame.")
    below_hook: PositiveLength = Field(description="Depth below the bearing of the hook.")


class FixedSheaves(SheaveWords):
    """The sheaves that are fixed in the frame."""

    what: ClassVar[str] = "fixed_sheaves"

    along: Lengths = Field(description="Positions along the frame.")
    below_hook: PositiveLength = Field(description="Depth of their centres below the bearing of the hook.")
    pitch_diameter: PositiveLength = Field(description="Diameter on which the rope's axis lies.")


class MovingSheaves(FixedSheaves):
    """The sheaves that travel up and down, in guides or freely; each carries one sling."""

    what: ClassVar[str] = "moving_sheaves"

    below_hook: PositiveLength = Field(
        description="Depth of their centres below the hook's bearing, at the start."
    )
    mass: PositiveMass = Field(description="Mass of one moving sheave with block, pin and eye.")
    guided: Literal["vertical", "none"] = Field(
        "vertical",
        description="'vertical', the default: the frame guides them up and down. 'none': they hang free in "
        "the equalizing rope, and a sling that leans draws its sheave aside.",
    )


@dataclass(frozen=True)
class LockedReader(Reader):
    """Reads ``true``, ``false`` or the moving sheaves that are locked, counted from 1."""

    def read(self, value: object) -> bool | tuple[int, ...]:
        """All, none or some."""
        if value in ("true", "false"):
            return value == "true"
        items = [str(item) for item in (value if isinstance(value, list) else [value])]
        if not items or not all(item.isascii() and item.isdigit() for item in items):
            right = "'true', 'false' or moving sheaves such as [1, 5]"
            raise refuse(f"found {found(value)}; {right} is needed")
        places = tuple(int(item) for item in items)
        if len(set(places)) < len(places):
            raise refuse("names a moving sheave twice; each stands once")
        return places

    def shown(self) -> JsonSchemaValue:
        """A truth value or a list of whole numbers."""
        number: JsonSchemaValue = {"type": "integer", "minimum": 1}
        return {
            "anyOf": [
                {"enum": [True, False, "true", "false"]},
                number,
                {"type": "array", "items": number, "minItems": 1},
            ]
        }


class Travel(Element):
    """How far moving sheaves may travel from where the lift file has them."""

    what: ClassVar[str] = "travel"

    up: NotNegativeLength = Field(description="Travel up from the start.")
    down: NotNegativeLength = Field(description="Travel down from the start.")
    locked: Annotated[bool | tuple[int, ...], LockedReader()] = Field(
        False,
        description="true: locking pins hold all moving sheaves where they start; a list such as [1, 5]: "
        "those of these sheaves. Steps of the plan pull them.",
    )
    pin_capacity: PositiveMass | None = Field(
        None, description="What a locking pin bears; not checked if not given."
    )
    stops: Flag = Field(
        False, description="true: stops end the travel; false: sheaves may go past it, which is only checked."
    )
    stop_stiffness: PositiveStiffness = Field(100e6, description="Stiffness of the stops at both ends.")
    stop_damping_time: Time = Field(2e-3, description="Damping over stiffness of the stops.")


class EqualizerParts(Element):
    """All that an equalizer type may say; a type says all of it, an equalizer only what differs."""

    what: ClassVar[str] = "an equalizer"

    rated_capacity: PositiveMass | None = Field(None, description="Rated capacity below its moving sheaves.")
    frame: EqualizerFrame | None = Field(None, description="The frame.")
    hinge: Hinge | None = Field(None, description="The hinge under the hook; without friction if not given.")
    rope: Name | None = Field(None, description="Equalizing rope, a name of 'ropes'.")
    rope_weight: RopeWeightWord | None = Field(
        None,
        description="How the weight of the equalizing rope acts: 'none', or 'lumped' to frame and moving "
        "sheaves. If not given: 'lumped' where its mass per length is known, else 'none'.",
    )
    rope_ends: RopeEnds | None = Field(None, description="Dead ends of the equalizing rope.")
    sheaves: SheaveWords | None = Field(
        None,
        description="Losses and inertia of all its sheaves, unless fixed or moving ones have their own. "
        "Inertia if none is given: half of the mass of a moving sheave.",
    )
    fixed_sheaves: FixedSheaves | None = Field(None, description="Sheaves fixed in the frame.")
    moving_sheaves: MovingSheaves | None = Field(None, description="Sheaves that travel.")
    travel: Travel | None = Field(None, description="Limits of travel.")
    mechanism: Literal["sheaves", "approximated"] | None = Field(
        None,
        description="'sheaves', the default: moving sheaves on one equalizing rope. 'approximated': none, "
        "the slings hang from the frame and their lengths are adjusted after every step; a baseline.",
    )
    adjusting_factor: Ratio | None = Field(
        None,
        description="approximated: share of a tension's distance from the mean that one step lets go; above "
        "0, all of it at 1.",
    )


class EqualizerType(EqualizerParts):
    """A type of equalizer, for several equalizers of one make."""

    what: ClassVar[str] = "an equalizer type"


class Equalizer(EqualizerParts):
    """An equalizer under a hook."""

    what: ClassVar[str] = "an equalizer"

    type: Name | None = Field(
        None, description="A name of 'equalizer_types' that gives what is not said here."
    )
    hangs_from: Name = Field(description="The hook it hangs from, by its name as steps have it.")
    heading: Angle = Field(
        0.0, description="Direction of the frame's length at the start, from world x towards y."
    )
