"""Names beside dots of a sketch, so that they cover neither each other nor other dots."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gantline.results.variable import FloatArray

__all__ = ["Box", "around_dot", "has_room", "hides_none", "names_beside", "text_box"]

_LETTER = 1.75  # mm, mean width of a letter
_LINE = 3.4  # mm, between lines
_BESIDE = 2.5  # mm, from a dot to its name
_DOT = 1.2  # mm, of a dot with its edge
_LETTERS = 2.1  # mm, from the middle of a dot to the middle of a line of letters that just leaves it in sight
_TOGETHER = 1.5  # mm, between dots that look like one
_DOWN = (0.0, 4.0, -4.0, 8.0)  # mm

#: Left, right, and the middle of the height of what is taken [mm].
Box = tuple[float, float, float]


def around_dot(place: FloatArray) -> Box:
    """What a dot takes [mm]."""
    return float(place[0]) - _DOT, float(place[0]) + _DOT, float(place[1])


def text_box(x: float, y: float, text: str, anchor: str = "middle") -> Box:
    """What a text takes that has its `start`, `middle` or `end` at a place [mm]."""
    wide = _LETTER * len(text)
    left = x - {"start": 0.0, "middle": wide / 2, "end": wide}[anchor]
    return left, left + wide, y


def has_room(box: Box, taken: Sequence[Box]) -> bool:
    """Whether nothing that is taken lies under a text."""
    return all(_apart(box, other) for other in taken)


def hides_none(box: Box, dots: Sequence[FloatArray]) -> bool:
    """Whether a text leaves all dots in sight, places on paper [mm], shape (2,) each."""
    return all(abs(box[2] - y) >= _LETTERS or x + _DOT < box[0] or box[1] < x - _DOT for x, y in dots)


def names_beside(
    places: Sequence[FloatArray], names: Sequence[str], right: float, drawn: Sequence[Box] = ()
) -> list[tuple[float, float, str, str]]:
    """Where names stand; dots that look like one have one name, and a name without room is left out.

    Args:
        places: Of the dots on paper [mm], shape (2,) each.
        names: One for each.
        right: Where the paper ends [mm].
        drawn: What names rather do not lie on; they do before they are left out.

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
    taken = [around_dot(place) for place, _ in groups]
    found: dict[int, tuple[float, float, str, str]] = {}
    texts = [", ".join(own) for _, own in groups]
    # Long names have the fewest places.
    for number in sorted(range(len(groups)), key=lambda one: -len(texts[one])):
        (x, y), text = groups[number][0], texts[number]
        wide = _LETTER * len(text)
        tries = [
            ((left, left + wide, height), side)
            for left, height, side in _tries(float(x), float(y), wide, right)
            if has_room((left, left + wide, height), taken)
        ]
        for box, side in [one for one in tries if has_room(one[0], drawn)][:1] or tries[:1]:
            taken.append(box)
            found[number] = (box[0] if side == "start" else box[1], box[2], text, side)
    return [found[number] for number in sorted(found)]


def _tries(x: float, y: float, wide: float, right: float) -> list[tuple[float, float, str]]:
    """Left ends and heights of a text beside a dot, the best first."""
    found = []
    for down in _DOWN:
        # Above or below its dot a name may reach back over it from the end of the paper.
        start = x + _BESIDE if down == 0.0 else min(x + _BESIDE, right - wide)
        for left, side in ((start, "start"), (x - _BESIDE - wide, "end")):
            if left >= 0.0 and left + wide <= right:
                found.append((left, y + down, side))
    return found


def _apart(one: Box, other: Box) -> bool:
    return one[1] < other[0] or other[1] < one[0] or abs(one[2] - other[2]) >= _LINE
