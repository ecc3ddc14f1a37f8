"""A bar of 3 t that slides over shapes of the world."""

from __future__ import annotations

import numpy as np

from mechanics import Floats, G, Json, Run, adaptive, body, document, free

MASS, SIZE = 3000.0, (4.0, 1.5, 0.5)
STIFFNESS, TAU = 1e8, 0.01
HALF, DEEP = SIZE[0] / 2, SIZE[2] / 2
INERTIA = tuple(MASS / 12 * sum(side**2 for side in SIZE) - MASS / 12 * side**2 for side in SIZE)


def shape(name: str, size: tuple[float, float, float], centre: tuple[float, float, float]) -> Json:
    """A box of the world."""
    return {
        "name": name,
        "body": None,
        "parts": [{"type": "box", "size": list(size), "centre": list(centre)}],
    }


def bar(x: float, spots: int, velocity: list[float], spin: float, friction: float, *on: Json) -> Json:
    """A bar on shapes of the world; its weight is on so many spots."""
    start = free(
        (x, 0.0, DEEP - MASS * G / spots / STIFFNESS), velocity=velocity, angular_velocity=[0, 0, spin]
    )
    law = {"stiffness": STIFFNESS, "damping_time": TAU, "friction": friction}
    own = {"name": "bar", "body": "bar", "parts": [{"type": "box", "size": list(SIZE), "centre": [0, 0, 0]}]}
    pairs = [
        {"name": f"on {one['name']}", "group": "bar", "shapes": ["bar", one["name"]], **law} for one in on
    ]
    return document([body("bar", start, MASS, inertia=INERTIA)], shapes=[own, *on], pairs=pairs)


def run(system: Json, duration: float, tolerance: float) -> Run:
    return adaptive(
        system,
        duration,
        position_tolerance=tolerance,
        tension_tolerance=1e6 * tolerance,
        sample_interval=duration,
    )


def end_of(found: Run) -> Floats:
    """Place [m] and quaternion of the bar at the end."""
    return np.concatenate([found.body("bar")[-1], found.body("bar", "body_orientation")[-1]])
