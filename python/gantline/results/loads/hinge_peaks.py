"""Most of what hinges bear in a recording: over all steps, where samples may have missed it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gantline.results import series
from gantline.results.alike import earliest_peak
from gantline.results.loads.hinges import (
    HINGE_OPENED,
    Hinge,
    axial_force,
    hinge_force,
    hinge_moment,
    hinge_state,
    is_shut,
    pulled_up,
    radial_force,
)
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray, FloatArray, Variable
from gantline.units import format_quantity

__all__ = ["hinge_peak", "in_words"]

#: Share of the load's weight from which on it is told that a hinge holds the load down [1].
_HELD_DOWN = 0.01


def hinge_peak(
    recording: Recording,
    hinge: Hinge,
    of: Callable[[Recording, Hinge], FloatArray],
    during: BoolArray | None = None,
) -> tuple[float, float]:
    """The largest size of what a hinge bears over all steps, and when that was [s].

    Recordings from before that was kept, and equilibria, have that of their samples.

    Args:
        recording: The recording.
        hinge: The hinge.
        of: What of it, such as `hinge_force` or `radial_force`.
        during: Samples that count, shape (time,); where they are not all, they alone do.

    Returns:
        Its size and its time; nothing, at the start, where no sample counts.
    """
    of_samples = series.peak(recording, np.abs(of(recording, hinge)), during) or (0.0, 0.0)
    all_count = during is None or during.all()
    if recording.is_equilibrium or not all_count or "hinge_peak_time" not in recording:
        return of_samples
    then = {
        name: recording[name.replace("hinge", "hinge_peak")].values for name in ("hinge_push", "hinge_moment")
    }
    state, labels = hinge_state(then, {}, recording.rig)
    time = recording["hinge_peak_time"].values
    moments = Recording({"time": Variable(("time",), time, "s", ""), **state}, labels, {})
    sizes = np.abs(of(moments, hinge))
    return earliest_peak(of_samples, *zip(sizes.tolist(), time.tolist(), strict=True))


def in_words(recording: Recording, hinge: Hinge, used: float | None = None) -> list[tuple[str, str]]:
    """What a hinge bears at most, how far its load turns in it, and when it opens: titles and sentences.

    Args:
        recording: Of a run.
        hinge: A hinge of it.
        used: Share of its rated capacity, as the checks have it [1]; None if that is not known.
    """
    force, shut = hinge_force(recording, hinge), is_shut(recording, hinge)
    most, time = hinge_peak(recording, hinge, hinge_force)
    radial, axial, moment = (
        hinge_peak(recording, hinge, of)[0] for of in (radial_force, axial_force, hinge_moment)
    )
    turned = recording.column("joint_position", hinge.name)
    reach = float(np.abs(turned - turned[0])[shut].max(initial=0.0))
    rows = [
        ("force", f"{format_quantity(most, 'kN', 1)} at most, at {format_quantity(time, 's', 2)}"),
        ("radial", f"{format_quantity(radial, 'kN', 1)} at most"),
        ("axial", f"{format_quantity(axial, 'kN', 1)} at most"),
        ("moment askew", f"{format_quantity(moment, 'kN m', 1)} at most"),
        (f"{hinge.load} turned in it", f"by {format_quantity(reach, 'deg', 2)} at most"),
    ]
    if used is not None:
        rows.insert(1, ("of rated capacity", format_quantity(used, "%", 1)))
    pulled = pulled_up(recording, hinge)
    load = recording.rig.load(hinge.load)
    highest = int(np.argmax(pulled))
    if load is not None and pulled[highest] > _HELD_DOWN * load.weight:
        down = f"with {format_quantity(pulled[highest], 'kN', 1)} at most"
        when = f"at {format_quantity(recording.time[highest], 's', 2)}"
        rows.append((f"holds {hinge.load} down", f"{down}, {when}"))
    at = [time for time, _, name in recording.events(HINGE_OPENED) if name == hinge.name]
    if at and shut.any():
        bore = format_quantity(float(force[shut][-1]), "kN", 1)
        rows.append(("opened", f"at {format_quantity(at[0], 's', 2)}; it bore {bore}"))
    return rows
