"""Writing a hydrodynamic database onto a full disk ended in a segmentation fault, as recordings did.

HDF5 writes its tables as a file is closed, and is left in pieces where it cannot. Room is now asked for
before xarray begins the file. A limit on the size of files stands for the disk here."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from databases import capytaine
from gantline.hydro.database import read_database, write_database

_WRITE = """
import resource, sys
from gantline.hydro.database import read_database, write_database
database = read_database(sys.argv[1])
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[3]), int(sys.argv[3])))
try:
    write_database(database, sys.argv[2])
except OSError as problem:
    print(problem.strerror, problem.filename)
"""


@pytest.mark.parametrize("share", [0.0, 0.1, 0.5, 0.9])
def test_no_room_is_an_error_of_the_file_and_no_crash(share: float, tmp_path: Path) -> None:
    (tmp_path / "part").mkdir()
    given = capytaine(tmp_path / "given.nc")
    whole = write_database(read_database(given), tmp_path / "whole.nc")
    room = int(share * whole.stat().st_size)
    part = tmp_path / "part" / "part.nc"
    done = subprocess.run(
        [sys.executable, "-c", _WRITE, str(whole), str(part), str(room)], capture_output=True, text=True
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"File too large {part}\n"
    assert list(part.parent.iterdir()) == []
