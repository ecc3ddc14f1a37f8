"""Rigid bodies in equations that tests write on their own: attitudes and what a cross product does."""

from __future__ import annotations

import numpy as np

from mechanics import Floats, Xyz


def axes(attitude: Floats) -> Floats:
    """Rotation from the body's axes to the world's, shape (3, 3), of a quaternion, w first."""
    w, x, y, z = attitude / np.sqrt(attitude @ attitude)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def turning(attitude: Floats, spin: Floats) -> Floats:
    """Rate of a quaternion, ½ q ω, by the angular velocity in the body's axes [rad/s]."""
    w, x, y, z = attitude
    p, q, r = spin
    return 0.5 * np.array(
        [-x * p - y * q - z * r, w * p + y * r - z * q, w * q + z * p - x * r, w * r + x * q - y * p]
    )


def across(vector: Xyz) -> Floats:
    """Matrix of the cross product with a vector from the left, shape (3, 3)."""
    x, y, z = vector
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def about(mass: float, place: Floats) -> Floats:
    """Inertia of a mass at a place, about the origin, shape (3, 3) [kg m²]."""
    return mass * (place @ place * np.eye(3) - np.outer(place, place))
