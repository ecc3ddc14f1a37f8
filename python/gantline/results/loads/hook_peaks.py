"""Largest loads of hooks over all steps, where samples may have missed them."""

from __future__ import annotations

from gantline.results import series
from gantline.results.alike import earliest_peak
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray

__all__ = ["hook_peak"]


def hook_peak(
    recording: Recording, hook: str, variable: str, during: BoolArray | None = None
) -> tuple[float, float]:
    """Largest load of a hook over all steps: of its samples, or when its ropes pulled most.

    Recordings from before that was kept, and equilibria, have that of their samples.

    Args:
        recording: The recording.
        hook: Name of the hook.
        variable: `hook_load` or `hoist_load`.
        during: Samples that count, shape (time,); where they are not all, they alone do.

    Returns:
        Force [N] and its time [s]; nothing, at the start, where no sample counts.
    """
    of_samples = series.peak(recording, recording.column(variable, hook), during) or (0.0, 0.0)
    all_count = during is None or during.all()
    if recording.is_equilibrium or not all_count or "hook_peak_load" not in recording:
        return of_samples
    of_steps = [
        float(recording.column(variable.replace("_load", of), hook)) for of in ("_peak_load", "_peak_time")
    ]
    return earliest_peak(of_samples, (of_steps[0], of_steps[1]))
