"""What gauges of winches and strand jacks of `mechanics` read."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gantline.checks.drums import lifts_loads, upright_share
from gantline.results.gear import Drum
from gantline.results.recording import Recording
from gantline.results.ropes.upper_end import at_drum
from gantline.results.variable import FloatArray

__all__ = ["Gauge", "lifting_beside_cranes", "winch_gauges"]

#: Share of its way that goes up or down, from which on a rope lifts and does not pull aside [1]: 45 deg.
_STEEP = 0.7


@dataclass(frozen=True)
class Gauge:
    """What is read of a rope on a drum.

    Attributes:
        name: Of the drum, with that of the rope where several lie on it: `shaft/left`.
        drum: The drum; of one on several diameters that on which the rope lies first.
        rope: Name of the rope.
        reads: Pull of the part that comes to the drum, shape (time,) [N].
    """

    name: str
    drum: Drum
    rope: str
    reads: FloatArray


def winch_gauges(recording: Recording) -> list[Gauge]:
    """Gauges of winches and jacks, in the order of the lift file.

    Of a lift that hangs in hooks those with a rated capacity or that lift beside them, of any other all; none
    of plain mechanics. A rope with both ends on one drum is read once, at the end that
    pulls more.
    """
    rig = recording.rig
    if not rig.is_lift or not rig.drums or not len(recording.time):
        return []
    wound: dict[tuple[str, str], tuple[Drum, list[str]]] = {}
    for drum in rig.drums:
        for rope, end in zip(drum.ropes, drum.ends, strict=True):
            if drum.rated_capacity or lifts_loads(recording, rope):
                wound.setdefault((drum.joint, rope), (drum, []))[1].append(end)
    drums = [joint for joint, _ in wound]
    return [
        Gauge(
            joint if drums.count(joint) == 1 else f"{joint}/{rope}",
            drum,
            rope,
            np.max([at_drum(recording, rope, end) for end in ends], axis=0),
        )
        for (joint, rope), (drum, ends) in wound.items()
    ]


def lifting_beside_cranes(recording: Recording) -> list[str]:
    """Names of winches and jacks that bear a part of the load, and are no crane's.

    A tugger that pulls aside bears nothing of it, however hard it pulls.
    None where ropes or bodies of `mechanics` lead to a crane: then a drum may be one of its own.
    """
    rig = recording.rig
    if rig.lifting_by_mechanics or any(hook.bears_mechanics for hook in rig.hooks):
        return []
    return [
        one.name
        for one in winch_gauges(recording)
        if lifts_loads(recording, one.rope) and upright_share(recording, one.rope) > _STEEP
    ]
