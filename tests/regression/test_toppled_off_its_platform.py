"""A column that stood on a platform, its centre of gravity nearly over its rim, toppled as it came to rest,
and lay between the underside of the platform and the ground, jammed with 6,800 times its weight.

The search for the equilibrium turned it by 0.8 rad in a step, which took its top metres into the platform.
What was found there pushed it out the nearest way, which was downwards. Through a deck of 0.3 m it fell
without touching it. Of these twelve columns ten lay below, or were refused since no step led on.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from round_lift import round_lift, simulated

#: Radius, length, height of the top of the platform [m]; weight [N].
R, LENGTH, TOP, WEIGHT = 2.2, 20.0, 5.0, 200e3 * 9.81
#: 1/k of each place where it may touch the platform [m/N].
YIELDS = 1 / 2000e6


@pytest.mark.parametrize("under", [0.0, 4.7], ids=["solid", "deck"])
@pytest.mark.parametrize("high", [5.0, 10.0, 16.0])
@pytest.mark.parametrize("aside", [0.99, 0.999])
def test_it_lies_on_the_platform(aside: float, high: float, under: float, tmp_path: Path) -> None:
    """On sixteen corners it stands within R cos(π/16) = 0.981 R of its axis, between two of them, and topples
    beyond. Then it lies on its side, its centre of gravity below its axis, R (1 - aside) over the
    platform, which bears its weight and no more; sides are cut by 1 mm at most (RL5).
    """
    angle = math.pi / 16
    platform = {
        "type": "box",
        "x": ["-40 m", "40 m"],
        "y": ["-40 m", "40 m"],
        "z": [f"{under} m", f"{TOP} m"],
    }
    given = round_lift(
        {"diameter": f"{2 * R} m", "length": f"{LENGTH} m", "along": "z"},
        (aside * R * math.cos(angle), aside * R * math.sin(angle), high),
        load={"position": ["0 m", "0 m", f"{TOP} m"]},
        structures={"platform": {**platform, "stiffness": "2000 MN/m", "damping": "100 MN s/m"}},
        start="rest",
    )
    recording = simulated(tmp_path, given, duration=0.02)
    assert math.degrees(recording.column("load_tilt", "column")[0]) == pytest.approx(90.0, abs=0.1)
    forces = np.asarray(recording["contact_force"].values[0])
    assert forces.sum() == pytest.approx(WEIGHT, rel=1e-6)
    height = recording.column("body_position", "column")[0, 2] - TOP
    assert R * (1 - aside) - 1e-3 - WEIGHT * YIELDS <= height <= R * (1 - aside) + 1e-4
