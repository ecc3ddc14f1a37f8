"""How long the equilibria of the benchmark lifts take, from their start, and how that grows with the sheaves.

    python -m benchmarks.statics [--largest N]

Each E(n) is let go from just-taut slings, as in the race. Beside its time stands that of simulating the same
lift until it has settled, 30 s, with gantline's own method at its default tolerance. The time is the least of
many; building the system, once for a lift, is not counted. The reference lift is found from a thousand places
up to 20 m off.

Then the other codes find the rest of E(5) from the same start, each by its best way
(`benchmarks/peers/at_rest.py`), until no sling is further from it than 1e-6 of their mean: those that
simulate how the lift settles, and those that search for where, by a static solver or by steps too long to
follow it. Codes that are not installed are left out.
"""

from __future__ import annotations

import argparse
import json
import math
import time
from collections.abc import Callable

import numpy as np
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from benchmarks.lifts import Lift, equalizer_lift, gantline_document
from benchmarks.measure import growth
from benchmarks.peers.at_rest import AT_REST
from benchmarks.worker import Worker
from gantline import Statics, _core

SIZES = (5, 10, 20, 50, 100, 200, 400, 700, 1000)
REPEATS = 50
SETTLING = 3
"""Simulations of each lift."""
FIRST = 20
"""Fewest sheaves that the exponent counts: below, the call itself is half of the time."""
BOUND = 1.2
"""The exponent is to stay below."""
STARTS, SEED = 1000, 20160101
MEDIAN, LONGEST = 1, 20
"""What a start may take [ms]."""
OTHERS = 5
"""Sheaves of the lift whose rest the other codes find."""
RIGHT = 1e-6
"""Largest error of a sling's tension, relative to the mean, at which a code has found it."""
RUNS = REPEATS
"""Of another code at one setting."""
TIMES = 100
"""As fast as the fastest that settles is what an equilibrium is to be."""


def least(repeats: int, run: Callable[[], object]) -> float:
    """Least wall time of several runs [s]."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    return min(times)


def starts(console: Console) -> None:
    """The reference lift from all over: hook, frame, five sheaves and load moved and turned at random."""
    lift = Statics("equalizer")
    end = lift.scenario.duration
    draw, core = np.random.default_rng(SEED), _core.Statics(lift.assembly.document_text())
    reach = np.array([0.0, math.pi, *[1.2] * 5, *[20.0] * 3, 0.8, 0.8, math.pi])
    seconds, tensions = [], []
    for _ in range(STARTS):
        increment = draw.uniform(-reach, reach).tolist()
        start = time.perf_counter()
        core.settle(end, increment)
        seconds.append(time.perf_counter() - start)
        tensions.append(core.columns()["rope_tension"][-1])
    apart = np.ptp(tensions, axis=0).max() / np.mean(tensions)
    console.print(
        f"{STARTS} starts of the reference lift: median {1e3 * np.median(seconds):.2f} ms (bound {MEDIAN}), "
        f"longest {1e3 * max(seconds):.1f} ms (bound {LONGEST}), tensions {apart:.0e} apart"
    )


def settling(lift: Lift) -> float:
    """Wall time of simulating a lift until it has settled [s]."""
    settings = json.dumps(
        {"integrator": {"type": "adaptive"}, "duration": lift.duration, "sample_interval": lift.duration}
    )
    document = gantline_document(lift)
    runs = [_core.Simulation(document, settings) for _ in range(SETTLING)]
    return least(SETTLING, lambda: runs.pop().run())


def others(console: Console, seconds: float) -> None:
    """Other codes beside an equilibrium that took so long [s]."""
    lift = equalizer_lift(OTHERS)
    core = _core.Statics(gantline_document(lift))
    core.settle()
    place = [core.names()["rope"].index(f"sling{i}") for i in range(lift.sheaves)]
    exact = core.columns()["rope_tension"][-1][place]
    head = ("code", "", "setting", "error", "time [ms]", "ratio")
    table = Table(*head, title=f"{lift.name} at rest to {RIGHT:g}")
    fastest: dict[bool, tuple[float, str]] = {}
    for code in AT_REST:
        worker = Worker(code)
        try:
            version = worker.version()
            if version is None:
                continue
            best = None
            for setting in code.settings(lift):
                outcomes = [worker.run(lift, setting, 0.0) for _ in range(RUNS)]
                taken = min(outcome.seconds for outcome in outcomes)
                tension = outcomes[-1].tension
                if tension is None:
                    continue
                error = float(np.abs(tension[-1] - exact).max() / exact.mean())
                if error <= RIGHT and (best is None or taken < best[0]):
                    best = (taken, error, setting)
            name = f"{code.name} {version}"
            how = "settles" if code.settles else "searches"
            if best is None:
                table.add_row(name, how, "none is right", "", "", "")
                continue
            fastest[code.settles] = min((best[0], name), fastest.get(code.settles, (math.inf, "")))
            row = (escape(str(best[2])), f"{best[1]:.0e}", f"{1e3 * best[0]:.2f}", f"{best[0] / seconds:.0f}")
            table.add_row(name, how, *row)
        finally:
            worker.stop()
    if not fastest:
        console.print("No other code is installed.")
        return
    console.print(table)
    for settles, how in ((True, "settles"), (False, "searches for the rest")):
        if settles not in fastest:
            continue
        taken, name = fastest[settles]
        ratio = taken / seconds
        aim = f" (aim {TIMES}: {'reached' if ratio >= TIMES else 'not reached'})" if settles else ""
        console.print(f"The fastest that {how}, {name}, takes {ratio:.0f} times as long{aim}.")


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
    starts(console)
    if OTHERS in sizes:
        others(console, seconds[sizes.index(OTHERS)])


if __name__ == "__main__":
    main()
