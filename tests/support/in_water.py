"""Bodies in water as the core's documents: cells, and waves that run over it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from mechanics import Floats, G, Json, Xyz

RHO = 1025.0
#: Nothing along any axis.
NONE = (0.0, 0.0, 0.0)


def lattice(
    at: Xyz = NONE,
    *,
    half: Xyz = (0.0, 0.0),
    height: float = 1.0,
    layers: int = 1,
    volume: float = 0.0,
    added: Xyz = NONE,
    quadratic: Xyz = NONE,
) -> Json:
    """Layers of four cells from `at` upwards; amounts are those of all of them."""
    count = 4 * layers
    return {
        "at": list(at),
        "half": list(half),
        "height": height,
        "layers": layers,
        "volume": volume / count,
        "added_mass": [part / count for part in added],
        "quadratic": [part / count for part in quadratic],
    }


def submerged(body: str, *lattices: Json, stream: Sequence[float] = NONE) -> Json:
    """Water up to 0 around a body."""
    named = {"type": "submerged", "name": f"{body}.in_water", "body": body, "lattices": list(lattices)}
    return {**named, "density": RHO, "level": 0.0, "stream": list(stream)}


def sea(*waves: tuple[float, float, float, float], rise_time: float, depth: float | None = None) -> Json:
    """Waves of ω [rad/s], amplitude [m], direction [rad] and phase [rad]."""
    components = []
    for omega, amplitude, direction, phase in waves:
        k = number(omega, depth)
        along = [k * math.cos(direction), k * math.sin(direction)]
        components.append({"frequency": omega, "wave_number": along, "amplitude": amplitude, "phase": phase})
    return {"components": components, "rise_time": rise_time, "depth": depth}


def number(omega: float, depth: float | None) -> float:
    """κ of ω² = g κ tanh κd [rad/m], by Newton's method."""
    k = omega**2 / G
    if depth is None:
        return k
    for _ in range(50):
        tanh = math.tanh(k * depth)
        k -= (G * k * tanh - omega**2) / (G * tanh + G * k * depth * (1 - tanh**2))
    return k


def within(value: Any, low: float, high: float) -> Any:
    """What `np.clip` gives, which takes several times as long for a few numbers."""
    return np.minimum(np.maximum(value, low), high)


def growth(time: Any, rise_time: float) -> Any:
    """What waves have grown to, as a share."""
    s = within(np.asarray(time) / rise_time, 0.0, 1.0)
    return s**3 * (10 - 15 * s + 6 * s**2)


def share(depth: Any, height: float) -> Floats:
    """How wet a cell is at a depth: the integral of a hat from -height to height."""
    t = within(np.asarray(depth) / height, -1.0, 1.0)
    # Of (1 + t)²/2 below 0 and 1 - (1 - t)²/2 above.
    wet: Floats = 0.5 + t - 0.5 * t * np.abs(t)
    return wet
