"""What the race asks of a code: settings that trade time for error, and a run that can be timed by itself."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
import numpy.typing as npt

from benchmarks.lifts import Lift

FloatArray = npt.NDArray[np.float64]

SAMPLE_INTERVAL = 0.01
"""Every code records every sling's tension this often [s]."""


@dataclass(frozen=True)
class Setting:
    """A method of a code, with the name of what its value is: a step, a tolerance."""

    method: str
    value: float

    def __str__(self) -> str:
        return f"{self.method} {self.value:.4g}"


class Unfit(Exception):
    """A run that says nothing: the method blew up or gave up at this setting."""


class Run(Protocol):
    """A model that stands at its start, ready to run once."""

    def integrate(self) -> None:
        """Run to the end and record; this alone is timed. Raises `Unfit`."""

    def tensions(self) -> FloatArray:
        """Sling tensions (time, sling) at 0, SAMPLE_INTERVAL, … [N]."""


class Code(Protocol):
    """A code that solves the benchmark lifts. Names of methods are explained in its module."""

    name: str

    def version(self) -> str:
        """As the code itself tells it. Raises ImportError where the code is not installed."""

    def settings(self, lift: Lift) -> Sequence[Setting]:
        """The ladder of the race: the best method for this lift, from tight to loose."""

    def candidates(self, lift: Lift) -> Sequence[Setting]:
        """All that was tried to find the ladder."""

    def prepare(self, lift: Lift, setting: Setting, duration: float) -> Run:
        """Build the model; nothing of this is timed."""


def sample_count(duration: float) -> int:
    """Samples of a run, start and end included."""
    return round(duration / SAMPLE_INTERVAL) + 1
