"""How long equalizers take to equalise.

An equalizer *begins* to equalise when the last of its slings has gone taut for good, or when the last of its
locking pins is pulled, whichever is later; 0 where all slings are taut from the start. It *has equalised*
from when its tension spread stays below a bound, `Rig.equalised_below`, to the end of the recording.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.gear import Equalizer
from gantline.results.recording import Recording
from gantline.results.ropes.parting import PARTING


@dataclass(frozen=True)
class Equalising:
    """When an equalizer equalised.

    Attributes:
        begin: When its slings were all taut and its pins out [s].
        end: From when its tension spread stays below the bound, not before `begin` [s]; between samples the
            spread runs straight.
    """

    begin: float
    end: float

    @property
    def time(self) -> float:
        """Time to equalise [s]."""
        return self.end - self.begin


def equalising(recording: Recording, equalizer: Equalizer) -> Equalising | None:
    """When an equalizer equalised.

    Args:
        recording: Any recording.
        equalizer: One of its equalizers.

    Returns:
        Its begin and end; None if it does not end equalised: a sling is slack or has parted, a pin is in, the
        spread is not below the bound, or no sling hangs from it. None of a lift at rest, which took no time.
    """
    if recording.is_equilibrium:
        return None
    begins = [_taut_from(recording, rope) for rope in equalizer.slings]
    begins += [_out_from(recording, sheave) for sheave in equalizer.moving_sheaves]
    if not equalizer.slings or not len(recording.time) or None in begins:
        return None
    begin = max(moment for moment in begins if moment is not None)
    time, bound = recording.time, recording.rig.equalised_below
    spread = series.tension_spread(recording, equalizer)
    over = np.flatnonzero(spread > bound)
    if not over.size:
        return Equalising(begin, begin) if begin <= time[-1] else None
    # The last may be a sample before the begin: what comes below the bound until the next one does so later.
    last = int(over[-1])
    if last + 1 == len(time):
        return None
    share = (spread[last] - bound) / (spread[last] - spread[last + 1])
    below = float(time[last] + share * (time[last + 1] - time[last]))
    return Equalising(begin, max(begin, below))


def _taut_from(recording: Recording, rope: str) -> float | None:
    """From when a rope is taut to the end [s]; None if it is slack there, or parted."""
    changes = [
        (time, kind)
        for time, kind, name in recording.events()
        if name == rope and kind in ("taut", "slack", *PARTING)
    ]
    if changes:
        time, kind = changes[-1]
        return time if kind == "taut" else None
    return 0.0 if recording.column("rope_tension", rope)[-1] > 0.0 else None


def _out_from(recording: Recording, sheave: str) -> float | None:
    """From when the pin of a sheave is out to the end [s], 0 if it has none; None if it is in there."""
    if sheave not in recording.coordinates.get("pin", ()):
        return 0.0
    moved = [
        (time, kind)
        for time, kind, name in recording.events()
        if name == sheave and kind in ("pin_pulled", "pin_put_in")
    ]
    if moved:
        time, kind = moved[-1]
        return time if kind == "pin_pulled" else None
    # One that is in holds at least the weight of its sheave.
    return None if recording.column("pin_force", sheave).any() else 0.0
