"""A bar in a hinge on a barge in a regular wave, raised by a rope over two sheaves with losses onto a drum,
against equations of its own.

The barge heaves by z and pitches by θ, the bar turns by φ about its hinge; J are the derivatives of the
places of their centres of gravity over q = (z, θ, φ):

    (Σ m Jᵀ J + I) q̈ = Σ m Jᵀ (g - J̇ q̇) + buoyancy + g(t) Re(X a e^{i(ε - ωt)}) - B q̇ - T₁ ∂ℓ₁/∂q

Buoyancy is that of the polygon of its box below the water. The rope has three spans, from the bar to the
first sheave, to the second, to the drum, (F1) to (F7) of docs/concepts/flows.md:

    T = w max(0, EA/L₀ (g + τ ġ))    I_s s̈ = T₂ (1 + ε₂/2) - T₁ (1 + ε₁/2) - σ (T₁ + T₂) ṡ/√(ṡ² + v₀²)

and the drum winds up by (WI2) as its ramp says. By v₀ sheaves creep that hold. scipy's LSODA solves that.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import (
    Floats,
    G,
    Json,
    adaptive,
    body,
    document,
    drum,
    end,
    flow,
    half_turn,
    hinge,
    rope,
    slider,
)

RHO = 1025.0
#: The barge: length, breadth, draft and height of its box [m], origin amidships at the waterline.
LONG, BROAD, DRAFT, TALL = 60.0, 20.0, 3.0, 6.0
BAR, CENTRE, TIP, BAR_INERTIA = 60e3, 10.0, 22.0, 2.16e6
BARGE, RAISED = RHO * LONG * BROAD * DRAFT - BAR, 0.5
BARGE_INERTIA = BARGE * 17.0**2
#: Of heave and pitch.
ADDED, DAMPING = (4e6, 1e9), (1.5e6, 3e8)
#: Places on the barge, x and z [m]: the hinge, where the rope meets its sheaves and leaves them, the drum.
HINGE, START = (5.0, 3.5), -math.radians(15.0)
MEETS, LEAVES, RADIUS = ((2.4, 20.0), (-2.6, 20.0)), ((1.6, 20.0), (-3.4, 20.0)), 0.4
DRUM = (-12.0, 4.0)
RATIOS, INERTIA = (1.06, 1.08), 150.0
EA, TAU = 60e6, 0.01
#: The wave, and what it does to heave and pitch per metre.
WAVE, OMEGA, LATE, RISE = 0.8, 0.75, 0.4, 4.0
FORCES = (3.0e6 * (1 + 0.3j), 6.0e7 * (0.4 + 1j))
#: Of the drum: when it starts, within which time, and its speed, paying out positive.
AT, WITHIN, SPEED = 2.0, 1.5, -0.15
#: v₀ [m/s].
CREEP = 1e-5


def along(angle: float) -> Floats:
    """x of a body that is turned about y, in x and z of the world."""
    return np.array([math.cos(angle), -math.sin(angle)])


def up(angle: float) -> Floats:
    return np.array([math.sin(angle), math.cos(angle)])


def of_barge(at: tuple[float, float], q: Floats) -> tuple[Floats, Floats]:
    """A place of the barge, and its derivatives (3, 2) over q."""
    x, z = at
    heave, pitch = q[:2].tolist()
    cos, sin = math.cos(pitch), math.sin(pitch)
    ahead, above = x * cos + z * sin, z * cos - x * sin
    return np.array([ahead, heave + above]), np.array([[0, 1], [above, -ahead], [0, 0]])


def of_bar(out: float, q: Floats) -> tuple[Floats, Floats]:
    place, slopes = of_barge(HINGE, q)
    beyond = -out * up(q[1] + q[2])
    return place + out * along(q[1] + q[2]), slopes + np.array([[0, 0], beyond, beyond])


def first_span(q: Floats) -> tuple[float, Floats]:
    """Its straight part and the derivatives of that."""
    (tip, tip_slopes), (sheave, sheave_slopes) = of_bar(TIP, q), of_barge(MEETS[0], q)
    length = math.dist(tip, sheave)
    slopes: Floats = (tip_slopes - sheave_slopes) @ ((tip - sheave) / length)
    return length, slopes


def buoyancy(q: Floats) -> Floats:
    """Of heave and pitch: ρ g B times the area of the box below z = 0, and that times the x of its centre."""
    half = LONG / 2
    corners = [(-half, -DRAFT), (half, -DRAFT), (half, TALL - DRAFT), (-half, TALL - DRAFT)]
    points = [of_barge(corner, q)[0].tolist() for corner in corners]
    wet = []
    for p, r in zip(points, points[1:] + points[:1], strict=True):
        if p[1] <= 0:
            wet.append(p)
        if (p[1] < 0) != (r[1] < 0):
            wet.append([p[0] + p[1] / (p[1] - r[1]) * (r[0] - p[0]), 0.0])
    area = moment = 0.0
    for p, r in zip(wet, wet[1:] + wet[:1], strict=True):
        cross = p[0] * r[1] - r[0] * p[1]
        area, moment = area + cross / 2, moment + (p[0] + r[0]) * cross / 6
    return RHO * G * BROAD * np.array([area, -moment, 0.0])


ARC = math.pi * RADIUS
FIXED = (math.dist(LEAVES[0], MEETS[1]) + ARC, math.dist(LEAVES[1], DRUM) + ARC / 2)
AT_START = (first_span(np.array([0, 0, START]))[0] + ARC / 2, *FIXED)
#: The rope begins with nine tenths of what holds the bar.
PULL = 0.9 * BAR * G * CENTRE * math.cos(START) / first_span(np.array([0, 0, START]))[1][2]
LENGTHS = [length / (1 + PULL / EA) for length in AT_START]


def asked(time: float) -> float:
    return SPEED * min(1.0, max(0.0, (time - AT) / WITHIN))


def rates(time: float, state: Floats) -> Floats:
    """Of q, q̇, both s, both ṡ, and the rope that the drum has let out."""
    q, v, (*s, first, other, out) = state[:3], state[3:6], state[6:].tolist()
    runs = (first, other)
    straight, slopes = first_span(q)
    spans = [straight + ARC / 2, *FIXED]
    lengths = [LENGTHS[0] - s[0], LENGTHS[1] + s[0] - s[1], LENGTHS[2] + s[1] + out]
    strains = [(span - length) / length for span, length in zip(spans, lengths, strict=True)]
    fed = asked(time) / (1 + max(0.0, strains[2]))
    grow, goes = (-runs[0], runs[0] - runs[1], runs[1] + fed), (slopes @ v, 0.0, 0.0)
    tensions = []
    for k in range(3):
        w = math.sqrt(LENGTHS[k] / lengths[k])
        stretch, rate = w * (spans[k] - lengths[k]), w * (goes[k] - (1 + strains[k] / 2) * grow[k])
        tensions.append(w * max(0.0, EA / LENGTHS[k] * (stretch + TAU * rate)))
    turn = v[1] + v[2]
    (_, of_one), (_, of_other) = of_barge((0.0, RAISED), q), of_bar(CENTRE, q)
    swings = -(v[1] ** 2) * RAISED * up(q[1])
    swings_other = -(v[1] ** 2) * (HINGE[0] * along(q[1]) + HINGE[1] * up(q[1]))
    swings_other = swings_other - turn**2 * CENTRE * along(q[1] + q[2])
    mass = BARGE * of_one @ of_one.T + BAR * of_other @ of_other.T
    mass += np.diag([ADDED[0], ADDED[1] + BARGE_INERTIA, 0.0])
    mass[1:, 1:] += BAR_INERTIA
    down = np.array([0.0, -G])
    force = BARGE * of_one @ (down - swings) + BAR * of_other @ (down - swings_other) + buoyancy(q)
    later = min(1.0, time / RISE)
    wave = later**3 * (10 - 15 * later + 6 * later**2) * WAVE * np.exp(1j * (LATE - OMEGA * time))
    force[:2] += [(FORCES[k] * wave).real - DAMPING[k] * v[k] for k in (0, 1)]
    turns = []
    for k, ratio in enumerate(RATIOS):
        held = (
            (ratio - 1) / (ratio + 1) * (tensions[k] + tensions[k + 1]) * runs[k] / math.hypot(runs[k], CREEP)
        )
        pulls = [tensions[k + side] * (1 + strains[k + side] / 2) for side in (0, 1)]
        turns.append((pulls[1] - pulls[0] - held) / INERTIA)
    return np.concatenate([v, np.linalg.solve(mass, force - tensions[0] * slopes), runs, turns, [fed]])


def lift() -> Json:
    """The same as a document of the core."""

    def place(at: tuple[float, float]) -> list[float]:
        return [at[0], 0.0, at[1]]

    half, side = LONG / 2, BROAD / 2
    levels = (-DRAFT, TALL - DRAFT)
    corners = [[x * half, y * side, z] for z in levels for y in (-1, 1) for x in (-1, 1)]
    faces = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4)]
    faces += [(2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    added, damping = np.zeros((6, 6)), np.zeros((6, 6))
    added[2, 2], added[4, 4] = ADDED
    damping[2, 2], damping[4, 4] = DAMPING
    phasors = np.zeros((4, 6, 2))
    phasors[0, 2], phasors[0, 4] = [(part.real, part.imag) for part in FORCES]
    about: Json = {"body": "barge", "at": [0, 0, 0]}
    mesh = {"vertices": corners, "triangles": faces, "density": RHO, "level": 0.0}
    pushed = {"origin": [0, 0, 0], "directions": [0.0], "phasors": [[phasors.tolist()]]}
    resisted = {"damping": damping.tolist(), "quadratic": [0.0] * 6}
    component = {"frequency": OMEGA, "wave_number": [OMEGA**2 / G, 0], "amplitude": WAVE, "phase": LATE}
    turned = [(meets[0] + leaves[0]) / 2 for meets, leaves in zip(MEETS, LEAVES, strict=True)]
    sheaves = [
        half_turn("barge", (x, 0, 20.0), -RADIUS, True, flow=f"s{k}", ratio=RATIOS[k])
        for k, x in enumerate(turned)
    ]
    route = [end("bar", (TIP, 0, 0)), *sheaves, drum("barge", place(DRUM), "drum")]
    return document(
        [
            body("heave", slider(), 0.0),
            body(
                "barge", hinge(), BARGE, parent="heave", centre_of_gravity=(0, 0, RAISED),
                inertia=[BARGE_INERTIA] * 3,
            ),
            body(
                "bar", hinge(position=START), BAR, parent="barge", position=place(HINGE),
                centre_of_gravity=(CENTRE, 0, 0), inertia=[BAR_INERTIA] * 3,
            ),
            flow("s0", INERTIA),
            flow("s1", INERTIA),
            flow("drum", 100.0, drive="winch"),
        ],
        ropes=[rope("fall", sum(LENGTHS), route, EA, TAU)],
        drives=[{"name": "winch", "ramps": [{"at": AT, "duration": WITHIN, "velocity": SPEED}]}],
        forces=[
            {"type": "buoyancy", "name": "hull", "body": "barge", **mesh},
            {"type": "added_mass", "name": "added", **about, "matrix": added.tolist()},
            {"type": "drag", "name": "damping", **about, **resisted},
            {"type": "wave", "name": "waves", **about, **pushed},
        ],
        sea={"components": [component], "rise_time": RISE},
    )  # fmt: skip


def test_a_bar_is_raised_on_a_barge_in_a_wave() -> None:
    """Barge, bar and sheaves over 10 s from rest, in which the sheaves hold, turn back and slip. Held sheaves
    creep by v₀ = 1e-5 m/s, 1e-4 m in all; what that lets the bar down by is a twentieth of it over its 22 m.
    """
    duration = 10.0
    run = adaptive(lift(), duration, tension_tolerance=20.0, position_tolerance=1e-8, sample_interval=0.05)
    start: Any = np.zeros(11)
    start[2] = START
    own = solve_ivp(rates, (0, duration), start, "LSODA", run.time, rtol=1e-7, atol=1e-9, max_step=0.05)
    assert own.success
    for name, k, off in (
        ("heave", 0, 2e-6),
        ("barge", 1, 2e-7),
        ("bar", 2, 5e-6),
        ("s0", 6, 1e-4),
        ("s1", 7, 1e-4),
    ):
        assert run.joint(name) == pytest.approx(own.y[k], abs=off), name
    assert np.ptp(own.y[2]) > 0.05 and np.ptp(own.y[0]) > 0.5, "the bar must go up, and the barge heave"
    assert run.energy_remainder < 1e-9
