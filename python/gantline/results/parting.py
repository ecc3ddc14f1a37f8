"""What parted or was taken off and which stops were met, from the events of a recording."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from gantline.results.recording import Recording

#: Kinds of events after which a rope carries nothing any more.
PARTING = ("cut", "broken", "detached")
#: A sample at the time of an event shows the rope before it parted; rounding of that time [s].
_AT_ONCE = 1e-9


@dataclass(frozen=True)
class Parting:
    """A rope that parted or was taken off.

    Attributes:
        rope: Its name.
        kind: `cut`, `broken`, or `detached`, as planned.
        time: When [s].
        tension: What it carried: of a broken rope the tension at which it broke, of another that of
            the last sample before [N].
    """

    rope: str
    kind: str
    time: float
    tension: float


@dataclass(frozen=True)
class Met:
    """A joint that met its stops.

    Attributes:
        joint: Its name.
        time: When for the first time [s].
        times: How often.
    """

    joint: str
    time: float
    times: int


def partings(recording: Recording) -> list[Parting]:
    """Ropes that parted or were taken off, in order of time."""
    found: dict[str, Parting] = {}
    breaks_at = {rope.name: rope.breaks_at for rope in recording.rig.ropes}
    for time, kind, rope in recording.events():
        if kind not in PARTING or rope in found:
            continue
        before = int(np.searchsorted(recording.time, time + _AT_ONCE, side="right")) - 1
        tension = float(recording.column("rope_tension", rope)[max(before, 0)])
        if kind == "broken":
            tension = breaks_at.get(rope) or tension
        found[rope] = Parting(rope, kind, time, tension)
    return list(found.values())


def stops_met(events: Iterable[tuple[float, str, str]]) -> list[Met]:
    """Joints that met their stops, in order of time; `events` are time [s], kind and name of each."""
    times: dict[str, list[float]] = {}
    for time, kind, joint in events:
        if kind == "stop_hit":
            times.setdefault(joint, []).append(time)
    return [Met(joint, hits[0], len(hits)) for joint, hits in times.items()]
