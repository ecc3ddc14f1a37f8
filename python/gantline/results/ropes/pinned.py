"""Which moving sheaves and rods of compensators locking pins hold, and when."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable

import numpy as np

from gantline.results.gear import Equalizer
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray

__all__ = ["PIN_PULLED", "is_pinned", "pinned_as_at", "pinned_sheaves"]

#: Kinds of events: a moving sheave goes from then on, and slings under it share anew; and it is held.
PIN_PULLED, _PIN_PUT_IN = "pin_pulled", "pin_put_in"


def pinned_sheaves(recording: Recording, equalizer: Equalizer, until: float = math.inf) -> set[str]:
    """Moving sheaves that pins hold, at the end or at a time [s]."""
    return _pinned(recording, equalizer.locked, equalizer.moving_sheaves, until)


def _pinned(recording: Recording, at_start: Iterable[str], joints: Collection[str], until: float) -> set[str]:
    """Of some joints those that pins hold at a time [s], of which some are held at the start."""
    pinned = set(at_start)
    for time, kind, joint in recording.events():
        if time > until:
            break
        if kind == _PIN_PUT_IN and joint in joints:
            pinned.add(joint)
        elif kind == PIN_PULLED:
            pinned.discard(joint)
    return pinned


def is_pinned(recording: Recording, joint: str, *, at_start: bool) -> BoolArray:
    """Samples at which a pin holds a joint, shape (time,); at that of its being put in or pulled it does."""
    held = np.full(len(recording.time), at_start)
    for time, kind, name in recording.events():
        if name == joint and kind in (PIN_PULLED, _PIN_PUT_IN):
            is_in = kind == _PIN_PUT_IN
            later = recording.time >= time if is_in or recording.is_equilibrium else recording.time > time
            held[later] = is_in
    return held


def pinned_as_at(recording: Recording, time: float) -> BoolArray:
    """Samples at which pins hold the same sheaves and rods as at a time [s], shape (time,)."""

    def held(until: float) -> set[str]:
        rig = recording.rig
        every = {sheave for one in rig.equalizers for sheave in pinned_sheaves(recording, one, until)}
        rods = {one.rod: one.locked for one in rig.compensators}
        return every | _pinned(recording, (rod for rod, locked in rods.items() if locked), rods, until)

    then = held(time)
    alike = np.full(len(recording.time), held(-math.inf) == then)
    changes = {moment for moment, kind, _ in recording.events() if kind in (PIN_PULLED, _PIN_PUT_IN)}
    for moment in sorted(changes):
        alike[recording.time >= moment] = held(moment) == then
    return alike
