"""`--continue` of verbs that make many runs: the file in which they are kept, and what is said of it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import Annotated

import typer

from gantline.cli.messages import stop, warn, writing

__all__ = ["Continue", "kept_file", "taking_over", "tell_of_going_on", "tell_taken_over"]

#: Whether to take over runs that there are.
Continue = Annotated[
    bool,
    typer.Option(
        "--continue",
        help="Take over the runs that are there in the same folder: of one that was cut off, or asked for "
        "less.",
    ),
]


def kept_file(folder: Path | None, name: str, *, go_on: bool) -> Path | None:
    """The file of runs in the folder; ends the program where there is nothing to go on from.

    Args:
        folder: The folder to write into, if one is asked for.
        name: Name of the file.
        go_on: Whether to take over what it has.
    """
    if folder is None:
        if go_on:
            stop("--continue: needs the folder of the runs that there are; name it by -o")
        return None
    kept = folder / name
    if go_on and not kept.exists():
        stop(f"--continue: {kept} is not there: nothing has been run in this folder; leave out --continue")
    return kept


@contextmanager
def taking_over(kept: Path | None) -> Iterator[None]:
    """Turn trouble with a file of runs into a message."""
    from gantline.study.kept_runs import KeptRunsError, RunsInUseError

    try:
        with nullcontext() if kept is None else writing(kept):
            yield
    except RunsInUseError as problem:
        stop(f"{problem}; wait for its end, or name another folder by -o")
    except KeptRunsError as problem:
        stop(f"--continue: {problem}; leave out --continue")


def tell_taken_over(count: int, name: str, *, aside: bool) -> None:
    """Say how many runs were taken from a file of that name, if any; `aside` on standard error."""
    if count:
        typer.echo(f"Taken over  {count} {'run' if count == 1 else 'runs'} of {name}", err=aside)


def tell_of_going_on(kept: Path | None) -> None:
    """Say of runs that were interrupted how the others are made, if there are some in the file."""
    if kept is not None and kept.exists():
        warn(f"--continue -o {kept.parent} goes on from the runs that have been made")
