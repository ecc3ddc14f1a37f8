"""A load that swings and turns about a point in a wind across two of its faces, against Lagrange's equations.

The force on the point P of the areas, along each of the load's axes (WC1):

    Fᵢ = −cᵢ |w| wᵢ        w = Rᵀ (v_P − u)

`lagrange` knows where the load's points are and what pushes at P, and differentiates.
"""

from __future__ import annotations

import numpy as np

from lagrange import Batch, Lagrange, derivative, six_points, spin, yaw_pitch_roll
from mechanics import Floats, Json, adaptive, body, document

MASS, INERTIA = 800.0, (300.0, 200.0, 150.0)
CENTRE, AREAS = np.array([0.3, -0.2, -2.0]), np.array([0.5, 0.4, -2.5])
#: c along the load's axes [N s²/m²], the wind u [m/s].
SHAPE, WIND = np.array([40.0, 25.0, 10.0]), np.array([12.0, 7.0, 0.0])
ANGLES, RATES = np.array([0.3, 0.4, -0.5]), np.array([0.8, -0.6, 0.7])
POINTS = six_points(MASS, CENTRE, np.diag(INERTIA))


def points(q: Batch) -> Batch:
    return np.asarray(np.einsum("kij,nj->kni", yaw_pitch_roll(q), POINTS))


def pushed(q: Batch) -> Batch:
    return np.asarray(np.einsum("kij,j->ki", yaw_pitch_roll(q), AREAS))


def wind(_: float, q: Floats, v: Floats) -> Floats:
    """J_Pᵀ F."""
    jacobian = derivative(pushed, q)[1]
    rotation = yaw_pitch_roll(q[None])[0].real
    seen = rotation.T @ (jacobian @ v - WIND)
    return np.asarray(-jacobian.T @ rotation @ (SHAPE * np.linalg.norm(seen) * seen))


def test_a_load_swings_and_turns_in_the_wind() -> None:
    """Place of the centre of gravity over 8 s, in which the wind puts in what the air takes, 0.4 MJ.

    Both solutions are right to some 1e-8 m; 2e-8 m were found.
    """
    times = np.linspace(0, 8, 17)
    own = Lagrange(np.full(6, MASS / 6), points, wind).run(ANGLES, RATES, times)
    orientation, rate = spin(yaw_pitch_roll, ANGLES, RATES)
    ball: Json = {"type": "ball", "orientation": orientation, "angular_velocity": rate}
    load = body("load", ball, MASS, centre_of_gravity=CENTRE.tolist(), inertia=INERTIA)
    areas = {
        "type": "drag",
        "name": "wind",
        "body": "load",
        "at": AREAS.tolist(),
        "damping": np.zeros((6, 6)).tolist(),
        "quadratic": [*SHAPE.tolist(), 0.0, 0.0, 0.0],
        "stream": WIND.tolist(),
    }
    run = adaptive(
        document([load], forces=[areas]),
        8.0,
        tension_tolerance=1e-2,
        position_tolerance=1e-8,
        sample_interval=0.5,
    )
    expected = np.einsum("kij,j->ki", yaw_pitch_roll(own[:, :3]).real, CENTRE)
    assert np.abs(run.body("load") - expected).max() < 2e-7
    assert run.energy("fluid_work")[-1] > 1e5 and run.energy("drag")[-1] > 1e5
    assert run.energy_remainder < 1e-12
