"""Where gantline's time goes, by stage: kinematics, assembly, factorisation, solution, events, recording.

    python -m benchmarks.stages [N ...]

Stages are timed in a run of their own, since reading the clock costs a few per cent: shares are of that run.
"""

from __future__ import annotations

import sys
import time

from rich.console import Console
from rich.table import Table

from benchmarks.gantline_code import GantlineRun
from benchmarks.lifts import equalizer_lift

SIZES = (5, 20, 100, 400)
TOLERANCE = 1e4  # N, about 1 % of rms error
REPEATS = 3


def timed(n: int, measures: bool) -> tuple[float, dict[str, float], dict[str, int]]:
    """Least time [s] of a few runs; stages [s] and counters of the last one."""
    lift = equalizer_lift(n)
    least = float("inf")
    for _ in range(REPEATS):
        run = GantlineRun(lift, TOLERANCE, lift.duration)
        if measures:
            run.simulation.measure()
        start = time.perf_counter()
        run.integrate()
        least = min(least, time.perf_counter() - start)
    return least, run.simulation.stages(), run.simulation.counters()


def shares(stages: dict[str, float]) -> list[tuple[str, float, float]]:
    """Name, time [s] and share of every stage, the longest first."""
    whole = sum(stages.values())
    ordered = sorted(stages.items(), key=lambda item: -item[1])
    return [(name, seconds, seconds / whole) for name, seconds in ordered]


def main(sizes: list[int]) -> None:
    console = Console()
    for n in sizes:
        whole, _, counters = timed(n, measures=False)
        console.print(f"E({n}) at a tolerance of {TOLERANCE:g} N: {1e3 * whole:.2f} ms")
        table = Table("stage", "time [ms]", "share")
        for name, seconds, share in shares(timed(n, measures=True)[1]):
            table.add_row(name, f"{1e3 * seconds:.2f}", f"{share:.0%}")
        console.print(table)
        console.print(", ".join(f"{name} {value:g}" for name, value in counters.items()))


if __name__ == "__main__":
    main([int(name) for name in sys.argv[1:]] or list(SIZES))
