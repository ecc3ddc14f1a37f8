"""Names beside dots of a sketch, so that they cover neither each other nor other dots."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from gantline.results.variable import FloatArray

__all__ = [
    "Box",
    "around_dot",
    "beside_dot",
    "fits_above",
    "has_room",
    "hides_none",
    "names_beside",
    "names_in_a_row",
    "on_paper",
    "text_box",
]

_LETTER = 1.75  # mm, mean width of a letter
_LINE = 3.4  # mm, between lines
_BESIDE = 2.5  # mm, from a dot to its name
_DOT = 1.2  # mm, of a dot with its edge
_LETTERS = 2.1  # mm, from the middle of a dot to the middle of a line of letters that just leaves it in sight
_BOLD = 2.2  # mm, mean width of a bold letter, in the widest fonts
_BETWEEN = 1.0  # mm, between names in a row
_APART = 0.6  # mm, between lines that can be told from each other
_LED = 4.5  # mm, how far below its name a line is met by what leads to it
_MOST_IN_A_ROW = 8
_TOGETHER = 1.5  # mm, between dots that look like one
_DOWN = (0.0, 4.0, -4.0, 8.0)  # mm

#: Left, right, and the middle of the height of what is taken [mm].
Box = tuple[float, float, float]


def around_dot(place: FloatArray) -> Box:
    """What a dot takes [mm]."""
    return float(place[0]) - _DOT, float(place[0]) + _DOT, float(place[1])


def beside_dot(text: str) -> float:
    """How far from a dot the middle of a bold text is that stands right beside it [mm]."""
    return _DOT + _APART + _BOLD * len(text) / 2


def text_box(x: float, y: float, text: str, anchor: str = "middle", *, is_bold: bool = False) -> Box:
    """What a text takes that has its `start`, `middle` or `end` at a place [mm]."""
    wide = (_BOLD if is_bold else _LETTER) * len(text)
    left = x - {"start": 0.0, "middle": wide / 2, "end": wide}[anchor]
    return left, left + wide, y


def names_in_a_row(
    ends: Sequence[tuple[FloatArray, FloatArray]], names: Sequence[str], right: float, taken: Sequence[Box]
) -> list[tuple[float, float, FloatArray | None]] | None:
    """Where names of lines that go down beside each other stand in one row.

    Where the lines are too near to each other the names are spread in the same order, and led to their lines.

    Args:
        ends: Upper and lower end of each line on paper [mm], shape (2,) each.
        names: One for each.
        right: Where the paper ends [mm].
        taken: What names may not lie on.

    Returns:
        x and y of each name [mm], and the place on its line to which it is led, None if it stands on it.
        None at all where lines hide each other, or where there is no room for a row.
    """
    if not 1 < len(names) <= _MOST_IN_A_ROW:
        return None
    wide = [_BOLD * len(name) for name in names]
    for height in _row_heights(ends):
        on_line = [_at_height(*pair, height) for pair in ends]
        order = sorted(range(len(names)), key=lambda one: float(on_line[one][0]))
        gaps = [float(on_line[b][0] - on_line[a][0]) for a, b in pairwise(order)]
        if min(gaps) < _APART:
            continue
        needed = [(wide[a] + wide[b]) / 2 + _BETWEEN for a, b in pairwise(order)]
        is_spread = any(gap < need for gap, need in zip(gaps, needed, strict=True))
        middles = [float(on_line[one][0]) for one in order]
        if is_spread:
            offsets = np.concatenate(
                [[0.0], np.cumsum([max(*pair) for pair in zip(gaps, needed, strict=True)])]
            )
            middles = list(offsets - offsets.mean() + np.mean(middles))
        found: dict[int, tuple[float, float, FloatArray | None]] = {}
        for one, x in zip(order, middles, strict=True):
            led = _at_height(*ends[one], height + _LED) if is_spread else None
            found[one] = (float(x), height, led)
        boxes = [(found[one][0] - wide[one] / 2, found[one][0] + wide[one] / 2, height) for one in found]
        if all(has_room(box, taken) and box[0] >= 0.0 and box[1] <= right for box in boxes):
            return [found[one] for one in range(len(names))]
    return None


def _row_heights(ends: Sequence[tuple[FloatArray, FloatArray]]) -> list[float]:
    """Heights [mm] at which all lines are, with room to lead names to them; the best first."""
    top, bottom = (choose(float(pair[end][1]) for pair in ends) for end, choose in ((0, max), (1, min)))
    room = bottom - top - 2 * _LED
    return [top + _LED + share * room for share in (0.5, 0.3, 0.7, 0.1, 0.9)] if room > 0.0 else []


def _at_height(upper: FloatArray, lower: FloatArray, height: float) -> FloatArray:
    """Where a line that goes down is at a height [mm]."""
    share = (height - float(upper[1])) / float(lower[1] - upper[1])
    place: FloatArray = upper + share * (lower - upper)
    return place


def on_paper(x: float, text: str, right: float) -> float:
    """The middle of a bold text [mm] that is wanted at x, kept between the ends of the paper."""
    half = _BOLD * len(text) / 2
    return max(half, min(x, right - half))


def has_room(box: Box, taken: Sequence[Box]) -> bool:
    """Whether nothing that is taken lies under a text."""
    return all(_apart(box, other) for other in taken)


def fits_above(box: Box, end: float) -> bool:
    """Whether a text lies between the upper end of the paper and a lower one [mm]."""
    return _LINE / 2 <= box[2] <= end - _LINE / 2


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
        if y + down < _LINE / 2:
            continue  # above the end of the paper
        # Above or below its dot a name may reach back over it from the end of the paper.
        start = x + _BESIDE if down == 0.0 else min(x + _BESIDE, right - wide)
        for left, side in ((start, "start"), (x - _BESIDE - wide, "end")):
            if left >= 0.0 and left + wide <= right:
                found.append((left, y + down, side))
    return found


def _apart(one: Box, other: Box) -> bool:
    return one[1] < other[0] or other[1] < one[0] or abs(one[2] - other[2]) >= _LINE
