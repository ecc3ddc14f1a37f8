"""Systems at rest, written as the core's documents."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from gantline import _core
from mechanics import Floats, G, Json, body, document, end, free, half_turn, rope, slider


@dataclass
class AtRest:
    """An equilibrium and how it was found."""

    core: Any
    found: dict[str, Any]

    @property
    def tensions(self) -> Floats:
        """Of all ropes [N]."""
        return np.asarray(self.core.columns()["rope_tension"][-1])

    def body(self, name: str, column: str = "body_position") -> Floats:
        """A column of a body."""
        return np.asarray(self.core.columns()[column][-1, self.core.names()["body"].index(name)])

    def joint(self, name: str) -> float:
        """Position of a joint [m or rad]."""
        return float(self.core.columns()["joint_position"][-1, self.core.names()["joint"].index(name)])

    @property
    def squares(self) -> Floats:
        """ω² of all modes [1/s²], ascending."""
        return np.asarray(self.core.modes()["square"])

    @property
    def periods(self) -> Floats:
        """Periods of all modes [s], slowest first."""
        return 2 * math.pi / np.sqrt(self.squares)


def at_rest(system: Json, time: float = 0.0, increment: Sequence[float] | None = None) -> AtRest:
    """The equilibrium of a document; raises RuntimeError(element, cause) where there is none."""
    core = _core.Statics(json.dumps(system))
    return AtRest(core, core.settle(time, None if increment is None else list(increment)))


CORNERS = ((1, 1), (-1, 1), (-1, -1), (1, -1))
TILTS_EASILY = (1e6, 1e6, 2e6)


def four_slings(
    axial_stiffness: float,
    short: float,
    *,
    mass: float = 300e3,
    length: float = 10.0,
    half: float = 2.5,
) -> Json:
    """A rigid load on four plumb slings from points over its lugs; the first is `short` of its length [m]."""
    slings = [
        rope(
            f"s{index}",
            length - (short if index == 0 else 0.0),
            [end(None, (x * half, y * half, length)), end("load", (x * half, y * half, 0))],
            axial_stiffness,
        )
        for index, (x, y) in enumerate(CORNERS)
    ]
    load = body("load", free((0, 0, 0)), mass, centre_of_gravity=(0, 0, -2.5), inertia=TILTS_EASILY)
    return document([load], ropes=slings)


def one_equalizer(
    lugs: Sequence[tuple[float, float]],
    *,
    lengths: Sequence[float],
    offset: Sequence[float] = (0.0, 0.0),
    below: float = 2.5,
    mass: float = 300e3,
    sheave_mass: float = 300.0,
    axial_stiffness: float = 2e8,
    plumb: bool = False,
) -> Json:
    """A load under one equalizer that does not turn: moving sheaves in a row along x, or plumb over the lugs.

    The load's centre of gravity is `offset` from the middle of its lugs' plane and `below` it [m].
    """
    drop, radius, height = 2.0, 0.4, 40.0
    places = lugs if plumb else [(1.6 * (i - (len(lugs) - 1) / 2), 0.0) for i in range(len(lugs))]
    bodies = [
        body(f"sheave{i}", slider((0, 0, -1)), sheave_mass, position=(x, y, height - drop))
        for i, (x, y) in enumerate(places)
    ]
    route = [end(None, (places[0][0] - radius, places[0][1], height))]
    for i, place in enumerate(places):
        route.append(half_turn(f"sheave{i}", (0, 0, 0), radius, over=False))
        if i + 1 < len(places):
            after = places[i + 1]
            enter, leave = [place[0] + radius, place[1], height], [after[0] - radius, after[1], height]
            route.append(
                {"type": "half_turn", "body": None, "enter": enter, "leave": leave, "bulge": [0, 0, 1]}
            )
    route.append(end(None, (places[-1][0] + radius, places[-1][1], height)))
    between = [math.dist(a, b) - 2 * radius for a, b in pairwise(places)]
    wraps = math.pi * radius * len(places) + sum(0.5 * math.pi * gap for gap in between)
    equalizing = rope("equalizing", 2 * drop * len(places) + wraps, route, 1e8)
    slings = [
        rope(f"s{i}", length, [end(f"sheave{i}"), end("load", (*lug, below))], axial_stiffness)
        for i, (lug, length) in enumerate(zip(lugs, lengths, strict=True))
    ]
    start = height - drop - max(lengths) - below
    inertia = (mass / 12 * 125, mass / 12 * 125, mass / 12 * 200)
    load = body("load", free((0, 0, start)), mass, centre_of_gravity=(*offset, 0), inertia=inertia)
    return document([*bodies, load], ropes=[equalizing, *slings])


__all__ = ["CORNERS", "AtRest", "G", "at_rest", "four_slings", "one_equalizer"]
