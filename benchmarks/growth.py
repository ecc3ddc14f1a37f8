"""How gantline's wall time grows with the number of sheaves, at an rms error of 1 %.

    python -m benchmarks.growth [--largest N] [--output FOLDER]

For every E(n) the time is interpolated over tolerances, against a reference at a tight tolerance; the
exponent is that of a power law by least squares in logarithms. Samples are taken ten times a second: what
grows is the integration.
"""

from __future__ import annotations

import argparse
import statistics
import time
from pathlib import Path

from matplotlib import rc_context
from matplotlib.figure import Figure
from rich.console import Console
from rich.table import Table

from benchmarks.contract import FloatArray, Setting
from benchmarks.gantline_code import REFERENCE_TOLERANCE, GantlineRun
from benchmarks.lifts import Lift, equalizer_lift
from benchmarks.measure import Point, cost, errors, growth
from benchmarks.race import OUTPUT
from gantline.plot.style import COLOURS, QUIET, RC

SIZES = (5, 10, 20, 50, 100, 200, 400, 700, 1000)
TOLERANCES = (1e3, 3e3, 1e4, 2e4, 4e4)
TARGET = 0.01
INTERVAL = 0.1  # s
REPEATS = 3
BOUND = 1.1
"""The exponent is to stay below."""


def run(lift: Lift, tolerance: float) -> tuple[float, FloatArray]:
    """Time [s] and sling tensions."""
    prepared = GantlineRun(lift, tolerance, lift.duration, INTERVAL)
    start = time.perf_counter()
    prepared.integrate()
    return time.perf_counter() - start, prepared.tensions()


def measure(n: int) -> float | None:
    """Wall time [s] of E(n) at the target, None where no tolerance reaches it."""
    lift = equalizer_lift(n)
    reference = run(lift, REFERENCE_TOLERANCE)[1]
    ladder = []
    for tolerance in TOLERANCES:
        runs = [run(lift, tolerance) for _ in range(REPEATS)]
        error = errors(runs[0][1], reference, float(reference[-1].mean()))
        seconds = statistics.median(seconds for seconds, _ in runs)
        ladder.append(Point(Setting("tolerance [N]", tolerance), seconds, error))
    found = cost(ladder, TARGET)
    return None if found is None else found.seconds


def picture(sizes: list[int], seconds: list[float], exponent: float) -> Figure:
    """Time over size, with the power law."""
    figure = Figure(figsize=(4.6, 3.4), layout="constrained")
    panel = figure.add_subplot()
    times = [1e3 * value for value in seconds]
    panel.loglog(sizes, times, "o-", color=COLOURS[0], markersize=5, label="gantline")
    middle = len(sizes) // 2
    law = [times[middle] * (n / sizes[middle]) ** exponent for n in sizes]
    panel.loglog(sizes, law, color=QUIET, linewidth=0.9, linestyle="--", label=f"n$^{{{exponent:.2f}}}$")
    panel.grid(True, axis="both")
    panel.set_xlabel("moving sheaves n")
    panel.set_ylabel("wall time of 30 s of lift [ms]")
    panel.set_title(f"E(n) at {100 * TARGET:g} % rms error", loc="left", fontweight="bold")
    panel.legend()
    return figure


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--largest", type=int, default=SIZES[-1], help="most sheaves")
    parser.add_argument("--output", type=Path, default=OUTPUT, help="where table and picture go")
    arguments = parser.parse_args()
    measured = [(n, measure(n)) for n in SIZES if n <= arguments.largest]
    known = [(n, seconds) for n, seconds in measured if seconds is not None]
    sizes, seconds = [n for n, _ in known], [value for _, value in known]
    exponent = growth(sizes, seconds)
    verdict = f"Exponent {exponent:.2f} (bound {BOUND})"
    table = Table("n", "time [ms]", "time per sheave [ms]", title=f"E(n) at {100 * TARGET:g} %. {verdict}")
    page = [
        "# Growth",
        "",
        "Written by `python -m benchmarks.growth`: wall time of gantline for 30 s of E(n) at an rms tension "
        f"error of {100 * TARGET:g} %, sampled ten times a second, one thread.",
        "",
        f"{verdict}: time grows like n to that power from {sizes[0]} to {sizes[-1]} sheaves.",
        "",
        "| n | time [ms] | time per sheave [ms] |",
        "|---:|---:|---:|",
    ]
    for n, value in known:
        cells = [str(n), f"{1e3 * value:.3g}", f"{1e3 * value / n:.3g}"]
        table.add_row(*cells)
        page.append("| " + " | ".join(cells) + " |")
    page += ["", "![Wall time over the number of sheaves](growth.png)", ""]
    Console().print(table)
    arguments.output.mkdir(parents=True, exist_ok=True)
    (arguments.output / "growth.md").write_text("\n".join(page), encoding="utf-8")
    with rc_context(RC):
        picture(sizes, seconds, exponent).savefig(arguments.output / "growth.png")


if __name__ == "__main__":
    main()
