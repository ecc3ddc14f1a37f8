"""Loads that nothing but their own weight keeps upright.

The slings of one equalizer pull alike, so they act as one force from the middle of their lugs. Under one
equalizer, or several whose middles lie in one line, the rig brings no moment against tilting (about that
line): the load hangs like a pendulum from the middle, by tan θ = e/h.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.gear import Sling
from gantline.results.parting import DETACHED, while_there
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.skew import pinned_sheaves
from gantline.units import format_quantity

__all__ = ["LooseTilt", "loose_tilt"]

#: Middles are in one line if they are off it by less than this share of their distance.
_IN_LINE = 0.02
#: Offset of the centre of gravity that a sentence speaks of [m].
_OFFSET = 0.1


@dataclass(frozen=True)
class LooseTilt:
    """A load that its rig does not keep from tilting.

    Attributes:
        load: Its name.
        equalizers: From which it hangs.
        line: Direction of the line about which it tilts freely, axes of the load; None: about any.
        depth: Of its centre of gravity below the middle of the lugs [m]; negative above.
    """

    load: str
    equalizers: tuple[str, ...]
    line: tuple[float, float] | None
    depth: float

    def __str__(self) -> str:
        about = "" if self.line is None else f" about ({self.line[0]:.2f}, {self.line[1]:.2f}, 0)"
        names = ", ".join(self.equalizers)
        no_stiffness = f"the slings of {names} give {self.load} no tilt stiffness{about}"
        if self.depth <= 0.0:
            return f"{no_stiffness}, and its centre of gravity is not below the middle of its lugs"
        tilt = format_quantity(math.atan2(_OFFSET, self.depth), "deg", 2)
        offset = format_quantity(_OFFSET, "mm", 0)
        by_hand = f"tan(tilt) = e/{self.depth:.2f} m with plumb slings"
        return f"{no_stiffness}: {by_hand}, {tilt} for {offset} of centre of gravity"


def loose_tilt(recording: Recording, load: Load) -> LooseTilt | None:
    """Whether equalizers leave a load free to tilt; None if they do not, or that is not known.

    Slings that steps put on or take off count while they are on and the load hangs; the first time counts at
    which it is free.

    Args:
        recording: Any recording; pins count as they are at the end of such a time.
        load: A load of it.
    """
    found = (_loose(recording, load, slings, until) for slings, until in _stages(recording, load))
    return next((one for one in found if one is not None), None)


def _stages(recording: Recording, load: Load) -> Iterator[tuple[list[Sling], float]]:
    """The slings that are on while a load hangs, and until when [s], in turn; at the end if it never does."""
    slings, times = recording.rig.slings, recording.time
    clear = series.load_is_clear(recording, load)
    if series.is_equilibrium(recording) or not clear.any():
        clear = series.last_sample(recording)
    on = while_there(recording, [sling.rope for sling in slings], [DETACHED])[:, clear]
    changes = np.flatnonzero((on[:, 1:] != on[:, :-1]).any(axis=0))
    for last in (*changes, on.shape[1] - 1) if on.shape[1] else ():
        there = on[:, last]
        yield [one for one, is_on in zip(slings, there, strict=True) if is_on], float(times[clear][last])


def _loose(recording: Recording, load: Load, slings: Sequence[Sling], until: float) -> LooseTilt | None:
    """The same of some slings, with pins as they are at a time [s]."""
    rig = recording.rig
    middles: dict[str, list[np.ndarray]] = {}
    for sling in slings:
        equalizer = rig.equalizer_of(sling)
        lug = load.lugs.get(sling.to_lug or "")
        if equalizer is None or sling.to_load != load.name or lug is None:
            return None
        if equalizer.mechanism != "sheaves" or pinned_sheaves(recording, equalizer, until):
            return None
        middles.setdefault(equalizer.name, []).append(np.asarray(lug.at, dtype=np.float64))
    if not middles:
        return None
    lugs = np.concatenate([np.array(places) for places in middles.values()])
    points = np.array([np.mean(places, axis=0) for places in middles.values()])
    _, sizes, axes = np.linalg.svd(points[:, :2] - points[:, :2].mean(axis=0))
    reach = float(np.linalg.norm(lugs[:, :2] - lugs[:, :2].mean(axis=0), axis=1).max())
    across = float(sizes[1]) if len(sizes) > 1 else 0.0
    if across > _IN_LINE * sizes[0] and across > 1e-3 * reach:
        return None
    line = None
    if sizes[0] > 1e-3 * reach:
        way = axes[0] if axes[0][int(np.argmax(np.abs(axes[0])))] > 0 else -axes[0]
        line = (float(way[0]) + 0.0, float(way[1]) + 0.0)
    return LooseTilt(load.name, tuple(middles), line, float(lugs[:, 2].mean()))
