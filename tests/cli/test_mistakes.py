"""Mistakes on the command line: one message that says what was found and what is right, nothing written."""

from __future__ import annotations

from pathlib import Path

import h5netcdf
import pytest
from typer.testing import CliRunner

import sample_lift
from gantline.cli.app import app
from gantline.scenario import template
from saved_states import with_digest


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a lift file, a recording, one that is cut short, and files that are neither."""
    (tmp_path / "lift.yaml").write_text(template(), encoding="utf-8")
    whole = sample_lift.ringing_lift().save(tmp_path / "whole.nc").read_bytes()
    (tmp_path / "short.nc").write_bytes(whole[: len(whole) // 2])
    (tmp_path / "words.nc").write_text("no recording", encoding="utf-8")
    (tmp_path / "state.bin").write_text("no state", encoding="utf-8")
    (tmp_path / "half.bin").write_text('{"time": 1.0, "pos', encoding="utf-8")
    (tmp_path / "older.bin").write_bytes(with_digest(b'{"fingerprint":1,"state":{}}' + bytes(16)))
    with h5netcdf.File(tmp_path / "other.nc", "w") as file:
        file.attrs["title"] = "Of another program"
    (tmp_path / "empty").mkdir()
    monkeypatch.chdir(tmp_path)
    return tmp_path


LIFT = "a lift file or its folder is needed"
USELESS, LEAVES_ONE = (
    "the saved state cannot be used:",
    "a run of this lift that cannot go on leaves one, 'state.bin'",
)
NO_STATE = f"{USELESS} it is no state of a run, or is damaged or cut off; {LEAVES_ONE}"
OLD_STATE = (
    f"{USELESS} it was saved by another version of gantline, and the version that saved it reads it; "
    f"{LEAVES_ONE}"
)
NO_RECORDING = "is no recording (.nc) and no folder with one; 'gantline run' makes recordings"
CUT_OFF = "not a recording of gantline (it is cut off: copy it anew, or run the lift again)"
SHARE = "needed is a share, written like '5 %' or '0.05'; angles are those of slope_x, slope_y and heading"
ENDINGS = "right would be one of .glb, .rrd, .csv, .parquet, .png, .mp4, .gif"
MISTAKES = {
    "lift.yaml": "'lift.yaml' is no verb; 'gantline run lift.yaml' simulates it, "
    "'gantline check lift.yaml' looks it over",
    "run equalizr": "equalizr: is no file or folder; "
    "did you mean 'equalizer', a lift that comes with gantline?",
    "run scenarios/equalizer": "scenarios/equalizer: is no file or folder; "
    "did you mean 'equalizer', a lift that comes with gantline?",
    "run nowhere.yaml": f"nowhere.yaml: cannot be read (no such file or directory); {LIFT}",
    "run empty": f"empty: is a folder without scenario.yaml; {LIFT}",
    "run whole.nc": "whole.nc: is no lift file but a recording; "
    "'gantline check', 'report', 'view', 'export' and 'compare' take recordings",
    "run lift.yaml -o short.nc": "short.nc: is a file; --output needs a folder",
    "run lift.yaml -o short.nc/out": "short.nc/out: cannot be written (not a directory)",
    "statics lift.yaml --state state.bin": f"--state: state.bin: {NO_STATE}",
    "statics lift.yaml --state half.bin": f"--state: half.bin: {NO_STATE}",
    "statics lift.yaml --state older.bin": f"--state: older.bin: {OLD_STATE}",
    "statics lift.yaml --state empty": "--state: empty: cannot be read (is a directory)",
    "statics lift.yaml --want 'slop_x=1 deg'": f"--want: slop_x: '1 deg' is an angle; {SHARE}",
    "statics lift.yaml --time 12": "--time: '12' has no unit; a time is written like '40 s' or '2 ms'",
    "report lift.yaml": f"lift.yaml: {NO_RECORDING}",
    "report nowhere": f"nowhere: {NO_RECORDING}",
    "report short.nc": f"short.nc: {CUT_OFF}",
    "report words.nc": "words.nc: not a recording of gantline (it is no NetCDF4 file)",
    "report other.nc": "other.nc: not a recording of gantline "
    "(another program wrote it: it has no attribute 'recording_format')",
    "report whole.nc -o empty": "empty: is a folder; --output needs a file",
    "compare whole.nc short.nc": f"short.nc: {CUT_OFF}",
    "compare whole.nc lift.yaml --b stp=1ms": "--b: there is no setting 'stp'; there are integrator, step, "
    "tension_tolerance, position_tolerance, sample_interval, duration, paper, geometric_stiffness, "
    "adjusting_factor, equalizers",
    "export whole.nc out": f"out: has no ending; {ENDINGS}",
    "export whole.nc out.doc": f"out.doc: ends with '.doc'; {ENDINGS}",
    "export whole.nc nowhere/out.csv": "nowhere/out.csv: cannot be written (no such file or directory)",
}


@pytest.mark.parametrize("words", MISTAKES)
def test_a_mistake_is_named_in_one_message(words: str, folder: Path) -> None:
    before = sorted(folder.rglob("*"))
    result = CliRunner().invoke(app, words)
    assert isinstance(result.exception, SystemExit), result.exception
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.partition("rror: ")[2] == f"{MISTAKES[words]}\n"
    assert sorted(folder.rglob("*")) == before
