"""A load at rest on more corners than hold it, for a day and longer.

At rest steps grow, to more than an hour. Beside the inertia the compliance of a corner counts by 1/h², and
once that was rounding the corners looked as if one repeated the others: the run ended after 1.7 hours with
"the equations are singular here".
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from mechanics import G, adaptive, body, contact, document, end, free, rope

MASS, SLOPE, DAY = 1000.0, 0.4, 1e5
CORNERS = ((-1, -1), (1, -1), (1, 1), (-1, 1))


@pytest.mark.parametrize("stiffness", [1e7, 1e8, 1e10])
def test_a_load_that_friction_holds_on_a_slope(stiffness: float) -> None:
    """tan 0.4 = 0.42 < μ: N = m g cos α/4 at each corner, and no creep."""
    load = body("load", free((0, 0, 0)), MASS, inertia=(100, 100, 100))
    load["placement"]["orientation"] = [math.cos(SLOPE / 2), 0, math.sin(SLOPE / 2), 0]
    plane = {"plane_normal": [math.sin(SLOPE), 0, math.cos(SLOPE)], "friction": 0.5, "damping_time": 0.01}
    corners = [
        contact(f"c{k}", "load", (x, y, 0), stiffness=stiffness, **plane) for k, (x, y) in enumerate(CORNERS)
    ]
    run = adaptive(
        document([load], contacts=corners),
        DAY,
        tension_tolerance=None,
        position_tolerance=None,
        sample_interval=1e3,
    )
    # Forces at rest are right to the tolerance of tension, 1 N where no rope carries.
    assert run.columns["contact_force"][-1] == pytest.approx(MASS * G * math.cos(SLOPE) / 4, abs=1.0)
    assert np.abs(run.body("load")[1:] - run.body("load")[1]).max() < 1.0 / stiffness


def test_a_load_on_four_slings() -> None:
    """Four plumb slings, each of a quarter of the weight, of which three would hold the load."""
    load = body("load", free((0, 0, 0)), MASS, inertia=(100, 100, 100))
    slings = [
        rope(f"s{k}", 10.0, [end(None, (x, y, 10)), end("load", (x, y, 0))], 1e9, 0.01)
        for k, (x, y) in enumerate(CORNERS)
    ]
    run = adaptive(
        document([load], ropes=slings),
        DAY,
        tension_tolerance=None,
        position_tolerance=None,
        sample_interval=1e3,
    )
    for k in range(4):
        assert run.tension(f"s{k}")[-1] == pytest.approx(MASS * G / 4, abs=1.0)
