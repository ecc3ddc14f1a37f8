"""Rigid bodies in equations that tests write on their own: attitudes and what a cross product does."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from mechanics import Floats, G, Xyz


def axes(attitude: Floats) -> Floats:
    """Rotation from the body's axes to the world's, shape (3, 3), of a quaternion, w first."""
    w, x, y, z = (attitude / np.sqrt(attitude @ attitude)).tolist()
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
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


def point_of(body: Floats, place: Floats) -> tuple[Floats, Floats]:
    """Where a point of a body is [m] and how fast it moves [m/s], in the world.

    Args:
        body: Centre of gravity [m], attitude, velocity [m/s], spin in its own axes [rad/s], shape (13,).
        place: Of the point, from the centre of gravity, in the body's axes [m].
    """
    turned = axes(body[3:7])
    return body[:3] + turned @ place, body[7:10] + turned @ cross(body[10:13], place)


def rates_of(body: Floats, mass: float, inertia: Floats, pulls: Iterable[tuple[Floats, Floats]]) -> Floats:
    """Rates of a body, as `point_of` has it, by Newton and Euler: its weight and pulls [N] at points [m].

    Args:
        body: As `point_of` has it.
        mass: [kg].
        inertia: About the centre of gravity, shape (3, 3) [kg m²].
        pulls: In the world, with the points where they act.
    """
    force, moment = np.array([0.0, 0.0, -mass * G]), np.zeros(3)
    for pull, point in pulls:
        force = force + pull
        moment = moment + cross(point - body[:3], pull)
    spin = body[10:13]
    own = axes(body[3:7]).T @ moment - cross(spin, inertia @ spin)
    return np.concatenate([body[7:10], turning(body[3:7], spin), force / mass, np.linalg.solve(inertia, own)])
