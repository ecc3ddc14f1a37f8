"""Floating bodies for verification: meshes of simple hulls, and what the water does to them as documents."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics import Json

#: Sea water [kg/m³].
SEA = 1025.0


def box_hull(size: Sequence[float]) -> tuple[list[list[float]], list[list[int]]]:
    """A box of length, breadth and depth [m]: x from the middle of its length, z from the keel."""
    length, breadth, depth = size
    corners = [
        [x, y, z] for x in (-length / 2, length / 2) for y in (-breadth / 2, breadth / 2) for z in (0, depth)
    ]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, [triangle for a, b, c, d in faces for triangle in ([a, b, c], [a, c, d])]


def sphere_hull(radius: float, rings: int) -> tuple[list[list[float]], list[list[int]]]:
    """A sphere about the origin with the volume of the smooth one, of `rings` bands and twice as many
    sectors.
    """
    sectors = 2 * rings
    latitude = np.repeat(np.arange(1, rings) * np.pi / rings, sectors)
    angle = np.tile(np.arange(sectors) * np.pi / rings, rings - 1)
    flat = np.sin(latitude)
    around = np.stack([flat * np.cos(angle), flat * np.sin(angle), -np.cos(latitude)], axis=1)
    points = np.concatenate([[[0, 0, -1]], around, [[0, 0, 1]]])
    top = len(points) - 1
    triangles = []
    for sector in range(sectors):
        this, right = 1 + sector, 1 + (sector + 1) % sectors
        triangles.append([0, right, this])
        for ring in range(rings - 2):
            a, b = this + ring * sectors, right + ring * sectors
            triangles += [[a, b, b + sectors], [a, b + sectors, a + sectors]]
        last = (rings - 2) * sectors
        triangles.append([top, this + last, right + last])
    faces = np.array(triangles)
    volume = np.linalg.det(points[faces]).sum() / 6
    scale = radius * (4 / 3 * math.pi / volume) ** (1 / 3)
    return (scale * points).tolist(), faces.tolist()


def buoyancy(
    body: str,
    hull: tuple[list[list[float]], list[list[int]]],
    *,
    name: str = "hull",
    density: float = SEA,
    level: float = 0.0,
) -> Json:
    """The hull of a body in water whose surface is at `level` [m]."""
    return {
        "type": "buoyancy",
        "name": name,
        "body": body,
        "vertices": hull[0],
        "triangles": hull[1],
        "density": density,
        "level": level,
    }


def added_mass(body: str, at: Sequence[float], diagonal: Sequence[float]) -> Json:
    """Water that moves along: surge, sway, heave [kg], roll, pitch, yaw [kg m²]."""
    matrix = np.diag(np.asarray(diagonal, dtype=float)).tolist()
    return {"type": "added_mass", "name": f"{body}.added", "body": body, "at": list(at), "matrix": matrix}


def drag(body: str, at: Sequence[float], linear: Sequence[float], quadratic: Sequence[float]) -> Json:
    """Resistance of six motions [N s/m, N m s], [N s²/m², N m s²]."""
    damping = np.diag(np.asarray(linear, dtype=float)).tolist()
    return {
        "type": "drag",
        "name": f"{body}.drag",
        "body": body,
        "at": list(at),
        "damping": damping,
        "quadratic": list(quadratic),
    }


def pitch_and_roll(orientation: NDArray[np.float64]) -> tuple[Any, Any]:
    """Angles of the body's x and y axes above the horizon [rad], of quaternions (…, wxyz)."""
    w, x, y, z = np.moveaxis(orientation, -1, 0)
    return np.arcsin(2 * (x * z - w * y)), np.arcsin(2 * (y * z + w * x))
