"""Directions of bodies from their unit quaternions (w, x, y, z; world from body)."""

from __future__ import annotations

import math

import numpy as np

from gantline.results.variable import FloatArray

#: Turn about a level axis up to which what remains of an attitude is a turn about plumb [rad].
_TIPPED = math.radians(160.0)


def axes(orientation: FloatArray) -> FloatArray:
    """Rotation matrices of unit quaternions.

    Args:
        orientation: Quaternions world from body, shape (..., 4).

    Returns:
        Matrices world from body, shape (..., 3, 3); their columns are the body's axes.
    """
    w, x, y, z = np.moveaxis(np.asarray(orientation, dtype=np.float64), -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def tilt(orientation: FloatArray) -> FloatArray:
    """Angle between a body's own z axis and plumb [rad], shape (...)."""
    up = axes(orientation)[..., :, 2]
    angle: FloatArray = np.arctan2(np.hypot(up[..., 0], up[..., 1]), up[..., 2])
    return angle


def heading(orientation: FloatArray) -> FloatArray:
    """Angle of a body's own x axis from world x, seen from above, counter-clockwise [rad], shape (...)."""
    forward = axes(orientation)[..., :, 0]
    angle: FloatArray = np.arctan2(forward[..., 1], forward[..., 0])
    return angle


def turn_about_plumb(orientation: FloatArray) -> FloatArray:
    """How far a body has turned about plumb since its first attitude, counter-clockwise from above.

    Every turn is one about a level axis, the least that brings plumb to where the body then has it, followed
    by one about plumb. This second one is that of a column which is upended and then turns below its hook,
    whose own x axis is upright and has no heading.

    Args:
        orientation: Unit quaternions world from body, shape (time, 4).

    Returns:
        Angles without jumps [rad], shape (time,); NaN where the turn about the level axis is more than
        160 degrees: turned upside down, a body may have come there about any axis.
    """
    w, x, y, z = np.moveaxis(orientation, -1, 0)
    w0, x0, y0, z0 = orientation[0]
    # q conj(q0): its real part and that along plumb, cos and sin of half the turn times cos of half the tip.
    along = w * w0 + x * x0 + y * y0 + z * z0
    about = z * w0 - w * z0 - x * y0 + y * x0
    angle = np.full(len(orientation), np.nan)
    known = np.hypot(along, about) >= math.cos(_TIPPED / 2)
    angle[known] = np.unwrap(2.0 * np.arctan2(about[known], along[known]))
    return angle


def angle_between(orientation_a: FloatArray, orientation_b: FloatArray) -> FloatArray:
    """Angle of the turn that takes one attitude to another [rad].

    Args:
        orientation_a: Quaternions world from body of any length but 0, shape (..., 4).
        orientation_b: The same, shape (..., 4).

    Returns:
        Angles from 0 to pi, shape (...); exactly 0 for equal quaternions.
    """
    real_a, real_b = orientation_a[..., :1], orientation_b[..., :1]
    vector_a, vector_b = orientation_a[..., 1:], orientation_b[..., 1:]
    # conj(a) b; its vector part keeps its size when a and b change places, to the last bit.
    across = (real_a * vector_b - real_b * vector_a) - np.cross(vector_a, vector_b)
    along = np.sum(orientation_a * orientation_b, axis=-1)
    angle: FloatArray = 2.0 * np.arctan2(np.linalg.norm(across, axis=-1), np.abs(along))
    return angle
