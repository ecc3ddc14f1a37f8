"""A crane barge with everything that water does to it, and a load that swings, against equations of their
own.

The integral of a power of (d − a·x)₊ over the unit cube is a sum over its corners c:

    ∫ (d − a·x)₊ᵏ/k! dx = Σ (−1)^Σc (d − a·c)₊^(k+3) / ((k + 3)! a₁ a₂ a₃)

So the work to push a box into water, and that of the liquid in a tank that is a box, whose surface is
level at the d where k = 0 gives its volume, are closed forms of height and upward direction; forces and
moments are their slopes, by complex steps. With the 6 × 6 inertia of barge and water along about the
origin, p = M ν and the forces f (Kirchhoff 1869)

    M ν̇ = f − (ω × p_l, ω × p_a + u × p_l)

scipy's DOP853 solves the motion. Nothing is symmetric: centre of gravity, added mass, damping, tanks,
crane, current.
"""

from __future__ import annotations

import itertools
import json
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, least_squares

from floating import SEA, box_hull, buoyancy
from gantline._core import Statics
from lagrange import Batch, quaternion, yaw_pitch_roll
from mechanics import Floats, G, Json, adaptive, body, document, end, free, point, rope

CORNERS = np.array(list(itertools.product((0, 1), repeat=3)))
SIGNS = (-1.0) ** CORNERS.sum(axis=1)
TINY = 1e-40

SIZE, LOWEST = np.array([40.0, 16.0, 6.0]), np.array([-20.0, -8.0, 0.0])
LOAD, TIP, FALLS, EA, TAU = 40e3, np.array([15.0, 12.0, 20.0]), 12.0, 4e7, 0.01
MASS = SEA * 40 * 16 * 3 - LOAD
INERTIA = MASS * np.array([[25.0, 3, -5], [3, 144, 0], [-5, 0, 149]])
#: Points of added mass and of drag; velocity of the water.
ADDED_AT, DRAG_AT, STREAM = np.array([0.5, 0.2, 1.0]), np.array([1.0, 0.5, 1.0]), np.array([0.8, -1.2, 0.0])
QUADRATIC = np.array([2e4, 5e4, 8e4, 2e7, 5e7, 4e7])


def coupled(diagonal: list[float], seed: int) -> Floats:
    """A positive symmetric matrix (6, 6) with about this diagonal and couplings of some per cent."""
    rows = np.random.default_rng(seed).normal(size=(6, 6))
    scale = np.sqrt(np.array(diagonal) * MASS)
    return np.asarray((np.eye(6) + 0.03 * rows @ rows.T) * np.outer(scale, scale))


ADDED = coupled([0.1, 0.5, 1, 25, 100, 60], 1)
DAMPING = coupled([0.05, 0.1, 0.3, 5, 30, 20], 2)


def below(up: Batch, level: Batch | float, lowest: Floats, size: Floats, power: int) -> Batch:
    """∫ (level − up·x)₊ᵏ/k! over a box; `up` has no zeros."""
    slope = up * size
    depth = level - up @ lowest
    depth = depth - np.where(slope.real < 0, slope, 0).sum()
    slope = np.where(slope.real < 0, -slope, slope)
    inside = depth - CORNERS @ slope
    inside = np.where(inside.real > 0, inside, 0)
    whole = SIGNS @ inside ** (power + 3) / math.factorial(power + 3)
    return np.asarray(whole / np.prod(slope) * np.prod(size))


@dataclass(frozen=True)
class Tank:
    """A box with liquid: lowest corner and size [m], volume [m³], density [kg/m³]."""

    lowest: Floats
    size: Floats
    volume: float
    density: float

    def level(self, up: Floats) -> float:
        """Height of the surface along `up` [m]."""
        heights = (self.lowest + CORNERS * self.size) @ up
        missing = lambda level: float(below(up, level, self.lowest, self.size, 0)) - self.volume  # noqa: E731
        return float(brentq(missing, heights.min(), heights.max(), xtol=1e-13))

    def energy(self, up: Batch, level: float) -> Batch:
        """Of its weight [J], beyond that of a body frozen in the upright tank; stationary over the level."""
        frozen = self.lowest + self.size / 2
        frozen[2] = self.lowest[2] + self.volume / self.size[0] / self.size[1] / 2
        lifted = level * self.volume - below(up, level, self.lowest, self.size, 1)
        return self.density * G * (lifted - self.volume * (up @ frozen))


TANKS = (
    Tank(np.array([-15.0, -6, 0.5]), np.array([10.0, 12, 3]), 150.0, 1000.0),
    Tank(np.array([5.0, -5, 0.5]), np.array([8.0, 10, 4]), 100.0, 900.0),
)


