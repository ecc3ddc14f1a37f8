"""`gantline export` of Parquet onto a full disk said `error writing bytes to file. detail: [errno 28]`.

Those were words of the package that writes it; all other files are told in words of the system. A limit on
the size of files stands for the disk here."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from sample_lift import ringing_lift

pytest.importorskip("pyarrow")

_WRITE = """
import resource, sys
import gantline
from gantline.export.tables import write_parquet
recording = gantline.open_recording(sys.argv[1])
resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
try:
    write_parquet(recording, sys.argv[2])
except OSError as problem:
    print(problem.strerror)
"""


def test_it_is_told_in_words_of_the_system(tmp_path: Path) -> None:
    whole = ringing_lift().save(tmp_path / "whole.nc")
    table = tmp_path / "table.parquet"
    done = subprocess.run(
        [sys.executable, "-c", _WRITE, str(whole), str(table)], capture_output=True, text=True
    )
    assert (done.returncode, done.stderr, done.stdout) == (0, "", "File too large\n")
    assert list(tmp_path.iterdir()) == [whole]
