"""The rating chart of a crane with a boom: what may hang at which radius."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.quantities import ListOf, PositiveAngle, PositiveLength, Quantity, refuse

__all__ = ["Rating"]

_Share = Annotated[float, Quantity("ratio", "positive")]
_Lengths = Annotated[tuple[float, ...] | None, ListOf(Quantity("length", "positive"), least=2)]
_Angles = Annotated[tuple[float, ...] | None, ListOf(Quantity("angle", "positive"), least=2)]
_Masses = Annotated[tuple[float, ...], ListOf(Quantity("mass", "not_negative"), least=2)]
_BY = ("radius", "outreach", "angle")


class Rating(Element):
    """A rating chart: one row of places, one of what may hang there, all hooks of the crane together."""

    what: ClassVar[str] = "a rating chart"

    radius: _Lengths = Field(
        None, description="Distances of the hook from the slewing axis, of a crane that slews."
    )
    outreach: _Lengths = Field(
        None,
        description="Distances of the hook ahead of the bow, or of where 'outreach_from' is, of a floating "
        "crane.",
    )
    angle: _Angles = Field(None, description="Angles of the boom from level.")
    rated: _Masses = Field(
        description="What may hang there, all hooks together, and nothing outside of the rows. "
        "'rating_includes_hook_block' of the crane says what is compared with it."
    )
    between: Literal["lines", "lower"] | None = Field(
        None,
        description="What may hang between two rows: on 'lines' between them, if nothing is said, or the "
        "'lower' of both, for charts that must not be interpolated.",
    )
    hooks_share: _Share | None = Field(
        None,
        description="Largest share of a row that one hook may carry; if not given, rated capacity of the "
        "hook over that of the crane.",
    )
    heel: PositiveAngle | None = Field(
        None, description="Largest heel, across the boom, for which the chart holds."
    )
    trim: PositiveAngle | None = Field(
        None, description="Largest trim, in the plane of the boom, for which the chart holds."
    )
    off_lead: PositiveAngle | None = Field(
        None, description="Largest angle of falls out of plumb in the plane of the boom."
    )
    side_lead: PositiveAngle | None = Field(
        None, description="Largest angle of falls out of plumb across the boom."
    )
    significant_height: PositiveLength | None = Field(
        None,
        description="Largest significant height of the waves for which the chart holds, as makers have a "
        "chart for each; of waves that are all alike root 2 times their height counts.",
    )

    @property
    def over(self) -> Literal["radius", "outreach", "angle"]:
        """What the rows are for."""
        if self.radius is not None:
            return "radius"
        return "angle" if self.angle is not None else "outreach"

    @property
    def rows(self) -> list[tuple[float, float]]:
        """Radius or outreach [m] or angle [rad], and what may hang there [kg], places rising."""
        return sorted(zip(getattr(self, self.over), self.rated, strict=True))

    @property
    def rises(self) -> tuple[tuple[float, float], tuple[float, float]] | None:
        """Two rows next to each other of which that farther out is rated for more; None if there are none."""
        outwards = self.rows[::-1] if self.over == "angle" else self.rows
        return next(((near, far) for near, far in pairwise(outwards) if far[1] > near[1]), None)

    @model_validator(mode="after")
    def _is_a_table(self) -> Rating:
        given = [key for key in _BY if getattr(self, key) is not None]
        if len(given) != 1:
            listed = " and ".join(f"'{key}'" for key in given) or "none of them"
            raise refuse(f"a chart has one of 'radius', 'outreach' and 'angle'; found {listed}")
        places = getattr(self, given[0])
        if len(places) != len(self.rated):
            sentence = f"{len(self.rated)} loads stand beside {len(places)} places of '{given[0]}'"
            raise refuse(f"{sentence}; each place has one load", "rated")
        ways = {after > before for before, after in pairwise(places)}
        if len(ways) > 1 or any(after == before for before, after in pairwise(places)):
            raise refuse(f"'{given[0]}' is not in order; its places only rise, or only fall", given[0])
        if self.angle is not None and max(self.angle) > math.pi / 2:
            sentence = f"{math.degrees(max(self.angle)):g} deg is past plumb, where no boom stands"
            raise refuse(f"{sentence}; angles count from level, and 90 deg is the most", "angle")
        if not max(self.rated) > 0:
            raise refuse("nothing may hang anywhere by this chart; a load above 0 is right", "rated")
        if self.hooks_share is not None and self.hooks_share > 1:
            sentence = f"{self.hooks_share * 100:g} % is more than the whole row"
            raise refuse(f"{sentence}; 100 % or less is right", "hooks_share")
        return self
