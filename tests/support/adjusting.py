"""Groups of ropes whose lengths are adjusted: small systems with closed forms."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from mechanics import Floats, Json, body, document, end, rope, slider

#: Length of the ropes [m].
LENGTH = 10.0
#: Stretch of both ropes at the middle [m].
PULL = 0.05


def held(stiffness: Sequence[float] | Floats, factor: float) -> Json:
    """Ropes of given EA [N] side by side, their ends held, stretched by 21, 22, 23, ... mm at the start."""
    ropes = []
    for number, ea in enumerate(stiffness, start=1):
        ends = [end(None, (number, 0, LENGTH)), end("bar", (number, 0, 0))]
        ropes.append(rope(f"r{number}", LENGTH - 1e-3 * (20 + number), ends, ea))
    names = [one["name"] for one in ropes]
    return document(
        [body("bar", slider(drive="hold"), 1.0)],
        ropes=ropes,
        drives=[{"name": "hold", "ramps": []}],
        adjusters=[{"name": "e", "ropes": names, "factor": factor}],
    )


def pair(mass: float, ea: float, factor: float, *, start: float = 1e-3, damping_time: float = 0.0) -> Json:
    """A mass between two stretched ropes, `start` [m] off the middle; along it ω² = 2 k/m."""
    material = (LENGTH - PULL, ea, damping_time)
    length, *rest = material
    ropes = [
        rope("left", length, [end(None, (-LENGTH, 0, 0)), end("m")], *rest),
        rope("right", length, [end(None, (LENGTH, 0, 0)), end("m")], *rest),
    ]
    adjusters = [{"name": "e", "ropes": ["left", "right"], "factor": factor}] if factor else []
    return document(
        [body("m", slider((1, 0, 0), position=start), mass)],
        ropes=ropes,
        adjusters=adjusters,
    )


def omega(mass: float, ea: float) -> float:
    """ω of the mass between the two ropes [rad/s]."""
    return math.sqrt(2 * ea / (LENGTH - PULL) / mass)


def step_map(kind: str, h: float, w: float, factor: float, damping_time: float = 0.0) -> Floats:
    """What a step makes of (y, v): the stretch of the left rope beyond the mean [m], velocity [m/s].

    explicit: v₊ = v - hω²(y + τv), del: v₊ = v - hω²(y + h v₊ + τ v₊); both then
    y₊ = y + h v₊ - f (y + (h + τ) v₊).
    """
    a, b = (h * w) ** 2, h * w * w * damping_time
    speed = np.array([-h * w * w, 1 - b]) if kind == "explicit" else np.array([-h * w * w, 1]) / (1 + a + b)
    stretch = np.array([1 - factor, 0]) + (h - factor * (h + damping_time)) * speed
    return np.array([stretch, speed])
