"""Loads that nothing but their own weight keeps upright.

The slings of one equalizer pull alike, so they act as one force from the middle of their lugs. Under one
equalizer, or several whose middles lie in one line, the rig brings no moment against tilting (about that
line): the load hangs like a pendulum from the middle, by tan θ = e/h.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gantline.results import series
from gantline.results.alike import first_peak
from gantline.results.gear import Sling
from gantline.results.loads.hinges import is_shut
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.ropes.pinned import pinned_sheaves
from gantline.results.rotation import axes
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
        line: Level direction of the line about which it tilts freely, world x and y; None: about any.
        depth: Of its centre of gravity below the middle of the lugs [m]; negative above.
        since: From when on it hangs so [s]; None of one that does from the first on.
        has_liquid: Whether there is liquid in its tanks then, of which the depth knows nothing.
    """

    load: str
    equalizers: tuple[str, ...]
    line: tuple[float, float] | None
    depth: float
    since: float | None = None
    has_liquid: bool = False

    def __str__(self) -> str:
        # What is left of rounding has no sign.
        x, y = (round(part, 2) + 0.0 for part in self.line or (0.0, 0.0))
        about = "" if self.line is None else f" about ({x:.2f}, {y:.2f}, 0.00)"
        names = ", ".join(self.equalizers)
        slings = f"the slings of {names}"
        if self.since is not None:
            slings = f"from {self.since:.2f} s on, when it hangs from them alone, {slings}"
        no_stiffness = f"{slings} give {self.load} no tilt stiffness{about}"
        own = ", without what is in its tanks," if self.has_liquid else ""
        if self.depth <= 0.0:
            return f"{no_stiffness}, and its centre of gravity{own} is not below the middle of its lugs"
        tilt = format_quantity(math.atan2(_OFFSET, self.depth), "deg", 2)
        offset = format_quantity(_OFFSET, "mm", 0)
        by_hand = f"tan(tilt) = e/{self.depth:.2f} m with plumb slings"
        if self.has_liquid:
            return f"{no_stiffness}: {by_hand} and empty tanks; 'gantline statics' counts what is in them"
        return f"{no_stiffness}: {by_hand}, {tilt} for {offset} of centre of gravity"


def loose_tilt(recording: Recording, load: Load) -> LooseTilt | None:
    """Whether equalizers leave a load free to tilt; None if they do not, or that is not known.

    Slings that come, go or part count while they are there and the load hangs; the first time counts at
    which it is free, with lugs where they are as it begins: what is turned later has hung from all of them.
    Of an equilibrium slings count that carry.

    Args:
        recording: Any recording; pins count as they are at the end of such a time.
        load: A load of it.
    """
    for number, (slings, sample, until) in enumerate(_stages(recording, load)):
        found = _loose(recording, load, slings, sample, until)
        if found is not None:
            return replace(found, since=float(recording.time[sample])) if number else found
    return None


def _stages(recording: Recording, load: Load) -> Iterator[tuple[list[Sling], int, float]]:
    """The slings that are there while a load hangs, its first sample and its end [s], in turn.

    At the end if it never does.
    """
    slings, times = recording.rig.slings, recording.time
    clear = series.load_is_clear(recording, load)
    for hinge in recording.rig.hinges:
        if hinge.load == load.name:
            clear = clear & ~is_shut(recording, hinge)
            if not clear.any() or (recording.is_equilibrium and not clear[-1]):
                return
    if recording.is_equilibrium or not clear.any():
        clear = series.last_sample(recording)
    there = series.are_whole(recording, [sling.rope for sling in slings])
    if recording.is_equilibrium and slings:
        there &= np.array([recording.column("rope_tension", sling.rope) > 0.0 for sling in slings])
    there, samples = there[:, clear], np.flatnonzero(clear)
    changes = np.flatnonzero((there[:, 1:] != there[:, :-1]).any(axis=0))
    first = 0
    for last in (*changes, there.shape[1] - 1) if there.shape[1] else ():
        own = [one for one, is_there in zip(slings, there[:, last], strict=True) if is_there]
        yield own, int(samples[first]), float(times[samples[last]])
        first = last + 1


def _loose(
    recording: Recording, load: Load, slings: Sequence[Sling], sample: int, until: float
) -> LooseTilt | None:
    """The same of some slings, with lugs where they are at a sample and pins as they are at a time [s]."""
    own = axes(recording.column("body_orientation", load.body)[sample])
    if not np.isfinite(own).all():  # a recording with gaps, which its checks tell
        return None
    rig = recording.rig
    middles: dict[str, list[np.ndarray]] = {}
    for sling in slings:
        equalizer = rig.equalizer_of(sling)
        lug = load.lugs.get(sling.to_lug or "")
        if equalizer is None or sling.to_load != load.name or lug is None:
            return None
        if equalizer.mechanism != "sheaves" or pinned_sheaves(recording, equalizer, until):
            return None
        middles.setdefault(equalizer.name, []).append(own @ lug.at)
    if not middles:
        return None
    lugs = np.concatenate([np.array(places) for places in middles.values()])
    points = np.array([np.mean(places, axis=0) for places in middles.values()])
    _, sizes, ways = np.linalg.svd(points[:, :2] - points[:, :2].mean(axis=0))
    reach = float(np.linalg.norm(lugs[:, :2] - lugs[:, :2].mean(axis=0), axis=1).max())
    across = float(sizes[1]) if len(sizes) > 1 else 0.0
    if across > _IN_LINE * sizes[0] and across > 1e-3 * reach:
        return None
    line = None
    if sizes[0] > 1e-3 * reach:
        way = ways[0] if ways[0][first_peak(np.abs(ways[0]))] > 0 else -ways[0]
        line = (float(way[0]) + 0.0, float(way[1]) + 0.0)
    liquid = series.load_weight(recording, load)[sample] > load.weight
    return LooseTilt(load.name, tuple(middles), line, float(lugs[:, 2].mean()), has_liquid=bool(liquid))
