"""Where a convex body bears on the top of a support, by (SU1) of docs/concepts/supports.md.

As the core has it in `contact/pad.rs`, for what has to be known before there is a system: heights and gaps.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gantline.assembly.parts import Json
from gantline.assembly.spatial import Array

__all__ = ["Bearing", "Sides"]

#: A side that rises by less than the first along a top carries in the middle of it, by more than the second
#: at its rim [1].
_RISES = (0.2, 0.5)
#: Cosine to upright of sides that are steeper lie on nothing, but where they meet lower than all else.
_FLAT = 0.5
#: A side so little turned downwards stands upright, cosine; sides are so near those of a convex body [m].
_UPRIGHT, _ROUGH = 1e-6, 1e-3
#: By how much steep sides are lower than flat ones [m], and within a top [1].
_LOWER = 1e-9

Pair = tuple[float, float]


class Bearing(NamedTuple):
    """Where a body bears on a top.

    Attributes:
        place: the place (3,), world axes [m].
        rise: how steeply its side rises there, as a tangent.
    """

    place: Array
    rise: float


@dataclass(frozen=True)
class Sides:
    """The sides of a convex body in the world.

    Attributes:
        outlines: corners (n, 3) of each side, anticlockwise as seen from outside, world axes [m].
    """

    outlines: tuple[Array, ...]

    @cached_property
    def _planes(self) -> tuple[list[int], Array, Array]:
        """Of sides that look downwards: their numbers, z over the origin, and rises along x and y (n, 2)."""
        normals = np.array([_normal(side) for side in self.outlines])
        levels = np.array([side[0] @ normal for side, normal in zip(self.outlines, normals, strict=True)])
        down = np.flatnonzero(normals[:, 2] < -_UPRIGHT)
        return down.tolist(), levels[down] / normals[down, 2], -normals[down, :2] / normals[down, 2, None]

    def over(self, pad: Json) -> Bearing | None:
        """Where the body bears on the top of a support; None where nothing flatter than 60° is over it."""
        down, levels, slopes = self._planes
        middle, (cos, sin, _) = np.array(pad["at"][:2]), pad["along"]
        axes = np.array([[cos, sin], [-sin, cos]])
        half: Pair = tuple(pad["half"])
        heights, rises = levels + slopes @ middle, slopes @ axes.T
        # A convex body is above every plane of its sides: what is lower than one of them is none of it here.
        highest = int(np.argmax(heights))
        most = heights - heights[highest] + np.abs(rises - rises[highest]) @ np.array(half)
        found: dict[bool, tuple[float, Pair, int]] = {}
        for one in np.flatnonzero(most >= -_ROUGH).tolist():
            corners = (self.outlines[down[one]][:, :2] - middle) @ axes.T
            least = _least((float(rises[one, 0]), float(rises[one, 1])), corners, half)
            if least is None:
                continue
            is_steep = 1.0 / np.sqrt(1.0 + float(rises[one] @ rises[one])) < _FLAT
            place, value = least[0], float(heights[one]) + least[1]
            if is_steep not in found or value < found[is_steep][0]:
                found[is_steep] = (value, place, one)
        steep, flat = found.get(True), found.get(False)
        if steep is not None:
            is_within = all(abs(at) < most * (1.0 - _LOWER) for at, most in zip(steep[1], half, strict=True))
            if is_within and (flat is None or steep[0] < flat[0] - _LOWER):
                flat = steep
        if flat is None:
            return None
        _, place, one = flat
        above = float(heights[one] + rises[one] @ np.array(place))
        return Bearing(np.array([*(middle + np.array(place) @ axes), above]), float(np.hypot(*rises[one])))


def _normal(side: Array) -> Array:
    """Unit normal of a side, outwards (3,)."""
    normal = np.cross(side[1:-1] - side[0], side[2:] - side[0]).sum(axis=0)
    return np.asarray(normal / np.linalg.norm(normal))


def _least(rises: Pair, corners: Array, half: Pair) -> tuple[Pair, float] | None:
    """Where on a side f is least, along the sides of the top, and f there less that height [m].

    Args:
        rises: how fast the side rises along the sides of the top, from its height over the middle [1].
        corners: of the side, from the middle of the top along its sides (n, 2) [m].
        half: half of its sides [m].
    """
    free_x, free_y = (
        -float(np.sign(rise)) * most * min(max((abs(rise) - _RISES[0]) / (_RISES[1] - _RISES[0]), 0.0), 1.0)
        for rise, most in zip(rises, half, strict=True)
    )
    ways = np.roll(corners, -1, axis=0) - corners
    turns = ways[:, 0] * (free_y - corners[:, 1]) - ways[:, 1] * (free_x - corners[:, 0])
    if not ((turns > 0.0).any() and (turns < 0.0).any()):
        return (free_x, free_y), _value(rises, (free_x, free_y), half)
    edges = (_least_along(rises, *edge, half) for edge in zip(corners.tolist(), ways.tolist(), strict=True))
    return min((edge for edge in edges if edge is not None), key=lambda found: found[1], default=None)


def _least_along(
    rises: Pair, start: Sequence[float], way: Sequence[float], half: Pair
) -> tuple[Pair, float] | None:
    """The same on what is over the top of an edge."""

    def at(share: float) -> Pair:
        return start[0] + share * way[0], start[1] + share * way[1]

    first, last, bends = 0.0, 1.0, [0.0, 0.0]
    for axis in (0, 1):
        if way[axis] == 0.0:
            if abs(start[axis]) > half[axis]:
                return None
            continue
        one, other = ((sign * half[axis] - start[axis]) / way[axis] for sign in (-1.0, 1.0))
        first, last = max(first, min(one, other)), min(last, max(one, other))
        bends[axis] = -start[axis] / way[axis]
    if first > last:
        return None
    # Where it comes past the middle of a side of the top f is another parabola.
    knots = [first, *sorted(min(max(bend, first), last) for bend in bends), last]
    shares = [first]
    for one, other in pairwise(knots):
        middle = (one + other) / 2
        slope = bend = 0.0
        for axis in (0, 1):
            curved, place = (_RISES[1] - _RISES[0]) / half[axis], at(middle)[axis]
            slope += way[axis] * (rises[axis] + _RISES[0] * float(np.sign(place)) + curved * place)
            bend += way[axis] ** 2 * curved
        shares.append(min(max(middle - slope / bend, one), other))
    return min(((at(share), _value(rises, at(share), half)) for share in shares), key=lambda found: found[1])


def _value(rises: Pair, place: Pair, half: Pair) -> float:
    """F less the height over the middle of the top [m]."""
    return sum(
        rise * at + _RISES[0] * abs(at) + (_RISES[1] - _RISES[0]) * at * at / (2.0 * most)
        for rise, at, most in zip(rises, place, half, strict=True)
    )
