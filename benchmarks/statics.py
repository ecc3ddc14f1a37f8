"""How long the equilibria of the benchmark lifts take, from their start, and how that grows with the sheaves.

    python -m benchmarks.statics [--largest N]

Each E(n) is let go from just-taut slings, as in the race. Beside its time stands that of simulating the same
lift until it has settled, 30 s, with gantline's own method at its default tolerance. The time is the least of
many; building the system, once for a lift, is not counted.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Callable

from rich.console import Console
from rich.table import Table

from benchmarks.lifts import Lift, equalizer_lift, gantline_document
from benchmarks.measure import growth
from gantline import _core

SIZES = (5, 10, 20, 50, 100, 200, 400, 700, 1000)
REPEATS = 50
SETTLING = 3
"""Simulations of each lift."""
FIRST = 20
"""Fewest sheaves that the exponent counts: below, the call itself is half of the time."""
BOUND = 1.2
"""The exponent is to stay below."""


def least(repeats: int, run: Callable[[], object]) -> float:
    """Least wall time of several runs [s]."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    return min(times)


def settling(lift: Lift) -> float:
    """Wall time of simulating a lift until it has settled [s]."""
    settings = json.dumps(
        {"integrator": {"type": "adaptive"}, "duration": lift.duration, "sample_interval": lift.duration}
    )
    document = gantline_document(lift)
    runs = [_core.Simulation(document, settings) for _ in range(SETTLING)]
    return least(SETTLING, lambda: runs.pop().run())


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--largest", type=int, default=SIZES[-1], help="most sheaves")
    arguments = parser.parse_args()
    table = Table(
        "n", "equilibrium [ms]", "steps", "factorisations", "settling [ms]", "ratio", title="E(n) at rest"
    )
    sizes, seconds = [], []
    for n in (n for n in SIZES if n <= arguments.largest):
        lift = equalizer_lift(n)
        core = _core.Statics(gantline_document(lift))
        found = core.settle()
        taken = least(REPEATS, core.settle)
        simulated = settling(lift)
        numbers = (f"{1e3 * taken:.3f}", found["steps"], found["factorisations"], f"{1e3 * simulated:.1f}")
        table.add_row(str(n), *map(str, numbers), f"{simulated / taken:.0f}")
        sizes.append(n)
        seconds.append(taken)
    console = Console()
    console.print(table)
    large = [(n, value) for n, value in zip(sizes, seconds, strict=True) if n >= FIRST]
    if len(large) > 1:
        exponent = growth([n for n, _ in large], [value for _, value in large])
        console.print(f"Exponent from {FIRST} sheaves on: {exponent:.2f} (bound {BOUND})")


if __name__ == "__main__":
    main()
