"""A prism with many corners that rocks over them until it stands, against its equations of motion.

An upright regular prism with an apothem a, two edges of its foot square to the way it leans, meets the ground
by its corners. In the plane of its motion n of them bear as one, at x: with k and τ of a corner
N = max(0, n k (e + τ ė)), and along the ground a spring s with its damper, F = n k (s + τ v), no more than
μ N; then ṡ = (F/nk − s)/τ. Of a corner (x, −H) of a body that leans by θ, the arm from its middle is
(x cos θ − H sin θ, −H cos θ − x sin θ).
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import Floats, G, adaptive, body, document, free

MASS, HIGH, APOTHEM = 2000.0, 1.2, 0.6
#: About its middle, across its axis and about it [kg m²]; any would do.
ACROSS, ABOUT = MASS * (APOTHEM**2 / 4 + (2 * HIGH) ** 2 / 12), MASS * APOTHEM**2 / 2
#: Of one corner.
STIFFNESS, DAMPED, FRICTION = 2e7, 0.005, 0.8
DURATION, SUNK = 3.0, 2e-4


def corners(count: int) -> Floats:
    """Of the foot of a prism, shape (count, 2) [m]."""
    angles = np.pi * (2 * np.arange(count) + 1) / count
    return APOTHEM / math.cos(math.pi / count) * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def rates(_: float, y: Floats, bearing: Floats) -> list[float]:
    """Of x, z and lean of the middle, their speeds, and of the springs along the ground.

    Args:
        bearing: places along x and how many corners are there, shape (p, 2).
    """
    _, z, lean, along, up, spin = y[:6]
    cosine, sine = math.cos(lean), math.sin(lean)
    force, moment, springs = [0.0, -MASS * G], 0.0, []
    for spring, (out, many) in zip(y[6:], bearing, strict=True):
        stiff = STIFFNESS * many
        arm = (out * cosine - HIGH * sine, -HIGH * cosine - out * sine)
        slides, sinks = along + spin * arm[1], spin * arm[0] - up
        pressed = max(0.0, stiff * (-z - arm[1] + DAMPED * sinks))
        wanted = stiff * (spring + DAMPED * slides)
        held = max(-FRICTION * pressed, min(FRICTION * pressed, wanted))
        # In the air a spring is let go of.
        springs.append(slides - (wanted - held) / (stiff * DAMPED) if pressed > 0.0 else -spring / 1e-4)
        force = [force[0] - held, force[1] + pressed]
        moment -= arm[1] * held + arm[0] * pressed
    return [along, up, spin, force[0] / MASS, force[1] / MASS, moment / ACROSS, *springs]


@pytest.mark.parametrize(("count", "lean", "heading"), [(12, 0.16, 0.3), (16, 0.35, 0.0)])
def test_a_prism_rocks_over_its_corners(count: int, lean: float, heading: float) -> None:
    """Lean, place and what it goes aside, nothing, of a prism let go of over an edge, turned about the plumb.

    Positions are to 1e-7 m in a step, 0.1 µm; an error of that goes on with the motion, which nothing drives.
    """
    foot = corners(count)
    bearing = np.array(np.unique(foot[:, 0].round(9), return_counts=True)).T
    cosine, sine = math.cos(lean), math.sin(lean)
    over = -APOTHEM * (cosine - 1.0) + HIGH * sine
    height = HIGH * cosine + APOTHEM * sine - SUNK
    turned = np.array([math.cos(heading), math.sin(heading)])
    c, s = math.cos(heading / 2), math.sin(heading / 2)
    attitude = [
        c * math.cos(lean / 2),
        -s * math.sin(lean / 2),
        c * math.sin(lean / 2),
        s * math.cos(lean / 2),
    ]
    prism = body(
        "prism", free([*over * turned, height], orientation=attitude), MASS, inertia=[ACROSS, ACROSS, ABOUT]
    )
    vertices = [[x, y, z] for x, y in foot.tolist() for z in (-HIGH, HIGH)]
    shapes = [
        {"name": "prism", "body": "prism", "parts": [{"type": "convex", "vertices": vertices}]},
        {"name": "slab", "body": None, "parts": [{"type": "box", "size": [50, 50, 2], "centre": [0, 0, -1]}]},
    ]
    law = {"stiffness": STIFFNESS, "damping_time": DAMPED, "friction": FRICTION}
    pair = {"name": "p", "group": "prism", "shapes": ["prism", "slab"], "places": 20, **law}
    system = document([prism], shapes=shapes, pairs=[pair])
    run = adaptive(system, DURATION, tension_tolerance=0.1, sample_interval=0.02)
    start = [over, height, lean, 0.0, 0.0, 0.0, *[0.0] * len(bearing)]
    exactly = {"rtol": 1e-9, "atol": 1e-11, "max_step": 4e-3}
    own = solve_ivp(rates, (0, DURATION), start, "LSODA", run.time, args=(bearing,), **exactly).y
    w, x, y, z = run.body("prism", "body_orientation").T
    # The body's own z axis lies over along the heading by the sine of its lean.
    leans = np.arcsin(2 * np.stack([x * z + w * y, y * z - w * x], axis=1) @ turned)
    place = run.body("prism")
    ours = np.array([place[:, :2] @ turned, place[:, 2], leans])
    assert np.abs(ours - own[:3]).max() < 1e-7
    assert np.abs(place[:, :2] @ [-turned[1], turned[0]]).max() < 1e-7
    assert (np.diff(np.sign(own[2, own[2] ** 2 > 1e-6])) != 0).sum() >= 3
    assert run.energy_remainder < 1e-9
