"""Where `CI` is set, as continuous integration sets it, random cases were others than those of `make test`.

Hypothesis then takes them from the name of each test and leaves `--hypothesis-seed` unread: a case that
failed there did not come again at home, and `make test SEED=7` drew the same ones as ever.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

CONFTEST = Path(__file__).resolve().parents[1] / "conftest.py"
DRAWS = """
from hypothesis import given, settings, strategies

@settings(max_examples=5)
@given(strategies.integers(0, 10**9))
def test_draws(number):
    print("drawn", number)
"""


def drawn(folder: Path, seed: int, **ci: str) -> list[str]:
    """What a test draws under the settings of these tests, where nothing else is set."""
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-s",
        "-p",
        "no:cacheprovider",
        f"--hypothesis-seed={seed}",
    ]
    plain = {name: value for name, value in os.environ.items() if name in ("PATH", "LD_LIBRARY_PATH")}
    result = subprocess.run(
        command, cwd=folder, env={**plain, **ci}, capture_output=True, text=True, check=True
    )
    return [line for line in result.stdout.splitlines() if "drawn" in line]


def test_the_seed_alone_says_what_is_drawn(tmp_path: Path) -> None:
    """The same from the same seed with `CI` and without, and others from another."""
    shutil.copy(CONFTEST, tmp_path)
    (tmp_path / "test_draws.py").write_text(DRAWS, encoding="utf-8")
    there = drawn(tmp_path, 2016, CI="true")
    assert len(there) == 5
    assert there == drawn(tmp_path, 2016)
    assert there != drawn(tmp_path, 7, CI="true")
