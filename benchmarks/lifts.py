"""The benchmark lifts E(n): one description, from which the model of every code is built.

A load is let go from just-taut slings and settles through one equalizer with n moving sheaves. The frame of
the equalizer turns about the vertical through the fixed hook, the moving sheaves slide vertically in it,
every part of the equalizing rope is vertical. Law of every rope in every code: T = max(0, k (e + τ ė)) with
the stretch e, k = EA/L and the damping time τ.
"""

from __future__ import annotations

import json
import math
import random
from dataclasses import dataclass, replace
from typing import Any

PITCH = 1.6  # m, between neighbouring moving sheaves
RADIUS = 0.4  # m, of every sheave, to the middle of the rope
VARIATION = 0.05  # m, of slings that are not as long as planned
SEED = 20160101


@dataclass(frozen=True)
class Lift:
    """Masses, geometry and ropes of one lift. SI units; world z up, x along the row of sheaves."""

    name: str
    frame_mass: float
    frame_inertia: float
    """About the hinge [kg m²]."""
    yaw_damping: float
    """Of the hinge [N m s/rad]."""
    sheave_mass: float
    sheave_x: tuple[float, ...]
    """Moving sheaves along the frame [m]."""
    axle_height: float
    """Axles of the fixed sheaves [m]."""
    start_drop: float
    """Of the moving sheaves below the axles [m]."""
    sling_lengths: tuple[float, ...]
    lugs: tuple[tuple[float, float], ...]
    """On the load's top, from its middle [m]."""
    load_mass: float
    load_box: tuple[float, float, float]
    """Length, breadth, height [m]."""
    axial_stiffness: float = 4e7
    damping_time: float = 0.02
    gravity: float = 9.81
    duration: float = 30.0

    @property
    def sheaves(self) -> int:
        """Moving sheaves."""
        return len(self.sheave_x)

    @property
    def equalizing_length(self) -> float:
        """Of the equalizing rope: two parts to every moving sheave, half a turn about every sheave [m]."""
        n = self.sheaves
        return 2 * n * self.start_drop + math.pi * RADIUS * (2 * n - 1)

    @property
    def equalizing_stiffness(self) -> float:
        """[N/m]."""
        return self.axial_stiffness / self.equalizing_length

    @property
    def sling_stiffness(self) -> tuple[float, ...]:
        """[N/m]."""
        return tuple(self.axial_stiffness / length for length in self.sling_lengths)

    @property
    def sheave_height(self) -> float:
        """Of the moving sheaves at the start [m]."""
        return self.axle_height - self.start_drop

    @property
    def load_inertia(self) -> tuple[float, float, float]:
        """Of the homogeneous box about its centre of gravity [kg m²]."""
        a, b, c = (side * side for side in self.load_box)
        m = self.load_mass / 12
        return (m * (b + c), m * (a + c), m * (a + b))

    @property
    def load_height(self) -> float:
        """Of the load's centre of gravity at the start: the shortest geometry is exactly taut [m]."""
        drops = (
            math.sqrt(length**2 - (lug[0] - x) ** 2 - lug[1] ** 2)
            for length, lug, x in zip(self.sling_lengths, self.lugs, self.sheave_x, strict=True)
        )
        return self.sheave_height - min(drops) - self.load_box[2] / 2


