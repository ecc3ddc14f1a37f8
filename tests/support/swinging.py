"""A load that swings under an ideal equalizer, without any damping unless it is asked for.

Three moving sheaves of 300 kg, one equalizing rope, three plumb slings of 20 m, a load of 300 t, in balance
but for its velocity.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from mechanics import G, Json, body, document, end, free, half_turn, rope, slider

LOAD, SHEAVE = 300e3, 300.0  # kg
LENGTH, RADIUS, PITCH, DROP, HALF_HEIGHT = 20.0, 0.4, 1.6, 3.0, 2.5  # m
ROW = (-PITCH, 0.0, PITCH)
EA = 1e9  # N
SIDEWAYS = (0.5, 0.7, 0.0)  # m/s
#: With 0.05 m/s downwards the ropes ring at 3.4 Hz, by 11 % of their tension.
RINGING = (0.5, 0.7, -0.05)


def swinging(ea: float | None, velocity: Sequence[float], damping_time: float = 0.0) -> Json:
    """The lift in balance, its load moving; `ea` None makes every rope inextensible."""
    n = len(ROW)
    arcs = (2 * n - 1) * math.pi * RADIUS
    equalizing = 2 * n * DROP + arcs
    sling_tension = LOAD * G / n
    stretch = sling_tension * LENGTH / ea if ea else 0.0
    sag = (sling_tension + SHEAVE * G) / 2 * equalizing / ea / (2 * n) if ea else 0.0
    route = [end(None, (ROW[0] - RADIUS, 0, 0))]
    bodies = []
    for i, x in enumerate(ROW):
        bodies.append(body(f"sheave{i}", slider((0, 0, -1), position=sag), SHEAVE, position=(x, 0, -DROP)))
        route.append(half_turn(f"sheave{i}", (0, 0, 0), RADIUS, over=False))
        if i + 1 < n:
            route.append(half_turn(None, (x + PITCH / 2, 0, 0), PITCH / 2 - RADIUS, over=True))
    route.append(end(None, (ROW[-1] + RADIUS, 0, 0)))
    height = -DROP - sag - LENGTH - stretch - HALF_HEIGHT
    inertia = [LOAD / 12 * size for size in (125, 125, 200)]  # a box 10 × 10 × 5 m
    bodies.append(body("load", free((0, 0, height), velocity=list(velocity)), LOAD, inertia=inertia))
    slings = [
        rope(f"sling{i}", LENGTH, [end(f"sheave{i}"), end("load", (x, 0, HALF_HEIGHT))], ea, damping_time)
        for i, x in enumerate(ROW)
    ]
    return document(bodies, ropes=[rope("equalizing", equalizing, route, ea, damping_time), *slings])
