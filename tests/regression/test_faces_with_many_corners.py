"""A load from CAD that stood on a deck, a structure or the floor of a dock with more than five corners.

Of such a face only the first four corners were looked at, which lie on one side of it, and one place more,
somewhere else in each step: a prism with eight corners below crept, its supports came to 0.96 to 1.02 of its
weight after ten seconds at rest, and a lift that began so was refused, "no step brings its forces closer to
balance".
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from mechanics import G, adaptive, body, document, free

MASS, RADIUS, HEIGHT = 50e3, 3.0, 2.0
#: Of the centre of gravity from the middle of the prism [m].
OFF = (0.3, 0.1)
SLAB = {
    "name": "slab",
    "body": None,
    "parts": [{"type": "box", "size": [40, 40, 2], "centre": [0, 0, -1]}],
}


@pytest.mark.parametrize("corners", [5, 6, 8, 12, 16, 24])
def test_a_prism_stands_on_all_of_its_corners(corners: int) -> None:
    """They share as springs, W (1/n + d S⁻¹ r), to how far it leans; of more than sixteen those bear that
    are farthest in sixteen directions, and all of the weight. It lies still.
    """
    turns = 2 * math.pi * (np.arange(corners) + 0.5) / corners
    places = RADIUS * np.stack([np.cos(turns), np.sin(turns)], axis=1) - OFF
    vertices = [[*place, z] for place in places.tolist() for z in (-HEIGHT / 2, HEIGHT / 2)]
    shape = {"name": "prism", "body": "prism", "parts": [{"type": "convex", "vertices": vertices}]}
    law = {"stiffness": 1e8, "damping_time": 0.01, "friction": 0.4, "places": 16}
    pair = {"name": "on", "group": "prism", "shapes": ["prism", "slab"], **law}
    prism = body("prism", free(position=(*OFF, HEIGHT / 2)), MASS, inertia=(1e5, 1e5, 1.5e5))
    run = adaptive(
        document([prism], shapes=[SLAB, shape], pairs=[pair]),
        10.0,
        tension_tolerance=None,
        position_tolerance=None,
        sample_interval=0.1,
    )
    forces = run.columns["contact_force"]
    assert forces[-1].sum() == pytest.approx(MASS * G, rel=1e-8)
    assert np.ptp(run.body("prism")[50:], axis=0).max() < 1e-10
    bears = np.sort(forces[-1][forces[-1] > 0.0])
    assert len(bears) == min(corners, 16)
    if corners <= 16:
        middle = places.mean(axis=0)
        around = places - middle
        shares = 1 / corners + around @ np.linalg.solve(around.T @ around, -middle)
        assert bears == pytest.approx(np.sort(MASS * G * shares), rel=1e-3)


@pytest.mark.parametrize("reach", [2.0, 3.4])
def test_a_prism_that_reaches_beyond_what_it_stands_on(reach: float) -> None:
    """Twelve corners on a top that is smaller, or larger one way: corners of both, and places where sides
    cross, bear; it stands level and still, as its centre of gravity is over the middle.
    """
    turns = 2 * math.pi * (np.arange(12) + 0.5) / 12
    vertices = [[RADIUS * math.cos(a), RADIUS * math.sin(a), z] for a in turns for z in (-1.0, 1.0)]
    shape = {"name": "prism", "body": "prism", "parts": [{"type": "convex", "vertices": vertices}]}
    top = {"type": "box", "size": [2 * reach, 4.0, 1.0], "centre": [0, 0, -0.5]}
    law = {"stiffness": 1e8, "damping_time": 0.01, "friction": 0.4, "places": 16}
    pair = {"name": "on", "group": "prism", "shapes": ["prism", "slab"], **law}
    prism = body("prism", free(position=(0.0, 0.0, 1.0)), MASS, inertia=(1e5, 1e5, 1.5e5))
    run = adaptive(
        document([prism], shapes=[{**SLAB, "parts": [top]}, shape], pairs=[pair]),
        10.0,
        tension_tolerance=None,
        position_tolerance=None,
        sample_interval=0.1,
    )
    forces = run.columns["contact_force"]
    assert forces[-1].sum() == pytest.approx(MASS * G, rel=1e-8)
    assert np.ptp(run.body("prism")[50:], axis=0).max() < 1e-10
    # Four corners of a small top; of a long one two of the prism at either end, and four where sides cross.
    assert int((forces[-1] > 0.0).sum()) == (4 if reach == 2.0 else 8)


def test_a_corner_between_those_that_bear() -> None:
    """A box of four corners on a top with 64 sides, of which sixteen corners bear: its corners lie where the
    polygon of these sixteen has ended, 2 % of the radius further in, and bear all the same.
    """
    turns = 2 * math.pi * (np.arange(64) + 0.5) / 64
    vertices = [[RADIUS * math.cos(a), RADIUS * math.sin(a), z] for a in turns for z in (-1.0, 0.0)]
    top = {"name": "slab", "body": None, "parts": [{"type": "convex", "vertices": vertices}]}
    reach = 0.99 * RADIUS / math.sqrt(2.0)
    turn = math.radians(45.0 + 360.0 / 64 * 2)  # towards the middle between two corners that bear
    half = [math.cos(turn / 2), 0.0, 0.0, math.sin(turn / 2)]
    part = {"type": "box", "size": [2 * reach, 2 * reach, HEIGHT], "centre": [0, 0, 0], "orientation": half}
    shape = {"name": "prism", "body": "prism", "parts": [part]}
    law = {"stiffness": 1e8, "damping_time": 0.01, "friction": 0.4, "places": 16}
    pair = {"name": "on", "group": "prism", "shapes": ["prism", "slab"], **law}
    box = body("prism", free(position=(0.0, 0.0, HEIGHT / 2)), MASS, inertia=(1e5, 1e5, 1.5e5))
    run = adaptive(
        document([box], shapes=[top, shape], pairs=[pair]),
        10.0,
        tension_tolerance=None,
        position_tolerance=None,
        sample_interval=0.1,
    )
    forces = run.columns["contact_force"][-1]
    assert np.sort(forces)[-4:] == pytest.approx([MASS * G / 4] * 4, rel=1e-6)
