"""Lugs: load over capacity, and slings out of the plane of the main plate."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.checks.forces import Raised, factor, force_together, over, sling_forces
from gantline.checks.measure import Finding, Missing, carrying, extreme
from gantline.results import series
from gantline.results.gear import Sling
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.variable import BoolArray

_CONSEQUENCE = "lug_consequence_factor"
#: Share of a load's weight from which a rope bears it; less holds its heading.
BEARS = 0.05


def out_of_plane_angle(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle between a carrying sling and the main plate of its lug."""
    for sling in recording.rig.slings:
        angles = series.out_of_plane_angles(recording, sling)
        for _, of, lug in sling.at_lugs():
            element = f"{of}.{lug}"
            if (of, lug) not in angles:
                yield Missing(element, "main plate not known")
            else:
                inside = carrying(recording, sling.rope, during)
                yield from extreme(recording, angles[of, lug], inside, element)


def ropes_that_bear(recording: Recording, load: Load, lack: str) -> Iterator[Missing]:
    """Ropes of `mechanics` that carry a load, with what they lack for a check."""
    for rope in load.other_ropes:
        if series.rope_peak(recording, rope)[0] > BEARS * load.weight:
            yield Missing(rope, f"carries {load.name} as a rope of 'mechanics', which {lack}")


def load_of_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Load of a lug of load or spreader over its capacity; forces of several slings at one lug add up."""
    forces = sling_forces(recording, during)
    slings: dict[tuple[str, str], list[Sling]] = {}
    for sling in recording.rig.slings:
        for _, of, lug_name in sling.at_lugs():
            slings.setdefault((of, lug_name), []).append(sling)
    consequence = factor(recording, _CONSEQUENCE)
    raised = (
        Raised() if consequence is None else Raised(consequence, f" x {consequence:.4g}", (_CONSEQUENCE,))
    )
    for (of, lug_name), own in slings.items():
        force = forces[own[0].name] if len(own) == 1 else force_together(recording, own, during)
        holder = recording.rig.with_lugs(of)
        lug = holder.lugs.get(lug_name) if holder is not None else None
        if lug is None or not lug.capacity:
            yield Missing(f"{of}.{lug_name}", "lug capacity not known")
        else:
            yield from over(force, lug.capacity, f"{of}.{lug_name}", raised)
    for one in recording.rig.loads:
        yield from ropes_that_bear(recording, one, "has no lug")
        for line in recording.rig.tag_lines:
            if series.rope_peak(recording, line.rope)[0] > BEARS * one.weight:
                yield Missing(line.rope, f"carries {one.name} as a tag line, which has no lug")
