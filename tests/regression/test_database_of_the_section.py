"""The database of a ship's section in a flume was no part of the repository: a clone failed all its 33 tests.

`.gitignore` leaves out recordings, `*.nc`, but for what scenarios need; the file lay beside its tests where
it had been written, and nowhere else.
"""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from ship_section import FILE

ROOT = Path(__file__).parents[2]


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="not in a clone")
def test_it_is_kept_with_its_tests() -> None:
    asked = ["git", "ls-files", "--", str(FILE.relative_to(ROOT))]
    kept = subprocess.run(asked, cwd=ROOT, capture_output=True, text=True, check=True).stdout.split()
    assert kept == ["tests/validation/section_in_flume.nc"]
