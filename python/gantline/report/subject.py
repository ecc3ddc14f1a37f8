"""What the sections of a report are about: a recording and what is worked out of it once."""

from __future__ import annotations

import re
from functools import cached_property

from gantline.checks import Check, check_recording
from gantline.results import series
from gantline.results.ending import Ending, ending_of
from gantline.results.file.saved import Beside, beside_of
from gantline.results.progress import under_way
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.stability import Stability, stability_of
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity

ABSENT = "–"
#: Share of its stroke that a moving sheave uses at most where no limit says otherwise [1].
_USUAL_TRAVEL = 0.9
#: Of a number; a dash between words has a blank behind it, one within a name a letter before it.
_MINUS = re.compile(r"(?<!\S)-(?=\d)")


class Subject:
    """A recording for a report.

    Args:
        recording: Any recording.
        beside: What else was asked of the same lift.
    """

    def __init__(self, recording: Recording, beside: Beside | None = None) -> None:
        self.recording = recording
        self.beside = beside_of(beside) or Beside()

    @property
    def rig(self) -> Rig:
        """What was lifted with what."""
        return self.recording.rig

    @property
    def has_motion(self) -> bool:
        """Whether there are curves to plot; between the start of a lift at rest and that nobody looked."""
        return len(self.recording.time) > 1 and not self.recording.is_equilibrium

    @cached_property
    def checks(self) -> list[Check]:
        """All checks."""
        return check_recording(self.recording)

    @cached_property
    def metrics(self) -> dict[str, float]:
        """Key numbers."""
        return self.recording.metrics()

    @cached_property
    def stability(self) -> Stability:
        """How sound the run was."""
        return stability_of(self.recording)

    @cached_property
    def ending(self) -> Ending | None:
        """How a run ended that did not get through its lift; None of one that did."""
        return ending_of(self.recording)

    @cached_property
    def counts(self) -> BoolArray:
        """Samples that count: of a lift at rest the last one, for the one before is where it starts."""
        return series.everywhere(self.recording)

    @cached_property
    def clear(self) -> BoolArray:
        """Those of them at which nothing supports any load."""
        clear: BoolArray = series.is_clear(self.recording) & self.counts
        return clear

    @property
    def most_travel(self) -> float:
        """Share of its stroke that a moving sheave may use [1]: the lift's own limit, or the usual one."""
        return float(self.rig.limits.get("equalizer_travel_used") or _USUAL_TRAVEL)

    def static(self, values: FloatArray) -> float | None:
        """Static value of a series, where it was largest; None if the lift has no quiet window."""
        return series.greatest_static(self.recording, values)[0]

    def peak(self, values: FloatArray) -> tuple[float, float] | None:
        """Largest sample of those that count, and its time [s]."""
        return series.peak(self.recording, values, self.counts)

    def step_at(self, time: float) -> str:
        """Names of the steps of the plan that go at a time [s], in one; empty where none does."""
        return under_way(self.recording, time)


def show(value: float | None, unit: str, digits: int) -> str:
    """A value with its unit, or a dash."""
    return ABSENT if value is None else typeset(format_quantity(value, unit, digits))


def typeset(text: str) -> str:
    """Written numbers with a proper minus, as plots have it."""
    return _MINUS.sub("−", text)


def number(value: float | None, unit: str, digits: int) -> str:
    """A value without its unit, for columns whose head has it; or a dash."""
    return show(value, unit, digits).removesuffix(unit).strip()


def as_given(mass: float | None) -> str:
    """A mass [kg] in t, with the digits that somebody gave it, as 12.5 and 300; or a dash."""
    text = number(mass, "t", 3)
    return text.rstrip("0").rstrip(".") if "." in text else text


def share(value: float | None, of: float | None) -> float | None:
    """A value of another; None if one is missing or nothing."""
    return None if value is None or not of else value / of
