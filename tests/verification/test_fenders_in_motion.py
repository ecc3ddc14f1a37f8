"""A pontoon on ropes that is pressed, bumps and rubs against two fenders, against equations of its own.

A fender whose point is d past its plane pushes with N = max(0, k (d + τ ḋ)). Along the plane its spring has
the deflection s: while k |s + τ v| ≤ μ N, ṡ = v; else the friction F = μ N along k (s + τ v), and
ṡ = (F/k − s)/τ. Where the fender is clear s goes back to nothing within 0.2 ms here. With straight ropes,
T = max(0, EA/L (e + τ ė)), and I ω̇ = m − ω × I ω in the pontoon's axes, scipy's LSODA solves the motion.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import Floats, G, adaptive, body, document, end, free, rope
from rigid import axes, cross, turning

MASS = 8e5
INERTIA = MASS * np.array([9.0, 40.0, 45.0])
#: Ropes: upper end, place on the pontoon, length [m], EA [N], τ [s].
HUNG = (([-8.5, -4, 43], [-8, -4, 3]), ([-8, 4.5, 43], [-8, 4, 3]), ([8.4, 0.3, 43], [8, 0, 3]))
EAS, TAU = 3e8, 0.01


@dataclass(frozen=True)
class Fender:
    """Its point on the pontoon and a point of its plane [m], which way it pushes, its law."""

    at: Floats
    plane: Floats
    normal: Floats
    stiffness: float
    damping_time: float
    friction: float


def fenders(friction: tuple[float, float]) -> list[Fender]:
    """Two ahead of the pontoon, 0.06 and 0.01 m away from it, that face a little inwards and outwards."""
    made = []
    for (y, z, gap, angle, k, tau), mu in zip(
        ((-5.0, 1.2, 0.06, 0.1, 6e6, 0.06), (5.0, -0.5, 0.01, -0.13, 3e6, 0.15)), friction, strict=True
    ):
        normal, at = np.array([-np.cos(angle), np.sin(angle), 0.0]), np.array([12.0, y, z])
        made.append(Fender(at, at - gap * normal, normal, k, tau, mu))
    return made


@pytest.mark.parametrize("friction", [(0.5, 0.2), (0.0, 0.5)], ids=["both rub", "one rubs"])
def test_a_pontoon_against_two_fenders(friction: tuple[float, float]) -> None:
    """Its place, attitude and both forces over 10 s in which it comes, rebounds, and is pressed again."""
    walls = fenders(friction)
    ropes = [(np.array(top, float), np.array(at, float)) for top, at in HUNG]
    spans = [float(np.linalg.norm(top - at)) / (1 + MASS * G / 3 / EAS) for top, at in ropes]
    ropes.append((np.array([40.0, 4.0, 2.0]), np.array([12.0, 0.0, 1.0])))
    spans.append(27.9)
    stiffnesses = [EAS, EAS, EAS, 8e6]

    def met(state: Floats) -> list[tuple[float, Floats, Floats, Floats]]:
        """Of each fender N, friction on the pontoon, ṡ, and where from the centre it acts."""
        rotation, (place, speed) = axes(state[3:7]), (state[:3], state[7:10])
        found = []
        for wall, deflected in zip(walls, state[13:].reshape(-1, 3), strict=True):
            arm = rotation @ wall.at
            moves = speed + cross(rotation @ state[10:13], arm)
            depth, rate = -(place + arm - wall.plane) @ wall.normal, -moves @ wall.normal
            normal = max(0.0, wall.stiffness * float(depth + wall.damping_time * rate))
            along = moves + rate * wall.normal
            wanted = wall.stiffness * (deflected + wall.damping_time * along)
            size, bound = math.sqrt(wanted @ wanted), wall.friction * normal
            if bound == 0.0:
                found.append((normal, np.zeros(3), -deflected / 2e-4, arm))
            elif size <= bound:
                found.append((normal, -wanted, along, arm))
            else:
                held = wanted * bound / size
                change = (held / wall.stiffness - deflected) / wall.damping_time
                found.append((normal, -held, change, arm))
        return found

    def rates(_: float, state: Floats) -> Floats:
        rotation, spin = axes(state[3:7]), state[10:13]
        force, moment = np.array([0, 0, -MASS * G]), np.zeros(3)
        touched = met(state)
        for wall, (normal, rubs, _slips, arm) in zip(walls, touched, strict=True):
            force = force + normal * wall.normal + rubs
            moment = moment + cross(arm, normal * wall.normal + rubs)
        for (top, at), length, stiffness in zip(ropes, spans, stiffnesses, strict=True):
            arm = rotation @ at
            way = state[:3] + arm - top
            span = math.sqrt(way @ way)
            rate = float(way @ (state[7:10] + cross(rotation @ spin, arm))) / span
            pull = -max(0.0, stiffness / length * (span - length + TAU * rate)) * way / span
            force, moment = force + pull, moment + cross(arm, pull)
        spun = (rotation.T @ moment - cross(spin, INERTIA * spin)) / INERTIA
        slips = (change for _, _, change, _ in touched)
        return np.concatenate([state[7:10], turning(state[3:7], spin), force / MASS, spun, *slips])

    speed, spin = [0.3, -0.25, 0.05], [0.01, -0.02, 0.03]
    start = np.concatenate([np.zeros(3), [1, 0, 0, 0], speed, spin, np.zeros(6)])
    times = np.linspace(0, 10, 51)
    own = solve_ivp(rates, (0, 10), start, "LSODA", times, rtol=1e-9, atol=1e-10, max_step=0.01).y.T
    pontoon = body("pontoon", free((0, 0, 0), velocity=speed, angular_velocity=spin), MASS)
    pontoon["inertia"] = [*INERTIA.tolist(), 0, 0, 0]
    contacts = [
        {
            "name": f"fender{k}",
            "group": f"fender{k}",
            "body": "pontoon",
            "at": wall.at.tolist(),
            "plane_point": wall.plane.tolist(),
            "plane_normal": wall.normal.tolist(),
            "stiffness": wall.stiffness,
            "damping_time": wall.damping_time,
            "friction": wall.friction,
        }
        for k, wall in enumerate(walls)
    ]
    lines = [
        rope(f"rope{k}", length, [end(None, top.tolist()), end("pontoon", at.tolist())], stiffness, TAU)
        for k, ((top, at), length, stiffness) in enumerate(zip(ropes, spans, stiffnesses, strict=True))
    ]
    run = adaptive(
        document([pontoon], ropes=lines, contacts=contacts),
        10.0,
        tension_tolerance=10.0,
        position_tolerance=1e-8,
        sample_interval=0.2,
    )
    pressed = np.array([[normal for normal, *_ in met(state)] for state in own])
    assert ((pressed == 0).any(axis=0) & (pressed.max(axis=0) > 1e5)).all(), "both are met and left"
    # Tolerances of 10 N and 10 nm in a step; 4e-7 m and 3 N were found of random ones.
    assert np.abs(run.body("pontoon") - own[:, :3]).max() < 1e-6
    alike = (run.body("pontoon", "body_orientation") * own[:, 3:7]).sum(axis=1)
    assert np.abs(np.abs(alike / np.linalg.norm(own[:, 3:7], axis=1)) - 1.0).max() < 1e-13
    assert np.abs(run.columns["contact_force"] - pressed).max() < 10.0
    assert run.energy("friction")[-1] > 1e3
    assert run.energy_remainder < 1e-11
