"""Hulls of simple shapes as meshes, x from the stern, z from the keel."""

from __future__ import annotations

from collections.abc import Sequence
from numbers import Integral

import numpy as np
import numpy.typing as npt

from gantline.arguments import listed, number
from gantline.hydro.hull import Hull

__all__ = ["box_hull", "raked_barge", "wigley_hull"]


def box_hull(size: Sequence[float], name: str = "box") -> Hull:
    """A box.

    Args:
        size: length, breadth, depth [m].
        name: What it is called.

    Raises:
        ValueError: if a side is not above zero.
    """
    length, breadth, depth = _sides(name, size)
    return _extruded(name, [(0.0, 0.0), (length, 0.0), (length, depth), (0.0, depth)], breadth)


def raked_barge(size: Sequence[float], rake: float, transom: float, name: str = "barge") -> Hull:
    """A barge whose bottom rises at both ends, over `rake` [m], up to `transom` [m] below its deck.

    Raises:
        TypeError: if a side, rake or transom is no number.
        ValueError: if a side is not above zero, or the rakes do not fit.
    """
    length, breadth, depth = _sides(name, size)
    rake, transom = number(rake, f"{name}: rake", "metres"), number(transom, f"{name}: transom", "metres")
    if not (0 < 2 * rake < length and 0 < transom < depth):
        raise ValueError(f"{name}: rakes of {rake:g} m and ends of {transom:g} m do not fit into its sides")
    sill = depth - transom
    profile = [(rake, 0.0), (length - rake, 0.0), (length, sill), (length, depth), (0.0, depth), (0.0, sill)]
    return _extruded(name, profile, breadth)


def wigley_hull(
    length: float, breadth: float, draft: float, freeboard: float, stations: int = 80, waterlines: int = 40
) -> Hull:
    """Wigley's parabolic hull, y = B/2 (1 - (2x/L)^2)(1 - (z/T)^2), wall-sided above its water.

    Volume 4/9 LBT, waterplane 2/3 LB; the mesh comes close to them with the squares of its numbers.

    Raises:
        TypeError: if a side is no number.
        ValueError: if a side is not above zero, or there are no stations or waterlines.
    """
    length, breadth, draft = _sides("wigley", (length, breadth, draft))
    freeboard = number(freeboard, "wigley: freeboard", "metres")
    for name, count in (("stations", stations), ("waterlines", waterlines)):
        if isinstance(count, bool) or not isinstance(count, Integral) or count < 1:
            raise ValueError(f"wigley: {name}: {count!r} is no whole number from 1 on")
    x = np.linspace(-1.0, 1.0, stations + 1)
    z = np.concatenate([np.linspace(-1.0, 0.0, waterlines + 1), [freeboard / draft]])
    half = breadth / 2 * (1 - x[:, None] ** 2) * (1 - np.minimum(z, 0.0)[None, :] ** 2)
    rows, columns = half.shape
    place = np.stack(
        [
            np.broadcast_to((x[:, None] + 1) * length / 2, half.shape),
            half,
            np.broadcast_to((z[None, :] + 1) * draft, half.shape),
        ],
        axis=2,
    ).reshape(-1, 3)
    points = np.concatenate([place, place * [1, -1, 1]])
    at = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]
    port = np.concatenate(
        [np.stack([a, c, b], axis=2).reshape(-1, 3), np.stack([a, d, c], axis=2).reshape(-1, 3)]
    )
    port = port[
        (points[port, 1] > 1e-12 * breadth).any(axis=1)
    ]  # at its corners both sides lie in the centre plane
    starboard = port[:, ::-1] + rows * columns
    left, right = at[:, -1], at[:, -1] + rows * columns
    deck = np.concatenate(
        [
            np.stack([right[:-1], right[1:], left[1:]], axis=1),
            np.stack([right[:-1], left[1:], left[:-1]], axis=1),
        ]
    )
    return Hull("wigley", points, np.concatenate([port, starboard, deck]))


def _sides(name: str, size: Sequence[float]) -> tuple[float, float, float]:
    for side in listed(size, f"{name}: a list of its sides", "length, breadth and depth [m]"):
        number(side, f"{name}: a side", "metres")
    if len(size) != 3 or not all(np.isfinite(side) and side > 0 for side in size):
        raise ValueError(
            f"{name}: its sides are {', '.join(f'{side:g}' for side in size)} m; three above zero are needed"
        )
    length, breadth, depth = size
    return length, breadth, depth


def _extruded(name: str, profile: Sequence[tuple[float, float]], breadth: float) -> Hull:
    """A convex profile (x, z), counter-clockwise seen from starboard, over the whole breadth."""
    count = len(profile)
    sides = [[(x, side, z) for x, z in profile] for side in (-breadth / 2, breadth / 2)]
    triangles: list[tuple[int, int, int]] = []
    for k in range(count):
        following = (k + 1) % count
        triangles += [(k, following + count, following), (k, k + count, following + count)]
    for k in range(1, count - 1):
        triangles += [(0, k, k + 1), (count, count + k + 1, count + k)]
    faces: npt.NDArray[np.int64] = np.array(triangles, dtype=np.int64)
    return Hull(name, np.array(sides).reshape(-1, 3), faces)
