"""The wind of a lift, steady or in gusts, and its current."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from gantline.hydro.wind import WindProfile
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
        profile: How it grows with height; None if it is the same at any.
    """

    speed: float
    direction: float
    gust_speed: float | None = None
    turbulence: float | None = None
    seed: int | None = None
    gusts: Trains | None = None
    profile: WindProfile | None = None

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        gusts, profile = document.get("gusts"), document.get("profile")
        made = {
            "gusts": None if gusts is None else Trains.from_json(gusts),
            "profile": None if profile is None else WindProfile(**profile),
        }
        return super().from_json({**document, **made})

    @property
    def differs(self) -> bool:
        """Whether it is another at another time or height."""
        return self.gusts is not None or self.profile is not None

    @property
    def height_in_words(self) -> str:
        """At which height it has its speed, after a space; nothing where it is the same at any."""
        return "" if self.profile is None else f" at {format_quantity(self.profile.height, 'm', 0)}"

    @property
    def in_words(self) -> str:
        """Speed, direction, growth with height, gusts and record."""
        gusty = "" if self.gust_speed is None else f", gusts of {format_quantity(self.gust_speed, 'm/s', 1)}"
        record = "" if self.seed is None else f", record {self.seed}"
        grows = "" if self.profile is None else f" {self.profile.in_words}"
        return f"{_shown(self.speed, self.direction, f'{self.height_in_words}{grows}')}{gusty}{record}"

    def speed_at(self, time: FloatArray, place: FloatArray) -> FloatArray:
        """Its speed [m/s].

        Args:
            time: (samples,) [s].
            place: world x, y and z (samples, ..., 3) [m]; x and y do where it is the same at any height.

        Returns:
            (samples, ...).
        """
        share = np.ones(place.shape[:-1]) if self.profile is None else self.profile.share(place[..., 2])
        mean: FloatArray = self.speed * share
        return mean if self.gusts is None else mean + self.gusts.at(time, place[..., :2])


def _shown(speed: float, direction: float, height: str = "") -> str:
    towards = format_quantity(direction, "deg", 0)
    return f"{format_quantity(speed, 'm/s', 1)}{height} towards {towards}"


def wind_at_loads(
    columns: Columns,
    names: Names,
    loads: Mapping[str, str],
    wind: Wind | None,
) -> Derived:
    """Speed of the wind at the centre of gravity of each load; nothing where it is the same always.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        loads: Bodies of the loads by their names.
        wind: That of the lift; None if it has none with a direction.
    """
    if wind is None or not wind.differs or not loads:
        return {}, {}
    bodies = [list(names["body"]).index(body) for body in loads.values()]
    speed = wind.speed_at(columns["time"], columns["body_position"][:, bodies, :3])
    described = "speed of the wind, gusts and growth with height included, at the centre of gravity of a load"
    return {"wind_at_load": Variable(("time", "load"), speed, "m/s", described)}, {"load": list(loads)}
