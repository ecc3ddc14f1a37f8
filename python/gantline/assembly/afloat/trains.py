"""Regular waves and gusts that run in one direction, as the core reads them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np
import numpy.typing as npt

from gantline.assembly.parts import Json
from gantline.hydro.waves import Components

__all__ = ["Train"]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Train:
    """What runs in one direction.

    Attributes:
        waves: what it is made of.
        numbers: k of each, world x and y (n, 2) [rad/m].
    """

    waves: Components
    numbers: Array

    @classmethod
    def of(cls, waves: Components, numbers: Array) -> Self:
        """Of waves by κ of each (n,) [rad/m]."""
        return cls(waves, np.outer(numbers, [math.cos(waves.direction), math.sin(waves.direction)]))

    @property
    def document(self) -> list[Json]:
        """As the core reads them."""
        waves = self.waves
        columns = (waves.frequency, self.numbers, waves.amplitude, waves.phase)
        keys = ("frequency", "wave_number", "amplitude", "phase")
        return [
            dict(zip(keys, wave, strict=True))
            for wave in zip(*(column.tolist() for column in columns), strict=True)
        ]
