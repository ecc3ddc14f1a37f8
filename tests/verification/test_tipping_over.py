"""A load that is pulled at its top: it tips over its edge, or slides and nods, against equations of its own.

Corners press by N = max(0, k (e + τ ė)). Along the ground each has an elastic spring with a damper from an
anchor α: with s = x − α the force is F* = k (s + τ ẋ) while |F*| ≤ μ N, else μ N F*/|F*|, and the anchor
slips by α̇ = (F* − F)/(k τ). The rope to the winch is T = max(0, k (e + τ ė)). scipy's LSODA solves the
motion of the rigid load in space.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import Floats, G, adaptive, body, contact, document, end, free, rope, slider
from rigid import cross

MASS, HALF = 2000.0, np.array([0.6, 0.5, 1.2])
INERTIA = (
    MASS
    / 3
    * np.array([HALF[1] ** 2 + HALF[2] ** 2, HALF[0] ** 2 + HALF[2] ** 2, HALF[0] ** 2 + HALF[1] ** 2])
)
CORNERS = np.array([(x, y, -1) for x in (-1, 1) for y in (-1, 1)]) * HALF
STIFFNESS, DAMPING_TIME = 2e6, 0.01
SUNK = MASS * G / 4 / STIFFNESS
#: The lug, a little out of the middle plane; where the winch begins, its speed [m/s] and its ramp [s].
LUG, WINCH, HAULING, RAMP = np.array([0.6, 0.1, 1.2]), np.array([6.6, 0.1, 2.4]), 0.15, 0.5
EA, LENGTH, TAU = 4e5, 6.0, 0.02
LAW: dict[str, Any] = {"stiffness": STIFFNESS, "damping_time": DAMPING_TIME}


def axes(q: Floats) -> Floats:
    """Rotation (3, 3) of a quaternion, w first."""
    w, (x, y, z) = q[0], q[1:]
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + 2 * (w * cross + cross @ cross) / (q @ q))


def pull(time: float, place: Floats, turn: Floats, u: Floats, w: Floats) -> tuple[float, Floats]:
    """Tension [N] and direction of the rope at the lug."""
    begun = min(time, RAMP)
    hauled = HAULING * (begun * begun / (2 * RAMP) + max(0.0, time - RAMP))
    way = place + turn @ LUG - WINCH - [hauled, 0, 0]
    span = float(np.linalg.norm(way))
    speed = u + turn @ cross(w, LUG) - [HAULING * begun / RAMP, 0, 0]
    stretch = span - LENGTH + TAU * float(way @ speed) / span
    return max(0.0, EA / LENGTH * stretch), -way / span


def rates(time: float, state: Floats, friction: float) -> Floats:
    """Of place, quaternion, velocity, spin in the load's axes, and anchors of the corners (4, 2)."""
    place, q, u, w = np.split(state[:13], [3, 7, 10])
    anchors, turn = state[13:].reshape(4, 2), axes(q)
    tension, along = pull(time, place, turn, u, w)
    force = tension * along + [0, 0, -MASS * G]
    moment = cross(turn @ LUG, tension * along)
    slipping = np.zeros((4, 2))
    for k, corner in enumerate(CORNERS):
        arm = turn @ corner
        velocity = u + turn @ cross(w, corner)
        normal = max(0.0, STIFFNESS * (-(place + arm)[2] - DAMPING_TIME * velocity[2]))
        deflection = (place + arm)[:2] - anchors[k]
        if normal == 0.0:
            # A corner in the air holds nothing: its anchor follows within a millisecond.
            slipping[k] = velocity[:2] + deflection / 1e-3
            continue
        held = STIFFNESS * (deflection + DAMPING_TIME * velocity[:2])
        size = float(np.linalg.norm(held))
        carried = held * min(1.0, friction * normal / size) if size > 0.0 else held
        slipping[k] = (held - carried) / (STIFFNESS * DAMPING_TIME)
        push = np.array([-carried[0], -carried[1], normal])
        force, moment = force + push, moment + cross(arm, push)
    turning = (turn.T @ moment - cross(w, INERTIA * w)) / INERTIA
    spun = np.concatenate([[-q[1:] @ w], q[0] * w + cross(q[1:], w)]) / 2
    return np.concatenate([u, spun, force / MASS, turning, slipping.ravel()])


