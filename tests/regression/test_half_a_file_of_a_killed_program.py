"""`kill`, or a terminal that was closed, left half a file beside the results.

A run, export or table that was told to end while it wrote had its file under another name first,
`.recording.nc.mv1ygpzy.part`, and nobody removed that: hidden, and as large as a recording.
"""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

import pytest

_WRITE = """
import os, sys
from pathlib import Path
from gantline.replacing import replaced
target, number = Path(sys.argv[1]), int(sys.argv[2])
with replaced(target) as trial:
    trial.write_text("half")
    print(trial.name, flush=True)
    os.kill(os.getpid(), number)
    print("went on", flush=True)
"""


@pytest.mark.parametrize("name", ["SIGTERM", "SIGHUP"])
def test_nothing_is_left_and_the_program_ends_by_the_signal(name: str, tmp_path: Path) -> None:
    """As it would have ended anywhere else: shells tell it by the same code."""
    number = getattr(signal, name)
    target = tmp_path / "recording.nc"
    target.write_text("of before", encoding="utf-8")
    # Whoever runs the tests may have it ignored, as `nohup` does.
    own = f"import signal; signal.signal({int(number)}, signal.SIG_DFL)\n"
    words = [sys.executable, "-c", own + _WRITE, str(target), str(int(number))]
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == -number
    assert done.stdout.endswith(".part\n") and done.stderr == ""
    assert {one.name: one.read_text(encoding="utf-8") for one in tmp_path.iterdir()} == {
        "recording.nc": "of before"
    }


def test_whoever_takes_the_signal_himself_keeps_it(tmp_path: Path) -> None:
    own = "import signal; signal.signal(signal.SIGTERM, lambda *_: print('mine', flush=True))\n"
    words = [sys.executable, "-c", own + _WRITE, str(tmp_path / "a.txt"), str(int(signal.SIGTERM))]
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == 0
    assert done.stdout.splitlines()[1:] == ["mine", "went on"]
    assert (tmp_path / "a.txt").read_text(encoding="utf-8") == "half"


def test_what_is_ignored_ends_nothing(tmp_path: Path) -> None:
    """Under `nohup` a run outlives its terminal."""
    own = "import signal; signal.signal(signal.SIGHUP, signal.SIG_IGN)\n"
    words = [sys.executable, "-c", own + _WRITE, str(tmp_path / "a.txt"), str(int(signal.SIGHUP))]
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.endswith("went on\n")
    assert (tmp_path / "a.txt").read_text(encoding="utf-8") == "half"
