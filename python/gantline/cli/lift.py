"""What verbs that simulate share: settings of the command line, a lift made ready, a folder to write into."""

from __future__ import annotations

import glob
import os
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, overload

import typer

from gantline.cli.messages import scenario_errors, stop, warn, writing
from gantline.interrupt import tidied

if TYPE_CHECKING:
    from gantline.results.recording import Recording
    from gantline.scenario import Scenario
    from gantline.simulation import Simulation

#: Name of the recording in a folder that `gantline run` wrote.
RECORDING = "recording.nc"

Setting = str | float | bool


def lifts_that_begin(incomplete: str) -> list[str]:
    """What a shell offers where a lift is asked for: lifts that come with gantline, lift files, folders."""
    from gantline.scenario.file.shipped import shipped

    places = sorted(glob.glob(f"{glob.escape(incomplete)}*"))
    files = [f"{place}/" if Path(place).is_dir() else place for place in places]
    names = [name for name in shipped() if name.startswith(incomplete)]
    return names + [file for file in files if file.endswith(("/", ".yaml", ".yml", ".nc"))]


#: The lift that a verb is about.
Lift = Annotated[
    Path,
    typer.Argument(
        metavar="LIFT",
        help="Lift file, its folder, or the name of a lift that comes with gantline.",
        autocompletion=lifts_that_begin,
    ),
]

#: The moment that a question of statics is about, see `moment_of`.
Moment = Annotated[
    str | None,
    typer.Option(
        "--time",
        metavar="TIME",
        help="Time of the plan, such as '12 s'.  [default: the end of the lift]",
    ),
]


def folder_option(help: str) -> Any:
    """`--output DIR` of a verb that writes into a folder, and what it says of it."""
    return typer.Option("--output", "-o", metavar="DIR", help=help)


@overload
def quantity_of(option: str, text: str, dimension: str) -> float: ...


@overload
def quantity_of(option: str, text: str | None, dimension: str) -> float | None: ...


def quantity_of(option: str, text: str | None, dimension: str) -> float | None:
    """SI value of a quantity as it stands behind an option; None if the option was not given."""
    from gantline.units import UnitError, quantity

    if text is None:
        return None
    try:
        return quantity(text, dimension)
    except UnitError as problem:
        stop(f"{option}: {problem}")


def unit_of(text: str | None) -> str | None:
    """A unit of length as it stands behind `--unit`; None if the option was not given."""
    from gantline.units import DIMENSIONS

    if text is not None and text not in DIMENSIONS["length"]:
        stop(f"--unit: '{text}' is no unit of length; there are {', '.join(DIMENSIONS['length'])}")
    return text


def moment_of(time: str | None) -> float | None:
    """Time of the plan that was asked for [s]; None for the end of the lift."""
    moment = quantity_of("--time", time, "time")
    if moment is not None and moment < 0.0:
        stop(f"--time: {time!r} is before the start of the lift; 0 s is the start")
    return moment


def refuse_beyond(scenario: Scenario, moment: float | None) -> None:
    """Ends the program where a time that was asked for [s] is after the end of the lift."""
    if moment is not None and moment > scenario.duration:
        stop(f"--time: {moment:g} s is after the end of the lift at {scenario.duration:g} s")


@dataclass(frozen=True)
class TypedSetting:
    """A setting in place of that of a lift file.

    Attributes:
        option: How it was named: `--step`, `--b step`.
        text: What was typed.
        value: The same, SI.
    """

    option: str
    text: str
    value: Setting


def prepare(lift: Path, settings: Mapping[str, TypedSetting]) -> Simulation:
    """A lift that is ready to run; what is wrong with it, or with a setting as typed, ends the program.

    Args:
        lift: Lift file, folder, or name of a lift that comes with gantline.
        settings: In place of those of the lift file, by their names.
    """
    with scenario_errors():
        from gantline.overrides import SettingError
        from gantline.simulation import Simulation

        try:
            return Simulation(lift, **{name: one.value for name, one in settings.items()})
        except SettingError as problem:
            stop(problem.as_typed({name: (one.option, one.text) for name, one in settings.items()}))


def recording_file(lift: Path) -> Path | None:
    """The recording that is meant: a file of that kind, or that in a folder which `gantline run` wrote."""
    if lift.suffix == ".nc":
        return lift
    try:
        is_of_run = lift.is_dir() and not (lift / "scenario.yaml").exists() and (lift / RECORDING).is_file()
    except OSError:  # told where it is read as a lift file
        return None
    return lift / RECORDING if is_of_run else None


def opened(file: Path) -> Recording:
    """A recording read; what is wrong with it ends the program."""
    from gantline.results import open_recording

    try:
        return open_recording(file)
    except (FileNotFoundError, ValueError) as problem:
        stop(str(problem))


def warn_of_gaps(recording: Recording, side: str = "") -> None:
    """Warn of values of a recording that are no numbers; `side` is what each warning begins with."""
    from gantline.results.file.gaps import gaps

    for sentence in gaps(recording):
        warn(f"{side}{sentence}")


def name_of(lift: Path) -> str:
    """Name of a lift by its file or folder."""
    place = lift.resolve()
    return (
        place.name if place.is_dir() else place.parent.name if place.name == "scenario.yaml" else place.stem
    )


def output_folder(folder: Path) -> Path:
    """The folder to write into, made and tried before a long run."""
    with writing(folder):
        if folder.exists() and not folder.is_dir():
            stop(f"{folder}: is a file; --output needs a folder")
        folder.mkdir(parents=True, exist_ok=True)
        handle, trial = tempfile.mkstemp(prefix=".trial.", dir=folder)
        os.close(handle)
        os.unlink(trial)
    return folder


@contextmanager
def new_folder(output: Path) -> Iterator[Path]:
    """The folder to write into; what of it is new goes again where nothing is written into it.

    Whether that is since what needs it is refused, interrupted, or told to end by `kill`.
    """
    with writing(output):
        new = [one for one in (output, *output.parents) if not one.exists()]

    def remove() -> None:
        for one in new:
            if one.is_dir() and not any(one.iterdir()):
                one.rmdir()

    with tidied(remove):
        try:
            yield output_folder(output)
        except BaseException:
            with suppress(OSError):
                remove()
            raise


@contextmanager
def folder_in_use(output: Path | None) -> Iterator[Path | None]:
    """The folder to write into, if one is asked for, as `new_folder` has it."""
    if output is None:
        yield None
        return
    with new_folder(output) as folder:
        yield folder


def refuse_to_replace(read: Iterable[Path], written: Iterable[Path], right: str) -> None:
    """Ends the program where a file to write is one that is read, whatever name it has there.

    Args:
        read: Files that are read; those that are not there are passed over.
        written: Files to write.
        right: What would be right.
    """
    there = [file for file in read if file.exists()]
    for output in written:
        with writing(output):
            if output.exists() and any(output.samefile(file) for file in there):
                stop(f"{output}: is read here and would be lost; {right}")
