"""Lagrange's equations by themselves: a second solution of small systems that shares nothing with gantline.

A rigid body is six points of a sixth of its mass each, with the same second moments. All that a system
says of itself is where its points x are over its coordinates q, and what generalised forces Q there are;
everything else is differentiation:

    J = ∂x/∂q        Σ m Jᵀ J q̈ = Q + Σ m Jᵀ (g − d²x/ds²)        s along q̇

First derivatives are complex steps, exact to rounding. The second derivative along q̇ is a central
difference of fourth order of them, right to about 1e-11 of itself.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from mechanics import Floats, G

#: Arrays that may be complex, with a leading axis of several evaluations side by side.
Batch = NDArray[Any]
#: Rotations (k, 3, 3) and origins (k, 3) [m] of bodies.
Frames = Sequence[tuple[Batch, Batch]]
_TINY = 1e-40
_FALL = np.array([0.0, 0.0, -G])


def turned(axis: Sequence[float] | Floats, angle: Batch) -> Batch:
    """Rotations about a unit axis by angles (k,) [rad]: (k, 3, 3)."""
    x, y, z = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    sine, cosine = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.asarray(np.eye(3) + sine * cross + (1 - cosine) * (cross @ cross))


def quaternion(rotation: Floats) -> list[float]:
    """The unit quaternion, w first, of a rotation (3, 3) by less than half a turn."""
    w = np.sqrt(1 + np.trace(rotation)) / 2
    axis = [rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]]
    return [float(w), *(float(part) / (4 * float(w)) for part in axis)]


def at(frames: Frames, body: int | None, place: Sequence[float] | Floats) -> Batch:
    """Points of a body, or of the world (k, 3) [m]: `frames` are rotations (k, 3, 3) and origins (k, 3)."""
    if body is None:
        return np.broadcast_to(np.asarray(place), frames[0][1].shape)
    rotation, origin = frames[body]
    return np.asarray(origin + rotation @ np.asarray(place))


def spin(turn: Callable[[Batch], Batch], angles: Floats, rates: Floats) -> tuple[list[float], list[float]]:
    """Quaternion and angular velocity in body axes [rad/s] of a body turned by `turn` of angles (k, 3)."""
    moved = turn((angles + 1j * _TINY * rates)[None])[0]
    rotation = moved.real
    rate = rotation.T @ (moved.imag / _TINY)
    return quaternion(rotation), [float(rate[2, 1]), float(rate[0, 2]), float(rate[1, 0])]


def yaw_pitch_roll(angles: Batch) -> Batch:
    """Rotations about z, the new y and the new x by angles (…, 3) [rad]: (…, 3, 3).

    The product of the three written out, which takes a tenth of the time.
    """
    sines, cosines = np.sin(angles), np.cos(angles)
    (sz, sy, sx), (cz, cy, cx) = ([part[..., k] for k in range(3)] for part in (sines, cosines))
    rows = (
        (cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx),
        (sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx),
        (-sy, cy * sx, cy * cx),
    )
    turn = np.empty((*angles.shape, 3), dtype=angles.dtype)
    for i, row in enumerate(rows):
        for j, part in enumerate(row):
            turn[..., i, j] = part
    return turn


def distance(one: Batch, other: Batch) -> Batch:
    """Between points (…, 3), without the absolute value that spoils complex steps: (…)."""
    way = one - other
    return np.asarray(np.sqrt((way * way).sum(axis=-1)))


def six_points(mass: float, centre: Sequence[float] | Floats, inertia: Floats) -> Floats:
    """Six points of mass/6 [m] with the centre and the inertia (3, 3) [kg m²] about it: (6, 3)."""
    second = np.trace(inertia) / 2 * np.eye(3) - inertia
    sizes, axes = np.linalg.eigh(second)
    arms = axes * np.sqrt(3 * sizes.clip(0) / mass)
    return np.asarray(np.asarray(centre) + np.concatenate([arms.T, -arms.T]))


def of_bodies(frames: Sequence[tuple[Batch, Batch]], points: Sequence[Floats]) -> Batch:
    """Points of bodies (k, n, 3) [m], by rotations (k, 3, 3), origins (k, 3) and points (m, 3) of each."""
    placed = zip(frames, points, strict=True)
    return np.concatenate([origin[:, None] + _arms(turn, own) for (turn, origin), own in placed], axis=1)


def _arms(turns: Batch, points: Floats) -> Batch:
    """Points (m, 3) [m] under rotations (k, 3, 3): (k, m, 3); one product is faster than one for each."""
    return (turns.reshape(-1, 3) @ points.T).reshape(-1, 3, len(points)).transpose(0, 2, 1)


@dataclass(frozen=True)
class Lagrange:
    """A system.

    Attributes:
        masses: of its points (n,) [kg].
        points: where they are (k, n, 3) [m], over q (k, degrees of freedom).
        force: generalised forces over t, q and q̇, but for weight.
        driven: q̈ over t of coordinates that follow a law in time, by their number.
    """

    masses: Floats
    points: Callable[[Batch], Batch]
    force: Callable[[float, Floats, Floats], Floats]
    driven: dict[int, Callable[[float], float]] | None = None

    def rates(self, time: float, state: Floats) -> Floats:
        """(q̇, q̈) of (q, q̇)."""
        q, v = np.split(state, 2)
        count = len(q)
        step = 2e-3 / max(float(np.linalg.norm(v)), 1.0)
        near = np.array([-2, -1, 1, 2])[:, None] * step * v + 1j * _TINY * v
        moved = self.points(q + np.concatenate([1j * _TINY * np.eye(count), near])).imag / _TINY
        jacobian = moved[:count]
        back_2, back, on, on_2 = moved[count:]
        bend = (back_2 - on_2 + 8 * (on - back)) / (12 * step)
        weighed = (self.masses[:, None] * jacobian).reshape(count, -1)
        mass = weighed @ jacobian.reshape(count, -1).T
        right = weighed @ (_FALL - bend).ravel()
        right += self.force(time, q, v)
        if not self.driven:
            return np.concatenate([v, np.linalg.solve(mass, right)])
        acceleration = np.zeros(count)
        for index, law in self.driven.items():
            acceleration[index] = law(time)
        free = [index for index in range(count) if index not in self.driven]
        right = right - mass @ acceleration
        acceleration[free] = np.linalg.solve(mass[np.ix_(free, free)], right[free])
        return np.concatenate([v, acceleration])

    def run(self, q: Floats, v: Floats, times: Floats, tolerance: float = 1e-11) -> Floats:
        """(q, q̇) at times that begin with 0 (time, 2 degrees of freedom), within a tolerance of a step."""
        start, small = np.concatenate([q, v]), tolerance / 10
        found = solve_ivp(self.rates, (0, times[-1]), start, "DOP853", times, rtol=tolerance, atol=small)
        assert found.success, found.message
        return np.asarray(found.y.T)


def derivative(function: Callable[[Batch], Batch], q: Floats) -> tuple[Floats, Floats]:
    """What a function of q (k, n) gives at one q, (m,), and its gradient there (m, n)."""
    answers = function(q + 1j * _TINY * np.eye(len(q)))
    return answers[0].real, answers.imag.T / _TINY
