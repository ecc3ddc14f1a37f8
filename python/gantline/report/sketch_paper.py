"""The paper of a sketch: places in millimetres, marks on it, and lines that end at its margin."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gantline.results.variable import FloatArray

#: Of the paper [mm]; no world is drawn beyond the margin.
WIDTH, HEIGHT, MARGIN = 92.0, 62.0, 2.0
#: Room for the scale bar below what is drawn [mm].
_BELOW = 6.0
#: Of the lower end of the paper, under the title and the scale bar [mm]: what lies there is not seen.
PLATE = 7.0


@dataclass(frozen=True)
class Mark:
    """One thing that a sketch draws.

    Attributes:
        kind: `area`, `line`, `dot`, `text` or `centre`.
        style: Its class in the style sheet.
        points: Places on paper [mm], `x,y x,y ...`.
        x: Of a dot or text [mm].
        y: Of a dot or text [mm].
        text: Of a text.
        anchor: Of a text: `start`, `middle` or `end`.
    """

    kind: str
    style: str
    points: str = ""
    x: float = 0.0
    y: float = 0.0
    text: str = ""
    anchor: str = "middle"


class Paper:
    """Points in space to places on paper.

    Args:
        view: Axes of the world that are to the right and up on paper, shape (2, 3).
        extent: Points in space [m], shape (n, 3), that all are on the paper.
    """

    def __init__(self, view: FloatArray, extent: FloatArray) -> None:
        flat = extent @ view.T
        low, high = flat.min(axis=0), flat.max(axis=0)
        room = np.array([WIDTH - 10.0, HEIGHT - 6.0 - _BELOW])
        self.scale = float(np.max((high - low) / room)) or 0.01
        self._view, self._middle = view, (low + high) / 2
        self._centre = np.array([WIDTH / 2, (HEIGHT - _BELOW) / 2 + 1.0])

    def place(self, points: FloatArray) -> FloatArray:
        """Places of points [mm], from the upper left corner to the right and down."""
        flat = (points @ self._view.T - self._middle) / self.scale
        moved: FloatArray = self._centre + flat * np.array([1.0, -1.0])
        return moved

    def shown(self, points: FloatArray) -> FloatArray:
        """Places of points, those beyond the margin on it."""
        within: FloatArray = np.clip(self.place(points), MARGIN, np.array([WIDTH - MARGIN, HEIGHT - MARGIN]))
        return within

    def ends(self) -> tuple[float, float]:
        """Least and most on the horizontal axis that the paper shows [m]."""
        half = (WIDTH / 2 - MARGIN) * self.scale
        return float(self._middle[0]) - half, float(self._middle[0]) + half

    def lowest(self) -> float:
        """The height at the lower end of what the paper shows [m]."""
        below = HEIGHT - MARGIN - float(self._centre[1])
        return float(self._middle[1]) - below * self.scale

    def line(self, path: FloatArray, style: str) -> list[Mark]:
        """A line of the world as far as it is on the paper."""
        places = self.place(path)
        pieces = (_cut(one, other) for one, other in pairwise(places))
        return [Mark("line", style, drawn_path(piece)) for piece in pieces if piece is not None]

    def area(self, points: FloatArray, style: str) -> list[Mark]:
        """The outline of something of the world as far as it is on the paper; none if it is beside it."""
        shown = self.shown(points)
        is_on_it = (np.ptp(shown, axis=0) > 0.0).all()
        return [Mark("area", style, drawn_path(outline(shown)))] if is_on_it else []


def _cut(one: FloatArray, other: FloatArray) -> FloatArray | None:
    """What of a straight line is within the margin of the paper (Liang and Barsky); None if nothing is."""
    begin, end = 0.0, 1.0
    for axis, most in enumerate((WIDTH, HEIGHT)):
        way = float(other[axis] - one[axis])
        for room, sign in ((float(one[axis]) - MARGIN, -1.0), (most - MARGIN - float(one[axis]), 1.0)):
            if sign * way > 0.0:
                end = min(end, room / (sign * way))
            elif sign * way < 0.0:
                begin = max(begin, room / (sign * way))
            elif room < 0.0:
                return None
    return None if begin >= end else np.array([one + begin * (other - one), one + end * (other - one)])


def drawn_path(points: FloatArray) -> str:
    """Places on paper as `Mark.points` holds them."""
    return " ".join(f"{x:.2f},{y:.2f}" for x, y in points)


def outline(points: FloatArray) -> FloatArray:
    """Convex hull of points on paper (Andrew's monotone chain)."""
    order = points[np.lexsort((points[:, 1], points[:, 0]))]

    def half(ordered: FloatArray) -> list[FloatArray]:
        chain: list[FloatArray] = []
        for point in ordered:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0.0:
                chain.pop()
            chain.append(point)
        return chain[:-1]

    return np.array([*half(order), *half(order[::-1])])


def _turn(a: FloatArray, b: FloatArray, c: FloatArray) -> float:
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
