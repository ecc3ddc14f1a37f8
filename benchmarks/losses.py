"""What losses and inertia of sheaves cost: E(n) with and without.

    python -m benchmarks.losses [N ...]

By `adaptive` at an rms error of 1 %; by `del` in the same steps, with the rms error that each has there.

With losses tensions differ by 2 % where rope slips over a sheave; light sheaves have losses and no inertia.
With inertia every sheave of the equalizer carries 100 kg of spinning mass along, without losses and with
them. Each variant is compared with itself at a tight tolerance.
"""

from __future__ import annotations

import json
import sys
import time
from importlib import import_module
from typing import Any

from rich.console import Console
from rich.table import Table

from benchmarks.contract import FloatArray, Setting
from benchmarks.gantline_code import settings_document
from benchmarks.lifts import equalizer_lift, gantline_document
from benchmarks.measure import Errors, Point, cost, errors

SIZES = (5, 20, 100)
INERTIA = 100.0
"""Of a sheave that has any, I/r^2 [kg]."""
RATIO = 1.0 / 0.98
"""Of the tensions at a sheave that slips."""
VARIANTS = (
    ("ideal sheaves", None),
    ("2 % loss, light", (RATIO, 0.0)),
    ("inertia", (1.0, INERTIA)),
    ("2 % loss and inertia", (RATIO, INERTIA)),
)
TOLERANCES = (3e2, 1e3, 3e3, 1e4, 3e4)
TIGHT = 100.0
"""Tolerance of what they are compared with [N]."""
TARGET = 0.01
INTERVAL = 0.01
"""Between samples [s]."""
STEP = 0.01
"""Of `del` [s]."""
REPEATS = 5
"""Of each run, of which the shortest counts: whatever else the machine does only adds to it."""


def document(n: int, sheaves: tuple[float, float] | None) -> str:
    """E(n), its equalizing rope over sheaves of this ratio of tensions and inertia [kg]; ideal if none."""
    text = gantline_document(equalizer_lift(n))
    if sheaves is None:
        return text
    ratio, inertia = sheaves
    system: dict[str, Any] = json.loads(text)
    guides = [guide for rope in system["ropes"] for guide in rope["route"] if guide["type"] == "half_turn"]
    still = {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]}
    for number, guide in enumerate(guides):
        guide |= {"flow": f"flow{number}", "ratio": ratio}
        flow: dict[str, Any] = {"name": f"flow{number}", "parent": None, "placement": still, "mass": 0.0}
        flow |= {"joint": {"type": "flow", "inertia": inertia}}
        system["bodies"].append(flow | {"centre_of_gravity": [0, 0, 0], "inertia": [0] * 6})
    return json.dumps(system)


def run(text: str, settings: str) -> tuple[float, FloatArray]:
    """Time [s] and tensions of all ropes."""
    simulation = import_module("gantline._core").Simulation(text, settings)
    start = time.perf_counter()
    simulation.run()
    return time.perf_counter() - start, simulation.rope_tension()


def measured(text: str, settings: str, reference: FloatArray) -> tuple[float, Errors]:
    """Shortest time [s] of some runs, and their errors."""
    runs = [run(text, settings) for _ in range(REPEATS)]
    return min(took for took, _ in runs), errors(runs[0][1], reference, float(reference[-1].mean()))


def by_tolerance(text: str, duration: float, reference: FloatArray) -> float | None:
    """Wall time of `adaptive` at the target [s]."""
    ladder = []
    for tolerance in TOLERANCES:
        took, error = measured(text, settings_document(tolerance, duration, INTERVAL), reference)
        ladder.append(Point(Setting("tolerance [N]", tolerance), took, error))
    found = cost(ladder, TARGET)
    return None if found is None else found.seconds


def by_step(text: str, duration: float, reference: FloatArray) -> tuple[float, float]:
    """Wall time of `del` [s] and its rms error."""
    settings = {
        "integrator": {"type": "del", "step": STEP},
        "duration": duration,
        "sample_interval": INTERVAL,
    }
    took, error = measured(text, json.dumps(settings), reference)
    return took, error.rms


def main(sizes: list[int]) -> None:
    columns = [f"E({n})" for n in sizes]
    tolerances = Table("adaptive at 1 %: ms, times as long", *columns)
    steps = Table(f"del, {1e3 * STEP:.0f} ms: ms, times as long, rms error", *columns)
    first: list[tuple[float | None, float]] = []
    for name, sheaves in VARIANTS:
        row: list[tuple[float | None, float]] = []
        wrong = []
        for n in sizes:
            text, duration = document(n, sheaves), equalizer_lift(n).duration
            reference = run(text, settings_document(TIGHT, duration, INTERVAL))[1]
            took, error = by_step(text, duration, reference)
            row.append((by_tolerance(text, duration, reference), took))
            wrong.append(error)
        first = first or row
        pairs = list(zip(row, first, strict=True))
        tolerances.add_row(
            name, *(f"{1e3 * t:.1f}, {t / base:.1f}" if t and base else "–" for (t, _), (base, _) in pairs)
        )
        steps.add_row(
            name,
            *(
                f"{1e3 * t:.0f}, {t / base:.1f}, {100 * error:.0f} %"
                for ((_, t), (_, base)), error in zip(pairs, wrong, strict=True)
            ),
        )
    for table in (tolerances, steps):
        Console().print(table)


if __name__ == "__main__":
    main([int(name) for name in sys.argv[1:]] or list(SIZES))