def crossing(way: Floats) -> Floats:
    """The matrix of way × (3, 3)."""
    x, y, z = way
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def inertia_of_all(centre: Floats) -> Floats:
    """Of barge and water along about the barge's origin (6, 6)."""
    arm, moved = crossing(centre), np.eye(6)
    own = np.block([[MASS * np.eye(3), -MASS * arm], [MASS * arm, INERTIA - MASS * arm @ arm]])
    moved[:3, 3:] = -crossing(ADDED_AT)
    return np.asarray(own + moved.T @ ADDED @ moved)


def rotation(q: Floats) -> Floats:
    """Of a quaternion, w first (3, 3)."""
    w, axis = q[0], q[1:]
    cross = crossing(axis)
    return np.asarray(np.eye(3) + 2 * (w * cross + cross @ cross) / (q @ q))


def weight_and_water(turn: Floats, height: float, centre: Floats) -> tuple[Floats, Floats]:
    """Force in world axes and moment about the origin in the barge's axes, of weight, hull and tanks."""
    up = turn[2]
    levels = [tank.level(up) for tank in TANKS]

    def energy(direction: Batch, lifted: Any) -> float:
        total = SEA * G * below(direction, -lifted, LOWEST, SIZE, 1) + MASS * G * (
            lifted + direction @ centre
        )
        total += sum(tank.energy(direction, level) for tank, level in zip(TANKS, levels, strict=True))
        return float(total.imag) / TINY

    force = np.array([0, 0, -energy(up + 0j, height + 1j * TINY)])
    moment = [-energy(up - 1j * TINY * np.cross(axis, up), height + 0j) for axis in np.eye(3)]
    return force, np.array(moment)


def rates(_: float, state: Floats, centre: Floats, inertia: Floats, resists: bool = True) -> Floats:
    """Of place, quaternion, velocity and spin in the barge's axes, place and velocity of the load."""
    place, q, u, w, load, speed = np.split(state, [3, 7, 10, 13, 16])
    turn = rotation(q)
    force, moment = weight_and_water(turn, place[2], centre)
    force = turn.T @ force
    flow = u + np.cross(w, DRAG_AT) - turn.T @ STREAM
    resistance = -DAMPING @ np.concatenate([flow, w])
    resistance -= QUADRATIC * np.concatenate([np.linalg.norm(flow) * flow, np.abs(w) * w])
    if resists:
        force = force + resistance[:3]
        moment = moment + resistance[3:] + np.cross(DRAG_AT, resistance[:3])
    way = load - place - turn @ TIP
    span = float(np.linalg.norm(way))
    rate = way @ (speed - turn @ (u + np.cross(w, TIP))) / span
    pull = max(0.0, EA / FALLS * (span - FALLS + TAU * rate)) * way / span
    force = force + turn.T @ pull
    moment = moment + np.cross(TIP, turn.T @ pull)
    momentum = inertia @ np.concatenate([u, w])
    turning = np.concatenate(
        [np.cross(w, momentum[:3]), np.cross(w, momentum[3:]) + np.cross(u, momentum[:3])]
    )
    acceleration = np.linalg.solve(inertia, np.concatenate([force, moment]) - turning)
    spun = np.concatenate([[-q[1:] @ w], q[0] * w + np.cross(q[1:], w)]) / 2
    return np.concatenate([turn @ u, spun, acceleration, speed, np.array([0, 0, -G]) - pull / LOAD])


