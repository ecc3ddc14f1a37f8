"""A line over a deflection sheave whose axis turns: a swinging weight and the arm that bears the sheave.

A weight swings on a rope. A line leads from it over a sheave on an arm that turns about an axis aslant, to a
winch on the same arm. The sheave's axis is aslant too, so that the line comes to it at a fleet angle that
changes all the time. The line leaves the circle where its direction along the circle's plane is tangential,
u·D = 0 (SH1), which a plane has in closed form: with p' the end seen in it, angles φ ± arccos(r/|p'|). Its
length ℓ(p, θ) is two straight parts and the arc between, forces are T ∂ℓ by central differences, and scipy's
DOP853 solves weight, arm and what the winch has paid out.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import Floats, G, adaptive, body, document, drum, end, flow, hinge, point, rope, sheave
from rigid import across

MASS, HUNG, HUNG_EA, HUNG_TAU = 800.0, 7.995, 3e6, 0.01
EA, TAU = 500e3, 0.02
ARM, RADIUS = np.array([12.0, 0.0, -8.0]), 0.25
#: Centre of the sheave and place of the winch, in the arm's axes.
CENTRE, WINCH = np.array([-0.3, 0.4, 0.2]), np.array([0.0, 2.0, 0.3])
INERTIA = np.array([50.0, 50.0, 80.0])
START = np.array([1.0, 0.3, -8.0])
DURATION, RAMP, DIFFERENCE = 4.0, 0.5, 1e-5


def touching(place: Floats, sense: float) -> tuple[float, float]:
    """Angle at which a line from a place touches the circle, and its length.

    The place is seen from the centre, along two directions in the plane of the circle and out of it.
    `sense` is 1 where it comes in, -1 where it goes out.
    """
    x, y, z = place.tolist()
    middle, aside = math.atan2(y, x), math.acos(RADIUS / math.hypot(x, y))
    for angle in (middle + aside, middle - aside):
        cosine, sine = math.cos(angle), math.sin(angle)
        # Where it touches less the place, along (-sin, cos).
        if sense * (x * sine - y * cosine) > 0.0:
            return angle, math.hypot(RADIUS * cosine - x, RADIUS * sine - y, z)
    raise AssertionError("one of both leads that way")


@pytest.mark.parametrize("seed", [0, 4])
def test_weight_and_arm_move_as_the_length_of_the_line_says(seed: int) -> None:
    """Through several snatches, while the arm turns by half a radian: place and angle to 1e-6."""
    draw = np.random.default_rng(seed)
    turns_about = np.array([*draw.uniform(-0.5, 0.5, 2), 1.0])
    turns_about /= np.linalg.norm(turns_about)
    axis = np.array([*draw.uniform(-0.3, 0.3, 2), 1.0])
    velocity = np.array([*draw.uniform(-1.0, 1.0, 2), 0.0])
    spin, damping, speed = draw.uniform(-0.3, 0.3), draw.uniform(0.0, 100.0), draw.uniform(-0.3, 0.2)
    system = document(
        [
            body("weight", point(START, velocity=velocity.tolist()), MASS),
            body(
                "arm",
                hinge(list(turns_about), velocity=spin, damping=damping),
                200.0,
                position=list(ARM),
                inertia=list(INERTIA),
            ),
            flow("winch", 30.0, drive="winch.drive"),
        ],
        ropes=[
            rope("hung", HUNG, [end(None), end("weight")], HUNG_EA, HUNG_TAU),
            rope(
                "line",
                None,
                [end("weight"), sheave("arm", list(CENTRE), list(axis), RADIUS), drum("arm", WINCH, "winch")],
                EA,
                TAU,
            ),
        ],
        drives=[{"name": "winch.drive", "ramps": [{"at": 0.0, "duration": RAMP, "velocity": speed}]}],
    )

    normal = axis / np.linalg.norm(axis)
    first = np.cross(normal, [1.0, 0.0, 0.0])
    first /= np.linalg.norm(first)
    # Rows: two directions in the plane of the circle and its normal, in the axes of the arm.
    plane = np.array([first, np.cross(normal, first), normal])
    spun = across(turns_about)
    # Of the winch, which goes along: the same at any angle.
    goes, after = touching(plane @ (WINCH - CENTRE), -1.0)

    def seen(place: Floats, angle: float) -> Floats:
        """A place from the centre, in the plane of the circle and out of it."""
        back = np.eye(3) - math.sin(angle) * spun + (1.0 - math.cos(angle)) * (spun @ spun)
        return np.asarray(plane @ (back @ (place - ARM) - CENTRE))

    def length(place: Floats, angle: float) -> float:
        comes, before = touching(seen(place, angle), 1.0)
        return before + after + RADIUS * ((goes - comes) % (2.0 * math.pi))

    def gradient(place: Floats, angle: float) -> Floats:
        found = [
            (length(place + step, angle) - length(place - step, angle)) / (2.0 * DIFFERENCE)
            for step in DIFFERENCE * np.eye(3)
        ]
        ahead, behind = length(place, angle + DIFFERENCE), length(place, angle - DIFFERENCE)
        return np.array([*found, (ahead - behind) / (2.0 * DIFFERENCE)])

    whole = length(START, 0.0)
    inertia = float(turns_about @ (INERTIA * turns_about))

    def rates(time: float, y: Floats) -> Floats:
        place, angle, rate, turning, unstretched = y[:3], y[3], y[4:7], y[7], y[8]
        paid = speed * min(1.0, time / RAMP)
        stretch, slope = length(place, angle) - unstretched, gradient(place, angle)
        strain, share = stretch / unstretched, math.sqrt(whole / unstretched)
        # (WI2): what winds up is stretched as the line is; what comes off was wound without tension.
        supply = paid / (1.0 + max(0.0, strain)) if paid < 0.0 else paid
        lengthens = float(slope[:3] @ rate + slope[3] * turning) - supply * (1.0 + strain / 2.0)
        tension = max(0.0, share * share * EA / whole * (stretch + TAU * lengthens))
        far = float(np.linalg.norm(place))
        hung = max(0.0, HUNG_EA / HUNG * (far - HUNG + HUNG_TAU * float(place @ rate) / far))
        falls = -(tension * slope[:3] + hung * place / far) / MASS - np.array([0.0, 0.0, G])
        return np.array([*rate, turning, *falls, -(tension * slope[3] + damping * turning) / inertia, supply])

    run = adaptive(system, DURATION, tension_tolerance=1e-2, position_tolerance=1e-9, sample_interval=0.05)
    start = [*START, 0.0, *velocity, spin, whole]
    own = solve_ivp(rates, (0.0, DURATION), start, "DOP853", run.time, rtol=1e-9, atol=1e-10, max_step=0.02)
    # 4e-9 with tolerances of 1e-10 of the other solution, which steps over kinks where the line goes slack.
    assert np.abs(run.body("weight") - own.y[:3].T).max() < 1e-6
    assert np.abs(run.joint("arm") - own.y[3]).max() < 1e-6
    assert np.abs(own.y[3]).max() > 0.4
    assert len(run.events("taut")) >= 2
    assert run.energy_remainder < 1e-10
