"""Largest forces of contacts and landing guides in a recording: over all steps, as far as these are known."""

from __future__ import annotations

from gantline.results import series
from gantline.results.alike import earliest_peak
from gantline.results.loads.guides import Guide
from gantline.results.recording import Recording

__all__ = ["contact_peak", "guide_peak"]


def contact_peak(recording: Recording, contact: str) -> tuple[float, float]:
    """Largest normal force of a contact over all steps, not only over the samples.

    Recordings from before it was kept, and equilibria, have that of their samples.

    Returns:
        Force [N] and its time [s].
    """
    force = recording.column("contact_force", contact)
    of_samples = series.peak(recording, force, series.everywhere(recording)) or (0.0, 0.0)
    if recording.is_equilibrium or "contact_peak_force" not in recording:
        return of_samples
    of_steps = (
        float(recording.column("contact_peak_force", contact)),
        float(recording.column("contact_peak_time", contact)),
    )
    return earliest_peak(of_steps, of_samples)


def guide_peak(recording: Recording, guide: Guide) -> tuple[float, float]:
    """Largest force of a landing guide, and when that was [s].

    It is that of several contacts together, by its samples. It is never less than the force of one of them,
    which is known of all steps.

    Returns:
        Force [N] and its time [s].
    """
    force = recording.column("guide_force", guide.name)
    together = series.peak(recording, force, series.everywhere(recording)) or (0.0, 0.0)
    return earliest_peak(together, *(contact_peak(recording, contact) for contact in guide.contacts))
