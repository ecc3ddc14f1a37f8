"""When loads come clear of what they stand on."""

from __future__ import annotations

import numpy as np

from gantline.results import series
from gantline.results.loads.hinges import is_shut
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.units import format_quantity

__all__ = ["hangs_from_the_start", "lift_off_in_words", "lift_off_time"]

#: A load that is clear for good within this of when it first was has come off once [s].
_AT_ONCE = 1.0


def hangs_from_the_start(recording: Recording, load: Load) -> bool:
    """Whether a load hangs clear as the recording begins; one that is put down just there presses at once."""
    clear = series.load_is_clear(recording, load)[:2]
    return bool(clear.size and clear.all())


def lift_off_time(recording: Recording) -> float | None:
    """When the last load first came clear of its supports [s].

    None if one never did, or if none stood on any as the recording began: a load that hangs then leaves no
    support, though it may bounce where it is set down later.
    """
    times = []
    for load in recording.rig.loads:
        if not load.contacts or hangs_from_the_start(recording, load):
            continue
        names = {load.name, load.body, load.contact_group}
        events = [time for time, _, name in recording.events("lift_off") if name in names]
        supported = series.support_force(recording, load) > 0.0
        freed = np.flatnonzero(supported[:-1] & ~supported[1:])
        if events:
            times.append(events[0])
        elif freed.size:
            times.append(float(recording.time[freed[0] + 1]))
        else:
            return None
    return max(times, default=None)


def lift_off_in_words(recording: Recording, digits: int) -> str:
    """When the loads came clear, and when for good where they had come down again, as a barge in waves does.

    Args:
        recording: With a load.
        digits: Of the times.
    """
    loads = recording.rig.loads
    first = lift_off_time(recording)
    if first is None:
        hangs = all(hangs_from_the_start(recording, load) for load in loads)
        within = "".join(
            f", in hinge {one.name}" for one in recording.rig.hinges if is_shut(recording, one)[0]
        )
        return (
            f"clear{' of supports' if within else ''} from the start{within}"
            if hangs
            else "never clear of a support"
        )
    names = {name for load in loads for name in (load.name, load.body, load.contact_group)}
    last = max((time for time, _, name in recording.events("lift_off") if name in names), default=first)
    words = f"at {format_quantity(first, 's', digits)}"
    if last > first + _AT_ONCE and series.is_clear(recording)[-1]:
        words += f", for good at {format_quantity(last, 's', digits)}"
    return words
