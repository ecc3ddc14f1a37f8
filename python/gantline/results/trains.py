"""What comes by as a sum of regular waves that travel: the surface of the water, gusts of the wind."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gantline.results.strength import FromJson
from gantline.results.variable import FloatArray

__all__ = ["Trains"]


@dataclass(frozen=True)
class Trains(FromJson):
    """η = g(t) Σ a cos(k·x − ωt + ε), g growing from 0 to 1 with two derivatives.

    Attributes:
        components: regular waves: `frequency` ω [rad/s], `wave_number` k, world x and y [rad/m],
            `amplitude` a [m, of gusts m/s], `phase` ε [rad].
        rise_time: in which they grow [s].
    """

    components: Sequence[Mapping[str, Any]] = ()
    rise_time: float = 1.0

    def at(self, time: FloatArray, place: FloatArray) -> FloatArray:
        """η [m, of gusts m/s].

        Args:
            time: (samples,) [s].
            place: world x and y (samples, ..., 2) [m].

        Returns:
            (samples, ...).
        """
        beside = (slice(None), *[None] * (place.ndim - 2))
        found = np.zeros(place.shape[:-1])
        for wave in self.components:
            x, y = wave["wave_number"]
            along = x * place[..., 0] + y * place[..., 1]
            found += wave["amplitude"] * np.cos(along - wave["frequency"] * time[beside] + wave["phase"])
        share = np.clip(time / self.rise_time, 0.0, 1.0)
        growth: FloatArray = share**3 * (10.0 - share * (15.0 - 6.0 * share))
        return found * growth[beside]
