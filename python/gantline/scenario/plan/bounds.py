"""What a step of the plan may report and require at its end."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, NamedTuple

from pydantic import Field
from pydantic.json_schema import JsonSchemaValue

from gantline.scenario.base import Element
from gantline.scenario.errors import nearest
from gantline.scenario.quantities import Quantity, Reader, Share, found, refuse
from gantline.units import example, units_of

__all__ = ["MEASURES", "Bound", "BoundReader", "MeasuresReader", "Require"]


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
        reader = Share() if self.dimension == "ratio" else Quantity(self.dimension, "not_negative")
        return Bound(words[0], reader.read(words[1]))

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
LengthBound = Annotated[Bound, BoundReader("length")]
RatioBound = Annotated[Bound, BoundReader("ratio")]

#: Measures that a step may report.
MEASURES = (
    "sling_tension",
    "equalizing_rope_tension",
    "equalizer_travel",
    "rod_out",
    "hinge_force",
    "hook_load",
    "hoist_load",
    "load_tilt",
    "load_transferred",
    "load_swing",
    "support_force",
    "hook_height",
    "falls_out_of_plumb",
    "corner_load",
    "draft",
    "heel",
    "trim",
    "freeboard",
    "boom_angle",
    "crane_radius",
    "off_lead",
    "side_lead",
    "luffing_pull",
    "ground_pressure",
    "tipping_utilisation",
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
    load_yaw: AngleBound | None = Field(None, description="Change of the load's heading from the start.")
    spreader_tilt: AngleBound | None = Field(
        None, description="Angle of a spreader's own z axis from plumb, while slings below it carry."
    )
    equalizer_tilt: AngleBound | None = Field(
        None, description="Angle from plumb of an equalizer's frame, of one that tilts."
    )
    equalizer_travel_used: RatioBound | None = Field(None, description="Travel used, of the stroke.")
    tension_spread: RatioBound | None = Field(
        None, description="(max - min)/mean over one equalizer's slings."
    )
    sling_tension: ForceBound | None = Field(None, description="Tension of every sling.")
    hook_load: ForceBound | None = Field(None, description="Hook load of every hook.")
    load_transferred: RatioBound | None = Field(None, description="1 - support forces/weight.")
    hook_level_difference: LengthBound | None = Field(
        None,
        description="How far of two hooks that bear the load one has gone up more than the other since it "
        "came clear.",
    )
    hoist_load_of_rating: RatioBound | None = Field(
        None, description="Hoist load of the rated load of the chart where the hook is, with factors."
    )
    moment_of_tipping_moment: RatioBound | None = Field(
        None, description="Moment of what hangs of that at which a crawler crane tips."
    )
    ground_pressure_of_allowed: RatioBound | None = Field(
        None, description="Pressure on the ground of 'allowed_pressure' of the tracks."
    )
    falls_out_of_plumb: AngleBound | None = Field(
        None,
        description="Angle of the falls from plumb, of hooks of Goliath cranes and at booms; of fixed hooks "
        "the angle at which falls would hang.",
    )
    off_lead: AngleBound | None = Field(
        None, description="Angle of the falls from plumb in the plane of the boom, of hooks at booms."
    )
    side_lead: AngleBound | None = Field(
        None, description="Angle of the falls from plumb across the boom, of hooks at booms."
    )
    heel: AngleBound | None = Field(None, description="Heel of every vessel, to either side.")
    trim: AngleBound | None = Field(None, description="Trim of every vessel, by bow or stern.")
    freeboard: LengthBound | None = Field(
        None, description="Height of deck edge and openings of every vessel above the water."
    )
