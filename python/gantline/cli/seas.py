"""`gantline seas`: in which seas a lift may be done."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from gantline.cli.kept import Continue, kept_file, taking_over, tell_of_going_on, tell_taken_over
from gantline.cli.lift import Lift, TypedSetting, folder_in_use, folder_option, quantity_of
from gantline.cli.messages import (
    CHECK_FAILED,
    DONE,
    INTERRUPTED,
    NO_VERDICT,
    scenario_errors,
    stop,
    warn,
    writing,
)
from gantline.cli.pictured import write_pictured
from gantline.cli.progress import telling
from gantline.cli.spans import values_of_option

if TYPE_CHECKING:
    from gantline.study.seas import SeasResult

_MOST_RECORDS = 1000
#: Options by the arguments of `run_seas`.
_OPTIONS = {
    "waves": "--waves",
    "heights": "--height",
    "periods": "--period",
    "directions": "--direction",
    "records": "--records",
}


def seas(
    lift: Lift,
    waves: Annotated[
        str | None,
        typer.Option(metavar="NAME", help="The waves that are varied, where the lift has several."),
    ] = None,
    height: Annotated[
        str | None,
        typer.Option(
            metavar="HEIGHTS",
            help="Significant heights, such as '0.5 m..2 m/4'; of waves that are all alike their heights.  "
            "[default: that of the lift file]",
        ),
    ] = None,
    period: Annotated[
        str | None,
        typer.Option(
            metavar="PERIODS", help="Peak periods, such as '6 s, 8 s'.  [default: that of the lift file]"
        ),
    ] = None,
    direction: Annotated[
        str | None,
        typer.Option(
            metavar="ANGLES",
            help="Directions in which they run, such as '180 deg, 150 deg'.  "
            "[default: that of the lift file]",
        ),
    ] = None,
    records: Annotated[
        int,
        typer.Option(
            metavar="NUMBER",
            min=1,
            max=_MOST_RECORDS,
            help="Records of each sea, by the seeds after its own.",
        ),
    ] = 1,
    duration: Annotated[
        str | None,
        typer.Option(
            metavar="TIME",
            help="Time to simulate in each, such as '600 s'.  [default: that of the lift file]",
        ),
    ] = None,
    every: Annotated[
        bool, typer.Option("--every", help="Run seas higher than the first in which the lift is no go, too.")
    ] = False,
    go_on: Continue = False,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print all numbers and checks as JSON, SI units.")
    ] = False,
    output: Annotated[
        Path | None,
        folder_option("Folder for all numbers as seas.json, and a picture; a report there shows them."),
    ] = None,
) -> None:
    """Simulate a lift in sea after sea, and say up to which height of waves it keeps its limits.

    Ends with code 1 where the lift is no go in a sea, or gives no verdict, and with 4 where there is no such
    sea at all, all of them being too steep. Ctrl-C ends it with what there is, and with code 130.
    """
    asked: dict[str, Any] = {
        "waves": waves,
        "heights": values_of_option("--height", height, "length"),
        "periods": values_of_option("--period", period, "time"),
        "directions": values_of_option("--direction", direction, "angle"),
    }
    settings = {}
    if duration is not None:
        settings["duration"] = TypedSetting(
            "--duration", duration, quantity_of("--duration", duration, "time")
        )
    from gantline.results.file.saved import SEA_RUNS

    with folder_in_use(output) as folder:
        try:
            kept = kept_file(folder, SEA_RUNS, go_on=go_on)
            result = _run(lift, asked, records, settings, every=every, kept=kept, anew=not go_on)
        except KeyboardInterrupt:
            warn("interrupted before any sea was run: nothing is known of them")
            raise typer.Exit(INTERRUPTED) from None
        _tell(result, folder, as_json=as_json)
    if result.interrupted:
        warn("interrupted; seas of which not all records have been run are told as not run")
        tell_of_going_on(kept)
        raise typer.Exit(INTERRUPTED)
    if all(sea.is_too_steep for sea in result.seas):
        raise typer.Exit(NO_VERDICT)
    raise typer.Exit(DONE if result.is_allowed else CHECK_FAILED)


def _run(
    lift: Path,
    asked: dict[str, Any],
    records: int,
    settings: dict[str, TypedSetting],
    *,
    every: bool,
    kept: Path | None,
    anew: bool,
) -> SeasResult:
    """All runs; what is wrong with the lift file or with an option ends the program."""
    with scenario_errors():
        from gantline.overrides import SettingError
        from gantline.study.sea import NoSeaError
        from gantline.study.seas import run_seas

        overrides: dict[str, Any] = {name: one.value for name, one in settings.items()}
        try:
            with telling("seas") as tell, taking_over(kept):
                result = run_seas(
                    lift,
                    **asked,
                    records=records,
                    all_heights=every,
                    kept=kept,
                    anew=anew,
                    on_progress=tell,
                    **overrides,
                )
        except SettingError as problem:
            stop(problem.as_typed({name: (one.option, one.text) for name, one in settings.items()}))
        except NoSeaError as problem:
            stop(f"{_OPTIONS.get(problem.name, problem.name)}: {problem.sentence}")
    return result


def _tell(result: SeasResult, folder: Path | None, *, as_json: bool) -> None:
    """Print what has been found, and write it into a folder if there is one."""
    from gantline.results.file.saved import SEA_RUNS, SEAS
    from gantline.results.file.saved_seas import SavedSeas

    document = result.to_json()
    text = json.dumps(document, indent=2, allow_nan=False)
    found = SavedSeas.from_json(document)
    if as_json:
        typer.echo(text)
    else:
        from gantline.cli.check_table import width_of_terminal
        from gantline.cli.seas_table import seas_table

        typer.echo("\n".join(seas_table(found, width_of_terminal())))
    if folder is not None:
        from gantline.plot.seas import seas_picture

        numbers = folder / SEAS
        with writing(folder):
            picture = write_pictured(seas_picture(found), text + "\n", numbers)
        typer.echo(f"Picture     {picture}\nSeas        {numbers}", err=as_json)
    tell_taken_over(result.taken_over, SEA_RUNS, aside=as_json)
