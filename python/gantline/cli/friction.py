"""Tables of `gantline statics --held`: what contacts hold by friction, and where else they would."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from gantline.cli.summary import show
from gantline.cli.table import table

if TYPE_CHECKING:
    from gantline.statics import Equilibrium, Statics

_WAYS = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0)}


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
    found = {way: question.stick_range(direction, rest.time) for way, direction in _WAYS.items()}
    rows = [
        (f"{load.name} along {way}", *(_shift(rest, end, load.body, "xyz".index(way)) for end in ends))
        for load in rest.recording.rig.loads
        for way, ends in found.items()
    ]
    return table(("Friction holds", "from", "to"), rows, "lrr") if rows else []


def _shift(rest: Equilibrium, end: Equilibrium | None, body: str, axis: int) -> str:
    if end is None:
        return "open"
    places = [one.recording.column("body_position", body)[-1][axis] for one in (rest, end)]
    return show(float(places[1] - places[0]), "m", 3)