def equalizer_lift(n: int) -> Lift:
    """E(n): n moving sheaves."""
    xs = tuple((i - (n - 1) / 2) * PITCH for i in range(n))
    frame_mass = 20e3 if n == 5 else 4e3 * n
    if n == 5:
        lugs: tuple[tuple[float, float], ...] = (
            (-2.5, 2.5),
            (2.5, 2.5),
            (0.0, 0.0),
            (-2.5, -2.5),
            (2.5, -2.5),
        )
        box = (10.0, 10.0, 5.0)
    else:
        sides = [0] * n
        for k in range(n // 2):
            sides[k] = (-1) ** k
            sides[n - 1 - k] = -sides[k]
        lugs = tuple((x, 2.5 * side) for x, side in zip(xs, sides, strict=True))
        box = (PITCH * n + 2, 10.0, 5.0)
    return Lift(
        name=f"E({n})",
        frame_mass=frame_mass,
        frame_inertia=frame_mass / 12 * ((PITCH * n) ** 2 + 1),
        yaw_damping=2e5 * (n / 5) ** 3,
        sheave_mass=200.0,
        sheave_x=xs,
        axle_height=58.0,
        start_drop=3.0,
        sling_lengths=tuple(23.0 if min(i, n - 1 - i) % 4 == 0 else 26.0 for i in range(n)),
        lugs=lugs,
        load_mass=60e3 * n,
        load_box=box,
    )


def varied_lift(n: int) -> Lift:
    """E(n) with slings that differ at random by up to ±5 cm from their plan, the same in every run."""
    lift = equalizer_lift(n)
    draw = random.Random(SEED)
    lengths = tuple(length + draw.uniform(-VARIATION, VARIATION) for length in lift.sling_lengths)
    return replace(lift, name=f"E({n}) varied", sling_lengths=lengths)


def gantline_document(lift: Lift) -> str:
    """The lift as gantline's core reads it."""
    return json.dumps(
        {
            "gravity": [0.0, 0.0, -lift.gravity],
            "bodies": [_frame(lift), *_moving_sheaves(lift), _load(lift)],
            "ropes": [_equalizing_rope(lift), *_slings(lift)],
        }
    )


def _placed(x: float, y: float, z: float) -> dict[str, Any]:
    return {"position": [x, y, z], "orientation": [1, 0, 0, 0]}


def _frame(lift: Lift) -> dict[str, Any]:
    return {
        "name": "frame",
        "parent": None,
        "placement": _placed(0, 0, lift.axle_height),
        "joint": {"type": "hinge", "axis": [0, 0, 1], "damping": lift.yaw_damping},
        "mass": lift.frame_mass,
        "centre_of_gravity": [0, 0, 0],
        "inertia": [lift.frame_inertia] * 3 + [0, 0, 0],
    }


def _moving_sheaves(lift: Lift) -> list[dict[str, Any]]:
    return [
        {
            "name": f"sheave{i}",
            "parent": "frame",
            "placement": _placed(x, 0, -lift.start_drop),
            "joint": {"type": "slider", "axis": [0, 0, -1]},
            "mass": lift.sheave_mass,
            "centre_of_gravity": [0, 0, 0],
            "inertia": [0] * 6,
        }
        for i, x in enumerate(lift.sheave_x)
    ]


def _load(lift: Lift) -> dict[str, Any]:
    start = {"position": [0, 0, lift.load_height], "orientation": [1, 0, 0, 0]}
    return {
        "name": "load",
        "parent": None,
        "placement": _placed(0, 0, 0),
        "joint": {"type": "free", **start, "velocity": [0] * 3, "angular_velocity": [0] * 3},
        "mass": lift.load_mass,
        "centre_of_gravity": [0, 0, 0],
        "inertia": [*lift.load_inertia, 0, 0, 0],
    }


def _material(lift: Lift) -> dict[str, Any]:
    return {
        "type": "elastic",
        "axial_stiffness": lift.axial_stiffness,
        "damping_time": lift.damping_time,
    }


def _end(body: str, x: float, y: float, z: float) -> dict[str, Any]:
    return {"type": "end", "body": body, "at": [x, y, z]}


def _half_turn(body: str, enter: float, leave: float, side: int) -> dict[str, Any]:
    """About a sheave whose rope lies below (-1) or above (+1) its axle."""
    points = {"enter": [enter, 0, 0], "leave": [leave, 0, 0], "bulge": [0, 0, side]}
    return {"type": "half_turn", "body": body, **points}


def _equalizing_rope(lift: Lift) -> dict[str, Any]:
    xs = lift.sheave_x
    route = [_end("frame", xs[0] - RADIUS, 0, 0)]
    for i, x in enumerate(xs):
        route.append(_half_turn(f"sheave{i}", -RADIUS, RADIUS, -1))
        if i + 1 < lift.sheaves:
            route.append(_half_turn("frame", x + RADIUS, xs[i + 1] - RADIUS, 1))
    route.append(_end("frame", xs[-1] + RADIUS, 0, 0))
    return {
        "name": "equalizing",
        "length": lift.equalizing_length,
        "material": _material(lift),
        "route": route,
    }


def _slings(lift: Lift) -> list[dict[str, Any]]:
    top = lift.load_box[2] / 2
    return [
        {
            "name": f"sling{i}",
            "length": length,
            "material": _material(lift),
            "route": [_end(f"sheave{i}", 0, 0, 0), _end("load", *lug, top)],
        }
        for i, (length, lug) in enumerate(zip(lift.sling_lengths, lift.lugs, strict=True))
    ]
