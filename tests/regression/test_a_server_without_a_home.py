"""On a server whose home cannot be written to, `gantline export`, `run` and what makes pictures began with
two lines of matplotlib, of half a screen: "mkdir -p failed for path …", "Matplotlib created a temporary cache
directory …, it is highly recommended to set the MPLCONFIGDIR environment variable".
"""

from __future__ import annotations

import os
import subprocess
import sys

#: As `gantline` starts, with a verb that only loads matplotlib; nothing else is asked of it.
BEGINS = """
import sys
from gantline.cli import app
app.app = lambda **_: __import__("matplotlib").get_cachedir()
app.run_app()
"""
#: No home is made below it, by root neither.
NO_HOME = "/proc/nobody"


def test_nothing_is_said_of_caches() -> None:
    kept = {name: value for name, value in os.environ.items() if name[:4] not in ("XDG_", "MPLC")}
    ended = subprocess.run(
        [sys.executable, "-c", BEGINS],
        env={**kept, "HOME": NO_HOME},
        capture_output=True,
        text=True,
        check=True,
    )
    assert ended.stderr == ended.stdout == ""
