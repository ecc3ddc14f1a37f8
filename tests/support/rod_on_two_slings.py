"""A rod on two plumb slings that turns about the plumb between them, as measured and as a lift file."""

from __future__ import annotations

import csv
import json
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

import gantline

FILE = Path(__file__).parents[1] / "validation" / "rod_on_two_slings.csv"
#: Of the rod: length, diameter [m], mass [kg], which is not told and is not in the period; here of steel.
ROD, DIAMETER, MASS = 0.1958, 0.00683, 0.056
#: Of each sling from the middle of the rod [m].
ASIDE = 0.0750
AMPLITUDES = np.linspace(0.1, 1.5, 8)


@dataclass(frozen=True)
class Record:
    """One time that the rod turned to and fro, ever less.

    Attributes:
        length: Of the slings, to the middle of the rod [m].
        series: Each length was hung once in each of three.
        amplitudes: Of five periods at a time (n,) [rad].
        periods: Their mean (n,) [s].
    """

    length: float
    series: int
    amplitudes: np.ndarray
    periods: np.ndarray


def records() -> list[Record]:
    """All that were measured, by length and series."""
    with FILE.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    found: dict[tuple[float, int], list[tuple[float, float]]] = {}
    for row in rows:
        of = float(row["length [m]"]), int(row["series"])
        found.setdefault(of, []).append((float(row["amplitude [rad]"]), float(row["period [s]"])))
    return [Record(*of, *np.array(values).T) for of, values in found.items()]


def periods(folder: Path, length: float) -> CubicSpline:
    """Of slings of a length [m], over the amplitude [rad], as simulated."""
    return CubicSpline(AMPLITUDES, [period(folder, length, amplitude) for amplitude in AMPLITUDES])


def period(folder: Path, length: float, amplitude: float) -> float:
    """Of a turn to and fro on slings of a length [m], by an amplitude [rad], of eight simulated [s]."""
    about = math.tau * ROD / math.sqrt(12) / ASIDE * math.sqrt(length / 9.81)
    run = gantline.simulate(lift(folder, length, amplitude, 11 * about), sample_interval=about / 200)
    w, z = run.column("body_orientation", "rod")[:, [0, 3]].T
    heading = 2 * np.arctan2(z, w)
    down = np.flatnonzero((heading[:-1] > 0) & (heading[1:] <= 0))
    share = heading[down] / (heading[down] - heading[down + 1])
    through = run.time[down] + share * np.diff(run.time)[down]
    return float((through[8] - through[0]) / 8)


def lift(folder: Path, length: float, amplitude: float, duration: float) -> Path:
    """A lift file: two hooks, a sling each, the rod turned by the amplitude and let go."""
    # A lug goes around a circle of this radius, so far aside of its sling's upper end.
    aside = 2 * ASIDE * math.sin(amplitude / 2)
    hangs = math.sqrt(length**2 - aside**2)
    whole = {
        "format": 1,
        "lift": {"title": "A rod on two slings"},
        "duration": f"{duration} s",
        "start": "as_given",
        "simulation": {"tension_tolerance": "1e-6 N", "position_tolerance": "1e-7 m"},
        # By 0.14 mm of 0.5 m longer under the rod.
        "ropes": {"yarn": {"axial_stiffness": "1 kN", "damping_time": "2 ms", "mass": "none"}},
        "load": {
            "name": "rod",
            "shape": {"box": [f"{ROD} m", f"{DIAMETER} m", f"{DIAMETER} m"]},
            "position": ["0 m", "0 m", f"{-hangs - DIAMETER / 2} m"],
            "heading": f"{amplitude} rad",
            "weight": {"calculated": f"{MASS} kg", "contingency": 1.0},
            "centre_of_gravity": {"at": ["0 m", "0 m", f"{DIAMETER / 2} m"]},
            "inertia": {
                # A round bar about its middle.
                "xx": f"{MASS * DIAMETER**2 / 8} kg m^2",
                "yy": f"{MASS * (ROD**2 / 12 + DIAMETER**2 / 16)} kg m^2",
                "zz": f"{MASS * (ROD**2 / 12 + DIAMETER**2 / 16)} kg m^2",
            },
            "lugs": {
                name: {"at": [f"{side * ASIDE} m", "0 m", f"{DIAMETER / 2} m"]}
                for name, side in (("A", -1), ("B", 1))
            },
        },
        "cranes": {
            name: {
                "type": "fixed_hook",
                "at": [f"{side * ASIDE} m", "0 m", "0 m"],
                "hoist": {"speed": "1 m/min", "acceleration": "0.1 m/s^2"},
            }
            for name, side in (("A", -1), ("B", 1))
        },
        "slings": {
            name: {"from": name, "to": f"rod.{name}", "length": f"{length} m", "rope": "yarn"}
            for name in ("A", "B")
        },
    }
    path = folder / "lift.yaml"
    path.write_text(json.dumps(whole), encoding="utf-8")
    return path
