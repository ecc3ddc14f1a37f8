"""A barge that moves as its answers to waves have it, and a load that hangs from a post aboard."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

import waves
from afloat import DRAFT, LENGTH, barge, lift_of, written
from gantline.hydro.raos import DisplacementRaos, write_raos

#: The point of the barge that the table is of: ahead of the middle, to port, on deck [m].
AT = np.array([LENGTH / 2 + 12.0, 3.0, 8.0])
#: From the middle of the waterline to there.
LEVER = AT - np.array([LENGTH / 2, 0.0, DRAFT])
PORT = np.concatenate([waves.DIRECTIONS, -waves.DIRECTIONS[1:-1]])


#: A load of 1 t that swings on a rope of 12 m from a post aboard.
HUNG: dict[str, Any] = {
    "mechanics": {
        "bodies": {
            "post": {
                "parent": "barge",
                "at": ["90 m", "5 m", "30 m"],
                "joint": {"type": "fixed"},
                "mass": "1 kg",
            },
            "held": {"at": ["90 m", "5 m", f"{18 - DRAFT} m"], "joint": {"type": "point"}, "mass": "1 t"},
        },
        "ropes": {
            "fall": {
                "rope": "fall",
                "length": "12 m",
                "route": [{"type": "end", "body": "post"}, {"type": "end", "body": "held"}],
            }
        },
    },
    "ropes": {"fall": {"axial_stiffness": "20 MN", "damping_time": "10 ms"}},
}


def free_barge(omega: float, direction: float) -> Any:
    """X of the point of the free barge, phases from there: (−ω²(M + A) − iωB + C)⁻¹ F and rigid motion."""
    about = waves.response(omega, waves.force_per_metre(omega, direction))
    there = np.concatenate([about[:3] + np.cross(about[3:], LEVER), about[3:]])
    ahead = np.array([math.cos(direction), math.sin(direction)])
    return there * np.exp(-1j * omega**2 / waves.G * (ahead @ LEVER[:2]))


def table(folder: Path, frequencies: Any = waves.FREQUENCIES, directions: Any = PORT) -> str:
    """Name of a table of the free barge beside a lift file, phases as lags."""
    motion = np.array([[free_barge(w, b) for b in directions] for w in frequencies])
    write_raos(DisplacementRaos("barge", frequencies, directions, motion), folder / "barge.csv")
    return "barge.csv"


def carried(folder: Path, trains: dict[str, Any], *, phases: str = "lag", **given: Any) -> Path:
    """The lift file of the barge that moves by this table; `vessel` changes it."""
    at = [f"{part} m" for part in AT]
    motion = {"raos": "barge.csv", "phases": phases, "at": at}
    vessel = barge(wave_motion=motion, **given.pop("vessel", {}))
    return written(folder, lift_of(vessel, waves=trains, **given))
