"""The program as a shell starts it, with an interpreter of its own."""

from __future__ import annotations

import subprocess
import sys

#: How a test starts the program.
PROGRAM = (sys.executable, "-m", "gantline")


def program(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Run the program to its end, and keep what it prints."""
    command = [*PROGRAM, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)
