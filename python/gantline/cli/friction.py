"""Tables of `gantline statics --held`: what contacts hold by friction, and where else they would."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from gantline.cli.table import ABSENT, show, table

if TYPE_CHECKING:
    from gantline.statics import Equilibrium, Statics


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
