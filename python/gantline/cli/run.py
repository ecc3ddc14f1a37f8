"""`gantline run`: simulate a lift, write its recording, pictures and report, print its table."""

from __future__ import annotations

import shlex
import time
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from gantline.cli.lift import (
    RECORDING,
    Lift,
    TypedSetting,
    folder_option,
    name_of,
    new_folder,
    prepare,
    quantity_of,
)
from gantline.cli.live import live_view
from gantline.cli.messages import COULD_NOT_GO_ON, DONE, INTERRUPTED, stop, warn, writing
from gantline.cli.progress import progress, speed
from gantline.cli.refinement import with_refinement
from gantline.cli.report import REPORT, write_beside
from gantline.cli.run_folder import STATE, save_run
from gantline.interrupt import noted_interrupt
from gantline.replacing import replace_bytes

if TYPE_CHECKING:
    from collections.abc import Sequence

    from gantline.checks import Check
    from gantline.results.recording import Recording
    from gantline.simulation import Simulation, SimulationError
    from gantline.viewer.live import LiveView


def run(
    lift: Lift,
    output: Annotated[
        Path | None, folder_option("Folder to write into.  [default: results/<name of the lift>]")
    ] = None,
    integrator: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="Method: adaptive, del or explicit.  [default: that of the lift file]",
        ),
    ] = None,
    step: Annotated[
        str | None,
        typer.Option(
            metavar="TIME",
            help="Step of del or explicit, such as '1 ms'.  [default: that of the lift file]",
        ),
    ] = None,
    tension_tolerance: Annotated[
        str | None,
        typer.Option(
            metavar="FORCE",
            help="Error of tensions in a step of adaptive, such as '50 N'.  [default: that of the lift file, "
            "else a ten-thousandth of the mean load of a rope]",
        ),
    ] = None,
    position_tolerance: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help="Error of positions in a step of adaptive, such as '0.01 mm'.  [default: that of the lift "
            "file, else 0.1 mm]",
        ),
    ] = None,
    sample_interval: Annotated[
        str | None,
        typer.Option(
            metavar="TIME",
            help="Time between samples, such as '20 ms'.  [default: that of the lift file]",
        ),
    ] = None,
    duration: Annotated[
        str | None,
        typer.Option(
            metavar="TIME", help="Time to simulate, such as '40 s'.  [default: that of the lift file]"
        ),
    ] = None,
    plots: Annotated[bool, typer.Option("--plots/--no-plots", help="Draw pictures.")] = True,
    report: Annotated[
        bool, typer.Option("--report/--no-report", help="Write a report that any browser opens.")
    ] = True,
    live: Annotated[
        bool, typer.Option("--live", help="Show the lift in the browser of this machine while it runs.")
    ] = False,
    browser: Annotated[
        bool, typer.Option("--browser/--no-browser", help="With --live: open a browser.")
    ] = True,
    refine: Annotated[
        bool,
        typer.Option(
            "--refine", help="Simulate it again by a finer method, and say how far figures of checks move."
        ),
    ] = False,
    profile: Annotated[bool, typer.Option("--profile", help="Show where the time went.")] = False,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print the checks as JSON, and nothing else to standard output.")
    ] = False,
) -> None:
    """Simulate a lift; write its recording, pictures and report into a folder and print its table.

    Ends with code 1 if a check failed, with 3 if the simulation could not go on, of which it writes all up to
    then, and with 4 if the checks give no verdict. Ctrl-C stops the lift, saves what there is and ends with
    code 130.
    """
    clock = _Clock()
    settings = {
        "integrator": _typed("--integrator", integrator),
        "step": _typed("--step", step, "time"),
        "tension_tolerance": _typed("--tension-tolerance", tension_tolerance, "force"),
        "position_tolerance": _typed("--position-tolerance", position_tolerance, "length"),
        "sample_interval": _typed("--sample-interval", sample_interval, "time"),
        "duration": _typed("--duration", duration, "time"),
    }
    simulation = prepare(lift, {name: given for name, given in settings.items() if given is not None})
    if profile:
        simulation.measure()
    place = output if output is not None else Path("results") / name_of(lift)
    with (
        new_folder(place) as folder,
        live_view(simulation, browser=browser, aside=as_json) if live else nullcontext() as view,
    ):
        clock.lap("prepare")
        with noted_interrupt() as is_interrupted:
            recording, problem = _simulate(simulation, view)
            clock.lap("simulate")
            written = save_run(recording, folder)
            if problem is not None:
                _save_state(problem, folder)
            clock.lap("save")
            if refine and recording.attributes["status"] == "done":
                recording = with_refinement(simulation, recording)
                written = save_run(recording, folder)
                clock.lap("simulate finer")
        if is_interrupted():
            warn(f"interrupted after the last step; the recording is {written}")
            raise typer.Exit(INTERRUPTED)
        try:
            code = _told(recording, simulation, as_json=as_json)
        except KeyboardInterrupt:
            again = f"'gantline check {shlex.quote(str(folder))}' prints the checks"
            warn(f"interrupted before all was checked; the recording is {written}, {again}")
            raise typer.Exit(INTERRUPTED) from None
        clock.lap("table")
        typer.echo(f"Recording   {written}", err=as_json)
        try:
            if plots:
                _draw(recording, folder, aside=as_json)
                clock.lap("pictures")
            if report:
                write_beside(recording, folder / REPORT, aside=as_json)
                clock.lap("report")
        except KeyboardInterrupt:
            again = f"; 'gantline report {shlex.quote(str(folder))}' writes the report" if report else ""
            warn(f"interrupted before all was drawn{again}")
            raise typer.Exit(INTERRUPTED) from None
        if profile:
            _print_profile(clock, simulation.stages(), recording, aside=as_json)
    if problem is not None:
        _end_with(problem, folder)
    if recording.attributes["status"] == "stopped":
        warn(f"stopped at {recording.time[-1]:.2f} s of {simulation.duration:g} s")
        raise typer.Exit(INTERRUPTED)
    raise typer.Exit(code)


