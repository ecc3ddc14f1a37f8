"""Ropes with nodes whose end moves, by gantline and by MoorDyn: how they differ, and what they take.

    python -m benchmarks.lines [--write]

Times are those of 30 s without coming to rest, of gantline with reading its lift file: with the longest step
of MoorDyn, the largest tolerance of gantline, at which the tensions of both ends have an rms error of 0.1 %
of their largest against the code's own finest. `--write` keeps MoorDyn's tensions for the tests.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from functools import partial
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from benchmarks.contract import FloatArray
from benchmarks.heaved_lines import LINES, SAMPLE_INTERVAL, HeavedLine, tensions
from benchmarks.peers.moordyn import MoorDyn

KEPT = Path(__file__).resolve().parents[1] / "tests" / "validation" / "lines_in_moordyn.csv"
STEPS = (1e-3, 5e-4, 2e-4, 1e-4, 5e-5)
"""Of MoorDyn, the last the finest [s]."""
TOLERANCES = (1e4, 3e3, 1e3, 3e2, 1e2, 30.0, 10.0, 1.0)
"""Of gantline, the last the finest [N]."""
TARGET = 1e-3


def rms(found: FloatArray, reference: FloatArray) -> float:
    """Of both ends, over the largest tension; the start is left out, where MoorDyn has not computed any."""
    return float(np.sqrt(np.mean((found - reference)[1:] ** 2)) / reference.max())


def timed(run: Callable[[], FloatArray]) -> tuple[float, FloatArray]:
    """How long it took [s], and tensions."""
    start = time.perf_counter()
    found = run()
    return time.perf_counter() - start, found


def by_moordyn(rested: MoorDyn, step: float) -> tuple[float, FloatArray] | None:
    """Time [s] and tensions; None where the step is not stable."""
    try:
        return timed(lambda: rested.run(step))
    except RuntimeError:
        return None


def by_gantline(line: HeavedLine, tolerance: float) -> tuple[float, FloatArray]:
    """Time [s] and tensions."""
    return timed(lambda: tensions(line, tolerance))


def cheapest(
    settings: tuple[float, ...], run: Callable[[float], tuple[float, FloatArray] | None], finest: FloatArray
) -> tuple[float, float] | None:
    """The first setting whose error is within the target, and its time [s]."""
    for setting in settings:
        found = run(setting)
        if found is not None and rms(found[1], finest) <= TARGET:
            return setting, found[0]
    return None


def write(kept: dict[str, FloatArray]) -> None:
    """Tensions of all lines by time, for the tests [kN]."""
    names = [f"{name}: {end}" for name in kept for end in ("first", "last")]
    columns = np.hstack([tension / 1e3 for tension in kept.values()])
    times = np.arange(len(columns)) * SAMPLE_INTERVAL
    lines = [
        f"# Tensions of the first and the last segment [kN]: MoorDyn {metadata.version('moordyn')}, RK4,",
        f"# steps of {STEPS[-1]} s; written by python -m benchmarks.lines --write",
        ",".join(["time [s]", *names]),
    ]
    for moment, row in zip(times[1:], columns[1:], strict=True):
        lines.append(",".join([f"{moment:.2f}", *(f"{value:.2f}" for value in row)]))
    KEPT.write_text("\n".join(lines) + "\n", encoding="utf-8")


def main(arguments: list[str]) -> None:
    if find_spec("moordyn") is None:
        print("benchmarks.lines: MoorDyn is not installed; requirements/bench.txt has it")
        return
    peak = "largest tension [kN]: MoorDyn, gantline"
    table = Table("line", "differ, rms", peak, "MoorDyn at 0.1 %", "gantline at 0.1 %", "ratio")
    kept = {}
    for line in LINES:
        rested = MoorDyn(line)
        reference = by_moordyn(rested, STEPS[-1])
        assert reference is not None, f"MoorDyn is not stable at {STEPS[-1]} s"
        kept[line.name] = reference[1]
        own = tensions(line, TOLERANCES[-1])
        peaks = f"{reference[1].max() / 1e3:.2f}, {own.max() / 1e3:.2f}"
        slow = cheapest(STEPS[:-1], partial(by_moordyn, rested), reference[1])
        fast = cheapest(TOLERANCES[:-1], partial(by_gantline, line), own)
        table.add_row(
            line.name,
            f"{100 * rms(own, reference[1]):.3f} %",
            peaks,
            f"{slow[1]:.2f} s, steps of {1e3 * slow[0]:.2g} ms" if slow else "–",
            f"{fast[1]:.2f} s, {fast[0]:.0f} N" if fast else "–",
            f"{slow[1] / fast[1]:.1f}" if slow and fast else "–",
        )
    Console(width=160).print(table)
    if "--write" in arguments:
        write(kept)


if __name__ == "__main__":
    main(sys.argv[1:])
