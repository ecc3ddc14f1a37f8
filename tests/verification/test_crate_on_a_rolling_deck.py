"""A crate that slides to and fro on the deck of a barge that rolls freely, against equations of its own.

Barge and crate move in the plane across the barge. With V the velocity of the barge's centre of gravity
along its own axes, w its roll rate, p and l the momenta of barge and water that goes along (Kirchhoff
1869), M their matrix,

    M (V̇, ẇ) = (F + w (p₂, -p₁), N - V₁ p₂ + V₂ p₁),   m_c r̈ = F_c,   I_c θ̈ = N_c

Buoyancy is the integral of the columns of water below the surface, exact as long as deck and bottom are not
cut. Under each lower edge of the crate two corners press, and stick to an anchor that gives way at μN,
(CO1) to (CO3) of docs/concepts/contact.md. What pushes the crate pushes the barge back at the same point.
scipy's LSODA solves that.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from gantline.results.recording import Recording
from gantline.simulation import simulate
from mechanics import Floats, G

LENGTH, BREADTH, DEPTH, DRAFT, KG, SEA = 60.0, 25.0, 8.0, 4.0, 3.0, 1025.0
DISPLACED, CRATE = SEA * LENGTH * BREADTH * DRAFT, 400e3
BARGE, RADIUS = DISPLACED - CRATE, 8.0
#: Across and upwards [m], and the moment of inertia about the third axis.
SIZE = np.array([4.0, 5.0])
INERTIA = CRATE / 12 * float(SIZE @ SIZE)
STIFFNESS, TAU, FRICTION = 100e6, 0.02, 0.17
#: Sway, heave and roll about a point on the waterline.
ADDED = DISPLACED * np.array([[0.3, 0.0, 0.3], [0.0, 0.8, 0.0], [0.3, 0.0, 16.0]])
#: Where the crate begins from the middle, uphill, and how far the barge heels.
ASIDE, HEEL, DURATION = 2.0, math.radians(11.0), 16.0
_NODES, _SHARES = np.polynomial.legendre.leggauss(3)


def axes(angle: float) -> Floats:
    """Rows are the directions across and upwards of what has turned by that."""
    cos, sin = math.cos(angle), math.sin(angle)
    return np.array([[cos, sin], [-sin, cos]])


def turned(arm: Floats) -> Floats:
    """Velocity at an arm of what turns with 1 rad/s."""
    return np.array([-arm[1], arm[0]])


_LEVER = DRAFT - KG
_TO_POINT = np.array([[1.0, 0.0, -_LEVER], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
INVERSE = np.linalg.inv(MOVED := _TO_POINT.T @ ADDED @ _TO_POINT + np.diag([BARGE, BARGE, BARGE * RADIUS**2]))


def buoyancy(place: Floats, own: Floats) -> tuple[float, float]:
    """Upward force and moment about the barge's centre of gravity at `place`."""
    up = own[:, 1]
    force = moment = 0.0
    for node, share in zip(_NODES, _SHARES, strict=True):
        keel = np.array([BREADTH / 2 * node, -KG])
        wet = -(place[1] + up @ keel) / up[1]
        column = SEA * G * LENGTH * BREADTH / 2 * share * wet
        force += column
        moment += column * float(own[:, 0] @ (keel + np.array([0.0, wet / 2])))
    return force, moment


def rates(_: float, state: Floats) -> Floats:
    """Of place, roll, own velocity and roll rate of the barge, of the crate likewise, of anchors, of heat."""
    place, roll, own_velocity, roll_rate = state[:2], state[2], state[3:5], state[5]
    at, angle, velocity, rate, anchors = state[6:8], state[8], state[9:11], state[11], state[12:14]
    own, crate = axes(roll), axes(angle)
    speed = own.T @ own_velocity
    lift, moment = buoyancy(place, own)
    on_barge, on_crate = np.array([0.0, lift - BARGE * G]), np.array([0.0, -CRATE * G])
    turning, slips, heat = 0.0, [], 0.0
    for side, anchor in zip((-1.0, 1.0), anchors, strict=True):
        arm = crate.T @ (SIZE / 2 * [side, -1.0])
        from_barge = at + arm - place
        relative = velocity + rate * turned(arm) - speed - roll_rate * turned(from_barge)
        (along, above), (sliding, rising) = own @ from_barge, own @ relative
        normal = 2 * max(0.0, STIFFNESS * (DEPTH - KG - above - TAU * rising))
        asked = 2 * STIFFNESS * (along - anchor + TAU * sliding)
        held = max(-FRICTION * normal, min(FRICTION * normal, asked))
        slip = (asked - held) / (2 * STIFFNESS * TAU)
        push = own.T @ np.array([-held, normal])
        on_crate, on_barge = on_crate + push, on_barge - push
        turning += float(turned(arm) @ push)
        moment -= float(turned(from_barge) @ push)
        slips.append(slip)
        heat += held * slip
    momenta = MOVED @ np.append(own_velocity, roll_rate)
    gyroscopic = [roll_rate * momenta[1], -roll_rate * momenta[0]]
    moment -= own_velocity[0] * momenta[1] - own_velocity[1] * momenta[0]
    grows = INVERSE @ np.append(own @ on_barge + gyroscopic, moment)
    return np.array(
        [*speed, roll_rate, *grows, *velocity, rate, *(on_crate / CRATE), turning / INERTIA, *slips, heat]
    )


