"""What chain hoists of slings have done in a recording: how far they went, and what they carried."""

from __future__ import annotations

from dataclasses import dataclass

from gantline.results import series
from gantline.results.cranes.chain_hoists import ChainHoist
from gantline.results.recording import Recording

__all__ = ["ChainUse", "chain_uses"]


@dataclass(frozen=True)
class ChainUse:
    """What a chain hoist has done.

    Attributes:
        hoist: The chain hoist.
        last: What it has paid out at the last sample [m].
        least: Least of that at any [m].
        most: Most of that at any [m].
        force: Largest force of its sling [N], of a run over all steps.
        time: When that is [s].
    """

    hoist: ChainHoist
    last: float
    least: float
    most: float
    force: float
    time: float


def chain_uses(recording: Recording) -> list[ChainUse]:
    """What each chain hoist has done; nothing before there are samples."""
    slings = {sling.name: sling for sling in recording.rig.slings}
    found = []
    for one in recording.rig.chain_hoists if len(recording.time) else ():
        out = recording.column("chain_paid_out", one.name)
        force, time = series.rope_peak(recording, slings[one.name].rope)
        found.append(ChainUse(one, float(out[-1]), float(out.min()), float(out.max()), force, time))
    return found
