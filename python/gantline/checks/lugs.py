"""Lugs: load over capacity, and slings out of the plane of the main plate."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.checks.force import Force, Raised, over
from gantline.checks.forces import (
    factor,
    force_together,
    rope_force,
    sling_forces,
    with_upper_ends,
)
from gantline.checks.measure import Caution, Finding, Missing, carrying, extreme, named
from gantline.results import series
from gantline.results.gear import Sling
from gantline.results.loads.pulls import pull_at_end, upright_pull
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.rotation import axes
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity

_CONSEQUENCE = "lug_consequence_factor"
#: Share of a load's weight from which a rope bears it; less holds its heading.
BEARS = 0.05


def out_of_plane_angle(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle between a sling or rope that carries and the main plate of its lug."""
    for sling in recording.rig.slings:
        angles = series.out_of_plane_angles(recording, sling)
        for _, of, lug in sling.at_lugs():
            element = f"{of}.{lug}"
            if (of, lug) not in angles:
                yield Missing(element, "main plate not known")
            else:
                inside = carrying(recording, sling.rope, during)
                yield from extreme(recording, angles[of, lug], inside, element)
    for load, lug, ropes in _with_ropes(recording):
        for rope, end in ropes:
            angle = series.to_main_plate(recording, load.name, lug, _direction(recording, rope, end))
            if angle is None:
                yield Missing(f"{load.name}.{lug}", "main plate not known")
            else:
                inside = carrying(recording, rope, during)
                yield from extreme(recording, angle, inside, f"{load.name}.{lug}")
    yield from _assumed(recording, during)


def _direction(recording: Recording, rope: str, end: str) -> FloatArray:
    """Unit vectors along which a rope pulls at an end, shape (time, 3); zero where it does not."""
    pull = pull_at_end(recording, rope, end)
    size = np.linalg.norm(pull, axis=1, keepdims=True)
    unit: FloatArray = np.divide(pull, size, out=np.zeros_like(pull), where=size > 0.0)
    return unit


def _with_ropes(recording: Recording) -> Iterator[tuple[Load, str, Sequence[Sequence[str]]]]:
    """Lugs at which ropes of `mechanics` are made fast: the load, the lug, and ends of ropes."""
    for load in recording.rig.loads:
        for lug, ropes in load.ropes_at_lugs.items():
            yield load, lug, ropes


def _leads(recording: Recording, *, of_all: bool) -> Iterator[tuple[str, str, str, FloatArray]]:
    """Ropes at lugs with the lug's load or spreader, its name, and their direction, of slings along these.

    Args:
        recording: The recording.
        of_all: Those without shackles too.
    """
    for sling in (one for one in recording.rig.slings if of_all or one.shackles):
        for end, of, name in sling.at_lugs():
            yield sling.rope, of, name, series.sling_direction(recording, sling, end)
    for load, lug, ropes in _with_ropes(recording) if of_all else ():
        for rope, which in ropes:
            yield rope, load.name, lug, _direction(recording, rope, which)


def _assumed(recording: Recording, during: BoolArray) -> Iterator[Caution]:
    """That plates of lugs are taken to stand along x where the lift file does not say it.

    It matters to shackles, and to a limit of the angle. However an upright plate stands, a sling that leans
    no farther than the first row of the chart of side loads takes nothing from its shackle.
    """
    most, lugs = recording.rig.shackle_side_load.rows[0][0], []
    worst = most
    is_asked = "lug_out_of_plane_angle" in recording.rig.limits
    for rope, of, name, direction in _leads(recording, of_all=is_asked):
        holder = recording.rig.with_lugs(of)
        lug = None if holder is None else holder.lugs.get(name)
        if holder is None or lug is None or not lug.plate_is_assumed:
            continue
        upright = axes(recording.column("body_orientation", holder.body))[:, :, 2]
        along = np.sum(upright * direction, axis=1)
        leans = np.arccos(np.clip(np.abs(along), 0.0, 1.0))[carrying(recording, rope, during)]
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
    """Ropes of `mechanics` that carry a load, or hang from it, with what they lack for a check.

    What stands for mud or suction is made fast to nothing.
    """
    mud = {rope.name for rope in recording.rig.ropes if rope.comes_free}
    for rope in (one for one in load.other_ropes if one not in mud):
        peak, time = series.rope_peak(recording, rope)
        if peak > BEARS * load.weight:
            upright = np.interp(time, recording.time, upright_pull(recording, load, rope))
            does = f"pulls {load.name} down" if upright < 0.0 else f"carries {load.name}"
            yield Missing(rope, f"{does} as a rope of 'mechanics', which {lack}")


