"""Fenders that cannot well be meant: on the wrong side of a hull, off it, or pressed deep from the start."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.assembly.afloat.hulls import hull_mesh
from gantline.assembly.parts import Parts
from gantline.assembly.spatial import Array
from gantline.results.afloat.pressed import DEEP
from gantline.scenario import Scenario
from gantline.scenario.afloat.mooring import Fender
from gantline.scenario.errors import Doubt
from gantline.units import format_by_size

__all__ = ["doubtful_fenders"]

#: The side of a vessel may be so far out of its hull, on a platform or a sponson [m], as a fairlead may; it
#: may be as far behind the outermost point, at a pointed bow, where it is that near to a flank [m].
_OFF_HULL = 10.0
_ON_FLANK = 2.0


def doubtful_fenders(parts: Parts, scenario: Scenario) -> Iterator[Doubt]:
    """What is doubtful about each fender, where the lift file has the bodies at the start."""
    for name, fender in (scenario.fenders or {}).items():
        path, found = ("fenders", name), _doubtful(parts, scenario, fender)
        if found is not None:
            key, sentence = found
            yield Doubt((*path, key), f"fender {name} {sentence}")


def _doubtful(parts: Parts, scenario: Scenario, fender: Fender) -> tuple[str, str] | None:
    """Key and sentence of the first thing about a fender that cannot well be meant."""
    normal = parts.pose(fender.wall_body)[1] @ np.array(fender.normal)
    wall = parts.place(fender.wall_body, [*fender.wall, 0.0])
    place = parts.place(fender.vessel, fender.at)
    if fender.wall_body is not None:
        off = _off(parts, scenario, fender.wall_body, wall, normal)
        if off is not None:
            right = (
                "'wall' is a place in its axes, 'facing' the direction in them to the vessel that meets it"
            )
            return "wall", f"has its wall {off} the hull of {fender.wall_body}: {right}"
    off = _off(parts, scenario, fender.vessel, place, -normal)
    if off is not None:
        return (
            "at",
            f"has 'at' {off} the hull of {fender.vessel}, seen from its wall: see 'at' and 'facing'",
        )
    deep = fender.thickness - float((place - wall) @ normal)
    pressed, capacity = deep * fender.stiffness, fender.capacity
    if deep > (fender.thickness or DEEP):
        beyond = f"; it is {fender.thickness:g} m thick" if fender.thickness else ""
    elif capacity is not None and pressed > capacity:
        beyond = f"; its capacity is {format_by_size(capacity, 'force')}"
    else:
        return None
    at_start = f"is pressed {deep:.3g} m deep where the lift file has its vessels"
    sentence = f"{at_start}, with {format_by_size(pressed, 'force')}{beyond}"
    return "at", f"{sentence}: see 'at', 'wall', 'thickness', and where they lie"


def _off(parts: Parts, scenario: Scenario, body: str, place: Array, side: Array) -> str | None:
    """Words before 'the hull' where a place in the world is not on the side that looks this way."""
    plain = scenario.mechanics.bodies if scenario.mechanics is not None else {}
    hull = hull_mesh(scenario, body, {**(scenario.vessels or {}), **plain}[body])
    if hull is None:
        return None
    position, turn = parts.pose(body)
    beyond, half = _beyond(hull.vertices @ turn.T, place - position, side)
    if beyond > _OFF_HULL:
        return f"{beyond:.3g} m off"
    across = np.array([-side[1], side[0], 0.0])
    flank = max(_beyond(hull.vertices @ turn.T, place - position, way)[0] for way in (across, -across))
    # It may stand back from the outermost point, in a notch or at a pointed bow, but is nearer to that side,
    # and not on a flank far from it.
    is_elsewhere = -beyond > half or (-beyond > _OFF_HULL and flank > -_ON_FLANK)
    return f"{-beyond:.3g} m inside" if is_elsewhere else None


def _beyond(hull: Array, place: Array, way: Array) -> tuple[float, float]:
    """How far a place is beyond the outermost point of a hull one way, and half its size that way [m]."""
    along = hull @ way
    low, high = float(along.min()), float(along.max())
    return float(place @ way) - high, (high - low) / 2
