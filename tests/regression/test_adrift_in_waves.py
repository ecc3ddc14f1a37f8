"""A vessel that nothing holds turns and drifts in waves, whose forces stay those of where it was first.

In a sea of 1 m a barge of 100 m turned by 14° in 40 minutes and by 81° in 67; the moment that had pitched it
rolled it by 19°, and after 91 minutes it capsized. Nothing said why.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

import waves
from gantline.results.sea import out_of_place
from gantline.simulation import Simulation, simulate

PERIOD = 8.0
SWELL = {"height": "10 cm", "period": f"{PERIOD} s", "direction": "90 deg"}
#: Of deep water, g T²/2π [m].
WAVELENGTH = waves.G * PERIOD**2 / (2 * math.pi)


def barge_at(folder: Path, turned: float, aside: float) -> list[str]:
    """What is said of a run whose last sample is turned [rad] and moved along the waves [m]."""
    simulation = Simulation(waves.in_waves(folder, {"swell": SWELL}, {"heading": "20 deg"}))
    document: dict[str, Any] = simulation.assembly.document
    joint = document["bodies"][0]["joint"]
    first = math.radians(20.0)
    orientation = np.array([[[math.cos(a / 2), 0.0, 0.0, math.sin(a / 2)]] for a in (first, first + turned)])
    # The point of the forces stays where it was but for `aside`.
    arm = np.array(document["forces"][-1]["at"]) - np.array(document["bodies"][0]["centre_of_gravity"])

    def level(angle: float) -> Any:
        cos, sin = math.cos(angle), math.sin(angle)
        return np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])

    point = np.array(joint["position"]) + level(first) @ np.array(document["forces"][-1]["at"])
    drifted = point + np.array([0.0, aside, 0.0])
    places = [point - level(first) @ arm, drifted - level(first + turned) @ arm]
    columns = {
        "time": np.array([0.0, 60.0]),
        "body_position": np.array(places)[:, None],
        "body_orientation": orientation,
    }
    return out_of_place(document, columns, {"body": ["barge"]})


def test_turns_and_drifts_are_told(tmp_path: Path) -> None:
    """From 10° and from a quarter of a wave on, along the waves, across which a way means nothing."""
    assert barge_at(tmp_path, math.radians(9.9), 0.249 * WAVELENGTH) == []
    (turned,) = barge_at(tmp_path, math.radians(-10.1), 0.0)
    assert "barge are for its place and heading in the lift file; it turns by up to 10.1 deg" in turned
    assert "from 60 s on" in turned
    (drifted,) = barge_at(tmp_path, 0.0, -0.251 * WAVELENGTH)
    assert f"drifts by up to {0.251 * WAVELENGTH:.3g} m" in drifted


def test_a_run_that_stays_says_nothing(tmp_path: Path) -> None:
    """Waves of 10 cm for 30 s move the barge by centimetres."""
    path = waves.in_waves(tmp_path, {"swell": SWELL}, {"heading": "20 deg"}, duration="30 s")
    assert not any("place and heading" in text for text in simulate(path).attributes["warnings"])
