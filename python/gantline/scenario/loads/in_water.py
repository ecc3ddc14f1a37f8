"""What water does to a load that is lowered into it."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field

from gantline.scenario.base import Element
from gantline.scenario.quantities import ListOf, Number, Quantity

__all__ = ["InWater"]

_Masses = Annotated[tuple[float, float, float], ListOf(Quantity("mass", "not_negative"), 3)]
_Coefficients = Annotated[tuple[float, float, float], ListOf(Number(least=0.0, most=100.0), 3)]


class InWater(Element):
    """A load in water: each part of it by how far it is wet."""

    what: ClassVar[str] = "a load in water"

    displaced_volume: Annotated[float, Quantity("volume", "positive")] | None = Field(
        None,
        description="Volume of water that it displaces, wholly wet: of its members and the inside of its "
        "tanks, not of its box; that of as much steel and of its tanks if not given.",
    )
    added_mass: _Masses = Field(
        description="Water that is accelerated along with it, wholly wet, along its x, y, z; what is trapped "
        "in it included, but for what is in its tanks."
    )
    drag_coefficients: _Coefficients = Field(
        description="Of the sides of its box, or of what a round load shows, across x, y, z: force over "
        "½ density × side × speed squared."
    )
    slamming_coefficient: Annotated[float, Number(least=0.1, most=20.0)] | None = Field(
        None,
        description="Of its underside as it goes into the water: force over ½ density × underside × speed "
        "squared. If not given, what its added mass makes that comes evenly over its height.",
    )

    def slamming_depth(self, underside: float, density: float) -> float | None:
        """Depth over which added mass along z comes, by (LW5) [m]; None if over the whole height.

        Args:
            underside: Area of its box seen from below [m^2].
            density: Of the water [kg/m^3].
        """
        if self.slamming_coefficient is None:
            return None
        return 2.0 * self.added_mass[2] / (density * underside * self.slamming_coefficient)
