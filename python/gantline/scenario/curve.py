"""Tension of a rope over its strain, where that is no one axial stiffness.

docs/concepts/rope.md has the equations. The core has the same curve for its rows.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Annotated, Any, ClassVar

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.errors import shorten
from gantline.scenario.quantities import ListOf, Quantity, Share, refuse

__all__ = ["RopeCurve", "energy_stiffness"]

#: Zero, with a unit or without.
_NOTHING = re.compile(r"\s*0+(\.0*)?\s*(%|[A-Za-z]*)\s*")
_Strains = Annotated[tuple[float, ...], ListOf(Share(sign="positive"))]
_Forces = Annotated[tuple[float, ...], ListOf(Quantity("force", "positive"))]


class RopeCurve(Element):
    """Tension over strain, straight between its points, from nothing upwards and beyond the last one."""

    what: ClassVar[str] = "a curve of tension over strain"

    strain: _Strains = Field(description="Strains, rising, such as '[1 %, 2 %, 3 %]'; 0 is before them.")
    tension: _Forces = Field(description="Tensions at these strains, rising.")

    @model_validator(mode="before")
    @classmethod
    def _as_makers_have_it(cls, data: Any) -> Any:
        """Tables of makers begin at nothing, and have tensions as shares of what breaks the rope."""
        given = data if isinstance(data, dict) else {}
        for key in ("strain", "tension"):
            values = given.get(key)
            if not isinstance(values, list) or not values:
                continue
            if _NOTHING.fullmatch(str(values[0])):
                sentence = f"item 1: '{values[0]}' is zero; a curve begins there by itself"
                raise refuse(f"{sentence}: leave this point out of strains and tensions", key)
            share = next((one for one in values if key == "tension" and "%" in str(one)), None)
            if share is not None:
                sentence = f"'{shorten(str(share))}' is a share; a force is needed, such as '10 kN'"
                raise refuse(f"{sentence}: multiply by the breaking force that the maker's table is for", key)
        return data

    @model_validator(mode="after")
    def _rises(self) -> RopeCurve:
        if len(self.strain) != len(self.tension):
            sentence = f"{len(self.tension)} tensions stand beside {len(self.strain)} strains"
            raise refuse(f"{sentence}; each strain has one tension", "tension")
        for key in ("strain", "tension"):
            if any(after <= before for before, after in pairwise(getattr(self, key))):
                raise refuse("its values do not rise from each to the next", key)
        return self

    @property
    def points(self) -> list[tuple[float, float]]:
        """Strain and tension [N] of every point."""
        return list(zip(self.strain, self.tension, strict=True))

    @property
    def axial_stiffness(self) -> float:
        """EA [N] of a rope that takes up the same energy up to the last tension."""
        return energy_stiffness(self.points)

    def pull(self, strain: float) -> tuple[float, float, float]:
        """Tension [N], its slope over the strain [N] and energy per length [N] at a strain, not below 0."""
        energy = 0.0
        for (begin, low), slope, end in self._lines():
            over = min(strain, end) - begin
            now = low + slope * over
            energy += 0.5 * (low + now) * over
            if strain <= end:
                return now, slope, energy
        raise AssertionError("the last line has no end")

    def strain_under(self, tension: float) -> float:
        """Strain at rest under a tension [N], not below 0."""
        lines = list(self._lines())
        (begin, low), slope, _ = next((one for one in reversed(lines) if one[0][1] <= tension), lines[0])
        return begin + (tension - low) / slope

    def _lines(self) -> Iterator[tuple[tuple[float, float], float, float]]:
        """Of each line where it begins, its slope, and the strain at which it ends; the last does not."""
        all_points = [(0.0, 0.0), *self.points]
        for (begin, low), (end, high) in pairwise(all_points):
            is_last = end == self.strain[-1]
            yield (begin, low), (high - low) / (end - begin), float("inf") if is_last else end


def energy_stiffness(points: Sequence[Sequence[float]]) -> float:
    """EA [N] of a rope with the same energy up to the last of points (strain, tension [N]) after (0, 0)."""
    pairs = pairwise([(0.0, 0.0), *points])
    energy = math.fsum(0.5 * (low + high) * (end - begin) for (begin, low), (end, high) in pairs)
    return float(points[-1][1] ** 2 / (2.0 * energy))
