"""Lugs: load over capacity, and slings out of the plane of the main plate."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.checks.force import Force, Raised, over
from gantline.checks.forces import factor, force_together, sling_forces, with_upper_ends
from gantline.checks.measure import Caution, Finding, Missing, carrying, extreme, named
from gantline.results import series
from gantline.results.gear import Sling
from gantline.results.loads.pulls import upright_pull
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.rotation import axes
from gantline.results.variable import BoolArray, FloatArray
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
    """Ropes of `mechanics` that carry a load, or hang from it, with what they lack for a check."""
    for rope in load.other_ropes:
        peak, time = series.rope_peak(recording, rope)
        if peak > BEARS * load.weight:
            upright = np.interp(time, recording.time, upright_pull(recording, load, rope))
            does = f"pulls {load.name} down" if upright < 0.0 else f"carries {load.name}"
            yield Missing(rope, f"{does} as a rope of 'mechanics', which {lack}")


@dataclass(frozen=True)
class LugForce:
    """What slings do to one lug.

    Attributes:
        of: The load or spreader that has it.
        name: Its name there.
        ends: The slings made fast to it, each with the number of its lower end, 0 at its upper one.
        force: Their forces together: as vectors on each side of the lug, as sizes above and below it; with
            what upper ends of slings below it weigh.
    """

    of: str
    name: str
    ends: Sequence[tuple[Sling, int]]
    force: Force

    @property
    def element(self) -> str:
        """Its name among all lugs, `<load or spreader>.<lug>`."""
        return f"{self.of}.{self.name}"


def lug_forces(recording: Recording, during: BoolArray) -> Iterator[LugForce]:
    """Forces of the lugs of loads and spreaders, by the order of the slings."""
    forces = sling_forces(recording, during)
    at: dict[tuple[str, str], list[tuple[Sling, int]]] = {}
    for sling in recording.rig.slings:
        for end, of, lug in sling.at_lugs():
            at.setdefault((of, lug), []).append((sling, end))
    for (of, lug), ends in at.items():
        own = [sling for sling, _ in ends]
        force = forces[own[0].name]
        if len(own) > 1:
            force = force_together(recording, own, _together(recording, (of, lug), ends), during)
        force = with_upper_ends(recording, [one for one in own if _is_above((of, lug), one)], force)
        yield LugForce(of, lug, ends, force)


def _together(recording: Recording, at: tuple[str, str], ends: Sequence[tuple[Sling, int]]) -> FloatArray:
    """What slings pull at a lug, shape (time,) [N].

    Those on one side of it pull as vectors. What pulls from above and what pulls from below is added up as
    sizes: the two are made fast in holes of their own, and do not relieve the lug of each other.
    """
    sides = [[one for one in ends if _is_above(at, one[0]) == above] for above in (True, False)]
    pulls = [[pull_at_lug(recording, sling, end, at) for sling, end in side] for side in sides if side]
    total: FloatArray = np.sum([np.linalg.norm(np.sum(side, axis=0), axis=1) for side in pulls], axis=0)
    return total


def _is_above(at: tuple[str, str], sling: Sling) -> bool:
    """Whether a sling hangs down from a lug."""
    return (sling.from_body, sling.from_lug) == at


def pull_at_lug(recording: Recording, sling: Sling, end: int, at: tuple[str, str]) -> FloatArray:
    """The pull of a sling at a lug, from the lug towards it, shape (time, 3) [N], world axes.

    Args:
        recording: The recording.
        sling: The sling.
        end: Number of its lower end, 0 at its upper one.
        at: Load or spreader, and the lug on it.
    """
    # It pulls up at the lug below it, and down at one of a spreader above.
    tension = series.sling_tension(recording, sling) * (-1.0 if _is_above(at, sling) else 1.0)
    pull: FloatArray = tension[:, None] * series.sling_direction(recording, sling, end)
    return pull


def consequence_of(recording: Recording) -> Raised:
    """The rule's consequence factor on forces of lugs, 1 if it has none."""
    found = factor(recording, _CONSEQUENCE)
    return Raised() if found is None else Raised(found, f" x {found:.4g}", (_CONSEQUENCE,))


def load_of_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Load of a lug of load or spreader over its capacity; several slings at one lug pull together."""
    raised = consequence_of(recording)
    for one in lug_forces(recording, during):
        holder = recording.rig.with_lugs(one.of)
        lug = holder.lugs.get(one.name) if holder is not None else None
        if lug is None or not lug.capacity:
            yield Missing(one.element, "lug capacity not known", is_strength=True)
        else:
            yield from over(one.force, lug.capacity, one.element, raised)
    for load in recording.rig.loads:
        yield from ropes_that_bear(recording, load, "has no lug")
        for line in recording.rig.tag_lines:
            if series.rope_peak(recording, line.rope)[0] > BEARS * load.weight:
                yield Missing(line.rope, f"carries {load.name} as a tag line, which has no lug")
