"""Chain hoists of slings: what they carry of what they may carry."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.checks.force import over
from gantline.checks.forces import sling_forces
from gantline.checks.measure import Finding, Missing
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray


def load_of_rated_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Force of a sling, static and dynamic, over the rated capacity of the chain hoist in it."""
    if not recording.rig.chain_hoists:
        return
    forces = sling_forces(recording, during)
    for one in recording.rig.chain_hoists:
        if not one.rated_capacity:
            yield Missing(one.name, "rated capacity not known", is_strength=True)
        else:
            yield from over(forces[one.name], one.rated_capacity, one.name)
