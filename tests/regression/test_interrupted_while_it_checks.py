"""Ctrl-C after the last step of `gantline run` and before its table: it ended with 130 and without a word.

The checks of a large lift take seconds. The recording was there, and nothing said so. `gantline compare`
was as silent between its two runs and its pictures, and `gantline seas` before its first run.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline.checks
import gantline.results.comparison
import gantline.study.seas
from verbs import gantline as run_gantline


def _interrupted(*_: object, **__: object) -> None:
    raise KeyboardInterrupt


@pytest.mark.parametrize("form", [[], ["--json"]])
def test_a_run_says_where_its_recording_is(
    form: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And what prints the checks that are missing."""
    monkeypatch.setattr(gantline.checks, "check_recording", _interrupted)
    result = run_gantline("run", "pulleys", "-o", str(tmp_path), "--duration", "0.2 s", *form)
    assert result.exit_code == 130
    recording = tmp_path / "recording.nc"
    said = f"interrupted before all was checked; the recording is {recording}, 'gantline check {tmp_path}'"
    assert f"warning: {said} prints the checks\n" in result.stderr
    assert result.stdout == ""
    assert recording.exists()


def test_a_comparison_says_where_its_recordings_are(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both runs are done by then."""
    monkeypatch.setattr(gantline.results.comparison, "compare", _interrupted)
    words = ["pulleys", "--b", "integrator=del", "--both", "duration=0.2 s", "-o", str(tmp_path)]
    result = run_gantline("compare", *words)
    assert result.exit_code == 130
    files = [tmp_path / "a.nc", tmp_path / "b.nc"]
    said = f"interrupted before all was compared; the recordings are {files[0]}, {files[1]}"
    assert f"warning: {said}\n" in result.stderr
    assert all(file.exists() for file in files)


def test_seas_say_that_none_was_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And leave no folder behind."""
    monkeypatch.setattr(gantline.study.seas, "run_seas", _interrupted)
    result = run_gantline("seas", "crane_barge_in_swell", "-o", str(tmp_path / "seas"))
    assert result.exit_code == 130
    assert result.stderr == "warning: interrupted before any sea was run: nothing is known of them\n"
    assert not (tmp_path / "seas").exists()
