"""`gantline compare`: two variants of a lift side by side, simulated or from recordings."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gantline.cli.lift import (
    Setting,
    TypedSetting,
    folder_option,
    lifts_that_begin,
    name_of,
    new_folder,
    opened,
    prepare,
    quantity_of,
    recording_file,
    refuse_to_replace,
    warn_of_gaps,
)
from gantline.cli.messages import COULD_NOT_GO_ON, DONE, INTERRUPTED, complain, stop, warn, writing
from gantline.cli.progress import progress
from gantline.replacing import remove_file, replace_bytes, replace_text

if TYPE_CHECKING:
    from gantline.results.comparison import Comparison
    from gantline.results.recording import Recording
    from gantline.simulation import Simulation

#: How the value of each setting is written: a dimension, a choice of words, or plain text.
_SETTINGS: dict[str, str] = {
    "integrator": "text",
    "step": "time",
    "tension_tolerance": "force",
    "position_tolerance": "length",
    "sample_interval": "time",
    "duration": "time",
    "paper": "switch",
    "geometric_stiffness": "switch",
    "adjusting_factor": "ratio",
    "equalizers": "text",
}
#: Files that are written, but for pictures.
_WRITTEN = ("a.nc", "b.nc", "a.state.bin", "b.state.bin", "comparison.json", "comparison.txt")
_SWITCH = {"true": True, "false": False}

_LIFT_HELP = (
    "Lift file, its folder, the name of a lift that comes with gantline; or a recording (.nc), or a folder "
    "that `gantline run` wrote"
)
_Changes = list[str] | None


@dataclass
class _Side:
    """A or B: a lift that is ready to run, or what was recorded of one."""

    letter: str
    name: str
    simulation: Simulation | None = None
    recording: Recording | None = None
    integration_time: float | None = None

    @property
    def status(self) -> str:
        return str(self.recording.attributes["status"]) if self.recording else "ready"


def compare(
    first: Annotated[
        Path, typer.Argument(metavar="A", help=f"{_LIFT_HELP}.", autocompletion=lifts_that_begin)
    ],
    second: Annotated[
        Path | None,
        typer.Argument(
            metavar="B",
            show_default=False,
            help="The same.  [default: A once more]",
            autocompletion=lifts_that_begin,
        ),
    ] = None,
    output: Annotated[
        Path | None, folder_option("Folder to write into.  [default: results/compare-<A>-<B>]")
    ] = None,
    changes_a: Annotated[
        _Changes, typer.Option("--a", metavar="KEY=VALUE", help="Setting of A, such as integrator=del.")
    ] = None,
    changes_b: Annotated[
        _Changes, typer.Option("--b", metavar="KEY=VALUE", help="Setting of B, such as 'step=1 ms'.")
    ] = None,
    changes_both: Annotated[
        _Changes, typer.Option("--both", metavar="KEY=VALUE", help="Setting of A and B.")
    ] = None,
    plots: Annotated[bool, typer.Option("--plots/--no-plots", help="Draw pictures.")] = True,
) -> None:
    """Compare two variants of a lift: tension, motion, steps and stability side by side.

    Settings: integrator, step, tension_tolerance, position_tolerance, sample_interval, duration, paper and
    geometric_stiffness (true or false), adjusting_factor, and equalizers=locked, the lift without moving
    sheaves. Each of --a, --b and --both may be given several times.

    Ends with code 3 if one of the two could not go on; verdicts do not change it. Ctrl-C stops, saves what
    there is and ends with code 130.
    """
    if second is None and not (changes_a or changes_b):
        stop("nothing to compare: name a second lift, or change a setting of one side with --a or --b")
    both = _settings("--both", changes_both)
    sides = [
        _side(letter, lift, both, _settings(f"--{letter.lower()}", changes))
        for letter, lift, changes in (("A", first, changes_a), ("B", second or first, changes_b))
    ]
    names = dict.fromkeys(name_of(lift) for lift in (first, second or first))
    place = output if output is not None else Path("results") / "-".join(["compare", *names])
    read = [recording_file(lift) or lift for lift in (first, second or first)]
    refuse_to_replace(read, (place / name for name in _WRITTEN), "--output needs another folder")
    with new_folder(place) as folder:
        for side in sides:
            _simulate(side, folder)
            if _was_stopped(side) and sides[1].status == "ready":
                warn(f"stopped before B was simulated; what there is of A: {folder / 'a.nc'}")
                raise typer.Exit(INTERRUPTED)
        try:
            comparison = _compare(sides, folder)
            if plots:
                _draw(comparison, folder)
        except KeyboardInterrupt:
            there = f"{folder / 'a.nc'}, {folder / 'b.nc'}"
            warn(f"interrupted before all was compared; the recordings are {there}")
            raise typer.Exit(INTERRUPTED) from None
    _end(sides)


def _settings(option: str, changes: _Changes) -> dict[str, TypedSetting]:
    """Settings as written after an option."""
    settings: dict[str, TypedSetting] = {}
    for change in changes or ():
        key, equals, text = (word.strip() for word in change.partition("="))
        key = key.replace("-", "_")
        if not equals or not text:
            stop(f"{option}: '{change}' is no setting; one is written like 'step=1 ms'")
        if key not in _SETTINGS:
            elsewhere = "; another value of a lift file stands in a second one" if "." in key else ""
            stop(f"{option}: there is no setting '{key}'; there are {', '.join(_SETTINGS)}{elsewhere}")
        if key in settings:
            stop(f"{option}: {key} is given twice")
        named = f"{option} {key}"
        settings[key] = TypedSetting(named, text, _value(named, text, _SETTINGS[key]))
    return settings


def _value(option: str, text: str, kind: str) -> Setting:
    if kind == "text":
        return text
    if kind != "switch":
        return quantity_of(option, text, kind)
    if text not in _SWITCH:
        stop(f"{option}: '{text}' is neither true nor false")
    return _SWITCH[text]


def _side(
    letter: str,
    lift: Path,
    both: dict[str, TypedSetting],
    own: dict[str, TypedSetting],
) -> _Side:
    """A lift made ready to run, or a recording read; what is wrong with either ends the program."""
    shown = ", ".join(f"{key}={setting.text}" for key, setting in own.items())
    side = _Side(letter, f"{lift}, {shown}" if shown else str(lift))
    file = recording_file(lift)
    if file is None:
        # Of a setting of both the option does not say which of them it does not fit.
        of_both = {key: replace(one, option=f"{letter}: {one.option}") for key, one in both.items()}
        side.simulation = prepare(lift, of_both | own)
        return side
    if both or own:
        stop(f"{letter}: {file} is a recording; the settings of a run that is over cannot be changed")
    side.recording = opened(file)
    return side


def _simulate(side: _Side, folder: Path) -> None:
    """Run a side that is no recording yet; save its recording, and the last good state if it failed."""
    state = folder / f"{side.letter.lower()}.state.bin"
    with writing(state):
        remove_file(state)  # of an earlier comparison
    if side.simulation is not None:
        from gantline.simulation import SimulationError

        typer.echo(f"simulating {side.letter}: {side.name}", err=True)
        simulation = side.simulation
        try:
            with progress(simulation) as report:
                side.recording = simulation.run(on_progress=report)
        except SimulationError as problem:
            side.recording = problem.recording
            with writing(state):
                replace_bytes(state, problem.state)
            complain(f"{side.letter}: {problem}\n  last good state: {state}")
        side.integration_time = simulation.integration_time
    assert side.recording is not None
    file = folder / f"{side.letter.lower()}.nc"
    with writing(file):
        if side.letter == "A":
            _remove_earlier(folder)
        side.recording.save(file)


def _remove_earlier(folder: Path) -> None:
    """Remove what an earlier comparison left, but for what is of A: it would pass for that of the new one.

    Raises:
        OSError: If there is something that cannot be removed.
    """
    for name in _WRITTEN:
        if not name.startswith("a."):
            remove_file(folder / name)
    if any(folder.glob("*.png")):
        from gantline.plot.pictures import comparison_picture_files

        for name in comparison_picture_files(_loads_before(folder)):
            remove_file(folder / name)


def _loads_before(folder: Path) -> list[str]:
    """Loads of the recording of A that is there; none of one that cannot be read."""
    from gantline.results.file.netcdf import load_rig

    try:
        return [load.name for load in load_rig(folder / "a.nc").loads]
    except (FileNotFoundError, ValueError):
        return []


def _compare(sides: list[_Side], folder: Path) -> Comparison:
    """Compare the recordings, print the table, and write it with all numbers."""
    from gantline.checks import check_recording, verdict_of
    from gantline.cli.comparison_table import comparison_table
    from gantline.results.comparison import compare as compare_recordings

    a, b = (side.recording for side in sides)
    assert a is not None and b is not None
    comparison = compare_recordings(a, b, names=(sides[0].name, sides[1].name))
    checks = (check_recording(a), check_recording(b))
    # Plain mechanics, of which nothing is checked, has no verdict.
    of_a, of_b = (verdict_of(one) if one else "" for one in checks)
    times = (sides[0].integration_time, sides[1].integration_time)
    lines = comparison_table(comparison, times, (of_a, of_b))
    text = "\n".join(lines)
    with writing(folder):
        document = {**comparison.to_json(), "verdicts": [of_a or None, of_b or None]}
        numbers = json.dumps(document, indent=2, allow_nan=False)
        replace_text(folder / "comparison.json", f"{numbers}\n")
        replace_text(folder / "comparison.txt", f"{text}\n")
    typer.echo(text)
    for side in (a, b):
        warn_of_gaps(side, "A: " if side is a else "B: ")
    names = ("a.nc", "b.nc", "comparison.json", "comparison.txt")
    for index, name in enumerate(names):
        typer.echo(f"{'Written' if index == 0 else '':<12}{folder / name}")
    return comparison


def _draw(comparison: Comparison, folder: Path) -> None:
    from gantline.plot import save_comparison_pictures

    with writing(folder):
        paths = save_comparison_pictures(comparison, folder)
    for index, path in enumerate(paths):
        typer.echo(f"{'Pictures' if index == 0 else '':<12}{path}")


def _end(sides: list[_Side]) -> None:
    """End with the code that says how the runs of this call went, not those of old recordings."""
    if any(_was_stopped(side) for side in sides):
        warn("stopped by Ctrl-C; what there is was compared")
        raise typer.Exit(INTERRUPTED)
    failed = any(side.status == "failed" for side in sides if side.simulation is not None)
    raise typer.Exit(COULD_NOT_GO_ON if failed else DONE)


def _was_stopped(side: _Side) -> bool:
    return side.status == "stopped" and side.simulation is not None