@dataclass(frozen=True)
class LugForce:
    """What slings, and ropes of `mechanics`, do to one lug.

    Attributes:
        of: The load or spreader that has it.
        name: Its name there.
        ends: The slings made fast to it, each with the number of its lower end, 0 at its upper one.
        ropes: Ends of ropes of `mechanics` made fast to it: the rope, and which end, `first` or `last`.
        force: Their forces together: as vectors on each side of the lug, as sizes above and below it; with
            what upper ends of slings below it weigh.
    """

    of: str
    name: str
    ends: Sequence[tuple[Sling, int]]
    force: Force
    ropes: Sequence[Sequence[str]] = ()

    @property
    def element(self) -> str:
        """Its name among all lugs, `<load or spreader>.<lug>`."""
        return f"{self.of}.{self.name}"


def lug_forces(recording: Recording, during: BoolArray) -> Iterator[LugForce]:
    """Forces of the lugs of loads and spreaders, by the order of the slings, then of the ropes."""
    forces = sling_forces(recording, during)
    at: dict[tuple[str, str], list[tuple[Sling, int]]] = {}
    for sling in recording.rig.slings:
        for end, of, lug in sling.at_lugs():
            at.setdefault((of, lug), []).append((sling, end))
    with_ropes = {(load.name, lug): ropes for load, lug, ropes in _with_ropes(recording)}
    for (of, lug), ends in at.items():
        if (of, lug) in with_ropes:
            continue
        own = [sling for sling, _ in ends]
        force = forces[own[0].name]
        if len(own) > 1:
            force = force_together(recording, own, _together(recording, (of, lug), ends), during)
        force = with_upper_ends(recording, [one for one in own if _is_above((of, lug), one)], force)
        yield LugForce(of, lug, ends, force)
    for (of, lug), ropes in with_ropes.items():
        ends = at.get((of, lug), [])
        yield LugForce(of, lug, ends, _force_of_ropes(recording, (of, lug), ends, ropes, during), ropes)


def _force_of_ropes(
    recording: Recording,
    at: tuple[str, str],
    ends: Sequence[tuple[Sling, int]],
    ropes: Sequence[Sequence[str]],
    during: BoolArray,
) -> Force:
    """What ropes of `mechanics` pull at a lug.

    Several, and slings, count as vectors of one time, those that pull up and those that pull down for
    themselves, and no less than one of them alone. A rule's factor for skew is one of slings: nothing tells
    how lengths of such ropes would be off.
    """
    names = [rope for rope, _ in ropes]
    if len(names) == 1 and not ends:
        return rope_force(recording, names[0], during)
    of_slings = [pull_at_lug(recording, sling, end, at) for sling, end in ends]
    pulls = np.array([*of_slings, *(pull_at_end(recording, rope, end) for rope, end in ropes)])
    is_up = pulls[:, :, 2:] >= 0.0
    sides = [np.sum(pulls, axis=0, where=is_side) for is_side in (is_up, ~is_up)]
    together = np.linalg.norm(sides, axis=2).sum(axis=0)
    return force_together(recording, [sling for sling, _ in ends], together, during, names)


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
    """Load of a lug of load or spreader over its capacity; what is made fast to one lug pulls together."""
    raised = consequence_of(recording)
    for one in lug_forces(recording, during):
        holder = recording.rig.with_lugs(one.of)
        lug = holder.lugs.get(one.name) if holder is not None else None
        if lug is None or not lug.capacity:
            yield Missing(one.element, "lug capacity not known", is_strength=True)
        else:
            yield from over(one.force, lug.capacity, one.element, raised)
    for load in recording.rig.loads:
        at_lugs = {rope for ropes in load.ropes_at_lugs.values() for rope, _ in ropes}
        lacking = ropes_that_bear(recording, load, "has no lug")
        yield from (one for one in lacking if one.element not in at_lugs)
        for line in recording.rig.tag_lines:
            if series.rope_peak(recording, line.rope)[0] > BEARS * load.weight:
                yield Missing(line.rope, f"carries {load.name} as a tag line, which has no lug")
