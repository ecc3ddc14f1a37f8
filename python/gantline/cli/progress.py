"""Progress of runs and searches: a bar on a terminal, plain lines elsewhere, both on the error stream."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Protocol

import typer

from gantline.units import format_quantity

Report = Callable[[float], None]
_LINES = 10
_LONGEST_SILENCE = 30.0  # s


_SILENCE_OF_SEARCHES = 10.0  # s


class Run(Protocol):
    """What progress asks of a simulation under way."""

    @property
    def duration(self) -> float:
        """Simulated time at the end [s]."""

    @property
    def current_step(self) -> str | None:
        """Name of the step of the plan that is under way."""

    @property
    def largest_sling_tension(self) -> tuple[str, float] | None:
        """The sling that carries most now, and what it carries [N]."""


@contextmanager
def progress(run: Run) -> Iterator[Report]:
    """Show how far a run is.

    Yields:
        A function to call with the simulated time [s].
    """
    if sys.stderr.isatty():
        with _bar(run) as report:
            yield report
    else:
        yield _lines(run)


@contextmanager
def _bar(run: Run) -> Iterator[Report]:
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (
        TextColumn("simulating"),
        BarColumn(),
        TextColumn("{task.completed:.1f} of {task.total:.1f} s"),
        TextColumn("{task.fields[speed]}"),
        TimeRemainingColumn(),
        TextColumn("left"),
        TextColumn("{task.fields[state]}", style="cyan", markup=False),
    )
    started = time.perf_counter()
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=run.duration, speed="", state="")

        def report(now: float) -> None:
            passed = time.perf_counter() - started
            bar.update(task, completed=now, speed=speed(now, passed), state=", ".join(_state(run)))

        yield report


@contextmanager
def telling(what: str) -> Iterator[Callable[[str], None]]:
    """Show what a search is at that may take long: on a terminal always, elsewhere every ten seconds.

    Yields:
        A function to call with that, in words.
    """
    if sys.stderr.isatty():
        from rich.console import Console
        from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

        columns = (SpinnerColumn(), TextColumn("{task.description}", markup=False), TimeElapsedColumn())
        with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
            task = bar.add_task(what)
            yield lambda text: bar.update(task, description=f"{what}, {text}")
        return
    started, is_over = time.perf_counter(), threading.Event()
    doing = ""

    def tell(text: str) -> None:
        nonlocal doing
        doing = text

    def lines() -> None:
        while not is_over.wait(_SILENCE_OF_SEARCHES):
            passed = time.perf_counter() - started
            typer.echo(", ".join(filter(None, (what, doing, f"{passed:.0f} s so far"))), err=True)

    # A single equilibrium may take long, and nothing is told meanwhile.
    watch = threading.Thread(target=lines, daemon=True)
    watch.start()
    try:
        yield tell
    finally:
        is_over.set()
        watch.join()


def _lines(run: Run) -> Report:
    duration = run.duration
    started = last = time.perf_counter()
    shown = 0

    def report(now: float) -> None:
        nonlocal shown, last
        clock = time.perf_counter()
        if now * _LINES < (shown + 1) * duration and clock - last < _LONGEST_SILENCE:
            return
        shown, last = int(now * _LINES / duration), clock
        passed = clock - started
        left = passed * (duration - now) / now
        parts = (speed(now, passed), f"{left:.0f} s left", *_state(run))
        typer.echo(", ".join((f"simulated {now:.1f} of {duration:.1f} s", *filter(None, parts))), err=True)

    return report


def speed(simulated: float, passed: float) -> str:
    """How fast a run goes, to three digits and written out: 3.74e+03 times is no number for people."""
    if passed <= 0.0:
        return ""
    return f"{float(f'{simulated / passed:.3g}'):,.15g} times real time"


def _state(run: Run) -> Iterator[str]:
    """The step under way, and the sling that carries most."""
    if run.current_step:
        yield f"step '{run.current_step}'"
    largest = run.largest_sling_tension
    if largest is not None:
        name, tension = largest
        yield f"most in sling {name}: {format_quantity(tension, 'kN', 0)}"
