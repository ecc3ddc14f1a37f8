"""What stands in the world of a recording as triangles: ground with holes, water, supports, structures."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gantline.results.recording import Recording
from gantline.results.solids import box_faces
from gantline.results.surroundings import Ground, Hole, ground_of, is_cut, structures_of, water_level
from gantline.results.variable import FloatArray, Indices
from gantline.viewer.decimate import Places

_AROUND = 0.4  # of the lift's largest side, by which ground and water reach beyond it
_SQUARE: Indices = np.array([(0, 1, 2), (0, 2, 3)])


@dataclass(frozen=True, eq=False)
class Standing:
    """Something of the world.

    Attributes:
        name: What a program calls it.
        kind: `support`, `structure`, `ground`, `quay` (ground without an end beside water) or `water`.
        vertices: Corners in the world [m], shape (n, 3).
        faces: Three corners of each triangle, shape (m, 3).
        size: 1 while it is there and 0 once it is taken away, at each time; None if it stays.
    """

    name: str
    kind: str
    vertices: FloatArray
    faces: Indices
    size: FloatArray | None = None


def surroundings(recording: Recording, at: Places) -> list[Standing]:
    """What stands in the world of a recording.

    Args:
        recording: Any recording.
        at: Samples of the times for which `size` is wanted.
    """
    time = recording.time[at]
    found = [
        Standing(
            one.name,
            one.kind,
            one.boxes.reshape(-1, 3),
            box_faces(len(one.boxes)),
            None if one.removed_at is None else (time < one.removed_at).astype(np.float64),
        )
        for one in structures_of(recording)
    ]
    ground, level = ground_of(recording), water_level(recording)
    x, y = _window(recording, [one.vertices for one in found])
    if ground is not None:
        # Where nobody says where the quay ends, one sees through it what lies in the water.
        kind = "ground" if level is None or is_cut(ground, level) else "quay"
        found.append(_of_squares("ground", kind, _ground(ground, x, y)))
    if level is not None and (squares := _water(ground, level, x, y)):
        found.append(_of_squares("water", "water", squares))
    return found


def _water(
    ground: Ground | None, level: float, x: tuple[float, float], y: tuple[float, float]
) -> list[FloatArray]:
    """The surface of the water: everywhere, or in the holes of ground that lies above it."""
    if ground is None or not ground.holes or ground.level < level:
        return [_flat(x, y, level)]
    wet = [_within(hole, x, y) for hole in ground.holes if hole.floor < level]
    return [_flat(*sides, level) for sides in wet if all(begin < end for begin, end in sides)]


def _within(
    hole: Hole, x: tuple[float, float], y: tuple[float, float]
) -> tuple[tuple[float, float], tuple[float, float]]:
    """What a window shows of a hole: its sides along x and y [m]."""
    (x0, x1), (y0, y1) = hole.x, hole.y
    return (max(x0, x[0]), min(x1, x[1])), (max(y0, y[0]), min(y1, y[1]))


def _window(recording: Recording, standing: list[FloatArray]) -> tuple[tuple[float, float], ...]:
    """From where to where ground and water are shown along x and y [m]."""
    points = [
        recording[name].values.reshape(-1, 3) for name in ("body_position", "rope_point") if name in recording
    ]
    every = np.concatenate([*points, *standing])
    low, high = every.min(axis=0)[:2], every.max(axis=0)[:2]
    more = _AROUND * float(np.max(every.max(axis=0) - every.min(axis=0)))
    return tuple((float(least) - more, float(most) + more) for least, most in zip(low, high, strict=True))


def _of_squares(name: str, kind: str, squares: list[FloatArray]) -> Standing:
    faces = np.concatenate([_SQUARE + 4 * place for place in range(len(squares))])
    return Standing(name, kind, np.concatenate(squares), faces)


def _flat(x: tuple[float, float], y: tuple[float, float], level: float) -> FloatArray:
    return np.array([(x[0], y[0], level), (x[1], y[0], level), (x[1], y[1], level), (x[0], y[1], level)])


def _ground(ground: Ground, x: tuple[float, float], y: tuple[float, float]) -> list[FloatArray]:
    """The ground in squares: around its holes, their floors, and their walls."""
    found = []
    edges = [
        sorted({*ends, *(float(np.clip(side, *ends)) for hole in ground.holes for side in hole.side(axis))})
        for axis, ends in enumerate((x, y))
    ]
    for column in pairwise(edges[0]):
        for row in pairwise(edges[1]):
            middle = sum(column) / 2, sum(row) / 2
            inside = [
                hole
                for hole in ground.holes
                if all(hole.side(axis)[0] < middle[axis] < hole.side(axis)[1] for axis in (0, 1))
            ]
            found.append(_flat(column, row, inside[0].floor if inside else ground.level))
    for hole in ground.holes:
        sides = _within(hole, x, y)
        if all(begin < end for begin, end in sides):
            found += _walls(sides[0], sides[1], hole.floor, ground.level)
    return found


def _walls(
    x: tuple[float, float], y: tuple[float, float], floor: float, level: float
) -> Iterator[FloatArray]:
    corners = _flat(x, y, floor)[[0, 1, 2, 3, 0], :2]
    for one, other in pairwise(corners):
        yield np.array([(*one, floor), (*other, floor), (*other, level), (*one, level)])
