"""Bodies and joints against closed forms, integrator `del`."""

from __future__ import annotations

import math

import numpy as np
import pytest

from mechanics import G, body, document, elliptic_k, end, free, hinge, period, point, rope, simulate, slider


@pytest.mark.parametrize("amplitude", [0.05, 1.0, 2.5])
def test_single_pendulum_period(amplitude: float) -> None:
    """T = 4 √(l/g) K(sin θ₀/2)."""
    length, step = 2.0, 1e-3
    exact = 4 * math.sqrt(length / G) * elliptic_k(math.sin(amplitude / 2))
    system = document([body("m", hinge(position=amplitude), 3.0, centre_of_gravity=(0, 0, -length))])
    run = simulate(system, 20.0, step=step)
    # Symplectic Euler: the period is right to (ω h)²/24 of itself; crossings are found to about h²/8.
    assert period(run.time, run.joint("m")) == pytest.approx(exact, rel=1e-6)
    assert run.joint("m").max() == pytest.approx(amplitude, rel=2e-3)


def test_pendulum_on_an_inextensible_rope_has_the_same_period() -> None:
    """The rope's row must do what the hinge does: T = 4 √(l/g) K(sin θ₀/2)."""
    length, amplitude = 5.0, 0.6
    start = (length * math.sin(amplitude), 0, -length * math.cos(amplitude))
    system = document([body("m", point(start), 40.0)], ropes=[rope("r", length, [end(None), end("m")], None)])
    run = simulate(system, 20.0, step=5e-4)
    exact = 4 * math.sqrt(length / G) * elliptic_k(math.sin(amplitude / 2))
    assert period(run.time, run.body("m")[:, 0]) == pytest.approx(exact, rel=2e-4)
    assert run.columns["residual_constraint"].max() < 1e-5


def test_double_pendulum_periods() -> None:
    """30 t on 30 m with 300 t on 20 m below it: 14.026 s and 2.119 s for small angles.

    ω² from det(K − ω² M) = 0 with M = [(m₁+m₂) l₁², m₂ l₁ l₂; ·, m₂ l₂²], K = diag((m₁+m₂) g l₁, m₂ g l₂).
    """
    m1, m2, l1, l2 = 30e3, 300e3, 30.0, 20.0
    mass = np.array([[(m1 + m2) * l1**2, m2 * l1 * l2], [m2 * l1 * l2, m2 * l2**2]])
    stiffness = np.diag([(m1 + m2) * G * l1, m2 * G * l2])
    squares, shapes = np.linalg.eig(np.linalg.solve(mass, stiffness))
    periods = 2 * math.pi / np.sqrt(squares)
    assert sorted(periods) == pytest.approx([2.119, 14.026], abs=1e-3)
    for index in range(2):
        first, second = 1e-3 * shapes[:, index] / np.abs(shapes[:, index]).max()
        system = document(
            [
                body("upper", hinge(position=first), m1, centre_of_gravity=(0, 0, -l1)),
                body(
                    "lower",
                    hinge(position=second - first),
                    m2,
                    parent="upper",
                    position=(0, 0, -l1),
                    centre_of_gravity=(0, 0, -l2),
                ),
            ]
        )
        run = simulate(system, 4.2 * periods[index], step=periods[index] / 5000)
        assert period(run.time, run.joint("upper")) == pytest.approx(periods[index], rel=1e-5)


def test_energy_of_a_double_pendulum() -> None:
    """E = const: to first order in h, without drift; the audit explains the difference to second order."""
    length, mass = 1.0, 10.0
    arm = (0, 0, -length)
    upper = body("upper", hinge(position=1.0), mass, centre_of_gravity=arm)
    lower = body("lower", hinge(position=-0.2), mass, parent="upper", position=arm, centre_of_gravity=arm)
    errors, remainders = [], []
    for step in (1e-3, 5e-4):
        run = simulate(document([upper, lower]), 20.0, step=step)
        energy = run.energy("kinetic") + run.energy("gravity")
        errors.append(float(np.abs(energy - energy[0]).max() / run.energy("kinetic").max()))
        remainders.append(run.energy_remainder)
    assert errors[0] < 2e-3
    assert errors[0] / errors[1] == pytest.approx(2, rel=0.1)
    assert remainders[0] < 2e-5
    assert remainders[0] / remainders[1] == pytest.approx(4, rel=0.1)


