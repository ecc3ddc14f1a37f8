"""The plan of a lift: steps that follow each other, and the limits that are checked."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, NamedTuple

from pydantic import Discriminator, Field, Tag, model_validator
from pydantic.json_schema import JsonSchemaValue

from gantline.scenario.base import Element
from gantline.scenario.errors import nearest
from gantline.scenario.quantities import (
    Names,
    PositiveAcceleration,
    PositiveLength,
    PositiveSpeed,
    Quantity,
    Reader,
    Text,
    Time,
    WordOr,
    found,
    refuse,
)
from gantline.units import example, units_of

__all__ = [
    "MEASURES",
    "Bound",
    "Condition",
    "DrumStep",
    "HaulInStep",
    "HoistStep",
    "HoldStep",
    "HookStep",
    "LowerStep",
    "MovingStep",
    "PayOutStep",
    "Require",
    "Step",
]


class Bound(NamedTuple):
    """A requirement on a measure: `relation` is ``below`` or ``above``, `value` in SI units."""

    relation: str
    value: float


@dataclass(frozen=True)
class BoundReader(Reader):
    """Reads ``below 1 deg`` and ``above 10 kN``."""

    dimension: str

    def read(self, value: object) -> Bound:
        """The bound."""
        words = value.split(maxsplit=1) if isinstance(value, str) else []
        if len(words) != 2 or words[0] not in ("below", "above"):
            right = example(self.dimension).split("like '")[1].split("'")[0]
            raise refuse(
                f"found {found(value)}; a requirement is written like 'below {right}' or 'above {right}'"
            )
        return Bound(words[0], Quantity(self.dimension, "not_negative").read(words[1]))

    def shown(self) -> JsonSchemaValue:
        """A string that begins with a relation."""
        right = example(self.dimension).split("like '")[1].split("'")[0]
        units = "|".join(
            unit.replace("^", "\\^").replace("/", "\\/") for unit in units_of(self.dimension) if unit
        )
        return {
            "type": "string",
            "pattern": rf"^(below|above)\s+[0-9.eE+\-]+\s*({units})?$",
            "examples": [f"below {right}"],
        }


AngleBound = Annotated[Bound, BoundReader("angle")]
ForceBound = Annotated[Bound, BoundReader("force")]
RatioBound = Annotated[Bound, BoundReader("ratio")]

#: Measures that a step may report.
MEASURES = (
    "sling_tension",
    "equalizing_rope_tension",
    "equalizer_travel",
    "hook_load",
    "hoist_load",
    "load_tilt",
    "load_transferred",
)


@dataclass(frozen=True)
class MeasuresReader(Reader):
    """Reads the list of measures that a step reports."""

    def read(self, value: object) -> tuple[str, ...]:
        """The measures."""
        items = [value] if isinstance(value, str) else value
        if not isinstance(items, list) or not items:
            raise refuse(
                f"found {found(value)}; a list of measures is needed, such as [hook_load, sling_tension]"
            )
        for item in items:
            if item not in MEASURES:
                raise refuse(f"{found(item)} is not a measure; {nearest(str(item), MEASURES)}")
        return tuple(str(item) for item in items)

    def shown(self) -> JsonSchemaValue:
        """A list of the known measures."""
        return {"type": "array", "items": {"enum": list(MEASURES)}, "minItems": 1}


class Require(Element):
    """What has to hold at the end of a step."""

    what: ClassVar[str] = "require"

    load_tilt: AngleBound | None = Field(None, description="Angle of the load's own z axis from plumb.")
    equalizer_travel_used: RatioBound | None = Field(None, description="Travel used, of the stroke.")
    tension_spread: RatioBound | None = Field(
        None, description="(max - min)/mean over one equalizer's slings."
    )
    sling_tension: ForceBound | None = Field(None, description="Tension of every sling.")
    hook_load: ForceBound | None = Field(None, description="Hook load of every hook.")
    load_transferred: RatioBound | None = Field(None, description="1 - support forces/weight.")


class Condition(Element):
    """What a step waits for."""

    what: ClassVar[str] = "until"

    load_transferred: Annotated[float, Quantity("ratio", "positive")] | None = Field(
        None, description="Share of the load's weight that has left its supports."
    )
    supports: Literal["clear"] | None = Field(
        None, description="'clear': the load has left all its supports."
    )

    @model_validator(mode="after")
    def _exactly_one(self) -> Condition:
        given = [self.load_transferred is not None, self.supports is not None]
        if sum(given) != 1:
            raise refuse("a step waits for one thing: 'load_transferred: 50 %' or 'supports: clear'")
        if self.load_transferred is not None and self.load_transferred > 1:
            raise refuse(f"load_transferred is {self.load_transferred * 100:g} %; it can reach 100 % at most")
        return self


class _AnyStep(Element):
    step: Text = Field(description="Name of the step.")
    report: Annotated[tuple[str, ...], MeasuresReader()] = Field(
        (), description="Measures to report at its end."
    )
    require: Require | None = Field(None, description="What has to hold at its end.")
    cut: Names = Field((), description="Rope or ropes that are cut as it begins, like 'sling.S1'.")
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


class MovingStep(_AnyStep):
    """A step that moves hooks or drums."""

    #: The key that says what is moved.
    verb: ClassVar[str]
    #: Sign of the motion of its drives.
    direction: ClassVar[float]

    speed: PositiveSpeed = Field(description="Speed of the hooks, or of the rope on the drums.")
    acceleration: PositiveAcceleration | None = Field(
        None, description="That of the hoist or drive itself if not given."
    )
    start_at: Time | None = Field(
        None, description="Time of the start; when the step before ends if not given."
    )
    brake_from: Time | None = Field(None, description="Time from which they brake.")
    emergency_stop_at: Time | None = Field(
        None,
        description="Time of an emergency stop: brakes are thrown in, and drums slip to rest against them.",
    )
    until: Condition | None = Field(None, description="Condition on which they brake.")
    by: PositiveLength | None = Field(
        None, description="Distance of the hooks, or length of rope, after which they are at rest."
    )

    @model_validator(mode="after")
    def _one_end(self) -> MovingStep:
        ends = ("brake_from", "emergency_stop_at", "until", "by")
        given = [name for name in ends if getattr(self, name) is not None]
        if len(given) != 1:
            listed = " and ".join(f"'{name}'" for name in given) or "none of them"
            ways = "'brake_from', 'emergency_stop_at', 'until' and 'by'"
            raise refuse(f"a step ends by one of {ways}; found {listed}")
        return self


class HookStep(MovingStep):
    """A step that moves hooks up or down."""

    @property
    def hooks(self) -> tuple[str, ...]:
        """Hooks that move."""
        moved: tuple[str, ...] = getattr(self, self.verb)
        return moved


class DrumStep(MovingStep):
    """A step that turns drums."""

    @property
    def drums(self) -> tuple[str, ...]:
        """Drums that turn."""
        moved: tuple[str, ...] = getattr(self, self.verb)
        return moved


class HoistStep(HookStep):
    """A step that hoists."""

    what: ClassVar[str] = "a hoist step"

    hoist: Names = Field(description="Hook or hooks to hoist.")

    verb: ClassVar[str] = "hoist"
    direction: ClassVar[float] = 1.0


class LowerStep(HookStep):
    """A step that lowers."""

    what: ClassVar[str] = "a lower step"

    lower: Names = Field(description="Hook or hooks to lower.")

    verb: ClassVar[str] = "lower"
    direction: ClassVar[float] = -1.0


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
    direction: ClassVar[float] = 1.0


class HoldStep(_AnyStep):
    """A step that waits."""

    what: ClassVar[str] = "a hold step"

    hold: Annotated[float | Literal["until_end"], WordOr(("until_end",), Quantity("time", "positive"))] = (
        Field(description="How long, or 'until_end'.")
    )


def _verb(data: Any) -> str | None:
    if isinstance(data, dict):
        verbs = [verb for verb in ("hoist", "lower", "haul_in", "pay_out", "hold") if verb in data]
        return f"{verbs[0]} step" if verbs else None
    return None


Step = Annotated[
    Annotated[HoistStep, Tag("hoist step")]
    | Annotated[LowerStep, Tag("lower step")]
    | Annotated[HaulInStep, Tag("haul_in step")]
    | Annotated[PayOutStep, Tag("pay_out step")]
    | Annotated[HoldStep, Tag("hold step")],
    Discriminator(
        _verb,
        custom_error_type="gantline",
        custom_error_message="a step says what is done: it has one of the keys 'hoist', 'lower', "
        "'haul_in', 'pay_out' and 'hold'",
    ),
]
