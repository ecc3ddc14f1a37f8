"""The undisturbed surface of the water over time, from the regular waves that it is made of."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from gantline.results.rotation import axes, heading
from gantline.results.strength import FromJson
from gantline.results.trains import Trains
from gantline.results.variable import Columns, Names
from gantline.units import format_quantity

__all__ = ["Sea", "WaveTrain", "out_of_place"]

#: Waves from so little beside the bow, or the stern, come over it [rad]: 0.5 deg.
_AHEAD = math.radians(0.5)
#: Turn of a vessel from which the forces of its first heading are doubtful [rad].
_TURNED = math.radians(10.0)
#: Phase by which waves come sooner or later to a vessel that has drifted, from which it counts.
_DRIFTED = math.pi / 2


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
    """

    name: str
    direction: float
    height: float
    period: float
    is_regular: bool = False
    seed: int | None = None

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

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        trains = tuple(WaveTrain.from_json(one) for one in document.get("trains") or ())
        return super().from_json({**document, "trains": trains})


def out_of_place(document: Mapping[str, Any], columns: Columns, names: Names) -> list[str]:
    """A sentence for each vessel that has turned or drifted away from where its wave forces are for.

    They keep amount, direction and phase of where the lift file has the vessel. On one that turns by and by
    the moment that pitched it rolls it, which can heel it far more than any such sea does.

    Args:
        document: What has been assembled of the lift.
        columns: What was recorded: `time`, `body_position`, `body_orientation`.
        names: Names along their dimensions.
    """
    sentences = []
    for force in (one for one in document.get("forces", ()) if one["type"] == "wave"):
        body = next(one for one in document["bodies"] if one["name"] == force["body"])
        at = list(names["body"]).index(force["body"])
        joint, centre = body["joint"], np.array(body.get("centre_of_gravity", (0.0, 0.0, 0.0)))
        first = np.array(joint["orientation"])
        turns = np.unwrap(heading(columns["body_orientation"][:, at])) - heading(first)
        turned = np.abs(turns - 2 * math.pi * np.round(turns[:1] / (2 * math.pi)))
        arm = np.array(force["at"])
        given = np.array(joint["position"]) + axes(first) @ arm
        found = columns["body_position"][:, at] + axes(columns["body_orientation"][:, at]) @ (arm - centre)
        along = np.array([wave["wave_number"] for wave in document["sea"]["components"]])
        energy = np.array([wave["amplitude"] ** 2 for wave in document["sea"]["components"]])
        phase = np.abs((found - given)[:, :2] @ along.T) @ energy / energy.sum()
        for doubtful, what in (
            (turned > _TURNED, f"turns by up to {math.degrees(turned.max()):.3g} deg"),
            (phase > _DRIFTED, f"drifts by up to {np.hypot(*(found - given)[:, :2].T).max():.3g} m"),
        ):
            if doubtful.any():
                since = float(columns["time"][int(np.argmax(doubtful))])
                sentences.append(
                    f"wave forces of {force['body']} are for its place and heading in the lift file; "
                    f"it {what} and from {since:.0f} s on feels those of other waves; mooring lines hold it"
                )
    return sentences
