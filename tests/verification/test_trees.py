"""A tree of every type of joint, tied together by ropes, against Lagrange's equations of its points.

Bodies with products of inertia and centres of gravity off their joints hang on a hinge, a slider on it, a
ball on that, a free body under the ball and a point under the hinge; axes and frames stand askew.
`lagrange` knows of it where points are and what ropes pull, and differentiates. Some of the ropes go slack
and taut again.
"""

from __future__ import annotations

import numpy as np
import pytest

from lagrange import (
    Batch,
    Lagrange,
    at,
    derivative,
    distance,
    quaternion,
    six_points,
    spin,
    turned,
    yaw_pitch_roll,
)
from mechanics import Floats, Json, adaptive, body, document, end, free, hinge, point, rope, slider

NAMES = ("hub", "sledge", "gimbal", "load", "bob")
PARENTS = (None, "hub", "sledge", "gimbal", "hub")
MASSES = np.array([900.0, 400.0, 250.0, 120.0, 60.0])
CENTRES = np.array([[0.3, -0.1, 0.5], [-0.2, 0.4, 0.1], [0.1, 0.3, -0.4], [-0.3, 0.2, 0.1], [0, 0, 0]])
AXES = (np.array([0.2, -0.1, 1.0]), np.array([1.0, 0.3, 0.2]))
PLACES = np.array([[0.3, -0.2, 5], [0.5, 0.1, 0.4], [0.2, -0.3, -0.1], [-0.4, 0.2, -0.6], [0.1, 0.5, 0.2]])
TURNS = [
    turned(axis, np.array([angle]))[0]
    for axis, angle in (
        ([1, 2, 3], 0.4),
        ([-1, 2, 1], 0.7),
        ([3, 1, -2], 0.5),
        ([0, 1, -2], -0.6),
        ([1, 1, -2], 0.8),
    )
]
#: Viscous damping of hinge [N m s] and slider [N s/m].
DAMPING = (30.0, 40.0)
#: Bodies and points of both ends, stretch at the start, EA [N], τ [s].
ROPES: list[tuple[int | None, tuple[float, ...], int, tuple[float, ...], float, float, float]] = [
    (None, (2.0, 1.0, 9.0), 3, (0.2, 0.1, 0.3), 0.03, 4e4, 0.01),
    (0, (0.5, -0.5, 1.0), 4, (0, 0, 0), 0.01, 3e4, 0.02),
    (2, (0.5, 0.5, 0.0), 3, (-0.2, 0.3, 0.1), 0.015, 2e4, 0.0),
    (1, (0.0, 0.0, 0.0), 4, (0, 0, 0), 0.01, 2e4, 0.0),
    (None, (-3.0, 0.0, 9.0), 4, (0, 0, 0), 0.02, 2e4, 0.0),
    (None, (0.0, -4.0, 8.0), 1, (0.1, 0.2, 0.3), 0.015, 3e4, 0.01),
]
#: Hinge, slider, three angles of the ball, place and three angles of the free body, place of the point.
START = np.array([0.3, 0.2, 0.2, -0.3, 0.4, -0.3, 0.1, -0.8, 0.3, 0.5, -0.2, 0.6, -0.2, -0.7])
VELOCITY = np.array([0.4, -0.3, 0.5, 0.2, -0.6, 0.3, -0.5, 0.4, -0.2, 0.6, 0.3, -0.4, 0.2, 0.5])
DURATION = 0.4


def inertia(index: int) -> Floats:
    """Of a body about its centre of gravity (3, 3) [kg m²], with products."""
    rows = np.random.default_rng(index).normal(size=(3, 3))
    second = rows @ rows.T * MASSES[index] * 0.25
    return np.asarray(np.trace(second) * np.eye(3) - second)


def frames(q: Batch) -> list[tuple[Batch, Batch]]:
    """Rotations and origins of the bodies over q (k, 14)."""
    world = (np.broadcast_to(np.eye(3), (len(q), 3, 3)), np.zeros((len(q), 3)))
    hub_joint = (world[0] @ TURNS[0], world[1] + PLACES[0])
    hub = (hub_joint[0] @ turned(AXES[0], q[:, 0]), hub_joint[1])

    def joint(parent: tuple[Batch, Batch], index: int) -> tuple[Batch, Batch]:
        return parent[0] @ TURNS[index], parent[1] + parent[0] @ PLACES[index]

    def moved(frame: tuple[Batch, Batch], by: Batch) -> Batch:
        return np.asarray(frame[1] + (frame[0] @ by[:, :, None])[:, :, 0])

    on_hub = joint(hub, 1)
    axis = AXES[1] / np.linalg.norm(AXES[1])
    sledge = (on_hub[0], moved(on_hub, q[:, 1:2] * axis))
    on_sledge = joint(sledge, 2)
    gimbal = (on_sledge[0] @ yaw_pitch_roll(q[:, 2:5]), on_sledge[1])
    under = joint(gimbal, 3)
    load = (under[0] @ yaw_pitch_roll(q[:, 8:11]), moved(under, q[:, 5:8]))
    beside = joint(hub, 4)
    return [hub, sledge, gimbal, load, (beside[0], moved(beside, q[:, 11:14]))]


