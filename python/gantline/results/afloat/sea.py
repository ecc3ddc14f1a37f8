"""The undisturbed surface of the water over time, from the regular waves that it is made of."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Self

from gantline.results.afloat.trains import Trains
from gantline.results.strength import FromJson
from gantline.units import format_quantity

__all__ = ["Sea", "WaveTrain"]

#: Waves from so little beside the bow, or the stern, come over it [rad]: 0.5 deg.
_AHEAD = math.radians(0.5)


@dataclass(frozen=True)
class WaveTrain(FromJson):
    """Waves that run in one direction, as the lift file names them.

    Attributes:
        name: Their name.
        direction: In which they run, from world x towards y [rad].
        height: Of waves that are all alike, else the significant height [m].
        period: Of waves that are all alike, else that of the peak of the spectrum [s].
        is_regular: Whether they are all alike.
        seed: Of a sea which of its records; None of waves that are all alike.
        phase: Of waves that are all alike how late crests pass the origin [rad]; None if not said.
    """

    name: str
    direction: float
    height: float
    period: float
    is_regular: bool = False
    seed: int | None = None
    phase: float | None = None

    @property
    def height_and_period(self) -> tuple[str, str]:
        """How high the waves are, and how long they take."""
        kind = ("height", "period") if self.is_regular else ("significant height", "peak period")
        height, period = format_quantity(self.height, "m", 2), format_quantity(self.period, "s", 1)
        return f"{height} {kind[0]}", f"{period} {kind[1]}"

    @property
    def in_words(self) -> str:
        """Height, period, direction and record."""
        runs = f"running towards {format_quantity(self.direction, 'deg', 0)}"
        record = () if self.seed is None else (f"record {self.seed}",)
        if self.phase is not None:
            record = (f"phase {format_quantity(self.phase, 'deg', 0)}",)
        return f"{self.name}: {', '.join((*self.height_and_period, runs, *record))}"

    def comes_from(self, heading: float) -> str:
        """From where they come, as seen from a vessel with this heading [rad]."""
        aside = math.remainder(self.direction + math.pi - heading, math.tau)
        if abs(aside) < _AHEAD:
            return "from ahead"
        if math.pi - abs(aside) < _AHEAD:
            return "from astern"
        side = "port" if aside > 0.0 else "starboard"
        return f"from {format_quantity(abs(aside), 'deg', 0)} off the bow to {side}"


@dataclass(frozen=True)
class Sea(Trains):
    """The undisturbed surface of the water above still water [m].

    Attributes:
        trains: as the lift file names them; of recordings from before they were kept none.
    """

    trains: Sequence[WaveTrain] = ()

    @property
    def significant_height(self) -> float:
        """Of all trains together, four standard deviations of the surface [m].

        Waves that are all alike have 1/8 of the square of their height as variance, a sea 1/16.
        """
        return math.sqrt(sum((2.0 if one.is_regular else 1.0) * one.height**2 for one in self.trains))

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        trains = tuple(WaveTrain.from_json(one) for one in document.get("trains") or ())
        return super().from_json({**document, "trains": trains})
