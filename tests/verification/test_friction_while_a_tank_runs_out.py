"""A pendulum in a hinge with dry friction, on a cart between two ropes, while its tank is pumped out.

The cart goes by X, the pendulum hangs θ from plumb about y; its own mass M₀ and what is in its tank, m,
have the first moment P and the second one I about the hinge. With m given over time, and the liquid frozen
upright as far as its inertia goes, its weight where it is (docs/concepts/ballast.md),

    (M_c + M₀ + m) Ẍ + P cos θ θ̈ − P sin θ θ̇² = T_r − T_l      I θ̈ + P cos θ Ẍ = −∂U/∂θ − R sgn θ̇

while it turns, and θ̈ = 0 while |P cos θ Ẍ + ∂U/∂θ| < R holds it. What lies over a bottom of 2a × w up to
the depth h, its surface level, has ρ ẑ·b = m (z_b + h/2) cos θ − ρ w a³/3 sin θ tan θ, z_b the height of
the bottom from the hinge. scipy's DOP853 integrates from one turn of the motion to the next.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import cumulative_simpson, solve_ivp

from mechanics import Floats, G, Json, adaptive, body, document, end, hinge, rope, simulate, slider

CART, OWN, CENTRE, SPIN = 6e3, 4e3, -3.0, 8e3
#: Moment of the friction [N m].
FRICTION = 9e3
#: Half of the tank along x, its breadth, height of its bottom from the hinge, its own height [m].
HALF, BROAD, BOTTOM, TALL = 1.0, 1.5, -5.0, 3.0
RHO = 1025.0
DEEP = 2.2
#: Content at the start [kg], pumped out at a rate [kg/s] with ramps between times [s].
START, RATE, BEGIN, STOP, RAMP = RHO * 2 * HALF * BROAD * DEEP, 700.0, 1.0, 7.0, 0.5
#: Ropes from the cart to walls 10 m off.
EA, LENGTH, WALL, TAU = 300e3, 8.0, 10.0, 0.02
DURATION, FIRST = 14.0, 0.35
#: Level of what is pumped into [m].
LEVEL = -8.0


def pumped(time: Any) -> tuple[Any, Any]:
    """What has been pumped in [kg], and its rate [kg/s]."""

    def ramp(at: float) -> tuple[Any, Any]:
        later = np.maximum(time - at, 0.0)
        share = np.minimum(later, RAMP)
        return 0.5 * share**2 / RAMP + np.maximum(later - RAMP, 0.0), share / RAMP

    (on, on_rate), (off, off_rate) = ramp(BEGIN), ramp(STOP)
    return -RATE * (on - off), -RATE * (on_rate - off_rate)


def pulls(place: Any, speed: Any) -> tuple[Any, Any]:
    """Tensions to the left and to the right [N]."""
    return tuple(
        np.maximum(0.0, EA / LENGTH * (WALL + side * place - LENGTH + TAU * side * speed)) for side in (1, -1)
    )


def parts(time: Any, angle: Any) -> tuple[Any, Any, Any, Any]:
    """Mass of all, P, I, and ∂U/∂θ."""
    content = START + pumped(time)[0]
    deep = content / (RHO * 2 * HALF * BROAD)
    first = OWN * CENTRE + content * (BOTTOM + deep / 2)
    second = OWN * CENTRE**2 + SPIN
    second = second + content * (HALF**2 / 3 + BOTTOM**2 + BOTTOM * deep + deep**2 / 3)
    sin, cos = np.sin(angle), np.cos(angle)
    surface = RHO * BROAD * HALF**3 / 3 * (sin + sin / cos**2)
    return CART + OWN + content, first, second, -G * (first * sin + surface)


def rates(time: float, state: Floats, side: float) -> tuple[list[float], float]:
    """Of X, θ and their speeds, and the moment that friction bears; `side` is the way it turns, 0 held."""
    place, angle, speed, turn = state
    left, right = pulls(place, speed)
    mass, first, second, slope = parts(time, angle)
    across = right - left + first * math.sin(angle) * turn**2
    coupled = first * math.cos(angle)
    if side == 0.0:
        starts = across / mass
        return [speed, 0.0, starts, 0.0], -coupled * starts - slope
    matrix = np.array([[mass, coupled], [coupled, second]])
    starts, turns = np.linalg.solve(matrix, [across, -slope - FRICTION * side])
    return [speed, turn, starts, turns], side * FRICTION


def own(times: Floats) -> tuple[Floats, int]:
    """X, θ and their speeds at times [s], (4, times); and how often the friction held it."""
    found = np.empty((4, len(times)))
    now, state, held = 0.0, np.array([0.0, FIRST, 0.0, 0.0]), 0
    while now < DURATION:
        if state[3] == 0.0:
            moment = rates(now, state, 0.0)[1]
            side = math.copysign(1.0, moment) if abs(moment) > FRICTION * (1 + 1e-12) else 0.0
            held += side == 0.0
        else:
            side = math.copysign(1.0, state[3])

        def turns(time: float, y: Floats, side: float = side) -> float:
            return abs(rates(time, y, side)[1]) - FRICTION if side == 0.0 else y[3] * side

        turns.terminal, turns.direction = True, 1 if side == 0.0 else -1  # type: ignore[attr-defined]
        # Ramps begin and end where a step does.
        stops = [one for one in (BEGIN, BEGIN + RAMP, STOP, STOP + RAMP, DURATION) if one > now + 1e-12]
        part = solve_ivp(
            lambda time, y, side=side: rates(time, y, side)[0], (now, stops[0]), state, "DOP853",
            dense_output=True, events=turns, rtol=1e-11, atol=1e-12, first_step=1e-5, max_step=0.05,
        )  # fmt: skip
        inside = (times >= now) & (times <= part.t[-1])
        found[:, inside] = part.sol(times[inside])
        now, state = float(part.t[-1]), part.y[:, -1].copy()
        if part.status == 1:
            state[3] = 0.0 if side != 0.0 else math.copysign(1e-13, rates(now, state, 0.0)[1])
    return found, held


def lift() -> Json:
    """The same as a document of the core."""
    corners = [
        [x * HALF, y * BROAD / 2, z]
        for z in (BOTTOM, BOTTOM + TALL)
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    quads = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    triangles = [tri for a, b, c, d in quads for tri in ((a, b, c), (a, c, d))]
    tank = {
        "type": "tank", "name": "tank", "body": "pendulum", "vertices": corners, "triangles": triangles,
        "density": RHO, "volume": START / RHO, "pumped": {"content": "content", "level": LEVEL},
    }  # fmt: skip
    bodies = [
        body("cart", slider((1, 0, 0)), CART),
        body(
            "pendulum", hinge(position=FIRST, friction=FRICTION), OWN, parent="cart",
            centre_of_gravity=(0, 0, CENTRE), inertia=(1e3, SPIN, 1e3),
        ),
        body("content", {"type": "content", "drive": "pump"}, 0.0, parent="pendulum"),
    ]  # fmt: skip
    ropes = [
        {**rope(name, LENGTH, [end(None, (x, 0, 0)), end("cart")], EA, TAU), "is_stretched": True}
        for name, x in (("left", -WALL), ("right", WALL))
    ]
    ramps = [{"at": at, "duration": RAMP, "velocity": rate} for at, rate in ((BEGIN, -RATE), (STOP, 0.0))]
    drives = [{"name": "pump", "ramps": ramps}]
    return document(bodies, ropes=ropes, forces=[tank], drives=drives)


def test_it_swings_and_is_held() -> None:
    """Cart, pendulum, ropes and books by `adaptive`, which is told 1 nm and 0.05 N; the own steps are finer.

    Over some hundred steps that adds up to 10 nm, and 100 nm of a rope are 4 mN. Simpson's rule over samples
    of 10 ms leaves 1e-7 of the work of the pump, and 5e-5 of the friction's, whose power has corners where
    the motion turns.
    """
    run = adaptive(lift(), DURATION, tension_tolerance=0.05, position_tolerance=1e-9)
    found, held = own(run.time)
    place, angle, speed, turn = found
    assert held >= 2 and abs(turn[-1]) == 0.0
    assert run.joint("cart") == pytest.approx(place, abs=1e-7)
    assert run.joint("pendulum") == pytest.approx(angle, abs=1e-7)
    for name, pull in zip(("left", "right"), pulls(place, speed), strict=True):
        assert run.tension(name) == pytest.approx(pull, abs=0.01)
    content, rate = pumped(run.time)
    high = BOTTOM + (START + content) / (RHO * 2 * HALF * BROAD)
    # Of a kilogram at the surface: its height over where it goes, and its motion, with the surface's spread.
    each = G * (high * np.cos(angle) - LEVEL) + 0.5 * (
        speed**2 + 2 * speed * turn * high * np.cos(angle) + turn**2 * (high**2 + HALF**2 / 3)
    )
    work = cumulative_simpson(each * rate, x=run.time, initial=0)
    assert run.energy("drive_work")[-1] == pytest.approx(work[-1], rel=1e-7)
    heat = cumulative_simpson(FRICTION * np.abs(turn), x=run.time, initial=0)
    assert run.energy("friction")[-1] == pytest.approx(heat[-1], rel=5e-5)
    assert run.energy_remainder < 1e-7


def test_it_does_by_steps_of_one_length() -> None:
    """`del` is wrong by what falls with its step, on the whole: half the step, half of that."""
    times = np.linspace(0.0, DURATION, round(DURATION / 0.01) + 1)
    angle = own(times)[0][1]
    wrong = []
    for step in (2e-3, 1e-3):
        run = simulate(lift(), DURATION, step=step, sample_interval=0.01)
        wrong.append(float(np.abs(run.joint("pendulum") - angle).max()))
    assert wrong[1] < 3e-3
    assert wrong[0] / wrong[1] == pytest.approx(2.0, rel=0.1)
