"""Lift files with one vessel: a barge, and a sheerleg of plausible weights."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

from floating import SEA

LENGTH, BREADTH, DEPTH, DRAFT, KG = 100.0, 30.0, 8.0, 4.0, 5.0
MASS = SEA * LENGTH * BREADTH * DRAFT


def barge(**changes: Any) -> dict[str, Any]:
    """A barge of 100 × 30 × 8 m that weighs 12 300 t, at 4 m draft."""
    return {
        "draft": f"{DRAFT} m",
        "hull": {"box": [f"{LENGTH} m", f"{BREADTH} m", f"{DEPTH} m"]},
        "masses": {"hull": {"mass": f"{MASS} kg", "at": [f"{LENGTH / 2} m", "0 m", f"{KG} m"]}},
        "radii_of_gyration": ["11 m", "27 m", "27 m"],
        **changes,
    }


def lift_of(vessel: dict[str, Any], **changes: Any) -> dict[str, Any]:
    """The lift file with the vessel as `barge`."""
    return {
        "format": 1,
        "lift": {"title": "A barge"},
        "duration": "1 s",
        "vessels": {"barge": vessel},
        **changes,
    }


def written(folder: Path, given: dict[str, Any]) -> Path:
    """A lift file; JSON is YAML."""
    path = folder / "lift.yaml"
    path.write_text(json.dumps(given), encoding="utf-8")
    return path


#: Heel pins of the sheerleg's boom, its head, 110 m from there at 60 deg, its centre at 48 %: x and z [m].
PINS = (98.0, 9.0)
HEAD = (98 + 110 * math.cos(math.radians(60)), 9 + 110 * math.sin(math.radians(60)))
BOOM = tuple(pin + 0.48 * (head - pin) for pin, head in zip(PINS, HEAD, strict=True))
#: Weights of the vessel by itself [t], and their x and z [m].
WEIGHTS = {
    "hull": (6800, 50, 5.0),
    "accommodation": (900, 22, 12.0),
    "winches": (700, 35, 9.5),
    "a_frame": (700, 70, 32.0),
}
#: Rows of four tanks of 26.4 × 11.5 m: x of their middles [m], content [t].
ROWS = ((13.2, 3311.0), (39.6, 6441.0))
#: Inertia of the boom about its centre, across its length [t m²].
BOOM_INERTIA = 1.51e6
#: Added mass about the middle of the keel [t], [t m²].
ADDED = {"surge": 1100, "sway": 5000, "heave": 85e3, "roll": 7.5e6, "pitch": 6.3e7, "yaw": 5e6}
#: From the boom head to what hangs there [m].
FALLS = 60.0


def sheerleg(on_hooks: float = 0.0, **changes: Any) -> dict[str, Any]:
    """A floating crane of 105.6 × 46 × 7.5 m with its boom at 60 deg; `on_hooks` [t] hang at its head by one
    rope, which is cut at 2 s, and the file begins with the vessel lying as it does under that load.
    """

    def at(x: float, y: float, z: float) -> list[str]:
        return [f"{part:.12g} m" for part in (x, y, z)]

    tanks = {
        f"row{row}.{place}": {
            "box": ["26.4 m", "11.5 m", "7.5 m"],
            "bottom": at(x, 11.5 * (2.5 - place), 0),
            "content": f"{content / 4} t",
        }
        for row, (x, content) in enumerate(ROWS, start=1)
        for place in range(1, 5)
    }
    vessel = {
        "draft": "4.40 m" if on_hooks else "4.18 m",
        "trim": "0 deg" if on_hooks else "1.46 deg",
        "hull": {"box": ["105.6 m", "46 m", "7.5 m"]},
        "masses": {name: {"mass": f"{mass} t", "at": at(x, 0, z)} for name, (mass, x, z) in WEIGHTS.items()},
        "radii_of_gyration": ["15 m", "28.5 m", "30 m"],
        "tanks": tanks,
        "added_mass": {
            "at": at(52.8, 0, 0),
            **{motion: f"{value} {'t' if value < 1e6 else 't m^2'}" for motion, value in ADDED.items()},
        },
        **changes,
    }
    boom = {
        "parent": "crane",
        "at": at(BOOM[0], 0, BOOM[1]),
        "orientation": {"about": ["0", "-1", "0"], "angle": "60 deg"},
        "joint": {"type": "fixed"},
        "mass": "1500 t",
        "inertia": {"xx": "0 t m^2", "yy": f"{BOOM_INERTIA} t m^2", "zz": f"{BOOM_INERTIA} t m^2"},
    }
    gear = {"parent": "crane", "at": at(HEAD[0], 0, HEAD[1]), "joint": {"type": "fixed"}, "mass": "460 t"}
    mechanics: dict[str, Any] = {"bodies": {"boom": boom, "gear": gear}}
    given: dict[str, Any] = {
        "format": 1,
        "lift": {"title": "A sheerleg"},
        "duration": "30 s",
        "vessels": {"crane": vessel},
        "mechanics": mechanics,
    }
    if on_hooks:
        place = at(HEAD[0], 0, HEAD[1] - 4.4 - FALLS)
        mechanics["bodies"]["held"] = {"at": place, "joint": {"type": "point"}, "mass": f"{on_hooks} t"}
        ends = [{"type": "end", "body": "gear"}, {"type": "end", "body": "held"}]
        mechanics["ropes"] = {
            "falls": {"rope": "falls", "length": f"{FALLS} m", "cut_at": "2 s", "route": ends}
        }
        given["ropes"] = {"falls": {"axial_stiffness": "4000 MN", "damping_time": "20 ms"}}
    return given
