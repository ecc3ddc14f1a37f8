"""Openings of plates: which of them cut a plate, and what each takes that no other has taken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import accumulate

import numpy as np
import numpy.typing as npt

from gantline.cad.ocx.curves import Curve, polyline
from gantline.cad.ocx.moments import Frame, clipped, kept_half, of_polygon
from gantline.cad.ocx.triangulate import simplified, triangulated

__all__ = ["Opening", "each_once", "is_off", "near", "parted"]

Array = npt.NDArray[np.float64]

_SLIVER = 1e-6  # share of an opening that is nothing of it
_JOINED = 1e-4  # m; two openings that are nearer to each other are one
_MOST_OVERLAPPING = 3  # openings that one overlaps; each costs more than those before
_ALONG = 0.5  # cosine between the planes of plate and opening, below which it is of another plate
_OTHER_PLANE = 0.1  # m from the plane of a plate, where an opening cuts another plate of its panel


@dataclass(frozen=True, eq=False)
class Opening:
    """An opening, seen along the normal of a plate.

    Attributes:
        path: its contour.
        polygon: its corners (n, 2) in the plate's plane [m].
        pieces: polygons (k, 2) of what it takes that no opening before it has taken.
        is_alone: whether that is all of it.
    """

    path: Sequence[Curve]
    polygon: Array
    pieces: tuple[Array, ...]
    is_alone: bool = True

    @classmethod
    def of(cls, path: Sequence[Curve], frame: Frame, tolerance: float) -> Opening:
        """An opening by itself."""
        polygon = frame.flat(polyline(path, tolerance))
        return cls(path, polygon, (polygon,))


def each_once(openings: Sequence[Opening]) -> list[Opening]:
    """Openings that overlap take once what they share: a panel and its plate may both name the same one.

    Raises:
        ValueError: if very many overlap.
    """
    apart: list[Opening] = []
    for opening in openings:
        if not any(_is_same(opening.polygon, other.polygon) for other in apart):
            apart.append(opening)
    found: list[Opening] = []
    for place, opening in enumerate(apart):
        others = [other.polygon for other in apart[:place] if _touches(opening.polygon, other.polygon)]
        if not others:
            found.append(opening)
            continue
        own = abs(of_polygon(opening.polygon).area)
        triangles = _triangles(opening.polygon)
        taken = [
            other
            for other in map(_triangles, others)
            if any(
                total > _SLIVER * own
                for total in accumulate(_shared(triangle, other) for triangle in triangles)
            )
        ]
        if not taken:
            found.append(opening)
            continue
        if len(taken) > _MOST_OVERLAPPING:
            raise ValueError(f"one of its openings overlaps {len(taken)} others")
        least, before = _SLIVER * own / len(triangles), np.concatenate(taken)
        rest = [
            piece for triangle in triangles for piece in _without(triangle, near(triangle, before), least)
        ]
        if sum(of_polygon(piece).area for piece in rest) > _SLIVER * own:
            found.append(replace(opening, pieces=tuple(rest), is_alone=False))
    return found


def _is_same(one: Array, other: Array) -> bool:
    return one.shape == other.shape and bool(np.allclose(one, other, rtol=0, atol=_JOINED))


def _triangles(polygon: Array) -> Array:
    """Triangles (t, 3, 2) of a polygon (n, 2), anticlockwise."""
    corners, indices = triangulated(simplified(polygon, 0.0))
    return np.asarray(corners[indices])


def _touches(one: Array, other: Array) -> bool:
    """Whether the boxes of two polygons touch."""
    return bool(np.all(one.max(axis=0) >= other.min(axis=0)) and np.all(one.min(axis=0) <= other.max(axis=0)))


def _without(polygon: Array, triangles: Array, least: float) -> list[Array]:
    """What triangles (n, 3, 2) leave of a convex polygon (k, 2), in convex pieces of some area [m^2]."""
    pieces = [polygon]
    for triangle in triangles:
        left: list[Array] = []
        for piece in pieces:
            shared = clipped(piece, triangle) if _touches(piece, triangle) else piece[:0]
            if len(shared) < 3 or of_polygon(shared).area <= least:
                left.append(piece)
                continue
            inside = piece
            for corner, following in zip(triangle, np.roll(triangle, -1, axis=0), strict=True):
                way = following - corner
                side = way[0] * (inside[:, 1] - corner[1]) - way[1] * (inside[:, 0] - corner[0])
                beyond = kept_half(inside, -side)
                if len(beyond) >= 3 and of_polygon(beyond).area > least:
                    left.append(beyond)
                inside = kept_half(inside, side)
        pieces = left
    return pieces


def is_off(path: Sequence[Curve], frame: Frame, tolerance: float) -> bool:
    """Whether an opening is in another plane than a plate: in that of another plate of its panel."""
    points = polyline(path, tolerance)
    away = (points - frame.origin) @ frame.normal
    around = points - points.mean(axis=0)
    normal = np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0)
    askew = abs(float(normal @ frame.normal)) < _ALONG * float(np.linalg.norm(normal))
    return askew or float(np.abs(away).min()) > _OTHER_PLANE


def parted(rim: Array, openings: Sequence[Opening]) -> tuple[list[Opening], list[Opening]]:
    """Openings within the rim, and those that run over it or over others; others cut nothing."""
    rim = rim if of_polygon(rim).area > 0 else rim[::-1]
    if not openings:
        return [], []
    corners, triangles = triangulated(rim)
    inner, across = [], []
    for opening in openings:
        own = abs(of_polygon(opening.polygon).area)
        shared = sum(_shared(piece, corners[triangles]) for piece in opening.pieces)
        if opening.is_alone and shared >= own * (1 - _SLIVER):
            inner.append(opening)
        elif shared > own * _SLIVER:
            across.append(opening)
    return inner, across


def _shared(polygon: Array, triangles: Array) -> float:
    """Area that a polygon shares with triangles that do not overlap."""
    return sum(abs(of_polygon(clipped(polygon, triangle)).area) for triangle in near(polygon, triangles))


def near(polygon: Array, triangles: Array) -> Array:
    """Those triangles (n, 3, 2) whose boxes touch that of a polygon."""
    touches = (triangles.max(axis=1) >= polygon.min(axis=0)) & (triangles.min(axis=1) <= polygon.max(axis=0))
    return np.asarray(triangles[touches.all(axis=1)])
