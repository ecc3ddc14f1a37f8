"""Ropes that cross themselves where they come on a sheave and go off it: its axis points the other way."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from gantline.results.variable import Columns, Names

__all__ = ["crossed_ropes"]

#: Distance at which parts of a rope whose diameter is not known lie in one another [m].
_NO_DIAMETER = 1e-3


def crossed_ropes(
    ropes: Sequence[Mapping[str, Any]],
    diameters: Mapping[str, float | None],
    columns: Columns,
    names: Names,
) -> list[str]:
    """A sentence for each sheave before and after which the same rope is in one place at the start.

    Tangents at the ends of a wrap b > pi meet r |tan(b/2)| from where they touch. A rope that is straight as
    far as that on both sides crosses itself, unless fleet angles lead it past by its diameter.

    Args:
        ropes: As the core takes them, with their routes.
        diameters: Of the ropes by name [m]; None where that is not known.
        columns: What the core recorded.
        names: Names along its dimensions.
    """
    found: list[str] = []
    if not len(columns["time"]) or "wrap_angle" not in columns:
        return found
    sheaves, segments = list(names["wrapped_sheave"]), list(names["segment"])
    for rope in ropes:
        for place, guide in enumerate(rope["route"]):
            name = f"{rope['name']}/sheave_{place}"
            if guide["type"] != "sheave" or name not in sheaves:
                continue
            at = sheaves.index(name)
            wrap, fleet = float(columns["wrap_angle"][0, at]), columns["fleet_angle"][0, at]
            reach = guide["radius"] * abs(math.tan(wrap / 2))
            both = [segments.index(f"{rope['name']}/{side}") for side in (place - 1, place)]
            apart = reach * abs(math.tan(fleet[0]) - math.tan(fleet[1]))
            if (
                math.pi < wrap < 2 * math.pi
                and min(columns["segment_length"][0, both]) > reach
                and apart < (diameters.get(rope["name"]) or _NO_DIAMETER)
            ):
                lies = f"on the sheave of route[{place + 1}] by {math.degrees(wrap):.0f} deg"
                crosses = f"lies {lies}, and crosses itself {reach:.3g} m from there"
                found.append(f"{rope['name']} {crosses}; does 'axis' point the other way?")
    return found
