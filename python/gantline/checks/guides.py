"""Landing guides against their capacity."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.checks.design_weight import largest_ratios
from gantline.checks.forces import raised_of_capacity
from gantline.checks.measure import Finding, Missing
from gantline.results.loads.contact_peaks import guide_peak
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray


def of_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Force of a guide, raised to the design weight of what it guides, over its capacity."""
    for guide in recording.rig.guides:
        if guide.capacity is None:
            yield Missing(guide.name, "no capacity")
            continue
        ratios = largest_ratios(recording, [guide.load])
        force = recording.column("guide_force", guide.name)
        of_steps = guide_peak(recording, guide)
        yield from raised_of_capacity(recording, during, guide.name, force, ratios, guide.capacity, of_steps)
