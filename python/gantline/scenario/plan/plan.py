"""The plan of a lift: which steps it may have, and emergency stops."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar

from pydantic import Discriminator, Field, Tag, model_validator

from gantline.scenario.base import Element
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.steps import (
    VERBS,
    HaulInStep,
    HaulStep,
    HoistStep,
    HoldStep,
    LowerStep,
    LuffStep,
    PayOutStep,
    PumpStep,
    SlewStep,
    TravelStep,
    TraverseStep,
    VeerStep,
)
from gantline.scenario.quantities import Text, Time, refuse

__all__ = ["VERBS", "EmergencyStop", "Step"]


class EmergencyStop(Element):
    """An emergency stop of all hoists, trolleys, cranes, booms and drums at once."""

    what: ClassVar[str] = "emergency_stop"

    at: Time | None = Field(None, description="When.")
    in_step: Text | None = Field(None, description="The step of the plan in which it is, in place of 'at'.")
    after: Time | None = Field(None, description="How long after that step has begun; at once if not given.")

    @model_validator(mode="after")
    def _one_time(self) -> EmergencyStop:
        if (self.at is None) == (self.in_step is None):
            raise refuse(
                "it has one of 'at' and 'in_step', such as {at: 321 s} or {in_step: hoist, after: 10 s}"
            )
        if self.after is not None and self.in_step is None:
            raise refuse("'after' stands without 'in_step', the step from which it counts", "after")
        return self


def _verb(data: Any) -> str | None:
    if isinstance(data, dict):
        verbs = [verb for verb in VERBS if verb in data]
        return f"{verbs[0]} step" if verbs else None
    return None


Step = Annotated[
    Annotated[HoistStep, Tag("hoist step")]
    | Annotated[LowerStep, Tag("lower step")]
    | Annotated[TraverseStep, Tag("traverse step")]
    | Annotated[TravelStep, Tag("travel step")]
    | Annotated[LuffStep, Tag("luff step")]
    | Annotated[SlewStep, Tag("slew step")]
    | Annotated[LeadStep, Tag("lead step")]
    | Annotated[HaulInStep, Tag("haul_in step")]
    | Annotated[PayOutStep, Tag("pay_out step")]
    | Annotated[PumpStep, Tag("pump step")]
    | Annotated[HaulStep, Tag("haul step")]
    | Annotated[VeerStep, Tag("veer step")]
    | Annotated[HoldStep, Tag("hold step")],
    Discriminator(
        _verb,
        custom_error_type="no_verb",
        custom_error_message="a step says what is done: it has one of the keys 'hoist', 'lower', 'traverse', "
        "'travel', 'luff', 'slew', 'lead', 'haul_in', 'pay_out', 'haul', 'veer', 'pump' and 'hold'",
    ),
]
