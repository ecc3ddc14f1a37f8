"""Heave compensation: what the hoist of a hook can do against the heave of its boom head."""

from __future__ import annotations

from typing import ClassVar

from pydantic import Field

from gantline.scenario.base import Element
from gantline.scenario.quantities import PositiveAcceleration, PositiveLength, PositiveSpeed, PositiveTime

__all__ = ["FILTER", "HeaveCompensation"]

#: Time of the filter where the lift file says none [s]: waves of 5 to 15 s leave 3 to 9 % of their heave, as
#: makers say of 2 to 10 %.
FILTER = 25.0


class HeaveCompensation(Element):
    """What a hoist can do against heave."""

    what: ClassVar[str] = "a heave compensation"

    speed: PositiveSpeed = Field(description="Most that it adds to the speed of the hook.")
    acceleration: PositiveAcceleration = Field(
        description="Most that it adds to the acceleration of the hook."
    )
    stroke: PositiveLength | None = Field(
        None,
        description="How far it can move the hook, half of that up and half down; without end if not given, "
        "as of a drum.",
    )
    filter: PositiveTime = Field(
        FILTER,
        description="Time of the high-pass filter behind its sensor of motion: what is slower is not "
        "compensated.",
    )
