"""What the world of a recording has, for drawings: ground with its holes, water, supports, structures."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.results.variable import FloatArray

#: Corners of a box of twice the size 1, x slowest, z fastest.
SIGNS = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=np.float64)


@dataclass(frozen=True)
class Hole:
    """A hole in the ground, such as a dock: its sides along world x and y, and its floor [m]."""

    x: tuple[float, float]
    y: tuple[float, float]
    floor: float

    def side(self, axis: int) -> tuple[float, float]:
        """From wall to wall along world x (0) or y (1) [m]."""
        return self.y if axis else self.x


@dataclass(frozen=True)
class Ground:
    """The ground: its level [m], and the holes in it."""

    level: float
    holes: tuple[Hole, ...]

    def under(self, points: FloatArray) -> FloatArray:
        """Height of the ground at the places of points, shape (points, 3), in plan; shape (points,) [m]."""
        heights: FloatArray = np.full(len(points), self.level)
        for hole in self.holes:
            sides = [
                (points[:, axis] - hole.side(axis)[0], hole.side(axis)[1] - points[:, axis])
                for axis in (0, 1)
            ]
            inside = np.all([part >= 0.0 for side in sides for part in side], axis=0)
            heights = np.where(inside, hole.floor, heights)
        return heights

    def near(self, points: FloatArray) -> FloatArray:
        """Points of the ground that a drawing of these points holds [m], shape (n, 3).

        Args:
            points: What is drawn [m], shape (points, 3).

        Returns:
            The level under their middle, and the floor of each hole that they reach over.
        """
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        found = [(middle[0], middle[1], self.level)]
        for hole in self.holes:
            if all(_meet(hole.side(axis), points[:, axis]) for axis in (0, 1)):
                x, y = (float(np.clip(middle[axis], *hole.side(axis))) for axis in (0, 1))
                found.append((x, y, hole.floor))
        return np.array(found)

    def profile(self, axis: int, ends: tuple[float, float], points: FloatArray) -> FloatArray:
        """The ground cut along world x (0) or y (1) where the lift is.

        Args:
            axis: Along which it is cut.
            ends: From where to where along it [m].
            points: Of the lift [m], shape (points, 3); holes beside them are not cut.

        Returns:
            Corners from one end to the other: place along the axis and height [m], shape (corners, 2). Where
            a hole goes on beyond an end, that is on its floor.
        """
        left, right = ends
        before, within, after = [(left, self.level)], [], [(right, self.level)]
        for hole in sorted(self.holes, key=lambda hole: hole.side(axis)):
            begin, end = hole.side(axis)
            if begin >= right or end <= left or not _meet(hole.side(1 - axis), points[:, 1 - axis]):
                continue
            if begin > left:
                within += [(begin, self.level), (begin, hole.floor)]
            else:
                before = [(left, hole.floor)]
            if end < right:
                within += [(end, hole.floor), (end, self.level)]
            else:
                after = [(right, hole.floor)]
        return np.array([*before, *within, *after])


def water_cut(
    ground: Ground | None,
    level: float,
    axis: int,
    window: tuple[tuple[float, float], float],
    points: FloatArray,
) -> list[FloatArray]:
    """The water cut along world x (0) or y (1) where the lift is.

    Where the ground has holes, or lies below the water, that is what stands above it. Ground without a hole
    above the water is a quay whose edge nobody has told: water is everywhere then.

    Args:
        ground: The ground, if there is some.
        level: Of the water [m].
        axis: Along which it is cut.
        window: From where to where along it, and the lowest that is drawn [m].
        points: Of the lift [m], shape (points, 3); holes beside them are not cut.

    Returns:
        Corners of each rectangle, the two of the surface last: place along the axis and height [m], shape
        (4, 2).
    """
    ends, low = window
    if not is_cut(ground, level):
        floor = [(np.array([ends[0], low]), np.array([ends[1], low]))]
    else:
        assert ground is not None
        floor = list(pairwise(ground.profile(axis, ends, points)))
    return [
        np.array([(one[0], one[1]), (other[0], other[1]), (other[0], level), (one[0], level)])
        for one, other in floor
        if one[1] == other[1] < level and other[0] > one[0]
    ]


def is_cut(ground: Ground | None, level: float) -> bool:
    """Whether the ground says where there is water of a level [m]: it has holes, or lies below the water."""
    return ground is not None and (bool(ground.holes) or ground.level < level)


@dataclass(frozen=True, eq=False)
class Structure:
    """Something of the world that is made of boxes.

    Attributes:
        name: of a support that of its contact.
        kind: `support`, `structure` or `water`.
        boxes: the eight corners of each [m], shape (boxes, 8, 3); x slowest, z fastest.
        removed_at: when it is taken away [s]; None if it stays.
    """

    name: str
    kind: str
    boxes: FloatArray
    removed_at: float | None

    def stands(self, time: float) -> bool:
        """Whether it is there at a time [s]."""
        return self.removed_at is None or time < self.removed_at


def ground_of(recording: Recording) -> Ground | None:
    """The ground of a recording; None if it has none."""
    return ground_in(_scene(recording))


def ground_in(scene: Mapping[str, Any]) -> Ground | None:
    """The ground of a scene; None if it has none."""
    given = scene.get("ground")
    if not given:
        return None
    holes = [Hole(_pair(one["x"]), _pair(one["y"]), float(one["floor"])) for one in given.get("holes") or ()]
    return Ground(float(given["level"]), tuple(holes))


def water_level(recording: Recording) -> float | None:
    """Level of the water of a recording [m]; None if it has none."""
    given = _scene(recording).get("water")
    return None if not given else float(given["level"])


def structures_of(recording: Recording) -> list[Structure]:
    """Supports and structures of a recording, in the order of its scene."""
    removed = {name: time for time, _, name in recording.events("support_removed")}
    return [
        Structure(
            str(entry["name"]),
            str(entry["kind"]),
            np.array([_corners(box) for box in entry["boxes"]]).reshape(-1, 8, 3),
            removed.get(entry["name"]),
        )
        for entry in _scene(recording).get("structures") or ()
    ]


def _scene(recording: Recording) -> Mapping[str, Any]:
    scene: Mapping[str, Any] = recording.attributes.get("scene") or {}
    return scene


def _pair(given: Any) -> tuple[float, float]:
    least, most = given
    return float(least), float(most)


def _corners(box: Mapping[str, Any]) -> FloatArray:
    """Corners of a box of the world, which may be turned."""
    half = SIGNS * np.asarray(box["size"], dtype=np.float64) / 2
    turn = axes(np.asarray(box.get("orientation") or (1.0, 0.0, 0.0, 0.0), dtype=np.float64))
    corners: FloatArray = np.asarray(box["centre"], dtype=np.float64) + half @ turn.T
    return corners


def _meet(side: tuple[float, float], places: FloatArray) -> bool:
    """Whether places reach into a range."""
    return bool(places.min() < side[1] and places.max() > side[0])
