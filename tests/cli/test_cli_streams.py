"""Where a command writes to, and what it is given in place of a lift file."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from program import PROGRAM
from sample_lift import ringing_lift

FULL = Path("/dev/full")


@pytest.mark.skipif(not FULL.is_char_device(), reason="no device here that is always full")
@pytest.mark.parametrize("words", [["schema"], ["--help"]])
def test_a_disk_that_is_full_is_told_in_a_sentence(words: list[str]) -> None:
    with FULL.open("w") as full:
        result = subprocess.run(
            [*PROGRAM, *words],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
            env=dict(os.environ),
        )
    assert result.returncode == 2
    assert result.stderr == "error: standard output: cannot be written (no space left on device)\n"


@pytest.mark.parametrize("words", [["schema"], ["check", "equalizer"], ["statics", "equalizer"]])
def test_nobody_reads_on(words: list[str]) -> None:
    """As after `| head -1`: it ended with 1, the code of a check that failed. Shells have 141 for SIGPIPE."""
    ours, theirs = os.pipe()
    os.close(ours)
    with os.fdopen(theirs, "w") as closed:
        command = [*PROGRAM, *words]
        result = subprocess.run(command, stdout=closed, stderr=subprocess.PIPE, text=True, check=False)
    assert (result.returncode, result.stderr) == (141, "")


def test_a_recording_in_place_of_a_lift_file(tmp_path: Path) -> None:
    path = ringing_lift().save(tmp_path / "recording.nc")
    result = CliRunner().invoke(app, ["run", str(path)])
    assert result.exit_code == 2
    assert "recording.nc: is no lift file but a recording; 'gantline check', " in result.stderr
    result = CliRunner().invoke(app, ["run", str(tmp_path)])
    assert result.exit_code == 2
    assert "is a folder with a recording; a lift file or its folder is needed" in result.stderr


@pytest.mark.parametrize(
    ("content", "says"), [(b"x", "it is no NetCDF4 file"), (None, "it is cut off: copy it anew")]
)
def test_a_file_that_is_no_recording(tmp_path: Path, content: bytes | None, says: str) -> None:
    path = tmp_path / "a.nc"
    if content is None:
        ringing_lift().save(path)
        content = path.read_bytes()[:5000]
    path.write_bytes(content)
    result = CliRunner().invoke(app, ["report", str(path)])
    assert result.exit_code == 2
    assert f"a.nc: not a recording of gantline ({says}" in result.stderr
