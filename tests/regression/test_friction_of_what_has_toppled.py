"""A load that toppled off the edge of a platform, as it came to rest at the start, leaned on the side of the
platform with a fifth of its weight.

Friction is held where a load stands at the start: its corners on the ground, which it had not touched there,
pulled it along the ground to below where it stood, 5 m up, and the platform was in the way.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from round_lift import round_lift, simulated

#: Half of its length, height of the platform [m]; weight [N].
HALF, TOP, WEIGHT = 2.0, 5.0, 200e3 * 9.81


@pytest.mark.parametrize("friction", [0.0, 0.1, 0.3])
@pytest.mark.parametrize(("along", "aside", "edge"), [(1.6, 1.0, 1.4), (1.6, 2.0, 0.0), (-0.5, 1.3, -0.8)])
def test_nothing_presses_aside(
    along: float, aside: float, edge: float, friction: float, tmp_path: Path
) -> None:
    """With its centre of gravity beyond the edge it falls onto its side at x = 2 m. The ground bears its
    weight and nothing else presses, so that all contact forces add up to that. Corners sink by W/2k at most.
    """
    platform = {"type": "box", "x": ["-40 m", f"{edge} m"], "y": ["-40 m", "40 m"], "z": ["0 m", f"{TOP} m"]}
    law = {"stiffness": "500 MN/m", "damping": "20 MN s/m", "friction": friction}
    given = round_lift(
        {},
        (along, aside, 4.9),
        load={"shape": {"box": [f"{2 * HALF} m", "9 m", "7 m"]}, "position": ["0 m", "0 m", f"{TOP} m"]},
        structures={"platform": {**platform, **law}},
        start="rest",
    )
    recording = simulated(tmp_path, given, duration=0.02)
    assert math.degrees(recording.column("load_tilt", "column")[0]) == pytest.approx(90.0, abs=0.1)
    forces = np.asarray(recording["contact_force"].values[0])
    assert forces.sum() == pytest.approx(WEIGHT, rel=1e-6)
    height = recording.column("body_position", "column")[0, 2]
    # The ground gives by 200 MN/m under each corner.
    assert HALF - along - WEIGHT / 2 / 200e6 <= height <= HALF - along
