"""A hull section on keel blocks, and what else may stand about, as lift files in text."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

import gantline
from gantline.results.variable import FloatArray

G = 9.81

HULL: dict[str, Any] = {
    "format": 1,
    "lift": {"title": "A hull section on keel blocks"},
    "duration": "5 s",
    "ground": {"level": "0 m", "friction": 0.4},
    "ropes": {"sling": {"axial_stiffness": "100 MN", "damping_time": "10 ms", "diameter": "44 mm"}},
    "load": {
        "name": "hull",
        "shape": {"box": ["43 m", "23 m", "11 m"]},
        "position": ["-35 m", "0 m", "1.5 m"],
        "weight": {"calculated": "350 t"},
        "centre_of_gravity": {"at": ["-2 m", "0 m", "4.8 m"]},
        "stands_on": "keel_blocks",
        "lugs": {name: {"at": [f"{x} m", f"{y} m", "11 m"]} for name, x, y in (("A", -8, 0), ("B", 4, 0))},
    },
    "supports": {
        "keel_blocks": {
            "under": "hull",
            "grid": {"x": ["-18 m", "-6 m", "6 m", "18 m"], "y": ["-9 m", "-3 m", "3 m", "9 m"]},
            "height": "1.5 m",
            "stiffness": "100 MN/m",
            "damping": "1 MN s/m",
            "friction": 0.4,
            "capacity": "100 t",
        }
    },
    "cranes": {
        "hook": {
            "type": "fixed_hook",
            "at": ["-37 m", "0 m", "40 m"],
            "rated_capacity": "600 t",
            "hoist": {"speed": "5 m/min", "acceleration": "0.02 m/s^2"},
        }
    },
    "slings": {
        name: {"from": "hook", "to": f"hull.{name}", "length": "29 m", "rope": "sling"} for name in ("A", "B")
    },
    "plan": [{"step": "hold", "hold": "until_end"}],
}


def lift(**changes: Any) -> dict[str, Any]:
    """The hull with other top-level sections; None leaves one out."""
    given = {**HULL, **changes}
    return {key: value for key, value in given.items() if value is not None}


def text(given: Mapping[str, Any]) -> str:
    """A lift file; JSON is YAML."""
    return json.dumps(given, indent=1)


def simulated(folder: Path, given: Mapping[str, Any], **settings: Any) -> gantline.Recording:
    """Run a lift, its file in a folder; `settings` as for `gantline.simulate`."""
    path = folder / "scenario.yaml"
    path.write_text(text(given))
    return gantline.simulate(path, **settings)


def shares_of_springs(
    places: FloatArray, stiffness: FloatArray, gaps: FloatArray, weight: float, centre: FloatArray
) -> FloatArray:
    """Forces of springs under a rigid load that only push, by the complementarity of gap and force.

    The load sinks by z and turns by a, b, little: a spring i carries k_i max(0, z + a y_i - b x_i - gap_i),
    and all of them the weight at `centre`. Springs that would pull are left out; with those that carry the
    three unknowns solve a linear system.

    Args:
        places: (n, 2) [m].
        stiffness: (n,) [N/m].
        gaps: between each spring and the level load (n,) [m].
        weight: [N].
        centre: of gravity (2,) [m].
    """
    carries = np.ones(len(places), dtype=bool)
    rows = np.column_stack([np.ones(len(places)), places[:, 1], -places[:, 0]])
    for _ in range(2 * len(places)):
        springs = rows[carries] * stiffness[carries, None]
        right = weight * np.array([1.0, centre[1], -centre[0]]) + springs.T @ gaps[carries]
        deflection = rows @ np.linalg.solve(springs.T @ rows[carries], right) - gaps
        wrong = (deflection > 0) != carries
        if not wrong.any():
            forces: FloatArray = np.where(carries, stiffness * deflection, 0.0)
            return forces
        carries ^= wrong
    raise AssertionError("no set of springs carries the load")
