"""Where loads stand that have been set down, and how far they have turned on the way."""

from __future__ import annotations

import numpy as np

from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.units import format_quantity

__all__ = ["set_down_in_words"]


def set_down_in_words(recording: Recording, load: Load, digits: int) -> str | None:
    """When a load came down that stands at the end, where it stands then, and how far it has turned.

    That is what bearings, anchor bolts and holes of a deck are compared with: slings of one hook hold no
    heading, and a load that still swings comes down beside its place.

    Args:
        recording: Of any lift.
        load: A load with something below that it may touch.
        digits: Of the time.

    Returns:
        The words; None of a load that never hung clear or hangs at the end, and of a lift at rest.
    """
    clear = series.load_is_clear(recording, load)
    if recording.is_equilibrium or not load.contacts or not clear.any() or clear[-1]:
        return None
    names = {load.name, load.body, load.contact_group}
    last = float(recording.time[np.flatnonzero(clear)[-1]])
    # The event comes within the sample after which the load is no more clear.
    downs = [time for time, _, name in recording.events("set_down") if name in names and time >= last]
    down = min(downs, default=last)
    x, y, _ = (float(one) for one in recording.column("body_position", load.body)[-1])
    place = f"x {format_quantity(x, 'm', 2)}, y {format_quantity(y, 'm', 2)}"
    turned = series.load_yaw(recording, load)
    words = f"at {format_quantity(down, 's', digits)}, at the end with its centre of gravity at {place}"
    return words if turned is None else f"{words}, turned by {_turned(float(turned[-1]))}"


def _turned(yaw: float) -> str:
    """An angle about plumb, in words that need no convention of signs."""
    angle = format_quantity(abs(yaw), "deg", 1)
    none = angle == format_quantity(0.0, "deg", 1)
    return angle if none else f"{angle} {'counter-clockwise' if yaw > 0.0 else 'clockwise'}"
