"""Time every scenario: steps per second, and how much faster than the lift itself.

    python benchmarks/speed.py [SCENARIO ...]

The time is that of the core alone, from the state at the start to the end, the least of three runs.
"""

from __future__ import annotations

import sys
from pathlib import Path

from rich.console import Console
from rich.table import Table

import gantline

SCENARIOS = Path(__file__).resolve().parents[1] / "scenarios"
RUNS = 3


def measure(lift: Path) -> tuple[float, float, int]:
    """Simulated time [s], least time of integration [s], steps."""
    times = []
    for _ in range(RUNS):
        simulation = gantline.Simulation(lift)
        recording = simulation.run()
        times.append(simulation.integration_time)
    return float(recording.time[-1]), min(times), int(recording.attributes["counters"]["steps"])


def main(names: list[str]) -> None:
    lifts = [SCENARIOS / name for name in names] or sorted(
        path.parent for path in SCENARIOS.glob("*/scenario.yaml")
    )
    table = Table("scenario", "simulated [s]", "time [s]", "steps", "steps/s", "faster than real time")
    for column in table.columns[1:]:
        column.justify = "right"
    for lift in lifts:
        simulated, time, steps = measure(lift)
        cells = [
            f"{simulated:g}",
            f"{time:.3f}",
            f"{steps}",
            f"{steps / time:,.0f}",
            f"{simulated / time:,.0f} ×",
        ]
        table.add_row(lift.name, *cells)
    Console().print(table)


if __name__ == "__main__":
    main(sys.argv[1:])
