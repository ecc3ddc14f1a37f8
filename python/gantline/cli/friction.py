"""Tables of `gantline statics --held`: what contacts hold by friction, and where else they would."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from gantline.cli.table import ABSENT, show, table

if TYPE_CHECKING:
    from gantline.statics import Equilibrium, Statics
    from gantline.study.state import State


#: A load at rest this far from where the lift file has it has slid [m]; a vessel that leans takes its
#: load aside by less.
_SLID = 0.25


def slid_loads(question: Statics, rest: Equilibrium) -> list[str]:
    """Loads that stand at the start, and have slid there without friction: how far, and what holds them.

    Later in the plan a load may stand elsewhere as it was put there.
    """
    from gantline.assembly.afloat.vessels import slid
    from gantline.results import series

    recording = rest.recording
    if rest.losses == "held" or rest.time > 0.0:
        return []
    places = dict(zip(recording.coordinates["body"], recording["body_position"].values[-1], strict=True))
    ways = {
        load.name: slid(question.assembly.document, load.body, list(load.meets.values()), places)
        for load in recording.rig.loads
        if not series.load_is_clear(recording, load)[-1]
    }
    return [
        f"  so {name} slides {way:.2f} m from where the lift file has it; --held has friction hold it"
        for name, way in ways.items()
        if way > _SLID
    ]


def stands_loosely(rests: Sequence[Equilibrium]) -> list[str]:
    """Loads that stand in an unstable equilibrium without friction, which may be all that is amiss.

    A load on a deck that leans slides down it until its slings hold it, and may turn round there.
    """
    from gantline.results import series

    names: dict[str, None] = {}
    for rest in rests:
        if rest.is_stable or rest.losses == "held":
            continue
        for load in rest.recording.rig.loads:
            if not series.load_is_clear(rest.recording, load)[-1]:
                names[load.name] = None
    said = "stands where it is unstable, free to slide; --held has friction hold what it can"
    return [f"  {name} {said}" for name in names]


def fails_as_it_slides(states: Iterable[State], held: str = "--held") -> list[str]:
    """Loads that stand, and fail a check there, on contacts whose friction is left out.

    Args:
        states: Equilibria with their checks.
        held: What has friction hold a load, in the words of the program.
    """
    names = dict.fromkeys(name for state in states for name in state.fails_as_it_slides)
    said = f"stands where a check fails, free to slide; {held} has friction hold what it can"
    return [f"  {name} {said}" for name in names]


def contact_forces(rest: Equilibrium) -> list[str]:
    """Support and friction of every contact that carries."""
    rows = [
        (
            one.contact,
            show(one.support, "kN", 1),
            show(float(np.linalg.norm(one.friction)), "kN", 1),
            show(one.used, "%", 1),
        )
        for one in rest.contacts
    ]
    head = ("Contact", "support force", "friction", "of what it can hold")
    return table(head, rows, "lrrr") if rows else []


def stick_ranges(question: Statics, rest: Equilibrium) -> list[str]:
    """How far the loads could stand from where they do, along x and y, and friction would still hold them."""
    from gantline.statics import NoEquilibriumError

    loads = rest.recording.rig.loads
    rows, causes = [], []
    for axis, way in enumerate("xy"):
        ends = []
        for sign in (1.0, -1.0):
            try:
                slid = question.slid([sign * (axis == other) for other in range(3)], rest.time)
                ends.append([_shift(rest, slid, load.body, axis) for load in loads])
            except NoEquilibriumError as problem:
                ends.append([ABSENT] * len(loads))
                causes.append(f"  {ABSENT} along {way}: {problem.cause} ({problem.element})")
        rows += [(f"{load.name} along {way}", *cells) for load, *cells in zip(loads, *ends, strict=True)]
    lines = table(("Friction holds", "from", "to"), rows, "lrr") if rows else []
    return [*lines, *dict.fromkeys(causes)]


def _shift(rest: Equilibrium, end: Equilibrium | None, body: str, axis: int) -> str:
    if end is None:
        return "open"
    places = [one.recording.column("body_position", body)[-1][axis] for one in (rest, end)]
    return show(float(places[1] - places[0]), "m", 3)
