"""A cylinder, tube or cone as the shape of a load, and what of it has a closed form.

Its axis lies along the load's x or stands along its z. Equations are those of `docs/concepts/round_loads.md`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import ClassVar, Literal, NamedTuple

from pydantic import Field

from gantline.scenario.base import Element
from gantline.scenario.file.tree import MapNode
from gantline.scenario.quantities import PositiveLength, refuse

__all__ = ["Cylinder", "segment_area", "segment_moment"]

#: Places and weights of Gauss over 0 to 1, exact for polynomials of the fifth degree.
_GAUSS = tuple((0.5 + 0.5 * at * math.sqrt(0.6), weight / 18.0) for at, weight in ((-1, 5), (0, 8), (1, 5)))

Triple = tuple[float, float, float]


class Moments(NamedTuple):
    """Of a body of revolution.

    Attributes:
        volume: V [m^3].
        middle: where along its axis its middle is, from its first end [m].
        along: ∫ s² dV about that [m^5].
        across: ∫ y² dV about the axis [m^5].
    """

    volume: float
    middle: float
    along: float
    across: float


class Cylinder(Element):
    """A cylinder, or a cone, solid or a tube."""

    what: ClassVar[str] = "a cylinder"

    diameter: PositiveLength = Field(
        description="Outer diameter; of a cone that of its end at the lower x, or of its foot."
    )
    length: PositiveLength = Field(description="Length along its axis.")
    along: Literal["x", "z"] = Field(
        "x", description="Axis of the load along which it is: x where it lies, z where it stands."
    )
    end_diameter: PositiveLength | None = Field(
        None, description="Outer diameter of a cone at its other end; the same if not given."
    )
    wall: PositiveLength | None = Field(
        None, description="Wall of a tube that is open at both ends; a solid one if not given."
    )

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """What a box has is none of a cylinder's."""
        if "radius" in data:
            raise refuse("a cylinder has a 'diameter', and no 'radius'", "radius")

    @property
    def radii(self) -> tuple[float, float]:
        """Outer radii of both ends, in the order of x or z [m]."""
        other = self.diameter if self.end_diameter is None else self.end_diameter
        return self.diameter / 2.0, other / 2.0

    @property
    def bores(self) -> tuple[float, float]:
        """Radii of what is hollow at both ends, 0 of a solid one [m]."""
        first, last = self.radii
        return (0.0, 0.0) if self.wall is None else (first - self.wall, last - self.wall)

    @property
    def widest(self) -> float:
        """The larger of its outer radii [m]."""
        return max(self.radii)

    @property
    def sizes(self) -> Triple:
        """The box about it along the load's x, y, z [m]."""
        wide = 2.0 * self.widest
        return (self.length, wide, wide) if self.along == "x" else (wide, wide, self.length)

    @property
    def seen(self) -> Triple:
        """Areas that it shows along the load's x, y, z [m^2], by (RL4)."""
        first, last = self.radii
        side, end = self.length * (first + last), math.pi * self.widest**2
        return (end, side, side) if self.along == "x" else (side, side, end)

    @property
    def middle(self) -> Triple:
        """Middle of its side, on its axis, from the load's bottom centre [m], by (RL4)."""
        first, last = self.radii
        share = (first + 2.0 * last) / (3.0 * (first + last))
        if self.along == "x":
            return self.length * (share - 0.5), 0.0, self.widest
        return 0.0, 0.0, self.length * share

    @property
    def moments(self) -> Moments:
        """Of what it is made of, a tube of its wall, by (RL2)."""
        outer, bore = (_moments(ends, self.length) for ends in (self.radii, self.bores))
        volume, first, second, across = (one - other for one, other in zip(outer, bore, strict=True))
        middle = first / volume
        return Moments(volume, middle, second - volume * middle**2, across)

    @property
    def enclosed(self) -> float:
        """Volume within its outer skin and its ends [m^3]."""
        return _moments(self.radii, self.length)[0]

    def inertia(self, mass: float) -> Triple:
        """About its own middle along the load's x, y, z, of an even density [kg m^2], by (RL3)."""
        volume, _, along, across = self.moments
        axial, level = 2.0 * mass / volume * across, mass / volume * (along + across)
        return (axial, level, level) if self.along == "x" else (level, level, axial)

    def own(self, at: Sequence[float]) -> tuple[float, float, float]:
        """A place from the load's bottom centre [m] as share of the length, and beside the axis [m]."""
        x, y, z = at
        if self.along == "x":
            return 0.5 + x / self.length, y, z - self.widest
        return z / self.length, x, y

    def depth(self, at: Sequence[float]) -> float:
        """How deep a place from the load's bottom centre is in its outer skin [m]; negative outside."""
        share, one, other = self.own(at)
        first, last = self.radii
        leans = math.hypot(1.0, (last - first) / self.length)
        skin = (first + (last - first) * share - math.hypot(one, other)) / leans
        return min(skin, self.length * share, self.length * (1.0 - share))


def _moments(ends: tuple[float, float], length: float) -> tuple[float, float, float, float]:
    """V, ∫ s dV, ∫ s² dV from the first end, ∫ y² dV of a cone with these radii at its ends, by (RL1)."""
    first, last = ends
    found = [0.0] * 4
    for share, weight in _GAUSS:
        radius, along = first + (last - first) * share, length * share
        slice_ = weight * length * math.pi * radius**2
        for place, part in enumerate((1.0, along, along**2, radius**2 / 4.0)):
            found[place] += slice_ * part
    return found[0], found[1], found[2], found[3]


def segment_area(radius: float, depth: float) -> float:
    """Area of a circle below a level that is a depth over its lowest point [m^2], by (RL9)."""
    if radius <= 0.0:
        return 0.0
    over = min(max(depth - radius, -radius), radius)
    return radius**2 * (math.asin(over / radius) + math.pi / 2.0) + over * math.sqrt(radius**2 - over**2)


def segment_moment(radius: float, depth: float) -> float:
    """∫ y² dA, across, of the same [m^4], by (RL10)."""
    if radius <= 0.0:
        return 0.0
    over = min(max(depth - radius, -radius), radius)
    half = math.sqrt(radius**2 - over**2)
    return segment_area(radius, depth) * radius**2 / 4.0 + over * half**3 / 6.0
