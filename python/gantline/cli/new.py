"""`gantline new`: a commented lift file to start from."""

from __future__ import annotations

import shlex
import textwrap
from contextlib import suppress
from pathlib import Path
from typing import Annotated, Any

import typer

from gantline.cli.messages import stop, writing
from gantline.cli.verb import Verb
from gantline.replacing import replace_bytes


class NamesLifts(Verb):
    """A verb whose help names the lifts that come with gantline, which are looked up when it is asked for."""

    # typer has a copy of click inside, so context and formatter have no public names.
    def format_epilog(self, ctx: Any, formatter: Any) -> None:
        """The lifts, then the examples."""
        from gantline.scenario.file.shipped import shipped

        with formatter.section("Lifts that come with gantline"):
            beside = " " * formatter.current_indent
            names = textwrap.wrap(", ".join(shipped()), formatter.width - len(beside))
            formatter.write("".join(f"{beside}{line}\n" for line in names))
        super().format_epilog(ctx, formatter)


def _lifts_that_begin(incomplete: str) -> list[str]:
    """What a shell offers behind `--from`."""
    from gantline.scenario.file.shipped import shipped

    return [name for name in shipped() if name.startswith(incomplete)]


def new(
    folder: Annotated[
        Path, typer.Argument(metavar="FOLDER", help="Folder of the new lift; made if it is not there.")
    ],
    source: Annotated[
        str | None,
        typer.Option(
            "--from",
            metavar="NAME",
            help="Start from a lift that comes with gantline; their names stand below.",
            autocompletion=_lifts_that_begin,
        ),
    ] = None,
) -> None:
    """Write a commented lift file to start from, with the schema by which editors check it while typing."""
    from gantline.scenario import FILE_NAME, schema_text, template

    text, beside = (template(), []) if source is None else _shipped(source)
    files = {folder / FILE_NAME: text.encode(), folder / "lift.schema.json": schema_text().encode()}
    files |= {folder / path.name: path.read_bytes() for path in beside}
    with writing(folder):  # whether something is there cannot be told of every name either
        if folder.exists() and not folder.is_dir():
            stop(f"{folder}: is a file; the name of a folder is needed")
        # The schema is gantline's own, and of this version once it is written anew.
        for path in (folder / FILE_NAME, *(folder / path.name for path in beside)):
            if path.exists():
                stop(f"{path}: exists already; nothing was written")
        _write(folder, files)
    for path in files:
        typer.echo(path)
    typer.echo(f"Next: gantline run {shlex.quote(str(folder))}")


def _write(folder: Path, files: dict[Path, bytes]) -> None:
    """Write all files or none: a lift file without what belongs to it would be taken for the user's own.

    Raises:
        OSError: If one of them cannot be written.
    """
    made = [path for path in (folder, *folder.parents) if not path.exists()]
    new = [path for path in files if not path.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for path, content in files.items():
            replace_bytes(path, content)
    except BaseException:
        for path in new:
            path.unlink(missing_ok=True)
        with suppress(OSError):  # others may have put something there meanwhile
            for path in made:
                path.rmdir()
        raise


def _shipped(name: str) -> tuple[str, list[Path]]:
    """Text of a lift that comes with gantline, with the schema beside it; and the files that it names."""
    from gantline.scenario import load_scenario, shipped
    from gantline.scenario.file.tree import texts

    lifts = shipped()
    if name not in lifts:
        stop(f"--from: no lift '{name}' comes with gantline; there are {', '.join(lifts)}")
    scenario = load_scenario(lifts[name])
    text = scenario.text.replace("../../schema/lift.schema.json", "lift.schema.json")
    named = set(texts(scenario.tree))
    return text, [path for path in sorted(lifts[name].parent.iterdir()) if path.name in named]
