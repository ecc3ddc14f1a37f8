"""Rigid bodies in equations that tests write on their own: attitudes and what a cross product does."""

from __future__ import annotations

import numpy as np

from mechanics import Floats, G, Xyz


def axes(attitude: Floats) -> Floats:
    """Rotation from the body's axes to the world's, shape (3, 3), of a quaternion, w first."""
    w, x, y, z = attitude.tolist()
    # Two over its square, which need not be one.
    k = 2 / (w * w + x * x + y * y + z * z)
    return np.array(
        [
            [1 - k * (y * y + z * z), k * (x * y - w * z), k * (x * z + w * y)],
            [k * (x * y + w * z), 1 - k * (x * x + z * z), k * (y * z - w * x)],
            [k * (x * z - w * y), k * (y * z + w * x), 1 - k * (x * x + y * y)],
        ]
    )


def turning(attitude: Floats, spin: Floats) -> Floats:
    """Rate of a quaternion, ½ q ω, by the angular velocity in the body's axes [rad/s]."""
    w, x, y, z = attitude.tolist()
    p, q, r = spin.tolist()
    return 0.5 * np.array(
        [-x * p - y * q - z * r, w * p + y * r - z * q, w * q + z * p - x * r, w * r + x * q - y * p]
    )


def across(vector: Xyz) -> Floats:
    """Matrix of the cross product with a vector from the left, shape (3, 3)."""
    x, y, z = vector
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def cross(one: Floats, other: Floats) -> Floats:
    """Cross product of two vectors; numpy's own takes ten times as long for one pair."""
    (a, b, c), (x, y, z) = one.tolist(), other.tolist()
    return np.array([b * z - c * y, c * x - a * z, a * y - b * x])


def moments(arms: Floats, forces: Floats) -> Floats:
    """Sum of the cross products of arms (n, 3) with forces (n, 3), shape (3,)."""
    (_, xy, xz), (yx, _, yz), (zx, zy, _) = (arms.T @ forces).tolist()
    return np.array([yz - zy, zx - xz, xy - yx])


def about(mass: float, place: Floats) -> Floats:
    """Inertia of a mass at a place, about the origin, shape (3, 3) [kg m²]."""
    return mass * (place @ place * np.eye(3) - np.outer(place, place))


def points_of(body: Floats, places: Floats) -> tuple[Floats, Floats]:
    """Where points of a body are [m] and how fast they move [m/s], in the world, shape (n, 3).

    Args:
        body: Centre of gravity [m], attitude, velocity [m/s], spin in its own axes [rad/s], shape (13,).
        places: Of the points, from the centre of gravity, in the body's axes, shape (n, 3) [m].
    """
    back = axes(body[3:7]).T
    return body[:3] + places @ back, body[7:10] + places @ across(body[10:13]).T @ back


def rates_of(body: Floats, mass: float, inertia: Floats, pulls: Floats, points: Floats) -> Floats:
    """Rates of a body, as `points_of` has it, by Newton and Euler: its weight and pulls [N] at points [m].

    Args:
        body: As `points_of` has it.
        mass: [kg].
        inertia: About the centre of gravity, shape (3, 3) [kg m²].
        pulls: In the world, shape (n, 3).
        points: Where they act, shape (n, 3).
    """
    spin = body[10:13]
    own = moments(points - body[:3], pulls) @ axes(body[3:7]) - cross(spin, inertia @ spin)
    falls = pulls.sum(axis=0) / mass - (0.0, 0.0, G)
    return np.concatenate([body[7:10], turning(body[3:7], spin), falls, np.linalg.solve(inertia, own)])
