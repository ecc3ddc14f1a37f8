"""Progress of a run: a bar on a terminal, plain lines elsewhere, both on the error stream."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import typer

Report = Callable[[float], None]
Step = Callable[[], str | None]
_LINES = 10
_LONGEST_SILENCE = 30.0  # s


@contextmanager
def progress(duration: float, step: Step) -> Iterator[Report]:
    """Show how far a run is.

    Args:
        duration: Simulated time at the end [s].
        step: Tells the name of the step of the plan that is under way.

    Yields:
        A function to call with the simulated time [s].
    """
    if sys.stderr.isatty():
        with _bar(duration, step) as report:
            yield report
    else:
        yield _lines(duration, step)


@contextmanager
def _bar(duration: float, step: Step) -> Iterator[Report]:
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (
        TextColumn("simulating"),
        BarColumn(),
        TextColumn("{task.completed:.1f} of {task.total:.1f} s"),
        TextColumn("{task.fields[speed]}"),
        TimeRemainingColumn(),
        TextColumn("left"),
        TextColumn("{task.fields[step]}", style="cyan", markup=False),
    )
    started = time.perf_counter()
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=duration, speed="", step="")

        def report(now: float) -> None:
            passed = time.perf_counter() - started
            bar.update(task, completed=now, speed=_speed(now, passed), step=step() or "")

        yield report


def _lines(duration: float, step: Step) -> Report:
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
        typer.echo(
            f"simulated {now:.1f} of {duration:.1f} s, {_speed(now, passed)}, {left:.0f} s left"
            f"{_under_way(step())}",
            err=True,
        )

    return report


def _speed(simulated: float, passed: float) -> str:
    return f"{simulated / passed:.3g} times real time" if passed > 0.0 else ""


def _under_way(step: str | None) -> str:
    return f" ({step})" if step else ""
