"""A prism of more than sixteen corners that leaned on one of those that its face does not keep.

Of such a face sixteen corners were looked at, wherever it leaned: on one between them it sank by up to
R (1 − cos π/16) sin β, 40 mm of a radius of 3 m at 44°, before anything bore. From 45° on another face,
of four corners, looks most at what it stands on, and all of that depth pressed at once.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from mechanics import adaptive, body, document, free

CORNERS, RADIUS, HALF, DEPTH, STIFFNESS = 32, 3.0, 1.0, 1e-3, 1e8
SLAB = {
    "name": "slab",
    "body": None,
    "parts": [{"type": "box", "size": [40, 40, 2], "centre": [0, 0, -1]}],
}


@pytest.mark.parametrize("lean", [1.0, 10.0, 44.0, 46.0])
@pytest.mark.parametrize("towards", [8, 9])
def test_the_deepest_corner_bears(towards: int, lean: float) -> None:
    """Leaning by `lean` degrees towards any of its corners, a millimetre deep there, the prism has k times
    that below it and no more than what is R (1 − cos 2π/n) sin β less deep at the corners beside it.
    """
    turns = 2 * math.pi * np.arange(CORNERS) / CORNERS
    places = RADIUS * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    vertices = [[*xy, z] for xy in places.tolist() for z in (-HALF, HALF)]
    shape = {"name": "prism", "body": "prism", "parts": [{"type": "convex", "vertices": vertices}]}
    sine, cosine = math.sin(math.radians(lean)), math.cos(math.radians(lean))
    # About the axis that takes the side of the corner down.
    half, across = math.radians(lean) / 2, turns[towards] + math.pi / 2
    turned = [math.cos(half), math.sin(half) * math.cos(across), math.sin(half) * math.sin(across), 0.0]
    height = RADIUS * sine + HALF * cosine - DEPTH
    prism = body("prism", free((0, 0, height), orientation=turned), 50e3, inertia=(1e5, 1e5, 1.5e5))
    law = {"stiffness": STIFFNESS, "damping_time": 0.0, "friction": 0.0, "places": 20}
    pair = {"name": "on", "group": "prism", "shapes": ["prism", "slab"], **law}
    run = adaptive(document([prism], shapes=[SLAB, shape], pairs=[pair]), 1e-6, sample_interval=1e-6)
    forces = np.sort(run.columns["contact_force"][0])[::-1]
    above = RADIUS * (1 - math.cos(2 * math.pi / CORNERS)) * sine
    assert forces[0] == pytest.approx(STIFFNESS * DEPTH, rel=1e-9)
    # Of the corners beside it those that are kept: both, or none.
    assert forces[1:3].max() <= STIFFNESS * max(0.0, DEPTH - above) * (1 + 1e-9)
