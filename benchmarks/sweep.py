"""How the settings of the race were found: all that a code offers, over its steps or tolerances.

    python -m benchmarks.sweep CODE N [--duration SECONDS]

Prints time and errors of all candidates, the cheapest first. The ladders in `benchmarks/peers` are the
methods that lead here.
"""

from __future__ import annotations

import argparse

from rich.console import Console
from rich.table import Table

from benchmarks.contract import sample_count
from benchmarks.gantline_code import reference
from benchmarks.lifts import equalizer_lift
from benchmarks.measure import errors
from benchmarks.worker import CODES, Worker


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    names = [code.name for code in CODES]
    parser.add_argument("code", choices=names, metavar="CODE", help="as the race names it")
    parser.add_argument("n", type=int, help="moving sheaves")
    parser.add_argument("--duration", type=float, default=30.0, help="simulated time [s]")
    arguments = parser.parse_args()
    lift = equalizer_lift(arguments.n)
    worker = Worker(next(code for code in CODES if code.name == arguments.code))
    whole = reference(lift)
    repeats = 3 if lift.sheaves <= 20 else 1
    found, failed = [], []
    for setting in worker.code.candidates(lift):
        outcomes = [worker.run(lift, setting, arguments.duration) for _ in range(repeats)]
        tension = outcomes[0].tension
        if tension is None:
            failed.append((setting, outcomes[0].failure))
            continue
        error = errors(tension, whole[: sample_count(arguments.duration)], float(whole[-1].mean()))
        found.append((min(outcome.seconds for outcome in outcomes), setting, error))
    worker.stop()
    table = Table("setting", "ms/s", "rms", "peak", "final", title=f"{worker.code.name} on {lift.name}")
    for seconds, setting, error in sorted(found, key=lambda row: row[0]):
        time = f"{1e3 * seconds / arguments.duration:.3g}"
        table.add_row(str(setting), time, f"{error.rms:.1e}", f"{error.peak:.1e}", f"{error.final:.1e}")
    console = Console()
    console.print(table, markup=False)
    for setting, failure in failed:
        console.print(f"{setting}: {failure}", markup=False)


if __name__ == "__main__":
    main()
