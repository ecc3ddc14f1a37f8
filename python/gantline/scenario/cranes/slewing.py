"""What slews a crane with a boom, and what its bodies are called."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

from pydantic import Field, model_validator

from gantline.scenario.cranes.luffing import TurningDrive
from gantline.scenario.quantities import ListOf, Quantity, refuse

__all__ = ["Slewing", "refuse_outside_of_range", "turned_body", "upper_body"]

_Angles = Annotated[tuple[float, float] | None, ListOf(Quantity("angle"), 2)]


class Slewing(TurningDrive):
    """What slews the upper structure."""

    what: ClassVar[str] = "slewing"

    range_: _Angles = Field(
        None, alias="range", description="Least and largest angle; all the way round if not given."
    )

    @model_validator(mode="after")
    def _range_is_one(self) -> Slewing:
        if self.range_ is not None and self.range_[0] >= self.range_[1]:
            low, high = (f"{math.degrees(one):g} deg" for one in self.range_)
            raise refuse(f"a range goes from the least to the largest angle; found {low} to {high}", "range")
        return self


def upper_body(crane: str) -> str:
    """Name of what slews of a crane, and of the joint by which it does."""
    return f"{crane}.upper"


def turned_body(crane: str) -> str:
    """Name of the body that turns as a crane slews, and that its hook blocks are points under."""
    return f"{upper_body(crane)}/turned"


def refuse_outside_of_range(slew: float, slewing: Slewing | None) -> None:
    """Refuse a direction at the start to which a crane does not slew [rad].

    Raises:
        ValueError: if it is outside of the range.
    """
    if slewing is None or slewing.range_ is None:
        return
    low, high = slewing.range_
    if not low <= slew <= high:
        at, least, most = (f"{math.degrees(one):g} deg" for one in (slew, low, high))
        raise refuse(f"{at} is outside of the range of slewing, {least} to {most}", "slew")
