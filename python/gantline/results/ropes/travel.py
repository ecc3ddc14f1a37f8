"""How far moving sheaves travel, of the stroke that they have."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from gantline.results.gear import Equalizer
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray, FloatArray

__all__ = ["Way", "most_used", "ways", "ways_of"]


@dataclass(frozen=True)
class Way:
    """A moving sheave one way.

    Attributes:
        sheave: Its name.
        word: That way, `up` or `down`.
        travel: How far it has travelled that way from the start, shape (time,) [m].
        stroke: How far it may [m].
        has_stop: Whether a stop at the end of that stroke is simulated.
    """

    sheave: str
    word: str
    travel: FloatArray
    stroke: float
    has_stop: bool

    @property
    def element(self) -> str:
        """Sheave and way in words."""
        return f"{self.sheave} {self.word}"


def ways(recording: Recording) -> Iterator[Way]:
    """Both ways of all moving sheaves whose stroke is known."""
    for equalizer in recording.rig.equalizers:
        yield from ways_of(recording, equalizer)


def ways_of(recording: Recording, equalizer: Equalizer, word: str = "") -> Iterator[Way]:
    """Ways of the moving sheaves of one equalizer whose stroke is known; both, or that of a `word`.

    Sheaves of an approximated equalizer do not travel: a stroke says nothing about them.
    """
    if equalizer.mechanism != "sheaves":
        return
    strokes = (("up", -1.0, equalizer.travel_up), ("down", 1.0, equalizer.travel_down))
    for sheave in equalizer.moving_sheaves:
        for name, sign, stroke in strokes:
            if stroke and word in ("", name):
                travel: FloatArray = sign * recording.column("sheave_travel", sheave)
                yield Way(sheave, name, travel, stroke, equalizer.stops)


def most_used(ways: Iterable[Way], during: BoolArray) -> float:
    """Largest share of its stroke that any way takes in some samples, one at least [1]; 0 where none does."""
    # Not by max(), which takes what is no number for less.
    return float(np.max([0.0, *(way.travel[during].max() / way.stroke for way in ways)]))