class _Clock:
    """Wall time by stage [s]."""

    def __init__(self) -> None:
        self.laps: list[tuple[str, float]] = []
        self._last = time.perf_counter()

    def lap(self, stage: str) -> None:
        now = time.perf_counter()
        self.laps.append((stage, now - self._last))
        self._last = now


def _typed(option: str, text: str | None, dimension: str | None = None) -> TypedSetting | None:
    """What stands behind an option: a quantity, or a word; None where it was left out."""
    if text is None:
        return None
    return TypedSetting(option, text, text if dimension is None else quantity_of(option, text, dimension))


def _simulate(simulation: Simulation, view: LiveView | None) -> tuple[Recording, SimulationError | None]:
    """What was recorded, and why the simulation could not go on if it could not."""
    from gantline.simulation import SimulationError

    try:
        with progress(simulation) as report:

            def tell(now: float) -> None:
                report(now)
                if view is not None:
                    view.offer()

            recording, failure = simulation.run(on_progress=tell), None
    except SimulationError as problem:
        recording, failure = problem.recording, problem
    if view is not None:
        view.finish(recording, str(recording.attributes["status"]))
    return recording, failure


def _save_state(problem: SimulationError, folder: Path) -> None:
    """Save the last good state of a run that could not go on."""
    state = folder / STATE
    with writing(state):
        replace_bytes(state, problem.state)


def _end_with(problem: SimulationError, folder: Path) -> NoReturn:
    """Say why a run could not go on, below all that is known up to then, and end the program."""
    end = f"{problem.recording.time[-1]:.2f} s" if len(problem.recording.time) else "its start"
    warn(f"all of this ends at {end}: what would have come after is not checked")
    there = f"  recording up to then: {folder / RECORDING}\n  last good state: {folder / STATE}"
    stop(f"{problem}\n{there}", COULD_NOT_GO_ON)


def _told(recording: Recording, simulation: Simulation, *, as_json: bool) -> int:
    """Print table or JSON, if there are samples; the answer is the code that tells of the verdict."""
    if not len(recording.time):
        return DONE
    return _print_json(recording) if as_json else _print_table(recording, simulation)


def _print_table(recording: Recording, simulation: Simulation) -> int:
    """Print the final table; the answer is the code that tells of its verdict."""
    from gantline.checks import check_recording
    from gantline.cli.check_table import styled, width_of_terminal
    from gantline.cli.summary import summary

    checks = check_recording(recording)
    typer.echo("\n".join(summary(recording, checks, styled, width_of_terminal())))
    simulated = float(recording.time[-1])
    passed = simulation.integration_time
    typer.echo(
        ", ".join(filter(None, (f"Integration {simulated:g} s in {passed:.2f} s", speed(simulated, passed))))
    )
    return _code(checks)


def _print_json(recording: Recording) -> int:
    """Print the checks as JSON; the answer is the code that tells of their verdict."""
    from gantline.checks import check_recording
    from gantline.cli.check_table import checks_json

    checks = check_recording(recording)
    typer.echo(checks_json(recording, checks))
    return _code(checks)


def _code(checks: Sequence[Check]) -> int:
    """The code that tells of a verdict; what has nothing to check, such as a mechanism, is done."""
    from gantline.cli.check_table import exit_code

    return exit_code(checks) if checks else DONE


def _draw(recording: Recording, folder: Path, *, aside: bool) -> None:
    from gantline.plot import save_pictures

    with writing(folder):
        paths = save_pictures(recording, folder)
    for index, path in enumerate(paths):
        typer.echo(f"{'Pictures' if index == 0 else '':<12}{path}", err=aside)


def _print_profile(clock: _Clock, stages: dict[str, float], recording: Recording, *, aside: bool) -> None:
    from gantline.results.counted import counted_in_words

    lines = ["", "Where the time went"]
    lines += [f"  {lap:<22}{1e3 * passed:12.2f} ms" for lap, passed in clock.laps]
    integration = {name: passed for name, passed in stages.items() if name != "recording"}
    whole = sum(integration.values())
    lines.append(f"Integrator{'':<14}{1e3 * whole:12.2f} ms")
    for name, passed in sorted(integration.items(), key=lambda item: -item[1]):
        lines.append(f"  {name:<22}{1e3 * passed:12.2f} ms  {passed / max(whole, 1e-12):4.0%}")
    lines.append(f"Recording{'':<15}{1e3 * stages.get('recording', 0.0):12.2f} ms")
    lines.append("Counted")
    counted = counted_in_words(recording.attributes["counters"])
    width = max(len(name) for name, _ in counted)
    lines += [f"  {name:<{width}}{count:12,}" for name, count in counted]
    typer.echo("\n".join(lines), err=aside)
