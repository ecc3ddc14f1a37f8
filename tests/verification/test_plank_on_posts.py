"""A plank that falls aslant onto two posts narrower than itself, rocks and slides, against its equations.

The top edges of the posts press on the plank's underside, so the plane of each spot, and the place where its
friction sticks, go with the plank. With e how far such an edge is inside the plank, x how far along it, both
in its axes, and two corners for each edge seen from the side,

    N = 2 max(0, k (e + τ e'))      F* = 2 k (x - a + τ x')      F = F* where |F*| < μ N, else ± μ N
    2 k τ a' = F* - F               heat: F a'

on the plank along its axes, at the edge. An edge that does not press takes its place a along. scipy's LSODA
solves that with the motion of the plank in its plane.
"""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from mechanics import Floats, G

MASS, SIZE = 3000.0, np.array([8.0, 1.0, 0.5])
INERTIA = MASS / 12 * float(SIZE @ SIZE - SIZE[1] ** 2)
STIFFNESS, TAU = 3e6, 0.01
#: Middle and width of both posts, their height and breadth [m].
POSTS, HIGH, BROAD = ((-1.5, 0.6), (2.0, 0.8)), 1.0, 0.8
EDGES = np.array([[middle + side * width / 2, HIGH] for middle, width in POSTS for side in (-1, 1)])
PLACE, LEAN, SPEED, LASTS = np.array([0.3, 1.35]), 0.06, 0.8, 2.0


def axes(lean: float) -> Floats:
    """Rows are the plank's directions along and upwards, turned about y."""
    cos, sin = math.cos(lean), math.sin(lean)
    return np.array([[cos, -sin], [sin, cos]])


def rates(state: Floats, friction: float) -> Floats:
    """Of place and lean, their speeds, where each edge sticks, and heat."""
    place, lean, velocity, rate, held_at = state[:2], state[2], state[3:5], state[5], state[6:10]
    own = axes(lean)
    force, moment, follows, heat = np.array([0.0, -MASS * G]), 0.0, [], 0.0
    for edge, at in zip(EDGES, held_at, strict=True):
        arm = edge - place
        along, above = own @ arm
        passing, entering = own @ -(velocity + rate * np.array([arm[1], -arm[0]]))
        normal = 2 * max(0.0, STIFFNESS * (above + SIZE[2] / 2 + TAU * entering))
        asked = 2 * STIFFNESS * (along - at + TAU * passing)
        held = max(-friction * normal, min(friction * normal, asked))
        if normal > 0:
            follows.append((asked - held) / (2 * STIFFNESS * TAU))
            heat += held * follows[-1]
        else:
            follows.append(passing + (along - at) / 1e-4)
        push = own.T @ np.array([held, normal])
        force, moment = force + push, moment + push[0] * arm[1] - push[1] * arm[0]
    return np.array([*velocity, rate, *(force / MASS), moment / INERTIA, *follows, heat])


def lift(friction: float) -> str:
    """The lift file."""

    def metres(*values: float) -> list[str]:
        return [f"{float(value)!r} m" for value in values]

    along, upwards = (float(part) for part in axes(LEAN) @ [SPEED, 0.0])
    turns = [f"{MASS / 12 * float(SIZE @ SIZE - one**2)!r} kg m^2" for one in SIZE]
    plank: dict[str, Any] = {
        "at": metres(PLACE[0], 0, PLACE[1]),
        "orientation": {"about": [0, 1, 0], "angle": f"{LEAN} rad"},
        "joint": {"type": "free", "velocity": [f"{along!r} m/s", "0 m/s", f"{upwards!r} m/s"]},
        "mass": f"{MASS} kg",
        "inertia": dict(zip(("xx", "yy", "zz"), turns, strict=True)),
        "shape": {"box": metres(*SIZE)},
    }
    bodies, touching = {"plank": plank}, {}
    for name, (middle, width) in zip(("west", "east"), POSTS, strict=True):
        shape = {"box": metres(width, BROAD, HIGH)}
        at = metres(middle, 0, HIGH / 2)
        bodies[name] = {"at": at, "joint": {"type": "fixed"}, "mass": "1 t", "shape": shape}
        law = {"stiffness": f"{STIFFNESS} N/m", "damping": f"{STIFFNESS * TAU} N s/m", "friction": friction}
        touching[name] = {"between": ["plank", name], **law}
    given = {
        "format": 1,
        "lift": {"title": "A plank"},
        "duration": f"{LASTS} s",
        "start": "as_given",
        "mechanics": {
            "bodies": bodies,
            "body_contacts": {f"on_{name}": one for name, one in touching.items()},
        },
    }
    return json.dumps(given)


@pytest.mark.parametrize("friction", [0.05, 0.25])
def test_a_plank_rocks_and_slides_on_edges(friction: float) -> None:
    """Place and lean over 2 s to 1e-7, as a hundred steps of 1 nm leave; the heat of friction to 1e-6."""
    run = simulate(parse_scenario(lift(friction)), position_tolerance=1e-9, tension_tolerance=0.1)
    sticks = [float((axes(LEAN) @ (edge - PLACE))[0]) for edge in EDGES]
    start = [*PLACE, LEAN, SPEED, 0.0, 0.0, *sticks, 0.0]
    own = solve_ivp(
        lambda _, state: rates(state, friction),
        (0, LASTS),
        start,
        "LSODA",
        run.time,
        rtol=1e-9,
        atol=1e-11,
        max_step=4e-3,
    ).y
    place = run.column("body_position", "plank")
    w, _, y, _ = run.column("body_orientation", "plank").T
    assert np.abs(place[:, [0, 2]].T - own[:2]).max() < 1e-7
    assert np.abs(2 * np.arctan2(y, w) - own[2]).max() < 1e-7
    assert own[0, -1] - PLACE[0] > 0.1, "it must slide"
    kinds = run.coordinates["energy_kind"]
    heat = run.variables["energy"].values[-1, kinds.index("friction")]
    assert heat == pytest.approx(own[-1, -1], rel=1e-6)
