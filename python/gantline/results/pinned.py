"""Which moving sheaves locking pins hold, and when."""

from __future__ import annotations

import math

import numpy as np

from gantline.results.gear import Equalizer
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray

__all__ = ["PIN_PULLED", "pinned_as_at", "pinned_sheaves"]

#: Kinds of events: a moving sheave goes from then on, and slings under it share anew; and it is held.
PIN_PULLED, _PIN_PUT_IN = "pin_pulled", "pin_put_in"


def pinned_sheaves(recording: Recording, equalizer: Equalizer, until: float = math.inf) -> set[str]:
    """Moving sheaves that pins hold, at the end or at a time [s]."""
    pinned = set(equalizer.locked)
    for time, kind, sheave in recording.events():
        if time > until:
            break
        if kind == _PIN_PUT_IN and sheave in equalizer.moving_sheaves:
            pinned.add(sheave)
        elif kind == PIN_PULLED:
            pinned.discard(sheave)
    return pinned


def pinned_as_at(recording: Recording, time: float) -> BoolArray:
    """Samples at which pins hold the same moving sheaves as at a time [s], shape (time,)."""

    def held(until: float) -> set[str]:
        every = recording.rig.equalizers
        return {sheave for one in every for sheave in pinned_sheaves(recording, one, until)}

    then = held(time)
    alike = np.full(len(recording.time), held(-math.inf) == then)
    changes = {moment for moment, kind, _ in recording.events() if kind in (PIN_PULLED, _PIN_PUT_IN)}
    for moment in sorted(changes):
        alike[recording.time >= moment] = held(moment) == then
    return alike