POINTS = [six_points(MASSES[k], CENTRES[k], inertia(k)) for k in range(4)] + [np.zeros((6, 3))]


def points(q: Batch) -> Batch:
    """Six of each body (k, 30, 3) [m]."""
    places = [
        origin[:, None, :] + np.einsum("kij,nj->kni", rotation, own)
        for (rotation, origin), own in zip(frames(q), POINTS, strict=True)
    ]
    return np.concatenate(places, axis=1)


def lengths(q: Batch) -> Batch:
    """Of the ropes' ways (k, 6) [m]."""
    placed = frames(q)
    return np.stack([distance(at(placed, a, p), at(placed, b, r)) for a, p, b, r, *_ in ROPES], axis=1)


LENGTHS = lengths(START[None])[0] * (1.0 - np.array([rope[4] for rope in ROPES]))
STIFFNESS = np.array([rope[5] for rope in ROPES]) / LENGTHS
TIMES = np.array([rope[6] for rope in ROPES])
MASS_OF_POINTS = np.repeat(MASSES / 6, 6)


def force(_: float, q: Floats, v: Floats) -> Floats:
    """Of ropes, T = max(0, k (e + τ ė)), and of dampers."""
    length, gradient = derivative(lengths, q)
    pull = -np.maximum(0.0, STIFFNESS * (length - LENGTHS + TIMES * (gradient @ v))) @ gradient
    pull[:2] -= np.array(DAMPING) * v[:2]
    return np.asarray(pull)


def system(acceleration: float | None) -> Json:
    """The same as a document; the hinge is driven where an acceleration [rad/s²] is given."""
    turning = [spin(yaw_pitch_roll, START[part], VELOCITY[part]) for part in (slice(2, 5), slice(8, 11))]
    ball = {"type": "ball", "orientation": turning[0][0], "angular_velocity": turning[0][1]}
    first = hinge(AXES[0].tolist(), position=START[0], velocity=VELOCITY[0], damping=DAMPING[0])
    if acceleration is not None:
        first = hinge(AXES[0].tolist(), position=START[0], drive="turn")
    joints = [
        first,
        slider(AXES[1].tolist(), position=START[1], velocity=VELOCITY[1], damping=DAMPING[1]),
        ball,
        free(
            START[5:8].tolist(),
            velocity=VELOCITY[5:8].tolist(),
            orientation=turning[1][0],
            angular_velocity=turning[1][1],
        ),
        point(START[11:].tolist(), VELOCITY[11:].tolist()),
    ]
    bodies = []
    for k, (name, parent, joint) in enumerate(zip(NAMES, PARENTS, joints, strict=True)):
        one = body(
            name,
            joint,
            MASSES[k],
            parent=parent,
            position=PLACES[k].tolist(),
            centre_of_gravity=CENTRES[k].tolist(),
        )
        one["placement"]["orientation"] = quaternion(TURNS[k])
        if k < 4:
            tensor = inertia(k)
            one["inertia"] = [
                float(tensor[i, j]) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
            ]
        bodies.append(one)
    ropes = [
        rope(f"r{k}", float(LENGTHS[k]), [end(None if a is None else NAMES[a], p), end(NAMES[b], r)], ea, tau)
        for k, (a, p, b, r, _, ea, tau) in enumerate(ROPES)
    ]
    if acceleration is None:
        return document(bodies, ropes=ropes)
    # The ramp outlasts the run.
    ramp = {"at": 0.0, "duration": 2 * DURATION, "velocity": 2 * DURATION * acceleration}
    return document(bodies, ropes=ropes, drives=[{"name": "turn", "ramps": [ramp]}])


@pytest.mark.parametrize("acceleration", [None, 1.5])
def test_a_tree_of_every_joint_moves_as_lagrange_says(acceleration: float | None) -> None:
    """Centres of gravity, tensions and the energy balance; with the root driven too."""
    times = np.linspace(0, DURATION, 9)
    velocity, driven = VELOCITY.copy(), None
    if acceleration is not None:
        velocity[0] = 0.0
        driven = {0: lambda _: acceleration}
    own = Lagrange(MASS_OF_POINTS, points, force, driven).run(START, velocity, times, tolerance=1e-10)
    run = adaptive(
        system(acceleration),
        DURATION,
        tension_tolerance=1e-2,
        position_tolerance=1e-8,
        sample_interval=DURATION / 8,
    )
    q = own[:, :14]
    for k, name in enumerate(NAMES):
        # Tolerances of a step of 10 nm and 0.01 N, of 1e4 N; what was found is 3e-9 m and less.
        assert np.abs(at(frames(q), k, CENTRES[k]) - run.body(name)).max() < 1e-8
    rate = np.array([derivative(lengths, one)[1] @ v for one, v in zip(q, own[:, 14:], strict=True)])
    tension = np.maximum(0.0, STIFFNESS * (lengths(q) - LENGTHS + TIMES * rate))
    found = np.stack([run.tension(f"r{k}") for k in range(len(ROPES))], axis=1)
    # 10 nm times 2e4 N/m, and 0.01 N.
    assert np.abs(found - tension).max() < 0.02
    slack = (tension == 0.0).any(axis=0)
    assert slack.any() and not slack.all(), "some ropes must go slack"
    assert run.energy_remainder < 1e-11
