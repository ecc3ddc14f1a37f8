"""A crane barge with everything that water does to it, and a load that swings: equations of their own.

The integral of a power of (d − a·x)₊ over the unit cube is a sum over its corners c:

    ∫ (d − a·x)₊ᵏ/k! dx = Σ (−1)^Σc (d − a·c)₊^(k+3) / ((k + 3)! a₁ a₂ a₃)

So the work to push a box into water, and that of the liquid in a tank that is a box, whose surface is
level at the d where k = 0 gives its volume, are closed forms of height and upward direction; forces and
moments are their slopes, by complex steps. With the 6 × 6 inertia of barge and water along about the
origin, p = M ν and the forces f (Kirchhoff 1869)

    M ν̇ = f − (ω × p_l, ω × p_a + u × p_l)

give the motion. Nothing is symmetric: centre of gravity, added mass, damping, tanks, crane, current.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import brentq

from floating import SEA, box_hull, buoyancy
from lagrange import Batch
from mechanics import Floats, G, Json, body, document, end, free, point, rope
from rigid import across, cross

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
    return np.asarray(whole / math.prod(slope.tolist()) * math.prod(size.tolist()))


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


def inertia_of_all(centre: Floats) -> Floats:
    """Of barge and water along about the barge's origin (6, 6)."""
    arm, moved = across(centre), np.eye(6)
    own = np.block([[MASS * np.eye(3), -MASS * arm], [MASS * arm, INERTIA - MASS * arm @ arm]])
    moved[:3, 3:] = -across(ADDED_AT)
    return np.asarray(own + moved.T @ ADDED @ moved)


def rotation(q: Floats) -> Floats:
    """Of a quaternion, w first (3, 3)."""
    w, axis = q[0], q[1:]
    about = across(axis)
    return np.asarray(np.eye(3) + 2 * (w * about + about @ about) / (q @ q))


def weight_and_water(
    turn: Floats, height: float, centre: Floats, mass: float, tanks: Sequence[Tank]
) -> tuple[Floats, Floats]:
    """Force in world axes and moment about the origin in the barge's axes, of weight, hull and tanks."""
    up = turn[2]
    levels = [tank.level(up) for tank in tanks]

    def energy(direction: Batch, lifted: Any) -> float:
        total = SEA * G * below(direction, -lifted, LOWEST, SIZE, 1) + mass * G * (
            lifted + direction @ centre
        )
        total += sum(tank.energy(direction, level) for tank, level in zip(tanks, levels, strict=True))
        return float(total.imag) / TINY

    force = np.array([0, 0, -energy(up + 0j, height + 1j * TINY)])
    moment = [-energy(up - 1j * TINY * cross(axis, up), height + 0j) for axis in np.eye(3)]
    return force, np.array(moment)


def rates(
    _: float,
    state: Floats,
    centre: Floats,
    inertia: Floats,
    resists: bool = True,
    mass: float = MASS,
    tanks: Sequence[Tank] = TANKS,
) -> Floats:
    """Of place, quaternion, velocity and spin in the barge's axes, place and velocity of the load.

    `mass` and `centre` are those of barge and liquids, these frozen in the upright tanks.
    """
    place, q, u, w, load, speed = np.split(state, [3, 7, 10, 13, 16])
    turn = rotation(q)
    force, moment = weight_and_water(turn, place[2], centre, mass, tanks)
    force = turn.T @ force
    flow = u + cross(w, DRAG_AT) - turn.T @ STREAM
    resistance = -DAMPING @ np.concatenate([flow, w])
    resistance -= QUADRATIC * np.concatenate([np.linalg.norm(flow) * flow, np.abs(w) * w])
    if resists:
        force = force + resistance[:3]
        moment = moment + resistance[3:] + cross(DRAG_AT, resistance[:3])
    way = load - place - turn @ TIP
    span = float(np.linalg.norm(way))
    rate = way @ (speed - turn @ (u + cross(w, TIP))) / span
    pull = max(0.0, EA / FALLS * (span - FALLS + TAU * rate)) * way / span
    force = force + turn.T @ pull
    moment = moment + cross(TIP, turn.T @ pull)
    momentum = inertia @ np.concatenate([u, w])
    turning = np.concatenate([cross(w, momentum[:3]), cross(w, momentum[3:]) + cross(u, momentum[:3])])
    acceleration = np.linalg.solve(inertia, np.concatenate([force, moment]) - turning)
    spun = np.concatenate([[-q[1:] @ w], q[0] * w + cross(q[1:], w)]) / 2
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
