"""Lugs: load over capacity, and slings out of the plane of the main plate."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.checks.forces import Force, Raised, factor, force_together, over, sling_forces
from gantline.checks.measure import Caution, Finding, Missing, carrying, extreme, named
from gantline.results import series
from gantline.results.gear import Sling
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.rotation import axes
from gantline.results.variable import BoolArray
from gantline.units import format_quantity

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
    yield from _assumed(recording, during)


def _assumed(recording: Recording, during: BoolArray) -> Iterator[Caution]:
    """That plates of lugs are taken to stand along x where the lift file does not say it.

    It matters to shackles, and to a limit of the angle. However an upright plate stands, a sling that leans
    no farther than the first row of the chart of side loads takes nothing from its shackle.
    """
    most, lugs = recording.rig.shackle_side_load.rows[0][0], []
    worst = most
    is_asked = "lug_out_of_plane_angle" in recording.rig.limits
    for sling in (one for one in recording.rig.slings if is_asked or one.shackles):
        for end, of, name in sling.at_lugs():
            holder = recording.rig.with_lugs(of)
            lug = None if holder is None else holder.lugs.get(name)
            if holder is None or lug is None or not lug.plate_is_assumed:
                continue
            upright = axes(recording.column("body_orientation", holder.body))[:, :, 2]
            along = np.sum(upright * series.sling_direction(recording, sling, end), axis=1)
            leans = np.arccos(np.clip(np.abs(along), 0.0, 1.0))[carrying(recording, sling.rope, during)]
            if leans.max(initial=0.0) > most:
                lugs.append(f"{of}.{name}")
                worst = max(worst, float(leans.max()))
    if lugs:
        lean = format_quantity(worst, "deg", 1)
        yield Caution(
            f"'main_plate' not said, xz assumed: if it stands across, the {lean} by which slings lean there "
            f"pull lug and shackle aside: {named(lugs)}"
        )


def ropes_that_bear(recording: Recording, load: Load, lack: str) -> Iterator[Missing]:
    """Ropes of `mechanics` that carry a load, with what they lack for a check."""
    for rope in load.other_ropes:
        if series.rope_peak(recording, rope)[0] > BEARS * load.weight:
            yield Missing(rope, f"carries {load.name} as a rope of 'mechanics', which {lack}")


@dataclass(frozen=True)
class LugForce:
    """What slings do to one lug.

    Attributes:
        of: The load or spreader that has it.
        name: Its name there.
        ends: The slings made fast to it, each with the number of its lower end, 0 at its upper one.
        force: Their forces, added up as they are at one time.
    """

    of: str
    name: str
    ends: Sequence[tuple[Sling, int]]
    force: Force

    @property
    def element(self) -> str:
        """Its name among all lugs, `<load or spreader>.<lug>`."""
        return f"{self.of}.{self.name}"

    def is_above(self, sling: Sling) -> bool:
        """Whether the sling hangs down from it."""
        return (sling.from_body, sling.from_lug) == (self.of, self.name)


def lug_forces(recording: Recording, during: BoolArray) -> Iterator[LugForce]:
    """Forces of the lugs of loads and spreaders, by the order of the slings."""
    forces = sling_forces(recording, during)
    at: dict[tuple[str, str], list[tuple[Sling, int]]] = {}
    for sling in recording.rig.slings:
        for end, of, lug in sling.at_lugs():
            at.setdefault((of, lug), []).append((sling, end))
    for (of, lug), ends in at.items():
        own = [sling for sling, _ in ends]
        force = forces[own[0].name] if len(own) == 1 else force_together(recording, own, during)
        yield LugForce(of, lug, ends, force)


def consequence_of(recording: Recording) -> Raised:
    """The rule's consequence factor on forces of lugs, 1 if it has none."""
    found = factor(recording, _CONSEQUENCE)
    return Raised() if found is None else Raised(found, f" x {found:.4g}", (_CONSEQUENCE,))


def load_of_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Load of a lug of load or spreader over its capacity; forces of several slings at one lug add up."""
    raised = consequence_of(recording)
    for one in lug_forces(recording, during):
        holder = recording.rig.with_lugs(one.of)
        lug = holder.lugs.get(one.name) if holder is not None else None
        if lug is None or not lug.capacity:
            yield Missing(one.element, "lug capacity not known")
        else:
            yield from over(one.force, lug.capacity, one.element, raised)
    for load in recording.rig.loads:
        yield from ropes_that_bear(recording, load, "has no lug")
        for line in recording.rig.tag_lines:
            if series.rope_peak(recording, line.rope)[0] > BEARS * load.weight:
                yield Missing(line.rope, f"carries {load.name} as a tag line, which has no lug")
