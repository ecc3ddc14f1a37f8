"""Ctrl-C while `gantline run` drew its pictures ended it with 130 behind a table that said GO, and without a
word: that the report was missing showed in the folder alone.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app


@pytest.mark.parametrize("stage", ["gantline.plot.save_pictures", "gantline.cli.run.write_beside"])
def test_what_is_missing_is_told(stage: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(stage, interrupted)
    plots = [] if "plot" in stage else ["--no-plots"]
    words = ["run", "pulleys", "-o", str(tmp_path), "--duration", "0.2 s", *plots]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 130
    assert (
        f"interrupted before all was drawn; 'gantline report {tmp_path}' writes the report" in result.stderr
    )
    assert (tmp_path / "recording.nc").exists()
    assert not (tmp_path / "report.html").exists()
