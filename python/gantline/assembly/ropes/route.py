"""How long the parts of a rope are at the start: straight segments, and arcs on sheaves."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import Array
from gantline.scenario.gear import RopeMaterial

__all__ = ["MOST_STRAIN", "most_strain", "route_length", "route_lengths", "taut_length", "too_far"]

#: Rounds of going back and forth between two sheaves; each leaves of the error a share, radius by distance.
_ROUNDS = 40
#: Largest strain of a rope at the start of a lift that is not at rest.
MOST_STRAIN = 0.02


def most_strain(kind: RopeMaterial) -> float:
    """The same of a kind of rope: one with a curve may be stretched to its last point."""
    return MOST_STRAIN if kind.curve is None else max(MOST_STRAIN, kind.curve.strain[-1])


def too_far(distance: float, length: float, most: float = MOST_STRAIN) -> str:
    """That a rope of some length [m] would be stretched too far over a distance [m], in words."""
    strain = distance / length - 1.0
    digits = max(2, 1 - math.floor(math.log10(max(100.0 * (strain - most), 1e-9))))
    stretched = f"{100.0 * strain:.{min(digits, 9)}f} %"
    return f"it would be stretched by {stretched}, and a start allows {100.0 * most:g} %"


def taut_length(distance: float, tension: float, kind: RopeMaterial) -> float:
    """Unstretched length [m] of a rope of a kind that stretches, with a tension [N] over a distance [m]."""
    return distance / (1.0 + kind.strain_under(tension))


def route_length(parts: Parts, route: Sequence[Json]) -> float:
    """Length of a route at the start, straight segments and arcs [m]."""
    straight, arcs = route_lengths(parts, route)
    return float(np.sum(straight) + np.sum(arcs))


def route_lengths(parts: Parts, route: Sequence[Json]) -> tuple[Array, Array]:
    """Lengths of the parts of a route at the start.

    Args:
        parts: the system so far.
        route: guides in order.

    Returns:
        Straight segments (guides - 1,) and arcs, 0 on an end, (guides,) [m].
    """
    circles = [_Circle(parts, guide) for guide in route]
    for _ in range(_ROUNDS if any(circle.is_free for circle in circles) else 1):
        for before, after in pairwise(circles):
            before.leave_to(after.arrival)
            after.arrive_from(before.departure)
    straight = [
        float(np.linalg.norm(after.arrival - before.departure)) for before, after in pairwise(circles)
    ]
    return np.array(straight), np.array([circle.arc() for circle in circles])


def end_to_end(parts: Parts, route: Sequence[Json]) -> Array:
    """From the first end of a route to its last at the start, world axes (3,) [m]."""
    first, last = _Circle(parts, route[0]), _Circle(parts, route[-1])
    way: Array = last.arrival - first.departure
    return way


class _Circle:
    """A guide in the world: an end, half a turn between given points, or a sheave touched along tangents.

    Attributes:
        arrival: where the rope arrives (3,) [m].
        departure: where it goes on (3,) [m].
        is_free: whether these points have to be found.
    """

    def __init__(self, parts: Parts, guide: Json) -> None:
        body = guide["body"]
        self.is_free = guide["type"] == "sheave"
        if guide["type"] == "half_turn":
            self.arrival, self.departure = (
                parts.place(body, guide["enter"]),
                parts.place(body, guide["leave"]),
            )
            return
        self.arrival = self.departure = self._centre = parts.place(body, guide["at"])
        if self.is_free:
            self._axis = parts.pose(body)[1] @ np.array(guide["axis"])
            self._radius = float(guide["radius"])

    def leave_to(self, point: Array) -> None:
        """Let the rope go on to a point."""
        if self.is_free:
            self.departure = self._touch(point, 1.0)

    def arrive_from(self, point: Array) -> None:
        """Let the rope come from a point."""
        if self.is_free:
            self.arrival = self._touch(point, -1.0)

    def _touch(self, point: Array, sense: float) -> Array:
        """Where a rope to a point leaves (sense +1), or from it arrives (-1).

        In the plane of the sheave, u the unit radius there and w the way to the point: u . w = radius. A
        point within the circle has no such place, and the core refuses the route; the centre stands for it.
        """
        way = point - self._centre
        flat = way - self._axis * float(self._axis @ way)
        square = float(flat @ flat)
        along = square - self._radius**2
        if along <= 0:
            return self._centre
        radial = (flat * self._radius - np.cross(self._axis, flat) * (sense * math.sqrt(along))) / square
        place: Array = self._centre + self._radius * radial
        return place

    def arc(self) -> float:
        """Length of rope on the guide [m]; 0 where it has lifted off."""
        if not self.is_free:
            return math.pi * float(np.linalg.norm(self.departure - self.arrival)) / 2
        first, last = self.arrival - self._centre, self.departure - self._centre
        angle = math.atan2(float(self._axis @ np.cross(first, last)), float(first @ last))
        if angle <= -math.pi / 2:  # the rope runs about the axis: more than half a turn
            angle += 2 * math.pi
        return self._radius * max(angle, 0.0)
