"""Chain hoists of slings: what they carry of what they may carry."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.checks.force import over
from gantline.checks.forces import at_upper_end, sling_forces
from gantline.checks.measure import Finding, Missing
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray


def load_of_rated_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Force of a sling, static and dynamic, over the rated capacity of the chain hoist in it.

    The hoist is at the upper end of its sling: what the sling weighs hangs on it too.
    """
    if not recording.rig.chain_hoists:
        return
    forces = sling_forces(recording, during)
    ropes = {sling.name: sling.rope for sling in recording.rig.slings}
    for one in recording.rig.chain_hoists:
        if not one.rated_capacity:
            yield Missing(one.name, "rated capacity not known", is_strength=True)
        else:
            rope, force = ropes[one.name], forces[one.name]
            force = at_upper_end(recording, rope, force, during, of_chain_hoist=False)
            yield from over(force, one.rated_capacity, one.name)
