"""Names beside dots of a sketch, so that they cover neither each other nor other dots."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gantline.results.variable import FloatArray

__all__ = ["names_beside"]

_LETTER = 1.75  # mm, mean width of a letter
_LINE = 3.4  # mm, between lines
_BESIDE = 2.5  # mm, from a dot to its name
_DOT = 1.2  # mm, of a dot with its edge
_TOGETHER = 1.5  # mm, between dots that look like one
_DOWN = (0.0, 4.0, -4.0, 8.0)  # mm

#: Left, right, and the middle of the height of what is taken [mm].
_Box = tuple[float, float, float]


def names_beside(
    places: Sequence[FloatArray], names: Sequence[str], right: float
) -> list[tuple[float, float, str, str]]:
    """Where names stand; dots that look like one have one name, and a name without room is left out.

    Args:
        places: Of the dots on paper [mm], shape (2,) each.
        names: One for each.
        right: Where the paper ends [mm].

    Returns:
        x and y [mm], the text, and the end of it that is there: `start` or `end`.
    """
    groups: list[tuple[FloatArray, list[str]]] = []
    for place, name in zip(places, names, strict=True):
        near = next((own for at, own in groups if np.linalg.norm(at - place) < _TOGETHER), None)
        if near is None:
            groups.append((place, [name]))
        else:
            near.append(name)
    taken: list[_Box] = [(float(x) - _DOT, float(x) + _DOT, float(y)) for (x, y), _ in groups]
    found = []
    for (x, y), own in groups:
        text = ", ".join(own)
        for left, height, side in _tries(float(x), float(y), _LETTER * len(text), right):
            box = (left, left + _LETTER * len(text), height)
            if all(_apart(box, other) for other in taken):
                taken.append(box)
                found.append((left if side == "start" else box[1], height, text, side))
                break
    return found


def _tries(x: float, y: float, wide: float, right: float) -> list[tuple[float, float, str]]:
    """Left ends and heights of a text beside a dot, the best first."""
    sides = [(x + _BESIDE, "start"), (x - _BESIDE - wide, "end")]
    return [
        (left, y + down, side)
        for down in _DOWN
        for left, side in sides
        if left >= 0.0 and left + wide <= right
    ]


def _apart(one: _Box, other: _Box) -> bool:
    return one[1] < other[0] or other[1] < one[0] or abs(one[2] - other[2]) >= _LINE
