"""A load that stands near the edge of a platform without friction came to rest by `losses="none"`, and was at
rest nowhere by `"held"`.

Friction that holds is taken as holding all in the first search, and as what presses allows from there.
Without any, the second search began where nothing but that endless friction had kept the load, and found no
step.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gantline.scenario import load_scenario
from gantline.statics import Losses, Statics
from hull_lift import text
from round_lift import round_lift

WEIGHT = 200e3 * 9.81


def at_rest(folder: Path, losses: Losses) -> tuple[np.ndarray, np.ndarray]:
    """Where the load is [m], and all contact forces [N]."""
    law = {"stiffness": "500 MN/m", "damping": "20 MN s/m", "friction": 0}
    platform = {
        "type": "box",
        "x": ["-40 m", "0.301 m"],
        "y": ["-40 m", "40 m"],
        "z": ["4.7 m", "5 m"],
        **law,
    }
    given = round_lift(
        {},
        (-1.258, -1.684, 1.011),
        load={"shape": {"box": ["9.78 m", "5.17 m", "4.51 m"]}, "position": ["0 m", "0 m", "5 m"]},
        structures={"platform": platform},
        ground={"level": "0 m", "stiffness": "200 MN/m", "damping": "2 MN s/m", "friction": 0},
        start="rest",
    )
    path = folder / "scenario.yaml"
    path.write_text(text(given))
    recording = Statics(load_scenario(path)).equilibrium(losses=losses).recording
    return recording.column("body_position", "column")[-1], np.asarray(recording["contact_force"].values[-1])


def test_held_by_no_friction_it_rests_as_without(tmp_path: Path) -> None:
    """One question asked twice: place and forces to what a search leaves; the ground bears all at last."""
    (place, forces), (held_place, held_forces) = (at_rest(tmp_path, way) for way in ("none", "held"))
    assert held_place == pytest.approx(place, abs=1e-9)
    assert held_forces == pytest.approx(forces, abs=1e-6 * WEIGHT)
    assert forces.sum() == pytest.approx(WEIGHT, rel=1e-6)
