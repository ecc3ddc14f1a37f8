"""The steps of a plan, one class for each verb."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.file.tree import MapNode
from gantline.scenario.plan.bounds import MeasuresReader, Require
from gantline.scenario.plan.condition import Condition
from gantline.scenario.quantities import (
    Angle,
    Length,
    Name,
    Names,
    PositiveAcceleration,
    PositiveAngularAcceleration,
    PositiveAngularSpeed,
    PositiveLength,
    PositiveMass,
    PositiveMassFlow,
    PositiveSpeed,
    Quantity,
    Text,
    Time,
    WordOr,
    refuse,
)

__all__ = [
    "VERBS",
    "AlongStep",
    "DrumStep",
    "HaulInStep",
    "HaulStep",
    "HoistStep",
    "HoldStep",
    "HookStep",
    "Kind",
    "LineStep",
    "LowerStep",
    "LuffStep",
    "MovingStep",
    "PayOutStep",
    "PumpStep",
    "PumpWay",
    "SlewStep",
    "StartingStep",
    "TravelStep",
    "TraverseStep",
    "TurnStep",
    "VeerStep",
]

Kind = Literal["hook", "drum", "trolley", "crane", "boom", "upper", "line", "sling"]


#: Keys by which a step says what it does.
VERBS = (
    "hoist",
    "lower",
    "traverse",
    "travel",
    "luff",
    "slew",
    "lead",
    "haul_in",
    "pay_out",
    "haul",
    "veer",
    "pump",
    "hold",
)


class _AnyStep(Element):
    step: Text = Field(description="Name of the step; each has its own.")
    report: Annotated[tuple[str, ...], MeasuresReader()] = Field(
        (), description="Measures to report at its end."
    )
    require: Require | None = Field(None, description="What has to hold at its end.")
    cut: Names = Field((), description="Rope or ropes that are cut as it begins, like 'sling.S1'.")
    detach: Names = Field(
        (),
        description="Sling or slings that are taken off as it begins, like 'sling.S1'; they have to be "
        "slack. Also ropes of 'mechanics'.",
    )
    attach: Names = Field(
        (),
        description="Sling or slings that are put on as it begins, like 'sling.S1'; they have to be long "
        "enough for where their ends then are. Before, they are not there; their mass hangs at their upper "
        "ends all along.",
    )
    remove_supports: Names = Field(
        (),
        description="Supports that are taken away as it begins: a whole group, like 'keel_blocks', or one, "
        "like 'keel_blocks.2.3'.",
    )
    pull_pins: Names = Field(
        (),
        description="Locking pins that are pulled as it begins: those of an equalizer, like 'e1', or of a "
        "moving sheave, like 'e1.2'.",
    )
    put_in_pins: Names = Field(
        (),
        description="Locking pins that are put in as it begins, where their sheaves then are; they have to "
        "be at rest.",
    )
    open_hinges: Names = Field(
        (), description="Hinge that opens as it begins, like 'gripper'; the load hangs free from then on."
    )
    open_holes: Names = Field(
        (), description="Hole or holes of tanks that open as it begins, like 'caisson.inside.valve'."
    )
    close_holes: Names = Field((), description="Hole or holes of tanks that are closed as it begins.")
    compensate_heave: Names = Field(
        (), description="Hook or hooks whose hoists keep them still against heave while it goes on."
    )
    relative_to: Name | None = Field(
        None,
        description="With 'compensate_heave': vessel against whose deck they are kept still; the ground if "
        "not given.",
    )

    @model_validator(mode="before")
    @classmethod
    def _does_one_thing(cls, data: Any) -> Any:
        verbs = [f"'{verb}'" for verb in VERBS if isinstance(data, dict) and verb in data]
        if len(verbs) > 1:
            sentence = f"a step does one thing; found {' and '.join(verbs)}"
            raise refuse(f"{sentence}: a step for each is right, side by side by 'starts: with_previous'")
        return data

    @model_validator(mode="after")
    def _relative_to_what_heaves(self) -> _AnyStep:
        if self.relative_to is not None and not self.compensate_heave:
            raise refuse("'relative_to' stands beside 'compensate_heave'; found it alone", "relative_to")
        return self


class StartingStep(_AnyStep):
    """A step whose start can be said."""

    starts: Literal["after_previous", "with_previous"] = Field(
        "after_previous",
        description="'with_previous': it begins as the step before begins, and both go on side by side.",
    )
    start_at: Time | None = Field(
        None, description="Time of the start; when the step before ends if not given."
    )


class MovingStep(StartingStep):
    """A step that moves hooks, drums, trolleys, cranes, booms or lines."""

    #: The key that says what is moved.
    verb: ClassVar[str]
    #: What that is.
    kind: ClassVar[Kind]
    #: Sign of the motion of its drives.
    direction: ClassVar[float] = 1.0
    #: The ways to end it.
    ends: ClassVar[tuple[str, ...]] = ("brake_from", "emergency_stop_at", "until", "by")

    speed: PositiveSpeed = Field(
        description="Speed of hooks, trolleys or crane, or of the rope on drums and winches."
    )
    acceleration: PositiveAcceleration | None = Field(
        None, description="That of the hoist or drive itself if not given."
    )
    brake_from: Time | None = Field(None, description="Time from which they brake.")
    emergency_stop_at: Time | None = Field(
        None,
        description="Time of an emergency stop: brakes are thrown in, and drums slip to rest against them.",
    )
    until: Condition | None = Field(None, description="Condition on which they brake.")
    by: Length | None = Field(
        None, description="Distance of the hooks, or length of rope, after which they are at rest."
    )

    @property
    def moved(self) -> tuple[str, ...]:
        """What moves, in the words of the file."""
        names: tuple[str, ...] = getattr(self, self.verb)
        return names

    @property
    def sign(self) -> float:
        """Sign of the motion of its drives, where neither a signed `by` nor `to` says it."""
        return self.direction

    @model_validator(mode="before")
    @classmethod
    def _what_follows(cls, data: Any) -> Any:
        if isinstance(data, dict) and "keep_plumb" in data and "keep_plumb" not in cls.ends:
            sentence = "a traverse, travel, luff or slew step follows a load"
            raise refuse(f"{sentence}; leave 'keep_plumb' out", "keep_plumb")
        return data

    @model_validator(mode="after")
    def _one_end(self) -> MovingStep:
        given = [name for name in self.ends if getattr(self, name) is not None]
        if len(given) != 1:
            listed = " and ".join(f"'{name}'" for name in given) or "none of them"
            ways = ", ".join(f"'{name}'" for name in self.ends[:-1]) + f" and '{self.ends[-1]}'"
            raise refuse(f"a step ends by one of {ways}; found {listed}")
        return self


class HookStep(MovingStep):
    """A step that moves hooks up or down."""

    kind: ClassVar[Kind] = "hook"
    ends: ClassVar[tuple[str, ...]] = ("brake_from", "emergency_stop_at", "until", "by", "to")

    by: PositiveLength | None = Field(None, description="Distance of the hooks after which they are at rest.")
    to: Length | None = Field(None, description="Height of the hooks' bearings in which they are at rest.")


class DrumStep(MovingStep):
    """A step that turns drums."""

    kind: ClassVar[Kind] = "drum"

    by: PositiveLength | None = Field(None, description="Length of rope after which the drums are at rest.")


class AlongStep(MovingStep):
    """A step that moves trolleys or cranes along, or turns them, or lets one follow the load."""

    ends: ClassVar[tuple[str, ...]] = ("brake_from", "emergency_stop_at", "until", "by", "to", "keep_plumb")
    #: A way, as messages show it.
    way: ClassVar[str] = "75 m"

    speed: PositiveSpeed = Field(description="Speed of trolleys or crane; the highest with 'keep_plumb'.")
    by: Length | None = Field(None, description="Way after which they are at rest; negative goes back.")
    to: Length | None = Field(None, description="Position in which they are at rest.")
    towards: Literal["plus", "minus"] = Field(
        "plus", description="Where they go if neither 'by' nor 'to' says it: to larger positions, or smaller."
    )
    keep_plumb: Names | None = Field(
        None, description="Hook or hooks whose falls it keeps plumb, until what goes on beside it has ended."
    )

    @property
    def sign(self) -> float:
        """Sign of the motion."""
        return 1.0 if self.towards == "plus" else -1.0

    @model_validator(mode="after")
    def _goes_somewhere(self) -> AlongStep:
        if self.by == 0:
            right = type(self).way
            raise refuse(f"'0' goes nowhere; a way like '{right}' or '-{right}' is needed", "by")
        if "towards" in self.model_fields_set and (self.by is not None or self.to is not None):
            raise refuse("'by' and 'to' say where it goes; leave 'towards' out", "towards")
        return self

    @model_validator(mode="after")
    def _follows_something(self) -> AlongStep:
        if self.keep_plumb is not None and "towards" in self.model_fields_set:
            raise refuse("what follows goes either way; leave 'towards' out", "towards")
        if self.keep_plumb is not None and self.starts != "with_previous":
            raise refuse("nothing goes on beside this step; 'starts: with_previous' is right")
        if self.keep_plumb is not None and len(self.moved) != 1:
            sentence = f"'keep_plumb' is for one trolley or crane, and here are {len(self.moved)}"
            raise refuse(f"{sentence}; a step for each is right", self.verb)
        return self


class TurnStep(AlongStep):
    """A step that turns something about an axis, between ends of its range."""

    way: ClassVar[str] = "10 deg"

    speed: PositiveAngularSpeed = Field(description="Angular speed; the highest with 'keep_plumb'.")
    acceleration: PositiveAngularAcceleration | None = Field(
        None, description="That of the drive itself if not given."
    )
    by: Angle | None = Field(None, description="Angle after which it is at rest; negative goes back.")
    to: Angle | None = Field(None, description="Angle in which it is at rest.")
    towards: Literal["plus", "minus"] = Field(
        "plus", description="Where it turns if neither 'by' nor 'to' says it: to larger angles, or smaller."
    )


class LuffStep(TurnStep):
    """A step in which booms luff; larger angles are steeper."""

    what: ClassVar[str] = "a luff step"

    luff: Names = Field(description="Crane or cranes whose booms luff.")

    verb: ClassVar[str] = "luff"
    kind: ClassVar[Kind] = "boom"


class SlewStep(TurnStep):
    """A step in which the upper structures of cranes slew; larger angles are to the left."""

    what: ClassVar[str] = "a slew step"

    slew: Names = Field(description="Crane or cranes that slew.")

    verb: ClassVar[str] = "slew"
    kind: ClassVar[Kind] = "upper"


class HoistStep(HookStep):
    """A step that hoists."""

    what: ClassVar[str] = "a hoist step"

    hoist: Names = Field(description="Hook or hooks to hoist.")

    verb: ClassVar[str] = "hoist"


class LowerStep(HookStep):
    """A step that lowers."""

    what: ClassVar[str] = "a lower step"

    lower: Names = Field(description="Hook or hooks to lower.")

    verb: ClassVar[str] = "lower"
    direction: ClassVar[float] = -1.0


class TraverseStep(AlongStep):
    """A step in which trolleys traverse."""

    what: ClassVar[str] = "a traverse step"

    traverse: Names = Field(description="Trolley or trolleys that traverse along the girder.")

    verb: ClassVar[str] = "traverse"
    kind: ClassVar[Kind] = "trolley"


class TravelStep(AlongStep):
    """A step in which cranes travel."""

    what: ClassVar[str] = "a travel step"

    travel: Names = Field(description="Crane or cranes that travel along their rails.")

    verb: ClassVar[str] = "travel"
    kind: ClassVar[Kind] = "crane"


class HaulInStep(DrumStep):
    """A step in which drums haul rope in."""

    what: ClassVar[str] = "a haul_in step"

    haul_in: Names = Field(description="Drum or drums of 'mechanics' that haul in.")

    verb: ClassVar[str] = "haul_in"
    direction: ClassVar[float] = -1.0


class PayOutStep(DrumStep):
    """A step in which drums pay rope out."""

    what: ClassVar[str] = "a pay_out step"

    pay_out: Names = Field(description="Drum or drums of 'mechanics' that pay out.")

    verb: ClassVar[str] = "pay_out"


class PumpWay(Element):
    """From where to where liquid is pumped."""

    what: ClassVar[str] = "pump"

    from_: Name = Field(
        alias="from", description="Tank like 'barge.row1', of a load 'module.inside', or 'sea'."
    )
    to: Name = Field(description="Tank like 'barge.row2', of a load 'module.inside', or 'sea': overboard.")

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """Both ends are said."""
        for key, what in (("from", "where it comes from"), ("to", "where it goes")):
            if key not in data:
                raise refuse(f"'{key}' is missing, {what}: a tank, or 'sea', which is all outside of tanks")


class PumpStep(StartingStep):
    """A step that pumps ballast, or lets water run out of a load or into it."""

    what: ClassVar[str] = "a pump step"

    pump: PumpWay = Field(description="From where to where.")
    rate: PositiveMassFlow = Field(
        description="How much is pumped in a time; pumps come to it, and stop, within 10 s."
    )
    by: PositiveMass | None = Field(None, description="How much is pumped.")
    until: Condition | None = Field(None, description="Condition on which the pumps stop.")

    verb: ClassVar[str] = "pump"

    @model_validator(mode="after")
    def _one_end(self) -> PumpStep:
        if (self.by is None) == (self.until is None):
            listed = "both" if self.by is not None else "none of them"
            raise refuse(f"a pump step ends by one of 'by' and 'until'; found {listed}")
        return self


class LineStep(MovingStep):
    """A step in which winches move mooring lines or tag lines, and chain hoists slings."""

    kind: ClassVar[Kind] = "line"

    by: PositiveLength | None = Field(
        None, description="Length of line or chain after which winches or chain hoists are at rest."
    )


class HaulStep(LineStep):
    """A step in which mooring lines or tag lines are hauled in, or slings shortened by chain hoists."""

    what: ClassVar[str] = "a haul step"

    haul: Names = Field(
        description="Mooring lines that are hauled in, tag lines, like 'tag.west', or slings with a "
        "'chain_hoist', like 'sling.S1', which get shorter."
    )

    verb: ClassVar[str] = "haul"
    direction: ClassVar[float] = -1.0


class VeerStep(LineStep):
    """A step in which mooring lines or tag lines are paid out, or slings lengthened by chain hoists."""

    what: ClassVar[str] = "a veer step"

    veer: Names = Field(
        description="Mooring lines that are paid out, tag lines, like 'tag.west', or slings with a "
        "'chain_hoist', like 'sling.S1', which get longer."
    )

    verb: ClassVar[str] = "veer"


class HoldStep(_AnyStep):
    """A step that waits."""

    what: ClassVar[str] = "a hold step"

    hold: Annotated[
        float | Literal["until_end", "until_met"],
        WordOr(("until_end", "until_met"), Quantity("time", "positive")),
    ] = Field(description="How long, 'until_end', or 'until_met': as long as 'until' asks for.")
    until: Condition | None = Field(None, description="What 'hold: until_met' waits for.")

    @model_validator(mode="after")
    def _condition_where_asked(self) -> HoldStep:
        if (self.hold == "until_met") != (self.until is not None):
            raise refuse("'hold: until_met' and 'until' stand together, or none of them does")
        return self
