"""Vectors, unit quaternions (wxyz, world_from_body) and inertias, as far as assembling needs them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

__all__ = [
    "IDENTITY",
    "Array",
    "about_axis",
    "inertia_list",
    "inertia_matrix",
    "quaternion_product",
    "rotation_matrix",
    "rotation_quaternion",
    "rotation_vector",
    "solid_box",
    "unit",
]

Array = npt.NDArray[np.float64]

#: The quaternion of no turn.
IDENTITY = (1.0, 0.0, 0.0, 0.0)


def unit(direction: Sequence[float]) -> list[float]:
    """Direction with length 1."""
    size = math.sqrt(sum(part * part for part in direction))
    return [part / size for part in direction]


def about_axis(axis: Sequence[float], angle: float) -> list[float]:
    """Quaternion of a turn by an angle [rad] about an axis."""
    half = angle / 2
    return [math.cos(half), *(part * math.sin(half) for part in unit(axis))]


def rotation_vector(vector: Sequence[float]) -> list[float]:
    """Quaternion of the turn about a vector by its length [rad]."""
    angle = math.sqrt(sum(part * part for part in vector))
    return about_axis(vector, angle) if angle > 0 else list(IDENTITY)


def quaternion_product(first: Sequence[float], second: Sequence[float]) -> list[float]:
    """Quaternion of the turn `second` followed by the turn `first`."""
    a, b, c, d = first
    e, f, g, h = second
    return [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]


def rotation_matrix(quaternion: Sequence[float]) -> Array:
    """Matrix (3, 3) of a unit quaternion."""
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def rotation_quaternion(matrix: Array) -> list[float]:
    """Unit quaternion of a rotation matrix (3, 3)."""
    # The largest of four squares, so that nothing small is divided by (Shepperd 1978).
    trace = float(np.trace(matrix))
    squares = [trace, *(2.0 * float(matrix[i, i]) - trace for i in range(3))]
    largest = int(np.argmax(squares))
    skew = [float(matrix[k, j] - matrix[j, k]) for j, k in ((1, 2), (2, 0), (0, 1))]
    if largest == 0:
        parts = [1.0 + trace, *skew]
    else:
        i = largest - 1
        both = [float(matrix[i, j] + matrix[j, i]) for j in range(3)]
        both[i] = 1.0 + squares[largest]
        parts = [skew[i], *both]
    return unit(parts)


def solid_box(mass: float, sizes: Sequence[float]) -> Array:
    """Inertia (3, 3) of a homogeneous box about its middle [kg m^2]; `sizes` along x, y, z [m]."""
    x, y, z = (size * size for size in sizes)
    return np.diag([y + z, x + z, x + y]) * (mass / 12)


def inertia_matrix(values: Sequence[float]) -> Array:
    """Matrix (3, 3) of xx, yy, zz, xy, xz, yz."""
    xx, yy, zz, xy, xz, yz = values
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def inertia_list(matrix: Array) -> list[float]:
    """The values xx, yy, zz, xy, xz, yz of a matrix (3, 3)."""
    return [float(matrix[place]) for place in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
