"""The wind of a lift, steady or in gusts, and its current."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from gantline.results.afloat.trains import Trains
from gantline.results.strength import FromJson
from gantline.results.variable import Columns, Derived, FloatArray, Names, Variable
from gantline.units import format_quantity

__all__ = ["Current", "Wind", "wind_at_loads"]


@dataclass(frozen=True)
class Current(FromJson):
    """Steady current.

    Attributes:
        speed: Its speed [m/s].
        direction: In which it moves, from world x towards y [rad].
    """

    speed: float
    direction: float

    @property
    def in_words(self) -> str:
        """Speed and direction."""
        return _shown(self.speed, self.direction)


@dataclass(frozen=True)
class Wind(FromJson):
    """Wind with a direction.

    Attributes:
        speed: Its speed, in gusts the mean over ten minutes [m/s].
        direction: In which it moves, from world x towards y [rad].
        gust_speed: The highest mean over 3 s to be expected in ten minutes [m/s]; None if it is steady.
        turbulence: Standard deviation over mean; None if it is steady.
        seed: Which of its records; None if it is steady.
        gusts: What comes on top of the mean; None if it is steady.
    """

    speed: float
    direction: float
    gust_speed: float | None = None
    turbulence: float | None = None
    seed: int | None = None
    gusts: Trains | None = None

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        given = document.get("gusts")
        return super().from_json({**document, "gusts": None if given is None else Trains.from_json(given)})

    @property
    def in_words(self) -> str:
        """Speed, direction, gusts and record."""
        gusty = "" if self.gust_speed is None else f", gusts of {format_quantity(self.gust_speed, 'm/s', 1)}"
        record = "" if self.seed is None else f", record {self.seed}"
        return f"{_shown(self.speed, self.direction)}{gusty}{record}"

    def speed_at(self, time: FloatArray, place: FloatArray) -> FloatArray:
        """Its speed [m/s].

        Args:
            time: (samples,) [s].
            place: world x and y (samples, ..., 2) [m].

        Returns:
            (samples, ...).
        """
        if self.gusts is None:
            return np.full(place.shape[:-1], self.speed)
        return self.speed + self.gusts.at(time, place)


def _shown(speed: float, direction: float) -> str:
    return f"{format_quantity(speed, 'm/s', 1)} towards {format_quantity(direction, 'deg', 0)}"


def wind_at_loads(
    columns: Columns,
    names: Names,
    loads: Mapping[str, str],
    wind: Wind | None,
) -> Derived:
    """Speed of gusty wind at the centre of gravity of each load; nothing in steady wind.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        loads: Bodies of the loads by their names.
        wind: That of the lift; None if it has none with a direction.
    """
    if wind is None or wind.gusts is None or not loads:
        return {}, {}
    bodies = [list(names["body"]).index(body) for body in loads.values()]
    speed = wind.speed_at(columns["time"], columns["body_position"][:, bodies, :2])
    described = "speed of the wind, gusts included, at the centre of gravity of a load"
    return {"wind_at_load": Variable(("time", "load"), speed, "m/s", described)}, {"load": list(loads)}
