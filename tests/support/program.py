"""The program as a shell starts it, with an interpreter of its own, and the same within that of the tests."""

from __future__ import annotations

import subprocess
import sys

from typer.testing import CliRunner

from gantline.cli.app import app

#: How a test starts the program.
PROGRAM = (sys.executable, "-m", "gantline")


def program(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Run the program to its end, and keep what it prints."""
    command = [*PROGRAM, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def called(*arguments: object) -> subprocess.CompletedProcess[str]:
    """The same by a call, without the seconds that an interpreter takes to load all that a verb needs.

    What goes wrong and has no message of its own is raised here.
    """
    words = [*map(str, arguments)]
    result = CliRunner().invoke(app, words, prog_name="gantline", catch_exceptions=False)
    return subprocess.CompletedProcess(words, result.exit_code, result.stdout, result.stderr)
