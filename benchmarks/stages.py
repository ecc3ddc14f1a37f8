"""Where gantline's time goes, by stage: kinematics, assembly, factorisation, solve, events, recording.

    python -m benchmarks.stages [N ...]

Shows what the core counts. Counters whose names end in `_seconds` are times by stage and become shares of the
whole; the rest are numbers. Recording is also told from outside, by a run that does not record.
"""

from __future__ import annotations

import sys
import time

from rich.console import Console
from rich.table import Table

from benchmarks.contract import SAMPLE_INTERVAL
from benchmarks.gantline_code import GantlineRun
from benchmarks.lifts import equalizer_lift

SIZES = (5, 20, 100, 400)
TOLERANCE = 1e4  # N, about 1 % of rms error
SUFFIX = "_seconds"
REPEATS = 3


def timed(n: int, interval: float) -> tuple[float, dict[str, float]]:
    """Least time [s] of a few runs, and the counters of the last one."""
    lift = equalizer_lift(n)
    least = float("inf")
    for _ in range(REPEATS):
        run = GantlineRun(lift, TOLERANCE, lift.duration, interval)
        start = time.perf_counter()
        run.integrate()
        least = min(least, time.perf_counter() - start)
    return least, dict(run.simulation.counters())


def stages(counters: dict[str, float], whole: float) -> list[tuple[str, float, float]]:
    """Name, time [s] and share of every stage that the core times, and of what is left."""
    known = {name.removesuffix(SUFFIX): value for name, value in counters.items() if name.endswith(SUFFIX)}
    if not known:
        return []
    known["other"] = whole - sum(known.values())
    return [(name.replace("_", " "), value, value / whole) for name, value in known.items()]


def main(sizes: list[int]) -> None:
    console = Console()
    for n in sizes:
        silent, _ = timed(n, equalizer_lift(n).duration)
        whole, counters = timed(n, SAMPLE_INTERVAL)
        console.print(f"E({n}) at a tolerance of {TOLERANCE:g} N: {1e3 * whole:.2f} ms")
        table = Table("stage", "time [ms]", "share")
        for name, seconds, share in stages(counters, whole):
            table.add_row(name, f"{1e3 * seconds:.2f}", f"{100 * share:.0f} %")
        recording = whole - silent
        table.add_row("recording, from outside", f"{1e3 * recording:.2f}", f"{100 * recording / whole:.0f} %")
        console.print(table)
        numbers = {name: value for name, value in counters.items() if not name.endswith(SUFFIX)}
        console.print(", ".join(f"{name} {value:g}" for name, value in numbers.items()))


if __name__ == "__main__":
    main([int(name) for name in sys.argv[1:]] or list(SIZES))
