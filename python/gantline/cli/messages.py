"""How the command line speaks of trouble: one plain message, an exit code, never a traceback."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import NoReturn

import typer

from gantline.cli import INTERRUPTED

__all__ = [
    "BAD_INPUT",
    "CHECK_FAILED",
    "COULD_NOT_GO_ON",
    "DONE",
    "INTERRUPTED",
    "NO_VERDICT",
    "complain",
    "scenario_errors",
    "stop",
    "warn",
    "writing",
]

DONE = 0
CHECK_FAILED = 1
BAD_INPUT = 2
COULD_NOT_GO_ON = 3
NO_VERDICT = 4


def stop(message: str, code: int = BAD_INPUT) -> NoReturn:
    """Print an error and end the program.

    Args:
        message: What is wrong, in plain words.
        code: Exit code.

    Raises:
        typer.Exit: Always.
    """
    complain(message)
    raise typer.Exit(code)


def complain(message: str) -> None:
    """Print an error."""
    typer.echo(f"{typer.style('error:', fg=typer.colors.RED, bold=True)} {message}", err=True)


def warn(message: str) -> None:
    """Print a warning."""
    typer.echo(f"{typer.style('warning:', fg=typer.colors.YELLOW, bold=True)} {message}", err=True)


@contextmanager
def scenario_errors() -> Iterator[None]:
    """Turn what is wrong with a lift file or its settings into a message."""
    from gantline.scenario import ScenarioError

    try:
        yield
    except ScenarioError as problem:
        stop(str(problem))


@contextmanager
def writing(what: object) -> Iterator[None]:
    """Turn trouble with a file or folder into a message."""
    try:
        yield
    except OSError as problem:
        stop(f"{what}: cannot be written ({(problem.strerror or str(problem)).lower()})")
