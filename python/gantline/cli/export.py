"""`gantline export`: a recording for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from gantline.cli.lift import opened
from gantline.cli.messages import stop, writing
from gantline.cli.report import Recorded, asked_for

_KINDS = (".glb", ".csv", ".parquet")


def export(
    recording: Recorded,
    output: Annotated[
        Path,
        typer.Argument(metavar="FILE", help="File to write, by its ending: .glb, .csv, .parquet."),
    ],
    variable: Annotated[
        list[str] | None,
        typer.Option("--variable", metavar="NAME", help="Variable of a table, several times for several."),
    ] = None,
) -> None:
    """Write a recording for another program: an animated scene (.glb) or a table (.csv, .parquet).

    Blender, Windows and browsers show .glb files; spreadsheets and data tools read tables.
    """
    from gantline.export import TableError, gltf_binary, write_csv, write_parquet

    kind = output.suffix.lower()
    if kind not in _KINDS:
        stop(f"{output}: ends with '{output.suffix}'; right would be one of {', '.join(_KINDS)}")
    if variable and kind == ".glb":
        stop("--variable is about tables; a .glb holds the motion of everything")
    file = asked_for(recording)
    found = opened(file)
    try:
        with writing(output):
            if kind == ".glb":
                output.write_bytes(gltf_binary(found))
            else:
                write = write_csv if kind == ".csv" else write_parquet
                write(found, output, variable or ())
    except (TableError, ValueError) as problem:
        stop(f"{file}: {problem}")
    typer.echo(f"Written     {output}")
