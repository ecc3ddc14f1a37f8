"""What parted, was taken off or put on and which stops were met, from the events of a recording."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.results.afloat.moorings import MooringLine
from gantline.results.loads.pulls import upright_pull
from gantline.results.recording import Recording
from gantline.results.ropes.tag_lines import TagLine
from gantline.results.variable import BoolArray

#: Kind of the event from which on a sling is off.
DETACHED = "detached"
#: Kinds of events after which a rope carries nothing any more.
PARTING = ("cut", "broken", DETACHED)
#: Kind of parting of what stands for mud or suction below a load that is hoisted off it.
CAME_FREE = "came free"
#: Kinds of partings that are as planned: slings taken off, lines and lashings that a step lets go of.
PLANNED = (DETACHED, "let go", CAME_FREE)
#: Kind of the event from which on a sling may carry.
ATTACHED = "attached"
#: A sample at the time of an event shows the rope before it parted; rounding of that time [s].
_AT_ONCE = 1e-9
#: Share of a load that its hooks bear at least while it is hoisted [1]: what holds it down may come free
#: before all of it has come off a bed that gives way.
_HOISTED = 0.01


@dataclass(frozen=True)
class Parting:
    """A rope that parted or was taken off.

    Attributes:
        rope: Its name.
        kind: `cut`, `broken`, or as planned `detached`, `let go` of a mooring or tag line, or of a lashing,
            `came free` of what stands for mud.
        time: When [s].
        tension: What it carried: of a broken rope the tension at which it broke, of another that of
            the last sample before [N].
    """

    rope: str
    kind: str
    time: float
    tension: float


@dataclass(frozen=True)
class Met:
    """A joint that met its stops.

    Attributes:
        joint: Its name.
        time: When for the first time [s].
        times: How often.
    """

    joint: str
    time: float
    times: int

    @property
    def again(self) -> str:
        """What is added where it came several times."""
        return f", {self.times} times in all" if self.times > 1 else ""


def partings(recording: Recording) -> list[Parting]:
    """Ropes that parted or were taken off, in order of time; one that is put on again may go again.

    None of an equilibrium: it knows what is gone, and not when nor what that carried.
    """
    if recording.is_equilibrium:
        return []
    found: list[Parting] = []
    gone: set[str] = set()
    breaks_at = {rope.name: rope.breaks_at for rope in recording.rig.ropes}
    begins = {name: time for time, _, name in recording.events("step_begin")}
    rig = recording.rig
    lines: list[MooringLine | TagLine] = [*rig.mooring_lines, *rig.tag_lines]
    let_go = {line.rope: [begins.get(step) for step in line.let_go_in] for line in lines}
    lashed = {rope: load for load in rig.loads for rope in load.let_go_in}
    let_go |= {rope: [begins.get(step) for step in load.let_go_in[rope]] for rope, load in lashed.items()}
    always = {line.rope for line in rig.tag_lines if line.is_let_go}
    for time, kind, rope in recording.events():
        if kind == ATTACHED:
            gone.discard(rope)
        if kind not in PARTING or rope in gone:
            continue
        gone.add(rope)
        before = max(int(np.searchsorted(recording.time, time + _AT_ONCE, side="right")) - 1, 0)
        tension = float(recording.column("rope_tension", rope)[before])
        # What bears a load is no lashing.
        bears = rope in lashed and upright_pull(recording, lashed[rope], rope)[before] > 0.0
        if kind == "broken":
            tension = breaks_at.get(rope) or tension
            kind = CAME_FREE if _stands_for_mud(recording, rope, before) else kind
        elif not bears and (rope in always or time in let_go.get(rope, ())):
            # One that was lost before its step lets go of it is lost.
            kind = "let go"
        found.append(Parting(rope, kind, time, tension))
    return found


def _stands_for_mud(recording: Recording, rope: str, before: int) -> bool:
    """Whether a rope that stands for mud or suction held down, at a sample, a load that is hoisted.

    The lift file alone tells it from a lashing that nobody let go of, which is lost.
    """
    rig = recording.rig
    if not any(one.name == rope and one.comes_free for one in rig.ropes):
        return False
    for load in rig.loads:
        if rope in load.tied_to and load.name in recording.coordinates.get("load", ()):
            hoisted = recording.column("load_transferred", load.name)[before] >= _HOISTED
            return bool(hoisted and upright_pull(recording, load, rope)[before] <= 0.0)
    return False


def while_there(recording: Recording, ropes: Sequence[str], gone_by: Sequence[str] = PARTING) -> BoolArray:
    """Where ropes are on, shape (ropes, time).

    At the moment at which one goes it is, and at that at which one comes it is not yet: a sample there is the
    last of the step before. An equilibrium has no moments.

    Args:
        recording: The recording.
        ropes: Their names.
        gone_by: Kinds of events after which one is not there any more.
    """
    later = np.greater_equal if recording.is_equilibrium else np.greater
    there = np.ones((len(ropes), len(recording.time)), dtype=np.bool_)
    starts_off = recording.rig.starts_off
    for place, rope in enumerate(ropes):
        there[place] = rope not in starts_off
    for time, kind, rope in recording.events():
        if rope in ropes and kind == ATTACHED:
            there[ropes.index(rope), later(recording.time, time)] = True
        elif rope in ropes and kind in gone_by:
            there[ropes.index(rope), recording.time > time] = False
    return there


def stops_met(events: Iterable[tuple[float, str, str]]) -> list[Met]:
    """Joints that met their stops, in order of time; `events` are time [s], kind and name of each."""
    times: dict[str, list[float]] = {}
    for time, kind, joint in events:
        if kind == "stop_hit":
            times.setdefault(joint, []).append(time)
    return [Met(joint, hits[0], len(hits)) for joint, hits in times.items()]
