"""Moments of flat areas up to third order, exactly, from the curves that bound them.

Seen from a point O in the plane, a small piece dq of the boundary spans a triangle with it, of signed area
½ q × dq. Over that triangle ∫ f dA of a homogeneous polynomial f of degree k is (q × dq) f(q)/(k + 2), so

    A = ½ ∮ q × dq,   ∫ q dA = ⅓ ∮ q (q × dq),   ∫ q qᵀ dA = ¼ ∮ q qᵀ (q × dq),   third order with ⅕.

Boundaries run anticlockwise; holes are subtracted. `docs/concepts/cad.md` derives it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from gantline.cad.ocx.curves import Curve, gauss

__all__ = ["Frame", "Moments", "clipped", "enclosed", "kept_half", "of_polygon"]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Frame:
    """Axes of a plane: a point in it and unit vectors, (3,) each; normal = first × second."""

    origin: Array
    first: Array
    second: Array

    @cached_property
    def normal(self) -> Array:
        """Unit normal (3,)."""
        return _across(self.first, self.second)

    @cached_property
    def axes(self) -> Array:
        """Both axes as columns (3, 2)."""
        return np.stack([self.first, self.second], axis=1)

    def flat(self, points: Array) -> Array:
        """Coordinates (..., 2) in the plane of points (..., 3)."""
        return np.asarray((points - self.origin) @ self.axes)

    def spatial(self, points: Array) -> Array:
        """Points (..., 3) of coordinates (..., 2) in the plane."""
        return np.asarray(self.origin + points @ self.axes.T)

    @classmethod
    def across(cls, origin: Array, normal: Array) -> Frame:
        """Axes of the plane through a point with a unit normal."""
        least = int(np.argmin(np.abs(normal)))
        first = np.eye(3)[least] - normal[least] * normal
        first = first / np.linalg.norm(first)
        return cls(origin, first, _across(normal, first))


def _across(one: Array, other: Array) -> Array:
    """Cross product of two vectors (3,), in a tenth of the time that numpy takes for so few."""
    (a, b, c), (x, y, z) = one.tolist(), other.tolist()
    return np.array([b * z - c * y, c * x - a * z, a * y - b * x])


@dataclass(frozen=True, eq=False)
class Moments:
    """Moments of an area about the origin of its plane.

    Attributes:
        area: [m^2].
        first: ∫ q dA (2,) [m^3].
        second: ∫ q qᵀ dA (2, 2) [m^4].
        third: ∫ q q q dA (2, 2, 2) [m^5].
    """

    area: float
    first: Array
    second: Array
    third: Array

    def __add__(self, other: Moments) -> Moments:
        return Moments(
            self.area + other.area,
            self.first + other.first,
            self.second + other.second,
            self.third + other.third,
        )

    def __neg__(self) -> Moments:
        return Moments(-self.area, -self.first, -self.second, -self.third)

    def __sub__(self, other: Moments) -> Moments:
        return self + -other

    @classmethod
    def none(cls) -> Moments:
        """Of nothing."""
        return cls(0.0, np.zeros(2), np.zeros((2, 2)), np.zeros((2, 2, 2)))

    def shifted(self, shift: Array) -> Moments:
        """Of the same area moved by (2,) [m]."""
        first = self.first + self.area * shift
        cross = np.multiply.outer(self.first, shift)
        second = self.second + cross + cross.T + self.area * np.multiply.outer(shift, shift)
        # ∫ (q + d)(q + d)(q + d) dA: every way to choose q or d in each of three places.
        third = self.third + self.area * np.multiply.outer(np.multiply.outer(shift, shift), shift)
        for order in ((0, 1, 2), (0, 2, 1), (2, 0, 1)):
            third = third + np.transpose(np.multiply.outer(self.second, shift), order)
            third = third + np.transpose(
                np.multiply.outer(np.multiply.outer(shift, shift), self.first), order
            )
        return Moments(self.area, first, second, third)


def enclosed(curves: Sequence[Curve], frame: Frame) -> Moments:
    """Moments of what a closed path encloses, positive if it runs anticlockwise about the frame's normal.

    A path that does not end where it begins is closed by a straight line.
    """
    places, weights = [], []
    for curve in curves:
        at, share = gauss(curve.points_per_span)
        points, along, _ = curve.evaluate(at)
        flat, ways = frame.flat(points), along @ frame.axes
        turn = flat[..., 0] * ways[..., 1] - flat[..., 1] * ways[..., 0]
        places.append(flat.reshape(-1, 2))
        weights.append((turn * share).reshape(-1))
    total = _sums(np.concatenate(places), np.concatenate(weights))
    ends = frame.flat(np.stack([curves[-1].end, curves[0].start]))
    return total + of_polygon(np.concatenate([ends, np.zeros((1, 2))]))


def _sums(places: Array, weights: Array) -> Moments:
    return Moments(
        float(weights.sum()) / 2,
        weights @ places / 3,
        np.einsum("n,ni,nj->ij", weights, places, places) / 4,
        np.einsum("n,ni,nj,nk->ijk", weights, places, places, places) / 5,
    )


def of_polygon(corners: Array) -> Moments:
    """Moments of a polygon with corners (n, 2), positive if they run anticlockwise."""
    # Cubic polynomials times the linear way along a side: three Gauss points are exact.
    at, share = gauss(3)
    ways = np.roll(corners, -1, axis=0) - corners
    points = corners[:, None, :] + at[None, :, None] * ways[:, None, :]
    turn = corners[:, 0] * ways[:, 1] - corners[:, 1] * ways[:, 0]
    return _sums(points.reshape(-1, 2), (turn[:, None] * share[None, :]).reshape(-1))


def clipped(polygon: Array, triangle: Array) -> Array:
    """What of a polygon (n, 2) lies in a triangle (3, 2) whose corners run anticlockwise: corners (k, 2).

    Sutherland and Hodgman (Communications of the ACM 17, 1974): side by side. Where several pieces are left,
    they hang together by lines of no width, which no integral sees.
    """
    for corner, following in zip(triangle, np.roll(triangle, -1, axis=0), strict=True):
        if not len(polygon):
            break
        way = following - corner
        inside = way[0] * (polygon[:, 1] - corner[1]) - way[1] * (polygon[:, 0] - corner[0])
        polygon = kept_half(polygon, inside)
    return polygon


def kept_half(polygon: Array, inside: Array) -> Array:
    """A polygon (n, 2) where a linear function, given at its corners (n,), is not negative."""
    if np.all(inside >= 0):
        return polygon
    if np.all(inside < 0):
        return polygon[:0]
    after, inside_after = np.roll(polygon, -1, axis=0), np.roll(inside, -1)
    crosses = (inside >= 0) != (inside_after >= 0)
    share = np.divide(inside, inside - inside_after, out=np.zeros_like(inside), where=crosses)
    cuts = polygon + share[:, None] * (after - polygon)
    both = np.stack([polygon, cuts], axis=1).reshape(-1, 2)
    kept = np.stack([inside >= 0, crosses], axis=1).reshape(-1)
    return np.asarray(both[kept])
