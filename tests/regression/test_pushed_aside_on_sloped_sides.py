"""A load that is pushed aside a little on supports under its sloped sides.

The place at which a load stands on a support followed it from 0.2 mm on, whatever the side rises by. Under
a keel of 20 t whose sides rise by 10°, on two supports of 400 MN/m, a push of 0.15 mm aside changed
nothing; by hand one bears 10.6 kN more and the other as much less, a tenth of what they bear. In
`heavy_lift_ship` the saddles of the reactor bore 0.6 % more or less from one tolerance to another, and the
ship was heeled by 0.155° over her cradles in place of 0.169°.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from box_on_tops import MASS, force, support
from mechanics import G, adaptive, body, document, slider

RISES, AWAY, STIFFNESS, SIDE = math.tan(math.radians(10.0)), 1.5, 400e6, 3.0
SPEED, ASIDE = 1e-4, 1.5e-4


def test_each_support_bears_by_how_deep_it_is_in() -> None:
    """N = k (±X rises - z - a rises), together the weight: N₁ - N₂ = 2 k X rises, to 0.1 µm of depth."""
    right = [(0, -1, 0), (0, 1, 0), (SIDE, 1, SIDE * RISES), (SIDE, -1, SIDE * RISES)]
    left = [(-x, y, z) for x, y, z in reversed(right)]
    tops = [
        support(name, x, 0.0, sides=[left, right], stiffness=STIFFNESS, friction=0.0)
        for name, x in (("left", -AWAY), ("right", AWAY))
    ]
    sunk = MASS * G / (2 * STIFFNESS)
    cart = body("cart", slider((1, 0, 0), drive="push"), 1.0, position=(0.0, 0.0, -AWAY * RISES - sunk))
    keel = body("box", slider(), MASS, parent="cart")
    ramps = [(0.0, SPEED), (ASIDE / SPEED, 0.0)]
    drives = [{"name": "push", "ramps": [{"at": at, "duration": 1e-3, "velocity": v} for at, v in ramps]}]
    done = adaptive(document([cart, keel], supports=tops, drives=drives), 2.5)
    borne = np.array([force(done, name)[-1] for name in ("right", "left")])
    assert borne.sum() == pytest.approx(MASS * G, rel=1e-6)
    assert borne[0] - borne[1] == pytest.approx(2 * STIFFNESS * ASIDE * RISES, abs=2 * STIFFNESS * 1e-7)
