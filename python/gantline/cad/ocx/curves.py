"""Curves in space: lines, arcs of circles and ellipses, and NURBS, all cut into smooth spans.

A NURBS is cut into its Bézier spans by polar forms: the i-th control point of the span from a to b is the
polar form at p − i times a and i times b (Ramshaw, Blossoms are polar forms, Computer Aided Geometric
Design 6, 1989). What is known of a curve is then the same for all kinds: position and two derivatives over
a parameter from 0 to 1 in each span. Integrals along it are sums over Gauss points, exact for polynomials
of the degree that they are asked for.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt

__all__ = ["Arc", "Curve", "Line", "Spline", "chained", "gauss", "polyline"]

Array = npt.NDArray[np.float64]

_MOST_DEGREE = 16
_ARC_SPAN = math.pi / 4  # of an arc's spans: twelve Gauss points integrate these to rounding


@cache
def gauss(count: int) -> tuple[Array, Array]:
    """Places within 0 to 1 and weights of Gauss–Legendre integration, each of shape (count,)."""
    places, weights = np.polynomial.legendre.leggauss(count)
    return (places + 1) / 2, weights / 2


class Curve(ABC):
    """A curve of smooth spans, one after another."""

    #: Gauss points of a span that integrate the second moments of an area that the curve bounds.
    points_per_span: int

    @abstractmethod
    def evaluate(self, places: Array) -> tuple[Array, Array, Array]:
        """Positions [m] and two derivatives at places (q,) from 0 to 1 of each span: (spans, q, 3)."""

    @abstractmethod
    def reversed(self) -> Curve:
        """The same curve from its end to its start."""

    @abstractmethod
    def moved(self, turn: Array, shift: Array) -> Curve:
        """The same curve turned by a matrix (3, 3) about the origin, then moved by (3,) [m]."""

    @property
    def start(self) -> Array:
        """First point (3,) [m]."""
        return np.asarray(self.evaluate(np.array([0.0]))[0][0, 0])

    @property
    def end(self) -> Array:
        """Last point (3,) [m]."""
        return np.asarray(self.evaluate(np.array([1.0]))[0][-1, 0])

    @property
    def length(self) -> float:
        """Length [m]."""
        places, weights = gauss(16)
        return float((np.linalg.norm(self.evaluate(places)[1], axis=2) @ weights).sum())

    def polyline(self, tolerance: float) -> Array:
        """Points (n, 3) on the curve with its ends, whose chords miss it by about a tolerance [m]."""
        steps = self._steps(tolerance)
        points = self.evaluate(np.arange(steps) / steps)[0].reshape(-1, 3)
        return np.concatenate([points, self.end[None]])

    def _steps(self, tolerance: float) -> int:
        # A chord over a parameter step h misses by at most h² |r″|/8.
        bend = float(np.linalg.norm(self.evaluate(np.linspace(0.0, 1.0, 5))[2], axis=2).max())
        return max(1, min(256, math.ceil(math.sqrt(bend / (8.0 * tolerance)))))


@dataclass(frozen=True, eq=False)
class Line(Curve):
    """A straight line or a polyline: points (n, 3) [m], n at least 2."""

    points: Array
    points_per_span = 2

    @property
    def start(self) -> Array:
        """See `Curve`; as it is given, without a sum."""
        return np.asarray(self.points[0])

    @property
    def end(self) -> Array:
        """See `Curve`."""
        return np.asarray(self.points[-1])

    def polyline(self, tolerance: float) -> Array:
        """See `Curve`; its own points miss nothing."""
        return self.points

    def evaluate(self, places: Array) -> tuple[Array, Array, Array]:
        """See `Curve`."""
        ways = np.diff(self.points, axis=0)[:, None, :]
        along = np.broadcast_to(ways, (len(ways), len(places), 3))
        return self.points[:-1, None, :] + places[None, :, None] * ways, along, np.zeros_like(along)

    def reversed(self) -> Line:
        """See `Curve`."""
        return Line(self.points[::-1])

    def moved(self, turn: Array, shift: Array) -> Line:
        """See `Curve`."""
        return Line(self.points @ turn.T + shift)


@dataclass(frozen=True, eq=False)
class Arc(Curve):
    """Part of an ellipse: centre + cos φ · first + sin φ · second, φ from one angle to another [rad].

    Attributes:
        centre: (3,) [m].
        first: to where φ = 0 (3,) [m].
        second: to where φ = π/2 (3,) [m].
        begin: [rad].
        end_angle: [rad].
    """

    centre: Array
    first: Array
    second: Array
    begin: float
    end_angle: float
    points_per_span = 12

    def evaluate(self, places: Array) -> tuple[Array, Array, Array]:
        """See `Curve`."""
        sweep = self.end_angle - self.begin
        spans = max(1, math.ceil(abs(sweep) / _ARC_SPAN - 1e-9))
        step = sweep / spans
        angles = (self.begin + step * (np.arange(spans)[:, None] + places[None, :]))[:, :, None]
        out = np.cos(angles) * self.first + np.sin(angles) * self.second
        turned = np.cos(angles) * self.second - np.sin(angles) * self.first
        return self.centre + out, step * turned, -(step**2) * out

    def reversed(self) -> Arc:
        """See `Curve`."""
        return Arc(self.centre, self.first, self.second, self.end_angle, self.begin)

    def moved(self, turn: Array, shift: Array) -> Arc:
        """See `Curve`."""
        return Arc(
            turn @ self.centre + shift, turn @ self.first, turn @ self.second, self.begin, self.end_angle
        )

    @classmethod
    def through(cls, start: Array, middle: Array, end: Array) -> Curve:
        """The arc from one point over a second to a third (3,) [m]; a line if they stand in a row."""
        one, two = middle - start, end - start
        normal = np.cross(one, two)
        size = float(normal @ normal)
        reach = max(float(one @ one), float(two @ two))
        if size <= 1e-18 * reach**2:
            return Line(np.stack([start, middle, end]) if reach else np.stack([start, end]))
        centre = start + np.cross(float(one @ one) * two - float(two @ two) * one, normal) / (2.0 * size)
        first = start - centre
        second = np.cross(normal, first) / math.sqrt(size)
        sweep = math.atan2(float((end - centre) @ second), float((end - centre) @ first)) % (2 * math.pi)
        return cls(centre, first, second, 0.0, sweep or 2 * math.pi)

    @classmethod
    def circle(cls, centre: Array, normal: Array, diameter: float) -> Arc:
        """A whole circle about a unit normal."""
        first = _across(normal) * diameter / 2
        return cls(centre, first, np.cross(normal, first), 0.0, 2 * math.pi)


@dataclass(frozen=True, eq=False)
class Spline(Curve):
    """Bézier spans: control points times their weights, and weights, (spans, degree + 1, 4)."""

    controls: Array

    @property
    def points_per_span(self) -> int:  # type: ignore[override]
        """See `Curve`. Of degree p, second moments integrate a polynomial of degree 4 p − 1."""
        degree = self.controls.shape[1] - 1
        return 2 * degree if self.is_polynomial else 16

    @property
    def is_polynomial(self) -> bool:
        """Whether all weights are one."""
        return bool(np.all(self.controls[:, :, 3] == 1.0))

    def evaluate(self, places: Array) -> tuple[Array, Array, Array]:
        """See `Curve`."""
        position = _bernstein(self.controls, places)
        first = _bernstein(_differences(self.controls), places)
        second = _bernstein(_differences(_differences(self.controls)), places)
        point, weight = position[..., :3], position[..., 3:]
        if self.is_polynomial:
            return point, first[..., :3], second[..., :3]
        point = point / weight
        slope = (first[..., :3] - first[..., 3:] * point) / weight
        bend = (second[..., :3] - 2 * first[..., 3:] * slope - second[..., 3:] * point) / weight
        return point, slope, bend

    def reversed(self) -> Spline:
        """See `Curve`."""
        return Spline(self.controls[::-1, ::-1])

    def moved(self, turn: Array, shift: Array) -> Spline:
        """See `Curve`."""
        weights = self.controls[:, :, 3:]
        return Spline(np.concatenate([self.controls[:, :, :3] @ turn.T + weights * shift, weights], axis=2))

    @classmethod
    def nurbs(cls, degree: int, knots: Array, points: Array, weights: Array) -> Spline:
        """A NURBS cut into its Bézier spans.

        Args:
            degree: of its polynomials.
            knots: in rising order (n + degree + 1,).
            points: control points (n, 3) [m].
            weights: of the control points (n,), greater than zero.

        Raises:
            ValueError: with a plain sentence, if these do not make a curve.
        """
        check_knots(degree, knots, len(points))
        if not np.all(weights > 0):
            raise ValueError("has a control point whose weight is not positive")
        homogeneous = np.concatenate([points * weights[:, None], weights[:, None]], axis=1)
        if np.all(weights == 1.0):
            homogeneous[:, 3] = 1.0
        return cls(bezier_spans(degree, knots, homogeneous))


def check_knots(degree: int, knots: Array, count: int) -> None:
    """Whether a knot vector fits control points.

    Raises:
        ValueError: with a plain sentence, if it does not.
    """
    if not 1 <= degree <= _MOST_DEGREE:
        raise ValueError(f"has degree {degree}; 1 to {_MOST_DEGREE} can be read")
    if count <= degree:
        raise ValueError(f"has {count} control points, too few for degree {degree}")
    if len(knots) != count + degree + 1:
        raise ValueError(
            f"has {len(knots)} knots, not {count + degree + 1} as {count} points of degree {degree} need"
        )
    if np.any(np.diff(knots) < 0):
        raise ValueError("has knots that do not rise")
    if not knots[count] > knots[degree]:
        raise ValueError("has knots that span nothing")
    if np.any(knots[degree:] - knots[:-degree] <= 0) and _has_gap(degree, knots, count):
        raise ValueError("has a knot of a multiplicity above its degree, so it is torn apart there")


def _has_gap(degree: int, knots: Array, count: int) -> bool:
    """Whether an inner knot occurs more often than the degree."""
    inner = knots[(knots > knots[degree]) & (knots < knots[count])]
    _, times = np.unique(inner, return_counts=True)
    return bool(len(times)) and int(times.max()) > degree


def bezier_spans(degree: int, knots: Array, controls: Array) -> Array:
    """Bézier control points (spans, degree + 1, k) of the spans of a B-spline with control points (n, k)."""
    at = np.arange(degree, len(knots) - degree - 1)
    at = at[knots[at + 1] > knots[at]]
    begin, end = knots[at], knots[at + 1]
    spans = np.empty((len(at), degree + 1, controls.shape[1]))
    local = controls[at[:, None] + np.arange(-degree, 1)[None, :]]
    for which in range(degree + 1):
        points = local.copy()
        for level in range(1, degree + 1):
            argument = begin if level <= degree - which else end
            for j in range(degree, level - 1, -1):
                low, high = knots[at + j - degree], knots[at + j + 1 - level]
                share = ((argument - low) / (high - low))[:, None]
                points[:, j] = (1.0 - share) * points[:, j - 1] + share * points[:, j]
        spans[:, which] = points[:, degree]
    return spans


def chained(curves: Sequence[Curve], tolerance: float) -> tuple[list[Curve], float]:
    """Curves in an order and a direction in which each begins where the one before it ends.

    Exporters write the edges of a contour in any order and direction.

    Returns:
        the curves, and the widest gap between neighbours [m], from the last to the first left out. Where no
        curve begins within the tolerance [m], the next in the given order follows, so that a gap shows.
    """
    if not curves:
        return [], 0.0
    ends = np.array([[curve.start, curve.end] for curve in curves])  # (n, 2, 3)
    free = np.ones(len(curves), dtype=bool)
    free[0] = False
    path = [curves[0]]
    head, tail = ends[0]
    widest = 0.0
    while free.any():
        index, side, distance = _next(ends, free, tail)
        if len(path) == 1 and distance > tolerance and _next(ends, free, head)[2] <= tolerance:
            # The first itself runs the other way.
            path[0], head, tail = path[0].reversed(), tail, head
            continue
        widest = max(widest, distance)
        free[index] = False
        path.append(curves[index].reversed() if side else curves[index])
        tail = ends[index, 1 - side]
    return path, widest


def _next(ends: Array, free: npt.NDArray[np.bool_], here: Array) -> tuple[int, int, float]:
    """The first of the nearest free curves: its number, its near end (0 start, 1 end), how far [m]."""
    ways = ends - here
    squares = np.where(free[:, None], np.einsum("nsk,nsk->ns", ways, ways), np.inf)
    index, side = divmod(int(np.argmin(squares)), 2)
    return index, side, math.sqrt(squares[index, side])


def polyline(curves: Sequence[Curve], tolerance: float) -> Array:
    """Points (n, 3) along a path of curves, none twice in a row, whose chords miss it by a tolerance [m]."""
    points = np.concatenate([curve.polyline(tolerance) for curve in curves])
    apart = np.linalg.norm(np.diff(points, axis=0), axis=1) > 1e-3 * tolerance
    return np.asarray(points[np.concatenate([[True], apart])])


def _across(normal: Array) -> Array:
    """A unit vector square to another."""
    axis = np.zeros(3)
    axis[int(np.argmin(np.abs(normal)))] = 1.0
    across = axis - (axis @ normal) * normal
    return np.asarray(across / np.linalg.norm(across))


def _differences(controls: Array) -> Array:
    """Control points of the derivative."""
    degree = controls.shape[1] - 1
    return degree * np.diff(controls, axis=1) if degree else np.zeros_like(controls)


def _bernstein(controls: Array, places: Array) -> Array:
    """Bézier spans (spans, p + 1, k) at places (q,): (spans, q, k)."""
    degree = controls.shape[1] - 1
    powers = np.stack(
        [math.comb(degree, i) * places**i * (1.0 - places) ** (degree - i) for i in range(degree + 1)],
        axis=1,
    )
    return np.asarray(np.einsum("qi,sik->sqk", powers, controls))