def begins() -> Floats:
    place = np.array([0.0, KG - DRAFT])
    at = place + axes(HEEL).T @ [ASIDE, DEPTH - KG + SIZE[1] / 2]
    anchors = ASIDE + SIZE[0] / 2 * np.array([-1.0, 1.0])
    return np.array([*place, HEEL, 0, 0, 0, *at, HEEL, 0, 0, 0, *anchors, 0.0])


def lift() -> dict[str, Any]:
    """The lift file, stern and keel where that has the centre of gravity in the middle of the plane."""

    def metres(*values: float) -> list[str]:
        return [f"{float(value)!r} m" for value in values]

    added = np.diag([0.05, 0.3, 0.8, 16.0, 200.0, 90.0]) * DISPLACED
    added[1, 3] = added[3, 1] = ADDED[0, 2]
    units = [["t", "t m"], ["t m", "t m^2"]]
    matrix = [[f"{float(added[i, j]) / 1e3!r} {units[i // 3][j // 3]}" for j in range(6)] for i in range(6)]
    state = begins()
    barge = {
        "position": metres(-LENGTH / 2, KG * math.sin(HEEL)),
        "draft": metres(KG + (DRAFT - KG) / math.cos(HEEL))[0],
        "heel": f"{HEEL!r} rad",
        "hull": {"box": metres(LENGTH, BREADTH, DEPTH)},
        "masses": {"own": {"mass": f"{BARGE!r} kg", "at": metres(LENGTH / 2, 0, KG)}},
        "radii_of_gyration": metres(RADIUS, 17, 17),
        "added_mass": {"at": metres(LENGTH / 2, 0, DRAFT), "matrix": matrix},
    }
    about = CRATE / 12 * (10.0**2 + SIZE[::-1] ** 2)
    crate = {
        "at": metres(0, *state[6:8]),
        "orientation": {"about": ["1", "0", "0"], "angle": f"{HEEL!r} rad"},
        "joint": {"type": "free"},
        "mass": f"{CRATE} kg",
        "inertia": {
            "xx": f"{INERTIA} kg m^2",
            "yy": f"{about[0]} kg m^2",
            "zz": f"{about[1]} kg m^2",
        },
        "shape": {"box": metres(10, *SIZE)},
    }
    pressed = {"stiffness": f"{STIFFNESS} N/m", "damping": f"{STIFFNESS * TAU} N s/m", "friction": FRICTION}
    return {
        "format": 1,
        "lift": {"title": "A crate on a deck"},
        "duration": f"{DURATION} s",
        "start": "as_given",
        "water": {"density": f"{SEA} kg/m^3"},
        "vessels": {"barge": barge},
        "mechanics": {
            "bodies": {"crate": crate},
            "body_contacts": {"on_deck": {"between": ["crate", "barge"], **pressed}},
        },
    }


def missed(run: Recording, expected: Floats) -> tuple[float, float, float]:
    """By how much places [m] and angles [rad] of both are off at most, and the heat, as a share of it."""
    names = run.coordinates["body"]
    off, turns = [], []
    for name, first in (("barge", 0), ("crate", 6)):
        body = names.index(name)
        place = run.variables["body_position"].values[:, body, 1:]
        w, x = run.variables["body_orientation"].values[:, body, :2].T
        off.append(np.abs(place - expected[first : first + 2].T).max())
        turns.append(np.abs(2 * np.arctan2(x, w) - expected[first + 2]).max())
    kinds = run.coordinates["energy_kind"]
    heat = run.variables["energy"].values[-1, kinds.index("friction")]
    return float(max(off)), float(max(turns)), float(abs(heat / expected[-1, -1] - 1.0))


def test_a_crate_slides_to_and_fro_on_the_deck_of_a_barge(tmp_path: Path) -> None:
    """By tight tolerances places of barge and crate to 0.1 µm in 16 s, in which the crate slides 14 m,
    angles to 0.01 µrad, the heat of friction to 1e-8; by default, tolerance 0.1 mm, to that, 10 µrad, 1e-5.
    """
    path = tmp_path / "lift.yaml"
    path.write_text(json.dumps(lift()), encoding="utf-8")
    usual, tight = simulate(path), simulate(path, tension_tolerance=5.0, position_tolerance=1e-8)
    solved = solve_ivp(
        rates, (0, DURATION), begins(), "LSODA", tight.time, rtol=1e-10, atol=1e-11, max_step=0.01
    )
    slid = np.array([axes(state[2])[0] @ (state[6:8] - state[:2]) for state in solved.y.T])
    assert np.abs(np.diff(slid)).sum() > 14.0
    place, turn, heat = missed(tight, solved.y)
    assert (place < 1e-7, turn < 1e-8, heat < 1e-8) == (True, True, True)
    place, turn, heat = missed(usual, solved.y)
    assert (place < 1e-4, turn < 1e-5, heat < 1e-5) == (True, True, True)
