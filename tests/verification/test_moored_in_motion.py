"""A mass that swings on a mooring line that lies partly on the sea bed and damps, against equations of
their own.

With H and V at the upper end, of the part V/w that is off the bed (Irvine 1981, no friction on the bed),

    X = L − V/w + (H/w) asinh(V/H) + H L/EA        Z = (sqrt(H² + V²) − H)/w + V²/(2 EA w)

are solved for H and V by bisection in bisection. The damper is that of the mean strain e = ∫ T du/(EA L):
−τ EA L ė ∂e/∂ρ, slopes of e by central differences. Two stiff springs hold the mass up and back. scipy's
DOP853 solves the motion.
"""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from mechanics import Floats, G, adaptive, body, document, end, free, rope

MASS, WEIGHT, EA, LENGTH, TAU, BED = 50e3, 600.0, 4e7, 107.0, 0.15, -25.0
ANCHOR = np.array([100.0, 20.0, BED])
#: Where springs are held, their length [m] and EA [N].
SPRINGS = ((np.array([0.0, 0, 30]), 29.71, 5e7), (np.array([-60.0, 0, 5]), 59.9, 5e6))
NODES, SHARES = np.polynomial.legendre.leggauss(40)


def line(across: float, up: float) -> tuple[float, float, float]:
    """H and V [N], and the mean strain, of ends that are so far apart [m]."""

    def lifted(horizontal: float) -> float:
        rise = lambda v: (np.hypot(horizontal, v) - horizontal) / WEIGHT + v * v / (2 * EA * WEIGHT) - up  # noqa: E731
        return float(brentq(rise, 0.0, 1e6, xtol=1e-9, rtol=1e-14))

    def reach(horizontal: float) -> float:
        vertical = lifted(horizontal)
        off = horizontal / WEIGHT * np.arcsinh(vertical / horizontal) + horizontal * LENGTH / EA
        return float(LENGTH - vertical / WEIGHT + off - across)

    horizontal = float(brentq(reach, 10.0, 3e5, xtol=1e-9, rtol=1e-14))
    vertical = lifted(horizontal)
    off = vertical / WEIGHT
    hanging = SHARES @ np.hypot(horizontal, vertical * (1 + NODES) / 2) * off / 2
    return horizontal, vertical, float(hanging + horizontal * (LENGTH - off)) / (EA * LENGTH)


def rates(_: float, state: Floats) -> Floats:
    """Of place and velocity."""
    place, velocity = state[:3], state[3:]
    across = (place - ANCHOR)[:2]
    span, up, step = float(np.hypot(*across)), float(place[2] - BED), 1e-3
    horizontal, vertical, _ = line(span, up)
    slope = np.array(
        [
            (line(span + step, up)[2] - line(span - step, up)[2]) / (2 * step),
            (line(span, up + step)[2] - line(span, up - step)[2]) / (2 * step),
        ]
    )
    along = np.concatenate([across / span, [0.0]])
    damper = TAU * EA * LENGTH * float(slope @ [along @ velocity, velocity[2]]) * slope
    force = -(horizontal + damper[0]) * along - np.array([0, 0, vertical + damper[1] + MASS * G])
    for held, length, stiffness in SPRINGS:
        way = place - held
        distance = float(np.linalg.norm(way))
        force -= stiffness / length * max(0.0, distance - length) * way / distance
    return np.concatenate([velocity, force / MASS])


def test_a_mass_on_a_line_that_lies_on_the_bed_and_damps() -> None:
    """Its way in space, and the tension at the fairlead."""
    duration, start, velocity = 4.0, (0.5, 0.2, -0.1), (-0.5, 0.5, 0.3)
    times = np.linspace(0, duration, 9)
    found = solve_ivp(rates, (0, duration), [*start, *velocity], "DOP853", times, rtol=1e-7, atol=1e-8)
    own = found.y.T
    ropes = [
        rope(f"spring{k}", length, [end(None, held.tolist()), end("mass")], stiffness)
        for k, (held, length, stiffness) in enumerate(SPRINGS)
    ]
    mooring = {
        "type": "mooring",
        "name": "line",
        "body": "mass",
        "at": [0, 0, 0],
        "to": ANCHOR.tolist(),
        "weight": WEIGHT,
        "axial_stiffness": EA,
        "damping_time": TAU,
        "length": LENGTH,
        "sea_bed": BED,
    }
    mass = body("mass", free(start, velocity=list(velocity)), MASS, inertia=(1e6, 1e6, 1e6))
    run = adaptive(
        document([mass], ropes=ropes, forces=[mooring]),
        duration,
        tension_tolerance=0.1,
        position_tolerance=1e-8,
        sample_interval=duration / 8,
    )
    # The other solution is right to some 1e-7; 1.2e-7 m were found.
    assert np.abs(run.body("mass") - own[:, :3]).max() < 1e-6
    lying = LENGTH - max(line(float(np.hypot(*(y[:2] - ANCHOR[:2]))), y[2] - BED)[1] for y in own) / WEIGHT
    assert lying > 0.0, "some of the line must lie on the bed"
    assert run.energy("rope_damping")[-1] > 100.0, "its damper must tell"
    assert run.energy_remainder < 1e-11
