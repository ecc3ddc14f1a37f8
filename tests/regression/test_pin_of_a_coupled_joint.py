"""A pin that was put in zeroed the rate of its own joint and nothing else.

Joints of a tree share their masses: to stop one takes a moment that all others feel. The rates of the others
stayed, so that momentum jumped, and `impact`, which can only take energy, gave some: a knee that closed at
0.8 mrad/s under a hip that turned the other way fed the pendulum.
"""

from __future__ import annotations

import json

import numpy as np
import pytest

from gantline._core import Simulation
from mechanics import Json, body, document, finished, hinge

METHODS: dict[str, Json] = {
    "adaptive": {"type": "adaptive", "tension_tolerance": 1e-3, "position_tolerance": 1e-9},
    "del": {"type": "del", "step": 1e-3},
}
#: Of both arms: mass [kg], length [m]; inertia about their centres [kg m²].
MASS, LENGTH = (20.0, 30.0), (1.0, 1.2)
INERTIA = tuple(m * length**2 / 12 for m, length in zip(MASS, LENGTH, strict=True))
#: Rates of the hip and of the knee [rad/s], both below what a pin takes for rest.
RATES = np.array([-4e-4, 8e-4])
PINNED = 0.5


def mass_matrix(knee: float) -> np.ndarray:
    """M of two rods, the second hinged to the end of the first, over hip and knee angle [kg m²]."""
    (m1, m2), (l1, l2), (i1, i2) = MASS, LENGTH, INERTIA
    own = i2 + m2 * l2**2 / 4
    coupling = m2 * l1 * l2 / 2 * np.cos(knee)
    whole = i1 + m1 * l1**2 / 4 + own + m2 * l1**2 + 2 * coupling
    return np.array([[whole, own + coupling], [own + coupling, own]])


@pytest.mark.parametrize("method", METHODS)
def test_a_knee_that_is_pinned_hands_its_momentum_on(method: str) -> None:
    """M Δv + p e₂ = 0 with q̇₂ = 0: q̇₁ becomes q̇₁ + M₁₂/M₁₁ q̇₂, and ½ (M₂₂ − M₁₂²/M₁₁) q̇₂² is the impact.

    Free of gravity. Rates are read a millisecond before, in which the swinging of the arms changes them by
    1e-6 of themselves.
    """
    arms = [
        body(
            name,
            hinge((0, 1, 0), velocity=float(rate), position=start),
            mass,
            parent=parent,
            position=(0, 0, z),
            centre_of_gravity=(0, 0, -length / 2),
            inertia=(inertia, inertia, 0),
        )
        for name, rate, start, mass, parent, z, length, inertia in (
            ("upper", RATES[0], 0.0, MASS[0], None, 0.0, LENGTH[0], INERTIA[0]),
            ("lower", RATES[1], 0.3, MASS[1], "upper", -LENGTH[0], LENGTH[1], INERTIA[1]),
        )
    ]
    arms[1]["joint"]["pin"] = False
    plan: list[Json] = [
        {"name": "free", "until": {"type": "duration", "duration": PINNED}},
        {"name": "pinned", "until": {"type": "end_of_run"}, "pins": ["lower"]},
    ]
    system = document(arms, gravity=[0, 0, 0], plan=plan)
    settings = {"integrator": METHODS[method], "duration": 1.0, "sample_interval": 1e-3}
    simulation = Simulation(json.dumps(system), json.dumps(settings))
    result = finished(simulation, simulation.run())
    upper, lower = (result.body(name, "body_angular_velocity")[:, 1] for name in ("upper", "lower"))
    before = int(np.searchsorted(result.time, PINNED - 1e-9)) - 1
    hip, knee = upper[before], lower[before] - upper[before]
    mass = mass_matrix(float(result.joint("lower")[before]))
    coupling = mass[0, 1] / mass[0, 0]
    assert upper[before + 2 :] == pytest.approx(hip + coupling * knee, rel=1e-6)
    assert np.abs(lower - upper)[before + 2 :].max() < 1e-15
    lost = 0.5 * (mass[1, 1] - mass[0, 1] * coupling) * knee**2
    assert result.energy("impact")[-1] == pytest.approx(lost, rel=3e-6)
    assert result.energy_remainder < 1e-6