@cache
def course(friction: float, duration: float) -> tuple[Floats, Floats]:
    """Times (21,) [s] and states of `rates` (21, 21)."""
    start = np.concatenate([[0, 0, HALF[2] - SUNK], [1, 0, 0, 0], np.zeros(6), CORNERS[:, :2].ravel()])
    times = np.linspace(0, duration, 21)
    found = solve_ivp(
        rates, (0, duration), start, "LSODA", times, rtol=1e-9, atol=1e-10, max_step=5e-3, args=(friction,)
    )
    return times, np.asarray(found.y.T)


@pytest.mark.parametrize("shapes", [False, True], ids=["corners", "shapes"])
@pytest.mark.parametrize(("friction", "duration"), [(0.9, 4.0), (0.23, 2.5)], ids=["tips", "slides"])
def test_a_load_that_is_pulled_at_its_top(friction: float, duration: float, shapes: bool) -> None:
    """Rough ground: over T > m g a/2c it turns about its edge. Smooth: it slides, rear corners in the air."""
    times, own = course(friction, duration)
    load = body("load", free((0, 0, HALF[2] - SUNK)), MASS, inertia=INERTIA.tolist())
    winch = body("winch", slider((1, 0, 0), drive="haul"), 1.0, position=WINCH.tolist())
    law = {**LAW, "friction": friction}
    touching: dict[str, Any] = {
        "contacts": [contact(f"c{k}", "load", at, **law) for k, at in enumerate(CORNERS.tolist())]
    }
    if shapes:
        parts = {
            "load": {"type": "box", "size": (2 * HALF).tolist()},
            "slab": {"type": "box", "size": [50, 50, 2], "centre": [0, 0, -1]},
        }
        touching = {
            "shapes": [
                {"name": name, "body": "load" if name == "load" else None, "parts": [part]}
                for name, part in parts.items()
            ],
            "pairs": [{"name": "load.slab", "group": "load", "shapes": ["load", "slab"], **law}],
        }
    ramps = [{"at": 0.0, "duration": RAMP, "velocity": HAULING}]
    system = document(
        [load, winch],
        ropes=[rope("r", LENGTH, [end("winch"), end("load", LUG.tolist())], EA, TAU)],
        drives=[{"name": "haul", "ramps": ramps}],
        **touching,
    )
    run = adaptive(
        system, duration, tension_tolerance=0.1, position_tolerance=1e-7, sample_interval=duration / 20
    )
    # 0.1 N on corners of 2 MN/m is 50 nm, and each corner that begins to slide adds to that: 3e-7 m were
    # found.
    assert np.abs(run.body("load") - own[:, :3]).max() < 2e-6
    alike = (run.body("load", "body_orientation") * own[:, 3:7]).sum(axis=1)
    assert np.abs(np.abs(alike) / np.linalg.norm(own[:, 3:7], axis=1) - 1.0).max() < 1e-11
    tension = [pull(t, y[:3], axes(y[3:7]), y[7:10], y[10:13])[0] for t, y in zip(times, own, strict=True)]
    # The same times 70 kN/m of the rope, and its damper.
    assert np.abs(run.tension("r") - tension).max() < 0.2
    over_edge = MASS * G * HALF[0] / (2 * HALF[2])
    tilt = np.degrees(2 * np.arctan2(own[-1, 5], own[-1, 3]))
    if friction > HALF[0] / (2 * HALF[2]):
        assert max(tension) > over_edge and tilt > 10.0
    else:
        assert own[-1, 0] > 0.1 and abs(tilt) < 3.0
        assert {name for _, name in run.events("slip")} == set(run.names["contact"][:4])
    assert run.energy_remainder < 1e-10
