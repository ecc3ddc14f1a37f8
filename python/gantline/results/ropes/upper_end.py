"""What the upper end of a rope carries: its tension, and of its own weight what hangs below.

The tension of a rope whose weight is lumped is that at the middle of each straight part; at the upper end
half the weight of that part comes to it (docs/concepts/rope_weight.md, equation RW4), and the weight of the
chain hoist of a sling. The tension of a mooring line that hangs by its weight is that at its fairlead; where
it is made fast higher up, all that hangs between the two heights comes to it. Ropes with nodes know the
forces of their ends themselves.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.alike import earliest_peak
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray, FloatArray

__all__ = ["UpperEnd", "at_drum", "own_weight", "peak_at_upper_end", "utilisation"]


@dataclass(frozen=True)
class UpperEnd:
    """The largest tension of a rope, at its upper end.

    Attributes:
        tension: With its own weight [N].
        own_weight: What of it is own weight over the tension that is recorded [N].
        time: When that is [s].
    """

    tension: float
    own_weight: float
    time: float


def own_weight(recording: Recording, rope: str, *, of_chain_hoist: bool = True) -> FloatArray:
    """What the upper end of a rope carries over its recorded tension [N], shape (time,).

    Half the weight of the part that goes farthest down, and that of a sling's chain hoist; of a mooring line
    that hangs by its weight, and is made fast above its fairlead, what it weighs in between. Of a rope in
    which a hook hangs these are its falls: what goes down to the drum pulls it there by less, not at the top
    by more.

    Args:
        recording: The recording.
        rope: Name of the rope.
        of_chain_hoist: Whether the hoist of a sling counts, which carries what hangs below it, and not
            itself.
    """
    more = recording.kept(("own_weight", rope), lambda: _found(recording, rope))
    if not of_chain_hoist:
        return more
    slings = {sling.rope: sling.name for sling in recording.rig.slings}
    hoists: float = sum(one.weight for one in recording.rig.chain_hoists if one.name == slings.get(rope))
    return more + hoists


def _found(recording: Recording, rope: str) -> FloatArray:
    return _of_rope(recording, rope) + _of_mooring(recording, rope)


def _of_mooring(recording: Recording, rope: str) -> FloatArray:
    """T2 - T1 = w (z2 - z1) of a catenary, from the fairlead to a higher end."""
    line = next((one for one in recording.rig.mooring_lines if one.rope == rope), None)
    drawn = recording.points_of_ropes.get(rope, ())
    if line is None or not line.hanging_weight or len(drawn) < 2:
        return np.zeros(recording.time.shape)
    first, last = series.rope_ends(recording, rope)
    more: FloatArray = line.hanging_weight * np.maximum(last[:, 2] - first[:, 2], 0.0)
    return more


def _of_rope(recording: Recording, rope: str) -> FloatArray:
    known = recording.rig.rope(rope)
    drawn = recording.points_of_ropes.get(rope, ())
    if known is None or known.weight != "lumped" or len(drawn) < 2:
        return np.zeros(recording.time.shape)
    falls = [fall for hook in recording.rig.hooks for fall in hook.falls if fall.rpartition("/")[0] == rope]
    if falls:
        down = np.max([recording.column("segment_length", fall) for fall in falls], axis=0)
    else:
        down = np.abs(np.diff(recording["rope_point"].values[:, drawn, 2], axis=1)).max(axis=1)
    weight: FloatArray = 0.5 * known.mass_per_length * recording.rig.gravity * down
    return weight


def peak_at_upper_end(
    recording: Recording, rope: str, during: BoolArray | None = None, *, of_chain_hoist: bool = True
) -> UpperEnd | None:
    """The largest tension at the upper end of a rope; over all steps, or over some samples.

    Args:
        recording: Any recording.
        rope: Name of the rope.
        during: Samples that count; None for all, and all steps between them.
        of_chain_hoist: As of `own_weight`.

    Returns:
        The peak; None if `during` holds no sample.
    """
    more = own_weight(recording, rope, of_chain_hoist=of_chain_hoist)

    def own(time: float) -> float:
        return float(np.interp(time, recording.time, more)) if len(more) else 0.0

    found = []
    if during is None or during.all():
        tension, time = series.rope_peak(recording, rope)
        found.append((tension + own(time), time))
    highest = series.peak(recording, series.tightest_tension(recording, rope) + more, during)
    found += [] if highest is None else [highest]
    if not found:
        return None
    tension, time = earliest_peak(*found)
    return UpperEnd(tension, own(time), time)


def at_drum(recording: Recording, rope: str, end: str) -> FloatArray:
    """What the gauge of a drum reads of a rope that is wound on it [N], shape (time,).

    The tension of the straight part that comes to it; of one whose weight is lumped with half the weight of
    that part, which is less where the drum stands below.

    Args:
        recording: The recording.
        rope: Name of the rope.
        end: Which end lies on the drum, `first` or `last`.
    """
    segments = [one for one in recording.coordinates["segment"] if one.rpartition("/")[0] == rope]
    tension = recording.column("segment_tension", segments[0 if end == "first" else -1])
    known, drawn = recording.rig.rope(rope), recording.points_of_ropes.get(rope, ())
    if known is None or known.weight != "lumped" or len(drawn) < 2:
        return tension
    heights = recording["rope_point"].values[:, drawn, 2]
    here, next_to_it = (0, 1) if end == "first" else (-1, -2)
    half = 0.5 * known.mass_per_length * recording.rig.gravity
    read: FloatArray = np.maximum(tension + half * (heights[:, here] - heights[:, next_to_it]), 0.0)
    return read


def utilisation(recording: Recording, rope: str) -> float | None:
    """Largest tension of a rope at its upper end, of its minimum breaking force [1]; None if not known."""
    strength = recording.rig.minimum_breaking_force(rope)
    peak = peak_at_upper_end(recording, rope) if strength else None
    return peak.tension / strength if strength and peak is not None else None
