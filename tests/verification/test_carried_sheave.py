"""A sheave with true tangents on a bar that turns right over, against equations of its own.

The bar hangs by a hinge and carries the sheave; a rope runs from a point of the world over it to a load. In
a plane a rope pulls along its tangents from where they touch, so that the sheave is pulled by T (d₁ + d₂)
through its centre, and T = max(0, EA (ℓ₁ + ℓ₂ + r β − L)/L). scipy's DOP853 solves that. The bar turns by
237°, the rope goes slack and taut, and the wrap β, followed beyond lift-off, becomes negative.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp

from mechanics import Floats, G, adaptive, body, document, end, hinge, point, rope, sheave

RADIUS, STIFFNESS, LOAD = 0.4, 2e5, 250.0
BAR, BAR_INERTIA, ANGLE = 300.0, 200.0, -0.3
#: Points (x, z): where the rope begins in the world; centres of sheave and bar on the bar [m].
ANCHOR, CENTRE, BAR_CENTRE = np.array([-3.0, 6.0]), np.array([2.3, 0.35]), np.array([1.2, -0.1])
LASTS = 5.0


def turned(angle: float, at: Floats) -> Floats:
    """A point of the bar after a turn about +y."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([c * at[0] + s * at[1], -s * at[0] + c * at[1]])


def tangent(centre: Floats, to: Floats, side: float) -> tuple[float, float, Floats]:
    """Length of the tangent from the sheave, the angle at which it touches, and its direction."""
    way = to - centre
    far = float(np.hypot(*way))
    at = math.atan2(way[1], way[0]) + side * math.acos(RADIUS / far)
    length = math.sqrt(far**2 - RADIUS**2)
    touch = centre + RADIUS * np.array([math.cos(at), math.sin(at)])
    return length, at, (to - touch) / length


def routed(angle: float, load: Floats) -> tuple[float, float, Floats, Floats]:
    """Length of the rope, its wrap, and its directions from the sheave to the anchor and to the load."""
    centre = turned(angle, CENTRE)
    before, arrives, back = tangent(centre, ANCHOR, -1.0)
    after, leaves, on = tangent(centre, load, 1.0)
    # Here the wrap stays within half a turn.
    wrap = math.remainder(arrives - leaves, 2 * math.pi)
    return before + after + RADIUS * wrap, wrap, back, on


def test_a_sheave_that_turns_over_with_its_bar() -> None:
    """Angle, load and wrap over 5 s to 1e-6: scipy steps across the moments at which the rope goes slack."""
    start = turned(ANGLE, CENTRE) + np.array([RADIUS + 0.8, -3.0])
    length = routed(ANGLE, start)[0] - 0.02

    def rates(_: float, y: Floats) -> list[float]:
        reach, _, back, on = routed(y[0], y[1:3])
        tension = max(0.0, STIFFNESS * (reach - length) / length)
        (x, z), pull = turned(y[0], CENTRE), tension * (back + on)
        moment = z * pull[0] - x * pull[1] + BAR * G * turned(y[0], BAR_CENTRE)[0]
        turning = moment / (BAR_INERTIA + BAR * float(BAR_CENTRE @ BAR_CENTRE))
        falling = -tension / LOAD * on - np.array([0.0, G])
        return [*y[3:], turning, *falling]

    times = np.linspace(0, LASTS, 101)
    tight = {"rtol": 1e-10, "atol": 1e-11, "max_step": 0.01}
    own = solve_ivp(rates, (0, LASTS), [ANGLE, *start, 0, -1.5, 0], "DOP853", times, **tight).y.T
    wraps = np.array([routed(y[0], y[1:3])[1] for y in own])
    assert np.ptp(own[:, 0]) > math.radians(230), "the bar must turn over"
    assert wraps.min() < -1.0, "the rope must have left the sheave"

    middle = (BAR_CENTRE[0], 0, BAR_CENTRE[1])
    bodies = [
        body("bar", hinge(position=ANGLE), BAR, centre_of_gravity=middle, inertia=(1, BAR_INERTIA, 1)),
        body("load", point((start[0], 0, start[1]), (-1.5, 0, 0)), LOAD),
    ]
    over = sheave("bar", (CENTRE[0], 0, CENTRE[1]), (0, 1, 0), RADIUS)
    route = [end(None, (ANCHOR[0], 0, ANCHOR[1])), over, end("load")]
    run = adaptive(
        document(bodies, ropes=[rope("r", length, route, STIFFNESS)]),
        LASTS,
        position_tolerance=1e-8,
        sample_interval=LASTS / 100,
    )
    assert np.abs(run.joint("bar") - own[:, 0]).max() < 1e-6
    assert np.abs(run.body("load")[:, [0, 2]] - own[:, 1:3]).max() < 1e-6
    assert np.abs(run.columns["wrap_angle"][:, 0] - wraps).max() < 1e-6
    assert run.events("slack") and run.events("rope_off_sheave")
