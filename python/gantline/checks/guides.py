"""Landing guides against their capacity, and loads that come down beside them."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.checks.check import Check, Verdict
from gantline.checks.design_weight import largest_ratios
from gantline.checks.forces import raised_of_capacity
from gantline.checks.measure import Finding, Missing
from gantline.results.loads.contact_peaks import guide_peak
from gantline.results.loads.guides import told_missed
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


def beside_guides(recording: Recording) -> Iterator[Check]:
    """A warning for each guide that a load misses as it comes down: it stands on its rim, or beside it."""
    warnings = map(str, recording.attributes.get("warnings") or ())
    for name, words in told_missed(recording.rig.guides, warnings).items():
        remark = f"{words}: see its place, and what brings the load there"
        meaning = "loads come down into the guides that are there for them"
        yield Check("comes_to_guides", Verdict.WARNING, meaning, element=name, remark=remark)
