"""What programs ask of a lift at rest, where a slip would end inside or be answered for something else."""

from __future__ import annotations

import math
from collections.abc import Sequence
from numbers import Integral
from typing import get_args

import numpy as np

from gantline.arguments import is_number, listed, number
from gantline.statics.answers import Losses, Mode

__all__ = ["increment_of", "losses_of", "swing_of"]


def losses_of(given: Losses) -> Losses:
    """What friction does, as it is.

    Raises:
        ValueError: If it is none of the words for that.
    """
    known = get_args(Losses)
    if given not in known:
        raise ValueError(f"losses: {given!r} is none; they are {', '.join(known[:-1])} or {known[-1]}")
    return given


def increment_of(given: Sequence[float] | None) -> list[float] | None:
    """How far each degree of freedom starts from the start of the lift, as a list; None for not at all.

    Raises:
        TypeError: If these are no numbers.
        ValueError: If one is not finite.
    """
    if given is None:
        return None
    parts = listed(given, "increment: a list", "a number of metres or radians for each degree of freedom")
    if any(is_number(part) and not math.isfinite(part) for part in parts):
        raise ValueError(f"increment: {given!r} has a part that is not finite")
    return [number(part, "increment", "metres or radians") for part in parts]


def swing_of(mode: Mode, last: Sequence[Mode], amplitude: float, frames: int) -> tuple[float, int]:
    """The size of a swing and its samples, as they are.

    Args:
        mode: What is to be shown.
        last: The modes found last; the core knows a mode by its number among them alone.
        amplitude: Largest displacement [m] or turn [rad].
        frames: Samples.

    Raises:
        ValueError: If it is none of them, or no motion can be shown so.
    """
    if not isinstance(mode, Mode):
        raise ValueError(f"mode: {mode!r} is no Mode; modes() answers with them")
    known = last[mode.number] if mode.number < len(last) else None
    same = known is not None and known.square == mode.square and known.bodies == mode.bodies
    if known is None or not same or not np.array_equal(known.body_motion, mode.body_motion):
        sentence = f"mode: {mode!r} is none of those found last"
        raise ValueError(f"{sentence}; ask modes() anew after each equilibrium, and show one of its answers")
    if not is_number(amplitude):
        raise ValueError(f"amplitude: {amplitude!r} is no number of metres or radians")
    if isinstance(frames, bool) or not isinstance(frames, Integral):
        raise ValueError(f"frames: {frames!r} is no whole number from 1 on")
    if not (math.isfinite(amplitude) and frames >= 1):
        raise ValueError(f"no motion of {frames} frames with the amplitude {amplitude:g} can be shown")
    return float(amplitude), int(frames)
