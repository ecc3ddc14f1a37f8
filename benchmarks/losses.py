"""What losses and inertia of sheaves cost: E(n) with and without, at an rms error of 1 %.

    python -m benchmarks.losses [N ...]

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
from benchmarks.measure import Point, cost, errors

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


def run(text: str, tolerance: float, duration: float) -> tuple[float, FloatArray]:
    """Time [s] and tensions of all ropes."""
    simulation = import_module("gantline._core").Simulation(
        text, settings_document(tolerance, duration, 0.01)
    )
    start = time.perf_counter()
    simulation.run()
    return time.perf_counter() - start, simulation.rope_tension()


def seconds(n: int, sheaves: tuple[float, float] | None) -> float | None:
    """Wall time at the target [s]."""
    text, duration = document(n, sheaves), equalizer_lift(n).duration
    reference = run(text, TIGHT, duration)[1]
    ladder = []
    for tolerance in TOLERANCES:
        runs = [run(text, tolerance, duration) for _ in range(REPEATS)]
        error = errors(runs[0][1], reference, float(reference[-1].mean()))
        ladder.append(Point(Setting("tolerance [N]", tolerance), min(t for t, _ in runs), error))
    found = cost(ladder, TARGET)
    return None if found is None else found.seconds


def main(sizes: list[int]) -> None:
    table = Table("ms, times as long", *(f"E({n})" for n in sizes))
    first: list[float | None] = []
    for name, sheaves in VARIANTS:
        row = [seconds(n, sheaves) for n in sizes]
        first = first or row
        pairs = zip(row, first, strict=True)
        table.add_row(
            name, *("–" if not t or not base else f"{1e3 * t:.1f}, {t / base:.1f}" for t, base in pairs)
        )
    Console().print(table)


if __name__ == "__main__":
    main([int(name) for name in sys.argv[1:]] or list(SIZES))
