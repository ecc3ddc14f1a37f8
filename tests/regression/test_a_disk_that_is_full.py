"""A run onto a disk that was full ended in a segmentation fault.

The library that writes recordings keeps tables of the file in memory, writes them as the file is closed, and
is left in pieces where it cannot: `gantline run` onto a disk of 300 kB printed a traceback of two pages, and
then the program crashed. Room for those tables is now held before anything is written, so that a full disk is
met between two writes. A limit on the size of files stands for the disk here.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from sample_lift import ringing_lift

_SAVE = """
import resource, sys
import gantline
recording = gantline.open_recording(sys.argv[1])
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[3]), int(sys.argv[3])))
try:
    recording.save(sys.argv[2])
except OSError as problem:
    print(problem.strerror, problem.filename)
"""


@pytest.mark.parametrize("share", [0.0, 0.05, 0.3, 0.6, 0.9, 0.99])
def test_no_room_is_an_error_of_the_file_and_no_crash(share: float, tmp_path: Path) -> None:
    """Whatever part of a recording there is room for."""
    whole = ringing_lift().save(tmp_path / "whole.nc")
    room = int(share * whole.stat().st_size)
    part = tmp_path / "part.nc"
    done = subprocess.run(
        [sys.executable, "-c", _SAVE, str(whole), str(part), str(room)], capture_output=True, text=True
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"File too large {part}\n"
    assert list(tmp_path.iterdir()) == [whole]
