"""Verbs of the program, called as people call them."""

from __future__ import annotations

from typer.testing import CliRunner, Result

from gantline.cli.app import app


def gantline(*arguments: str, columns: int = 80) -> Result:
    """What a command line answers on a terminal of so many columns; no traceback is an answer."""
    result = CliRunner().invoke(app, arguments, env={"COLUMNS": str(columns)})
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exception
    return result
