"""`gantline schema`: the JSON Schema of lift files."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from gantline.cli.messages import writing
from gantline.replacing import replace_text


def schema(
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", metavar="FILE", help="File to write instead of printing."),
    ] = None,
    library: Annotated[
        bool,
        typer.Option("--library", help="That of libraries: types, ropes and shackles that lift files name."),
    ] = False,
) -> None:
    """Print the JSON Schema of lift files, by which editors complete and check while typing."""
    from gantline.scenario import library_schema_text, schema_text

    text = library_schema_text() if library else schema_text()
    if output is None:
        typer.echo(text, nl=not text.endswith("\n"))
        return
    with writing(output):
        replace_text(output, text)
    typer.echo(output)