def test_torque_free_body_keeps_energy_and_angular_momentum() -> None:
    """Tumbling about the middle axis: kinetic energy and |L| constant, L fixed in space to the order of h."""
    inertia = np.array([1.0, 2.0, 3.5])
    spin = [0.02, 3.0, 0.01]
    system = {
        "gravity": [0, 0, 0],
        "bodies": [body("b", free((0, 0, 0), angular_velocity=spin), 7.0, inertia=tuple(inertia))],
    }
    directions = []
    for step in (2e-3, 1e-3):
        run = simulate(system, 30.0, step=step)
        kinetic = run.energy("kinetic")
        assert np.abs(kinetic / kinetic[0] - 1).max() < 1e-9
        local, momentum = run.spin("b", inertia)
        size = np.linalg.norm(momentum, axis=1)
        assert np.abs(size / size[0] - 1).max() < 1e-9
        assert np.abs(local[:, 1]).max() > 2.9 and local[:, 1].min() < -2.5, "it must have turned over"
        directions.append(np.abs(momentum - momentum[0]).max() / size[0])
    assert directions[1] < 5e-3
    assert directions[0] / directions[1] == pytest.approx(2, rel=0.15)


def test_slider_on_an_incline() -> None:
    """a = g sin α along a slider that is inclined by α; nothing else moves."""
    alpha = 0.3
    axis = (math.cos(alpha), 0, -math.sin(alpha))
    run = simulate(document([body("m", slider(axis), 4.0)]), 2.0)
    expected = 0.5 * G * math.sin(alpha) * run.time * (run.time + 1e-3)
    assert np.abs(run.joint("m") - expected).max() < 1e-11


def test_driven_joint_follows_its_ramp_and_its_work_is_the_energy() -> None:
    """A driven mass: position of the trapezoid, work = ½ m v² + m g z."""
    mass, speed = 500.0, 0.4
    drives = [
        {
            "name": "up",
            "ramps": [
                {"at": 0.5, "duration": 2.0, "velocity": speed, "shape": "smooth"},
                {"at": 4.0, "duration": 1.0, "velocity": 0.0},
            ],
        }
    ]
    run = simulate(document([body("m", slider(drive="up"), mass)], drives=drives), 6.0)
    travel = speed * (2.0 / 2 + 1.5 + 1.0 / 2)
    assert run.joint("m")[-1] == pytest.approx(travel, abs=1e-12)
    # The scheme's own loss ½ Σ m Δv², 0.06 J here, is drive work too; the audit knows it.
    work = run.energy("drive_work") - run.energy("method")
    assert work[-1] == pytest.approx(mass * G * travel, rel=1e-9)
    middle = np.searchsorted(run.time, 3.0)
    assert work[middle] == pytest.approx(0.5 * mass * speed**2 + mass * G * run.joint("m")[middle], rel=1e-9)
    assert run.energy_remainder < 1e-10


def test_load_swings_under_an_accelerated_hook() -> None:
    """A hook that travels off with constant a: the load swings about tan θ = a/g, to twice that angle."""
    a, length = 0.2, 20.0
    drives = [{"name": "go", "ramps": [{"at": 0.0, "duration": 40.0, "velocity": 40.0 * a}]}]
    system = document(
        [
            body("hook", slider((1, 0, 0), drive="go"), 0.0),
            body("load", hinge((0, 1, 0)), 5000.0, parent="hook", centre_of_gravity=(0, 0, -length)),
        ],
        drives=drives,
    )
    run = simulate(system, 30.0)
    tilt = math.atan2(a, G)
    # Rotation about +y moves a body below the hinge towards −x: a positive angle lags behind the hook.
    assert run.joint("load").max() == pytest.approx(2 * tilt, rel=1e-3)
    assert run.joint("load").mean() == pytest.approx(tilt, rel=5e-2)
    effective = math.hypot(G, a)
    exact = 4 * math.sqrt(length / effective) * elliptic_k(math.sin(tilt / 2))
    assert period(run.time, run.joint("load"), about=tilt) == pytest.approx(exact, rel=1e-5)


def test_joint_force_of_a_conical_pendulum() -> None:
    """A ball-jointed mass on a circle: the joint pulls m g/cos θ along the arm, ω² = g/(l cos θ)."""
    length, theta, mass = 3.0, 0.7, 12.0
    omega = math.sqrt(G / (length * math.cos(theta)))
    half = theta / 2
    # Turned by θ about −y, the arm (0, 0, −l) points to (+l sin θ, 0, −l cos θ); spin about world z.
    orientation = [math.cos(half), 0, -math.sin(half), 0]
    spin = [omega * math.sin(theta), 0, omega * math.cos(theta)]
    joint = {"type": "ball", "orientation": orientation, "angular_velocity": spin}
    small = (1e-9, 1e-9, 1e-9)
    run = simulate(document([body("m", joint, mass, centre_of_gravity=(0, 0, -length), inertia=small)]), 3.0)
    force = run.body("m", "joint_force")
    assert force[:, 2] == pytest.approx(np.full(len(force), mass * G), rel=3e-3)
    assert np.hypot(force[:, 0], force[:, 1]) == pytest.approx(
        np.full(len(force), mass * G * math.tan(theta)), rel=3e-3
    )
    assert np.abs(run.body("m")[:, 2] + length * math.cos(theta)).max() < 5e-3 * length
