"""`gantline export`: a recording for other programs."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gantline.cli.lift import opened, quantity_of, refuse_to_replace, warn_of_gaps
from gantline.cli.messages import stop, writing
from gantline.cli.report import Recorded, asked_for

if TYPE_CHECKING:
    from gantline.results.recording import Recording

_SCENES = (".glb", ".rrd")
_TABLES = (".csv", ".parquet")
_STILLS = (".png",)
_FILMS = (".mp4", ".gif")
_KINDS = (*_SCENES, *_TABLES, *_STILLS, *_FILMS)


def export(
    recording: Recorded,
    output: Annotated[
        Path,
        typer.Argument(metavar="FILE", help=f"File to write, by its ending: {', '.join(_KINDS)}."),
    ],
    variable: Annotated[
        list[str] | None,
        typer.Option("--variable", metavar="NAME", help="Variable of a table, several times for several."),
    ] = None,
    lugs: Annotated[
        bool,
        typer.Option("--lugs", help="Table (.csv) of the force of each lug, in kN and t, for its designer."),
    ] = False,
    time: Annotated[
        str | None,
        typer.Option("--time", metavar="TIME", help="Moment of a picture: '12 s'.  [default: the end]"),
    ] = None,
    speed: Annotated[
        float | None,
        typer.Option(metavar="FACTOR", help="Speed of a film, of real time.  [default: a film of 20 s]"),
    ] = None,
) -> None:
    """Write a recording for another program: a scene that moves, a table, a picture or a film.

    Blender, Windows and browsers show .glb files, the Rerun viewer .rrd files (by the package rerun-sdk);
    spreadsheets and data tools read .csv and .parquet. A .png shows one moment, .gif and .mp4 (ffmpeg) all.
    """
    kind = output.suffix.lower()
    if kind not in _KINDS:
        ending = f"ends with '{output.suffix}'" if output.suffix else "has no ending"
        stop(f"{output}: {ending}; right would be one of {', '.join(_KINDS)}")
    for option, given, kinds, what in (
        ("--variable", variable, _TABLES, "tables"),
        ("--time", time, _STILLS, "pictures"),
        ("--speed", speed, _FILMS, "films"),
    ):
        if given is not None and kind not in kinds:
            stop(f"{option} is about {what} ({', '.join(kinds)}); {output} is none")
    if lugs and (variable is not None or kind != ".csv"):
        beside = "has no --variable" if variable is not None else f"is a .csv, and {output} is none"
        stop(f"--lugs: the table of lugs {beside}")
    moment = quantity_of("--time", time, "time")
    if speed is not None and not 0.0 < speed < math.inf:
        stop(f"--speed: {speed:g} is not a finite number above zero; 2 is twice as fast as the lift")
    from gantline import export

    file = asked_for(recording)
    refuse_to_replace([file], [output], "FILE is another one")
    found = opened(file)
    try:
        with writing(output):
            if lugs:
                export.write_lugs(found, output)
            else:
                _write(found, output, kind, variable or [], moment, speed)
    except ValueError as problem:
        stop(f"{file}: {problem}")
    warn_of_gaps(found)
    typer.echo(f"Written     {output}")


def _write(
    recording: Recording,
    output: Path,
    kind: str,
    variables: list[str],
    moment: float | None,
    speed: float | None,
) -> None:
    from gantline import export
    from gantline.replacing import replace_bytes

    if kind == ".glb":
        replace_bytes(output, export.gltf_binary(recording))
    elif kind == ".rrd":
        export.write_rerun(recording, output)
    elif kind in _TABLES:
        write = export.write_csv if kind == ".csv" else export.write_parquet
        try:
            write(recording, output, variables)
        except export.VariableError as problem:
            stop(f"--variable: {problem}")
    elif kind in _STILLS:
        from gantline.export.video import MomentError, write_still

        try:
            write_still(recording, output, moment)
        except MomentError as problem:
            stop(f"--time: {problem}")
    else:
        from gantline.export.video import write_video

        write_video(recording, output, speed)
