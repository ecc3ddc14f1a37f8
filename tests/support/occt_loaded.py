"""Open CASCADE that is there already: the program that reads STEP and IGES, forked off one that has loaded it.

To load the library takes over a second, to read a small body a tenth of that. The program is the same, in a
process of its own for each file; only who starts it is another one.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

#: Reads a line with the words of a program and where its complaints go, and answers with its exit code.
_LOADED = """
import json
import os
import runpy
import sys
import traceback

import numpy
import OCP

for line in sys.stdin:
    words, complaints = json.loads(line)
    child = os.fork()
    if child == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        os.dup2(os.open(complaints, os.O_WRONLY), 2)
        code = 0
        try:
            sys.argv = words
            runpy.run_path(words[0], run_name="__main__")
        except SystemExit as ended:
            code = ended.code or 0
        except BaseException:
            traceback.print_exc()
            code = 1
        sys.stderr.flush()
        os._exit(code)
    print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
"""


@cache
def _loaded() -> subprocess.Popen[str]:
    command = [sys.executable, "-P", "-c", _LOADED]
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def _run(command: list[str], **_how: Any) -> subprocess.CompletedProcess[str]:
    """What `subprocess.run` says of the command `python -P PROGRAM WORD …`."""
    process = _loaded()
    assert process.stdin is not None and process.stdout is not None
    with tempfile.NamedTemporaryFile() as complaints:
        print(json.dumps([command[2:], complaints.name]), file=process.stdin, flush=True)
        code = int(process.stdout.readline())
        said = Path(complaints.name).read_text(encoding="utf-8", errors="replace")
    return subprocess.CompletedProcess(command, code, "", said)


#: In place of `subprocess` within `gantline.cad.step`.
LOADED = SimpleNamespace(run=_run, TimeoutExpired=subprocess.TimeoutExpired)
