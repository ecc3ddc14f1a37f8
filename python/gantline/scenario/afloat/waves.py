"""Waves on the water: regular ones, and seas by height and period."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field

from gantline.scenario.base import Element
from gantline.scenario.file.tree import MapNode
from gantline.scenario.quantities import (
    Angle,
    Components,
    Number,
    PositiveLength,
    PositiveTime,
    Seed,
    refuse,
)

__all__ = ["WaveTrain"]

_REGULAR = ("height", "period")
_IRREGULAR = ("significant_height", "peak_period")


class WaveTrain(Element):
    """Waves that run in one direction: all alike, or a sea with a JONSWAP spectrum."""

    what: ClassVar[str] = "waves"

    direction: Angle = Field(description="Direction in which they run, from world x towards y.")
    height: PositiveLength | None = Field(None, description="Of waves that are all alike: crest to trough.")
    period: PositiveTime | None = Field(None, description="Their period.")
    significant_height: PositiveLength | None = Field(
        None, description="Of a sea: four times the standard deviation of its surface."
    )
    peak_period: PositiveTime | None = Field(None, description="Period at the peak of its spectrum.")
    peak_enhancement: Annotated[float, Number(least=1.0, most=7.0)] = Field(
        3.3, description="γ of its JONSWAP spectrum; 1 is a fully developed sea (Pierson, Moskowitz)."
    )
    components: Components = Field(100, description="Regular waves that a sea is made of.")
    seed: Seed = Field(1, description="Another number is another record of the same sea.")
    phase: Angle | None = Field(
        None,
        description="Of waves that are all alike how late crests pass the origin of the world: with 0, or if "
        "not given, as the lift starts and every period after it, with 90 deg a quarter of a period later.",
    )

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """Waves are alike or a sea."""
        if set(data).difference(cls.keys()):
            return  # which is told, with what may be meant by it
        regular, irregular = ([key for key in keys if key in data] for keys in (_REGULAR, _IRREGULAR))
        if regular and irregular:
            raise refuse(
                "waves that are all alike have 'height' and 'period', a sea 'significant_height' and "
                "'peak_period'; leave one pair out",
                irregular[0],
            )
        if not regular and not irregular:
            raise refuse(
                "needs 'significant_height: 1.5 m' and 'peak_period: 8 s', or 'height' and 'period' of waves "
                "that are all alike"
            )
        for pair in (_REGULAR, _IRREGULAR):
            given = [key for key in pair if key in data]
            if len(given) == 1:
                missing = next(key for key in pair if key != given[0])
                raise refuse(f"'{missing}' is missing beside '{given[0]}'")
        for key in ("peak_enhancement", "components", "seed"):
            if regular and key in data:
                raise refuse(f"'{key}' is for a sea with 'significant_height'", key)
        if irregular and "phase" in data:
            raise refuse(
                "'phase' is for waves with 'height'; those of a sea are drawn by its 'seed'", "phase"
            )

    @property
    def is_regular(self) -> bool:
        """Whether all waves are alike."""
        return self.height is not None

    @property
    def main_height(self) -> float:
        """Height, of a sea the significant one [m]."""
        height = self.height if self.is_regular else self.significant_height
        assert height is not None  # validated
        return height

    @property
    def main_period(self) -> float:
        """Period, of a sea that of the peak of its spectrum [s]."""
        period = self.period if self.is_regular else self.peak_period
        assert period is not None  # validated
        return period