def system(state: Floats, centre: Floats) -> Json:
    """The same as a document."""
    place, q, u, w, load, speed = (part.tolist() for part in np.split(state, [3, 7, 10, 13, 16]))
    velocity = (rotation(np.array(q)) @ np.array(u)).tolist()
    barge = body(
        "barge",
        free(place, orientation=q, velocity=velocity, angular_velocity=w),
        MASS,
        centre_of_gravity=centre.tolist(),
    )
    barge["inertia"] = [INERTIA[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    named = {"body": "barge"}
    forces = [
        buoyancy("barge", box_hull(SIZE.tolist())),
        {"type": "added_mass", "name": "along", "at": ADDED_AT.tolist(), "matrix": ADDED.tolist(), **named},
        {
            "type": "drag",
            "name": "drag",
            "at": DRAG_AT.tolist(),
            "damping": DAMPING.tolist(),
            "quadratic": QUADRATIC.tolist(),
            "stream": STREAM.tolist(),
            **named,
        },
    ]
    for number, tank in enumerate(TANKS):
        points, triangles = box_hull(tank.size.tolist())
        middle = tank.lowest + np.array([tank.size[0] / 2, tank.size[1] / 2, 0])
        inside = {"vertices": (np.array(points) + middle).tolist(), "triangles": triangles}
        held = {"density": tank.density, "volume": tank.volume}
        forces.append({"type": "tank", "name": f"tank{number}", **named, **inside, **held})
    falls = rope("falls", FALLS, [end("barge", TIP.tolist()), end("load")], EA, TAU)
    return document([barge, body("load", point(load, speed), LOAD)], ropes=[falls], forces=forces)


@pytest.mark.parametrize(
    ("orientation", "height", "heel"),
    [((0.99, 0.08, -0.03, 0.1), 3.5, (-8.1, 9.3)), ((0.8, 0.45, -0.15, 0.1), 4.5, (58.4, 180.0))],
    ids=["upright", "turning over"],
)
def test_a_crane_barge_moves_as_its_own_equations_say(
    orientation: tuple[float, ...], height: float, heel: tuple[float, float]
) -> None:
    """Place, attitude, load, and what drag takes; upright, and as it turns over with its deck under water."""
    duration, centre = 4.0, np.array([0.3, -0.2, height])
    q = np.array(orientation) / np.linalg.norm(orientation)
    turn, place = rotation(q), np.array([0, 0, -3.2])
    velocity = turn.T @ np.array([0.5, 0.3, -0.4])
    load = place + turn @ TIP + np.array([1.0, 2.0, -11.8])
    start = np.concatenate([place, q, velocity, [0.05, 0.03, 0.02], load, np.zeros(3)])
    times = np.linspace(0, duration, 9)
    given = (centre, inertia_of_all(centre))
    found = solve_ivp(rates, (0, duration), start, "DOP853", times, rtol=1e-8, atol=1e-9, args=given)
    own = found.y.T
    run = adaptive(
        system(start, centre),
        duration,
        tension_tolerance=0.1,
        position_tolerance=1e-7,
        sample_interval=duration / 8,
    )
    turns = [rotation(one) for one in own[:, 3:7]]
    places = np.array([one[:3] + turn @ centre for one, turn in zip(own, turns, strict=True)])
    # Tolerances of 0.1 µm and 0.1 N in a step; where a corner of the deck goes under, the stiffness of the
    # water jumps within a step: 1 µm was found.
    assert np.abs(run.body("barge") - places).max() < 5e-6
    assert np.abs(run.body("load") - own[:, 13:16]).max() < 5e-6
    alike = (run.body("barge", "body_orientation") * own[:, 3:7]).sum(axis=1)
    norm = np.linalg.norm(own[:, 3:7], axis=1)
    assert np.abs(np.abs(alike / norm) - 1.0).max() < 1e-12
    ups = np.array([turn[2] for turn in turns])
    angle = np.degrees(np.arctan2(ups[:, 1], ups[:, 2]))
    assert heel[0] - 1.0 < angle.min() and angle.max() < heel[1] + 1.0
    assert run.energy_remainder < 1e-7


def test_modes_of_a_barge_with_a_load_that_hangs_from_it() -> None:
    """ω² of nine motions, three of which nothing holds, against differences of the accelerations at rest."""
    centre = np.array([0.3, -0.2, 3.5])
    inertia = inertia_of_all(centre)

    def accelerations(turn: Floats, place: Floats, load: Floats) -> Floats:
        """Of the barge along its axes and about them, and of the load, from rest (9,)."""
        state = np.concatenate([place, quaternion(turn), np.zeros(6), load, np.zeros(3)])
        return rates(0.0, state, centre, inertia, resists=False)[[7, 8, 9, 10, 11, 12, 16, 17, 18]]

    def lying(found: Floats) -> tuple[Floats, Floats, Floats]:
        """Attitude, place and load of height, two angles and the load's place."""
        turn = yaw_pitch_roll(np.array([[0.02, found[1], found[2]]]))[0]
        return turn, np.array([0, 0, found[0]]), found[3:]

    def unbalanced(found: Floats) -> Floats:
        return accelerations(*lying(found))

    guess = np.concatenate([[-3.0, -0.02, -0.06], TIP + np.array([1.2, 1.0, -3.0 - FALLS])])
    rest = least_squares(unbalanced, guess, xtol=1e-15, ftol=1e-15, gtol=1e-15)
    assert np.abs(rest.fun).max() < 1e-9
    turn, place, load = lying(rest.x)

    def moved(by: Floats) -> Floats:
        """Accelerations along the axes at rest, moved and turned along and about these."""
        further = yaw_pitch_roll(by[None, [5, 4, 3]])[0]
        found = accelerations(turn @ further, place + turn @ by[:3], load + by[6:])
        return np.concatenate([further @ found[:3], found[3:]])

    step = 1e-4
    slopes = [
        (8 * (moved(way) - moved(-way)) - moved(2 * way) + moved(-2 * way)) / (12 * step)
        for way in step * np.eye(9)
    ]
    squares = np.sort(-np.linalg.eigvals(np.array(slopes).T).real)
    state = np.concatenate([place, quaternion(turn), np.zeros(6), load, np.zeros(3)])
    document_at_rest = system(state, centre)
    for force in document_at_rest["forces"]:
        if force["type"] == "drag":
            force["stream"] = [0.0, 0.0, 0.0]
    statics = Statics(json.dumps(document_at_rest))
    statics.settle()
    found = np.sort(statics.modes()["square"])
    # Differences of fourth order at 0.1 mrad: 1e-8 and less. Surge, sway and yaw have none.
    assert np.abs(found[:3]).max() < 1e-9
    assert found[3:] == pytest.approx(squares[3:], rel=1e-6)
