"""Static equilibrium of a load on the contact springs under its corners."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gantline.assembly.spatial import Array, rotation_matrix, rotation_vector

__all__ = ["Resting", "TipsOver", "rest_on_ground", "rest_on_rim"]

_MOST_STEPS = 500
_TOLERANCE = 1e-9
_SMALLEST_FRACTION = 1e-6
#: Largest turn in one step, and the turn beyond which the load has fallen [rad].
_LARGEST_TURN = 0.05
_FALLEN = 0.5
#: Within what tilt, as a sine, the end of a round body is domed: as the core has it in `contact/rim.rs`.
_DOME = 1e-3


class TipsOver(ValueError):
    """The load does not rest on its corners: its centre of gravity is not over the area between them."""


@dataclass(frozen=True)
class Resting:
    """How a load rests.

    Attributes:
        height: centre of gravity above the ground [m].
        turn: rotation vector from the given attitude, in world axes [rad]; never about the vertical.
        forces: force of each corner's spring [N].
    """

    height: float
    turn: tuple[float, float, float]
    forces: Array


def rest_on_ground(corners: Array, weight: float, stiffness: float) -> Resting:
    """Height and tilt at which the springs under the corners carry the weight.

    Minimises the potential energy W z + sum k/2 max(0, depth)^2 over the height z and the two tilts by
    Newton's method with halved steps; only corners below the ground push.

    Args:
        corners: positions (n, 3) from the centre of gravity, world axes, before any tilt [m].
        weight: weight of the load [N].
        stiffness: stiffness under each corner [N/m].

    Raises:
        TipsOver: if no such position exists near the given attitude.
    """
    largest = float(np.abs(corners).max())
    scale = np.array([1.0, 1 / largest, 1 / largest])  # tilts count as heights at the farthest corner
    # A depth is a small difference of heights: its rounding, as a force of all springs, is the best there is.
    rounding = 4 * len(corners) * float(np.finfo(float).eps) * largest * stiffness
    state = np.array([-float(corners[:, 2].min()) - weight / (len(corners) * stiffness), 0.0, 0.0])
    for _ in range(_MOST_STEPS):
        gradient, hessian, energy = _derivatives(state, corners, weight, stiffness)
        residual = float(np.abs(gradient * scale).max())
        balanced = residual <= max(rounding, _TOLERANCE * weight)
        step = _newton_step(gradient * scale, hessian * np.outer(scale, scale), stiffness) * scale
        fraction = min(1.0, _LARGEST_TURN / max(_LARGEST_TURN, float(np.abs(step[1:]).max())))
        while fraction > _SMALLEST_FRACTION:
            after = state + fraction * step
            changed, _, lower = _derivatives(after, corners, weight, stiffness)
            remains = float(np.abs(changed * scale).max())
            # In balance, rounding moves the energy up and down; only a clear gain is worth a step there.
            if remains < residual / 2 if balanced else (lower < energy or remains < residual):
                break
            fraction /= 2
        else:  # no step betters this state
            if not balanced:
                break
            if np.linalg.eigvalsh(hessian * np.outer(scale, scale))[0] < _TOLERANCE * stiffness:
                break
            forces = stiffness * np.maximum(0.0, _depths(state, corners))
            return Resting(float(state[0]), (float(state[1]), float(state[2]), 0.0), forces)
        state = after
        if float(np.abs(state[1:]).max()) > _FALLEN:
            break
    raise TipsOver


def rest_on_rim(centre: Array, radius: float, weight: float, stiffness: float) -> Resting:
    """How a round load stands on the rim of its foot, by (RL8): that presses under its centre of gravity.

    Args:
        centre: of gravity, from the middle of the foot, world axes, before any tilt (3,) [m].
        radius: of the rim [m].
        weight: of the load [N].
        stiffness: of the rim [N/m].

    Raises:
        TipsOver: if it does not stand within what the foot tilts on its own dome.
    """
    aside, above = float(np.hypot(*centre[:2])), float(centre[2])
    if radius <= aside + above * _DOME:
        raise TipsOver
    least, most = 0.0, _DOME
    for _ in range(_MOST_STEPS):
        lean = (least + most) / 2
        share = lean / _DOME
        is_under = radius * (1.5 * share - 0.5 * share**3) < aside + above * lean
        least, most = (lean, most) if is_under else (least, lean)
    lean = 0.0 if aside == 0.0 else (least + most) / 2
    share = (lean / _DOME) ** 2
    sunk = radius * _DOME * (0.375 + share * (0.75 - 0.125 * share)) - weight / stiffness
    towards = centre[:2] / aside if aside > 0.0 else np.zeros(2)
    height = sunk + above * np.sqrt(1.0 - lean**2) - aside * lean
    turn = float(np.arcsin(lean)) * np.array([-towards[1], towards[0]])
    return Resting(float(height), (float(turn[0]), float(turn[1]), 0.0), np.array([weight]))


def _depths(state: Array, corners: Array) -> Array:
    turned = corners @ rotation_matrix(rotation_vector((state[1], state[2], 0.0))).T
    depths: Array = -(state[0] + turned[:, 2])
    return depths


def _heights(tilt: Array, corners: Array) -> tuple[Array, Array, Array]:
    """Corner heights under the rotation vector (a, b, 0), with first and second derivatives by a and b.

    Rodrigues: z = z0 c + s (a y - b x) with c = cos t, s = sin(t)/t, t^2 = a^2 + b^2; the term along the axis
    has no z part.
    """
    a, b = float(tilt[0]), float(tilt[1])
    square = a * a + b * b
    angle = np.sqrt(square)
    if angle < 1e-4:  # series in t^2
        c, c1, c2 = 1 - square / 2 + square**2 / 24, -0.5 + square / 12, 1 / 12
        s, s1, s2 = 1 - square / 6 + square**2 / 120, -1 / 6 + square / 60, 1 / 60
    else:  # c1, s1: derivatives by t^2; c2, s2: second ones
        c, s = np.cos(angle), np.sin(angle) / angle
        c1, s1 = -s / 2, (c - s) / (2 * square)
        c2, s2 = -s1 / 2, (c1 - s1) / (2 * square) - (c - s) / (2 * square**2)
    x, y, z = corners.T
    lever = a * y - b * x
    first = np.array([2 * a, 2 * b])  # of t^2
    lever_first = np.array([y, -x])  # (2, n)
    heights = z * c + s * lever
    slope = first[:, None] * (z * c1 + s1 * lever) + s * lever_first
    curve = np.einsum("i,j,n->ijn", first, first, z * c2 + s2 * lever)
    curve += 2 * np.eye(2)[:, :, None] * (z * c1 + s1 * lever)
    mixed = np.einsum("i,jn->ijn", first * s1, lever_first)
    return heights, slope, curve + mixed + mixed.transpose(1, 0, 2)


def _derivatives(state: Array, corners: Array, weight: float, stiffness: float) -> tuple[Array, Array, float]:
    heights, slope, curve = _heights(state[1:], corners)
    pushes = stiffness * np.maximum(0.0, -(state[0] + heights))
    rows = np.vstack([np.ones(len(corners)), slope])
    active = pushes > 0
    gradient = np.array([weight, 0.0, 0.0]) - rows @ pushes
    hessian = stiffness * rows[:, active] @ rows[:, active].T
    hessian[1:, 1:] -= curve @ pushes
    energy = weight * state[0] + 0.5 * float(pushes @ pushes) / stiffness
    return gradient, hessian, float(energy)


def _newton_step(gradient: Array, hessian: Array, stiffness: float) -> Array:
    """Newton's step, with curvatures made positive so that it always goes downhill."""
    values, vectors = np.linalg.eigh(hessian)
    values = np.maximum(np.abs(values), 1e-6 * stiffness)
    step: Array = -vectors @ ((vectors.T @ gradient) / values)
    return step
